"""Times CasADi's generated C of the step of benches/laws.rs and its derivatives: lines of law, row and nanoseconds, between tabs.
One row more has the sum of the entries of the Jacobian, by which the bench sees that the same is timed.

With --native the C is compiled for the machine at hand, as the Rust of the same run.
"""

import pathlib
import subprocess
import sys
import tempfile

try:
    import casadi as ca
except ImportError:
    sys.exit("Python has no casadi; `pip install casadi` brings it")

STEP = 0.01
VALUE = ca.DM([0.1, -0.2, 0.3])
ARM = ca.DM([0.05, -0.1, 0.3])
WIND = ca.DM([0.3, 0.0, -0.1])


def seen(q, v):
    """The components in the body of a vector of space, q⁻¹ v q."""
    u = -q[1:]
    square = ca.dot(u, u)
    return v * (q[0] ** 2 - square) + u * (2 * ca.dot(u, v)) + ca.cross(u, v) * (2 * q[0])


LAWS = {
    "free": lambda t, q, w: ca.SX.zeros(3),
    "gravity": lambda t, q, w: ca.cross(ARM, seen(q, ca.DM([0, 0, -9.81]))),
    "torque in space": lambda t, q, w: seen(q, VALUE),
    "damping": lambda t, q, w: -0.02 * w,
    "sinusoid in space": lambda t, q, w: seen(q, VALUE * ca.sin(2.0 * t + 0.3)),
    "one's own": lambda t, q, w: seen(q, WIND) - ca.vertcat(0, 0, 0.02 * w[2] ** 2),
}


# Where an added torque stands in space.
IN_SPACE = {"torque in space", "sinusoid in space"}


def product(p, q):
    w = p[0] * q[0] - ca.dot(p[1:], q[1:])
    return ca.vertcat(w, p[0] * q[1:] + q[0] * p[1:] + ca.cross(p[1:], q[1:]))


def symmetric(e):
    return ca.vertcat(ca.horzcat(e[0], e[3], e[4]), ca.horzcat(e[3], e[1], e[5]), ca.horzcat(e[4], e[5], e[2]))


def stepped(law, in_space, time, state, inertia, torque):
    """The state after a classical Runge-Kutta step."""
    tensor = symmetric(inertia)
    inverse = ca.inv(tensor)

    def rates(t, x):
        q, w = x[:4], x[4:]
        added = seen(q, torque) if in_space else torque
        net = law(t, q, w) + added - ca.cross(w, tensor @ w)
        return ca.vertcat(product(q, ca.vertcat(0, w / 2)), inverse @ net)

    first = rates(time, state)
    second = rates(time + STEP / 2, state + first * (STEP / 2))
    third = rates(time + STEP / 2, state + second * (STEP / 2))
    fourth = rates(time + STEP, state + third * STEP)
    end = state + (first + 2 * second + 2 * third + fourth) * (STEP / 6)
    return ca.vertcat(end[:4] / ca.norm_2(end[:4]), end[4:])


def functions(law, in_space):
    """The step, its columns and products, in the tangent (θ, ω), the torque and the inertia."""
    state, inertia, torque = ca.SX.sym("x", 7), ca.SX.sym("I", 6), ca.SX.sym("M", 3)
    time, tangent = ca.SX.sym("t"), ca.SX.sym("d", 6)
    moved = ca.vertcat(product(state[:4], ca.vertcat(1, tangent[:3] / 2)), state[4:] + tangent[3:])
    end = stepped(law, in_space, time, moved, inertia, torque)
    at_rest = stepped(law, in_space, time, state, inertia, torque)
    # The attitude from which the turn is counted does not move with the inputs.
    held = ca.SX.sym("h", 4)
    back = ca.vertcat(held[0], -held[1:])
    result = ca.vertcat(2 * product(back, end[:4])[1:], end[4:])
    inputs = ca.vertcat(tangent, torque, inertia)

    def here(derivative):
        there = ca.substitute(derivative, tangent, ca.SX.zeros(6))
        return ca.cse([at_rest, ca.densify(ca.substitute(there, held, at_rest[:4]))])

    given = [state, inertia, torque, time]
    direction, covector = ca.SX.sym("v", 15), ca.SX.sym("c", 6)
    yield "step", ca.Function("f0", given, [at_rest])
    for i, count in enumerate((6, 9, 15)):
        matrix = here(ca.jacobian(result, inputs[:count]))
        yield f"{count} columns", ca.Function(f"f{i + 1}", given, matrix)
    along = here(ca.jtimes(result, inputs, direction))
    yield "Jacobian times a direction", ca.Function("f4", given + [direction], along)
    pulled = here(ca.jtimes(result, inputs, covector, True))
    yield "covector times Jacobian", ca.Function("f5", given + [covector], pulled)


