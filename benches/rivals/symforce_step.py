"""Times SymForce's generated C++ of the step of benches/laws.rs and its derivatives: lines of law, row and nanoseconds, between tabs.

    python3 benches/rivals/symforce_step.py [--native] [LAW ...]

It is no part of the bench: to write the code of one law takes SymForce ten minutes and more, for it writes each derivative out
before it looks for what they share. With --native the C++ is compiled for the machine at hand. Needs Eigen's headers.
"""

import pathlib
import subprocess
import sys
import tempfile

try:
    import symforce
except ImportError:
    sys.exit("Python has no symforce; `pip install symforce` brings it")

symforce.set_epsilon_to_zero()
import symforce.symbolic as sf
from symforce import codegen
from symforce.jacobian_helpers import tangent_jacobians
from symforce.values import Values

STEP = 0.01
VALUE = sf.V3(0.1, -0.2, 0.3)
ARM = sf.V3(0.05, -0.1, 0.3)
WIND = sf.V3(0.3, 0.0, -0.1)


def seen(q, v):
    """The components in the body of a vector of space, q⁻¹ v q."""
    w, u = q[3], -sf.V3(*q[:3])
    square = u.dot(u)
    return v * (w**2 - square) + u * (2 * u.dot(v)) + u.cross(v) * (2 * w)


LAWS = {
    "free": lambda t, q, w: sf.V3.zero(),
    "gravity": lambda t, q, w: ARM.cross(seen(q, sf.V3(0, 0, -9.81))),
    "torque in space": lambda t, q, w: seen(q, VALUE),
    "damping": lambda t, q, w: w * -0.02,
    "sinusoid in space": lambda t, q, w: seen(q, VALUE * sf.sin(2.0 * t + 0.3)),
    "one's own": lambda t, q, w: seen(q, WIND) - sf.V3(0, 0, 0.02 * w[2] ** 2),
}

# Where an added torque stands in space.
IN_SPACE = {"torque in space", "sinusoid in space"}


