"""Counts the operations of emitted code and of CasADi's for the same functions, and times both as C.

    python3 benches/rivals/code.py target/release/polhode

CasADi gets the equations as one writes them there, its own Jacobian and its own elimination of common subexpressions.
"""

import collections
import ctypes
import pathlib
import re
import subprocess
import sys
import tempfile
import timeit

import casadi as ca

TIMES = 200_000
PARAMETERS = {"full": [0, 1, 2, 3, 4, 5], "principal": [0, 1, 2], "axisymmetric": [0, 0, 2]}


def tensor(i, body):
    zero = 0 * i[0] if body == "full" else 0
    xx, yy, zz = i[0], i[1 if body != "axisymmetric" else 0], i[2 if body != "axisymmetric" else 1]
    xy, xz, yz = (i[3], i[4], i[5]) if body == "full" else (zero,) * 3
    return ca.vertcat(ca.horzcat(xx, xy, xz), ca.horzcat(xy, yy, yz), ca.horzcat(xz, yz, zz))


def inverse(j, body):
    return ca.inv(j) if body == "full" else ca.diag(1 / ca.diag(j))


def product(p, q):
    v = p[0] * q[1:] + q[0] * p[1:] + ca.cross(p[1:], q[1:])
    return ca.vertcat(p[0] * q[0] - ca.dot(p[1:], q[1:]), v)


def step(q, w, torque, j, back, h):
    """The classical Runge-Kutta step, the quaternion made unit after it."""

    def rates(q, w):
        return product(q, ca.vertcat(0, w)) / 2, back @ (torque - ca.cross(w, j @ w))

    along = lambda k, s: (q + s * k[0], w + s * k[1])
    a = rates(q, w)
    b = rates(*along(a, h / 2))
    c = rates(*along(b, h / 2))
    d = rates(*along(c, h))
    q, w = along([x + 2 * (y + z) + u for x, y, z, u in zip(a, b, c, d)], h / 6)
    return q / ca.norm_2(q), w


def functions(body):
    """The inputs and outputs of each quantity, in the order of the emitted code."""
    sym = ca.SX.sym
    i = sym("i", len(set(PARAMETERS[body])))
    q, w, a, m, h, theta = sym("q", 4), sym("w", 3), sym("a", 3), sym("m", 3), sym("h"), sym("theta", 3)
    j = tensor(i, body)
    back = inverse(j, body)
    moment = j @ a + ca.cross(w, j @ w)
    alpha = back @ (m - ca.cross(w, j @ w))
    yield "moment", [i, w, a], [moment]
    yield "acceleration", [i, w, m], [alpha]
    yield "jacobian", [i, w, m], [alpha, ca.jacobian(alpha, ca.vertcat(w, m, i))]
    yield "regressor", [w, a], [ca.jacobian(moment, i)]
    end = step(q, w, m, j, back, h)
    yield "step", [i, q, w, m, h], list(end)
    turned = step(product(q, ca.vertcat(1, theta / 2)), w, m, j, back, h)
    x = ca.vertcat(theta, w, m, i, h)
    dq, dw = [ca.substitute(ca.jacobian(y, x), theta, ca.DM.zeros(3)) for y in turned]
    r = end[0]
    tangent = 2 * ca.horzcat(-r[1:], r[0] * ca.DM.eye(3) - ca.skew(r[1:]))
    yield "step-jacobian", [i, q, w, m, h], [*end, ca.vertcat(tangent @ dq, dw)]


def operations(f):
    """What the function does, but for moving numbers."""
    moved = {ca.OP_INPUT, ca.OP_OUTPUT, ca.OP_CONST, ca.OP_PARAMETER, ca.OP_ASSIGN}
    done = collections.Counter(f.instruction_id(k) for k in range(f.n_instructions()))
    return sum(count for what, count in done.items() if what not in moved)


def emitted(polhode, quantity, body):
    command = [polhode, "derive", "--as", "c", "--of", quantity, "--body", body, "--name", "emitted"]
    text = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    counts = re.search(r"Does (.*)\.", text).group(1)
    return text, sum(map(int, re.findall(r"\d+", counts)))


def library(folder, name, text, loop):
    """The code and a loop around it, apart so that the loop can't look inside."""
    sources, target = [folder / f"{name}.c", folder / f"{name}_loop.c"], folder / f"{name}.so"
    for source, content in zip(sources, [text, loop]):
        source.write_text(content)
    subprocess.run(["cc", "-std=gnu11", "-O3", "-shared", "-fPIC", *sources, "-o", target, "-lm"], check=True)
    return ctypes.CDLL(str(target))


def nanoseconds(timed):
    timed(TIMES // 10)
    return min(timeit.repeat(lambda: timed(TIMES), number=1, repeat=5)) / TIMES * 1e9


def loop(call):
    return f"void timed(int n) {{ for (int k = 0; k < n; ++k) {{ {call} }} }}\n"


def times(folder, name, text, function, shapes):
    """Of the emitted code and of CasADi's, in nanoseconds."""
    values = {"i": [0.6, 0.8, 1.0, 0.02, -0.03, 0.05], "q": [0.1, 0.7, -0.5, 0.5], "w": [1.0, 0.5, -0.9]}
    values |= {"a": [0.3, -0.2, 0.1], "m": [0.3, -0.2, 0.1], "h": [0.01]}
    given = [x.name().split("_")[0] if x.is_scalar() else x[0].name().split("_")[0] for x in shapes[0]]
    state = "".join(f"static double {n}[] = {{{', '.join(map(str, values[n]))}}};\n" for n in given)
    sizes = [out.numel() for out in shapes[1]]
    state += "".join(f"static double o{k}[{size}];\n" for k, size in enumerate(sizes))
    outs = [f"(void *)o{k}" for k in range(len(sizes))]
    ours = ", ".join(["h[0]" if n == "h" else n for n in given] + outs)
    first = library(folder, f"{name}_ours", text, f"void emitted();\n{state}{loop(f'emitted({ours});')}")
    generated = ca.CodeGenerator("generated.c")
    generated.add(function)
    arrays = f"const double *in[] = {{{', '.join(given)}}}; double *out[] = {{{', '.join(outs)}}};"
    call = f"{arrays} static double work[20000]; rival(in, out, 0, work, 0);"
    second = library(folder, f"{name}_theirs", generated.dump(), f"int rival();\n{state}{loop(call)}")
    return nanoseconds(first.timed), nanoseconds(second.timed)


def main():
    polhode = sys.argv[1] if len(sys.argv) > 1 else "polhode"
    print(f"{'quantity':14} {'body':13} {'operations':>10} {'CasADi':>7} {'with cse':>8} {'ns':>7} {'CasADi':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for body in PARAMETERS:
            for quantity, inputs, outputs in functions(body):
                text, ours = emitted(polhode, quantity, body)
                plain = ca.Function("rival", inputs, outputs)
                shared = ca.Function("rival", inputs, [ca.densify(y) for y in ca.cse(outputs)])
                name = f"{quantity}_{body}".replace("-", "_")
                mine, other = times(pathlib.Path(folder), name, text, shared, (inputs, outputs))
                counts = f"{ours:10} {operations(plain):7} {operations(shared):8}"
                print(f"{quantity:14} {body:13} {counts} {mine:7.1f} {other:7.1f}")


if __name__ == "__main__":
    main()