# Each function in turns; medians of the time of one call. The last is a loop over the first and the one before it: a hundred
# steps and the gradient backwards.
HARNESS = """
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include "step.c"
typedef int (*function)(const double**, double**, casadi_int*, double*, int);
static double now(void) { struct timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * t.tv_sec + t.tv_nsec; }
static int order(const void *a, const void *b) { double x = *(double*)a, y = *(double*)b; return (x > y) - (x < y); }
static double x[7] = {1, 0, 0, 0, 3, 0.5, -0.9}, inertia[6] = {0.6, 0.8, 1, 0.02, -0.03, 0.05}, torque[3], start[1];
static double other[15] = {0.7, -0.4, -0.1, 0.2, 0.5, 0.8}, end[7], matrix[90], work[1 << 16], times[FUNCTIONS + 1][301];
static double states[101][7], torques[100][3], costs[101][6], gradient[100][3], of_inertia[6];
static casadi_int iw[1 << 10];
static function f[] = {NAMES};
static void call(int i) {
    const double *in[] = {x, inertia, torque, start, other};
    double *out[] = {end, matrix};
    f[i](in, out, iw, work, 0);
}
static void rollout(void) {
    double covector[6], pulled[15], time;
    for (int i = 0; i < 7; i++) states[0][i] = x[i];
    for (int k = 0; k < 100; k++) {
        time = k * STEP;
        const double *in[] = {states[k], inertia, torques[k], &time};
        double *out[] = {states[k + 1]};
        f[0](in, out, iw, work, 0);
    }
    for (int i = 0; i < 6; i++) { covector[i] = costs[100][i]; of_inertia[i] = 0; }
    for (int k = 99; k >= 0; k--) {
        time = k * STEP;
        const double *in[] = {states[k], inertia, torques[k], &time, covector};
        double *out[] = {0, pulled};
        f[FUNCTIONS - 1](in, out, iw, work, 0);
        for (int i = 0; i < 6; i++) { covector[i] = pulled[i] + costs[k][i]; of_inertia[i] += pulled[9 + i]; }
        for (int i = 0; i < 3; i++) gradient[k][i] = pulled[6 + i];
    }
}
int main(void) {
    for (int k = 0; k < 100; k++) { torques[k][0] = 0.1; torques[k][2] = -0.2; }
    for (int k = 0; k < 101; k++) for (int i = 0; i < 6; i++) costs[k][i] = 0.3 * i - 0.7;
    for (int turn = 0; turn < 301; turn++)
        for (int i = 0; i <= FUNCTIONS; i++) {
            int calls = i < FUNCTIONS ? 64 : 1;
            double begun = now();
            for (int n = 0; n < calls; n++) {
                __asm__ volatile("" : : "g"(x), "g"(start), "g"(other), "g"(torques), "g"(costs) : "memory");
                if (i < FUNCTIONS) call(i); else rollout();
            }
            times[i][turn] = (now() - begun) / calls;
        }
    for (int i = 0; i <= FUNCTIONS; i++) {
        qsort(times[i], 301, sizeof(double), order);
        printf("%f\\n", times[i][150]);
    }
    double sum = 0;
    call(3);
    for (int i = 0; i < 90; i++) sum += matrix[i];
    printf("%.17g\\n", sum);
}
"""


def times(law, in_space, native):
    rows, made = zip(*functions(law, in_space))
    rows += ("100 steps with gradient", "sum of entries")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        code = ca.CodeGenerator("step.c")
        for function in made:
            code.add(function)
        code.generate(f"{folder}/")
        names = ", ".join(function.name() for function in made)
        known = {"FUNCTIONS": str(len(made)), "NAMES": names, "STEP": str(STEP)}
        main = HARNESS
        for name, value in known.items():
            main = main.replace(name, value)
        (folder / "main.c").write_text(main)
        flags = ["-O3"] + (["-march=native"] if native else [])
        subprocess.run(["cc", *flags, "main.c", "-o", "main", "-lm"], cwd=folder, check=True)
        printed = subprocess.run([folder / "main"], capture_output=True, text=True, check=True).stdout
    return zip(rows, printed.split())


for name, law in LAWS.items():
    for row, time in times(law, name in IN_SPACE, "--native" in sys.argv):
        print(name, row, time, sep="\t")