def stepped(law, in_space, time, attitude, omega, inertia, torque):
    """Attitude and angular velocity after a classical Runge-Kutta step."""
    xx, yy, zz, xy, xz, yz = inertia
    tensor = sf.M33([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    inverse = tensor.inv()

    def rates(t, x):
        q, w = sf.V4(*x[:4]), sf.V3(*x[4:])
        added = seen(q, torque) if in_space else torque
        alpha = inverse * (law(t, q, w) + added - w.cross(tensor * w))
        u, s = sf.V3(*q[:3]), q[3]
        turn = w * (s / 2) + u.cross(w) / 2
        return sf.Matrix([*turn, -u.dot(w) / 2, *alpha])

    state = sf.Matrix([*attitude.to_storage(), *omega])
    first = rates(time, state)
    second = rates(time + STEP / 2, state + first * (STEP / 2))
    third = rates(time + STEP / 2, state + second * (STEP / 2))
    fourth = rates(time + STEP, state + third * STEP)
    end = state + (first + second * 2 + third * 2 + fourth) * (STEP / 6)
    q = sf.V4(*end[:4])
    return sf.Rot3.from_storage(list(q / q.norm())), sf.V3(*end[4:])


def functions(law, in_space):
    """The inputs and outputs of the step, its columns and products, in the tangent (θ, ω), the torque and the inertia."""
    attitude, omega = sf.Rot3.symbolic("q"), sf.V3.symbolic("w")
    inertia, torque, time = sf.V6.symbolic("i"), sf.V3.symbolic("m"), sf.Symbol("t")
    end = stepped(law, in_space, time, attitude, omega, inertia, torque)
    of = [attitude, omega, torque, inertia]
    blocks = [tangent_jacobians(row, of) for row in end]
    matrix = sf.Matrix.block_matrix(blocks)
    direction, covector = sf.Matrix(15, 1).symbolic("d"), sf.V6.symbolic("c")
    given = {"q": sf.V4(*attitude.to_storage()), "w": omega, "i": inertia, "m": torque, "t": time}
    after = {"end": sf.Matrix([*end[0].to_storage(), *end[1]])}
    yield "step", given, after
    for count in (6, 9, 15):
        yield f"{count} columns", given, after | {"matrix": sf.Matrix(matrix[:, :count])}
    yield "Jacobian times a direction", given | {"d": direction}, after | {"product": matrix * direction}
    yield "covector times Jacobian", given | {"c": covector}, after | {"product": matrix.T * covector}


# Each function in turns; medians of the time of one call. Eigen's own types, and nothing copied.
HARNESS = """
#include <algorithm>
#include <cstdio>
#include <time.h>
INCLUDES
static double now() { timespec t; clock_gettime(CLOCK_MONOTONIC, &t); return 1e9 * t.tv_sec + t.tv_nsec; }
template <int M, int N = 1> using Matrix = Eigen::Matrix<double, M, N>;
static Matrix<4> q(0, 0, 0, 1);
static Matrix<3> w(3, 0.5, -0.9), m(0, 0, 0);
static Matrix<6> i, c;
static Matrix<15> d;
static double t = 0, times[COUNT][301];
static Matrix<7> end;
OUTPUTS
static void call(int which) { switch (which) { CALLS } }
int main() {
    i << 0.6, 0.8, 1, 0.02, -0.03, 0.05;
    for (int k = 0; k < 6; k++) c[k] = 0.3 * k - 0.7;
    for (int k = 0; k < 15; k++) d[k] = 0.1 * k - 0.7;
    for (int turn = 0; turn < 301; turn++)
        for (int which = 0; which < COUNT; which++) {
            double begun = now();
            for (int n = 0; n < 64; n++) {
                __asm__ volatile("" : : "g"(&q), "g"(&w), "g"(&t) : "memory");
                call(which);
            }
            times[which][turn] = (now() - begun) / 64;
        }
    for (auto &of : times) { std::sort(of, of + 301); printf("%f\\n", of[150]); }
}
"""


def generated(number, given, after, folder):
    """Writes a function; its header, the declaration of what it returns besides the state, and a call."""
    name = f"f{number}"
    config = codegen.CppConfig(explicit_template_instantiation_types=None)
    maker = codegen.Codegen(inputs=Values(**given), outputs=Values(**after), config=config, name=name)
    made = maker.generate_function(output_dir=folder, namespace="rival", skip_directory_nesting=True)
    header = next(path for path in made.generated_files if path.suffix == ".h")
    extra = [key for key in after if key != "end"]
    shapes = [f"static Matrix<{after[key].shape[0]}, {after[key].shape[1]}> {name}_{key};" for key in extra]
    arguments = ", ".join([*given, "&end", *(f"&{name}_{key}" for key in extra)])
    return f'#include "{header}"', "\n".join(shapes), f"case {number}: rival::{name.upper()}({arguments}); break;"


def times(law, in_space, native):
    rows, givens, afters = zip(*functions(law, in_space))
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        parts = [generated(k, *pair, folder) for k, pair in enumerate(zip(givens, afters))]
        includes, outputs, calls = ("\n".join(part) for part in zip(*parts))
        main = HARNESS.replace("COUNT", str(len(rows))).replace("INCLUDES", includes)
        (folder / "main.cc").write_text(main.replace("OUTPUTS", outputs).replace("CALLS", calls))
        flags = ["-O3", "-std=c++17", "-isystem", "/usr/include/eigen3"] + (["-march=native"] if native else [])
        subprocess.run(["c++", *flags, "main.cc", "-o", "main"], cwd=folder, check=True)
        printed = subprocess.run([folder / "main"], capture_output=True, text=True, check=True).stdout
    return zip(rows, printed.split())


asked = [name for name in LAWS if name in sys.argv] or ["free"]
for name in asked:
    for row, time in times(LAWS[name], name in IN_SPACE, "--native" in sys.argv):
        print(name, row, time, sep="\t", flush=True)
