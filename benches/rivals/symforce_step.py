"""Times SymForce's generated C++ of the step of benches/laws.rs and its derivatives: lines of law, row and nanoseconds, between tabs.
One row more has the sum of the entries of the Jacobian, by which the bench sees that the same is timed.

    python3 benches/rivals/symforce_step.py [--native] [LAW ...]

The derivative of one stage is SymForce's; the stages are chained by hand, forwards for columns and a direction, backwards for a
covector. Asked for the derivative of the whole step, SymForce writes it out before it looks for what is shared, which takes ten
minutes for a free body. With --native the C++ is compiled for the machine at hand. Needs Eigen's headers.
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


class Stage:
    """The rates of attitude and angular velocity under a law, and their derivatives, as functions of time and state."""

    def __init__(self, law, in_space, inertia, torque):
        xx, yy, zz, xy, xz, yz = inertia
        tensor = sf.M33([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        self.time, self.state = sf.Symbol("stage_time"), sf.Matrix(7, 1).symbolic("stage")
        q, w = sf.V4(*self.state[:4]), sf.V3(*self.state[4:])
        added = seen(q, torque) if in_space else torque
        inverse, acceleration = tensor.inv(), sf.V3.symbolic("alpha")
        alpha = inverse * (law(self.time, q, w) + added - w.cross(tensor * w))
        u, s = sf.V3(*q[:3]), q[3]
        turn = w * (s / 2) + u.cross(w) / 2
        self.rates = sf.Matrix([*turn, -u.dot(w) / 2, *alpha])
        self.by_state = self.rates.jacobian(self.state)
        # By the moment that the tensor takes: the inverse is not differentiated.
        moment = tensor * acceleration + w.cross(tensor * w)
        by_inertia = (inverse * moment.jacobian(inertia) * -1).subs([*zip(acceleration, alpha)])
        of_omega = sf.Matrix.block_matrix([[alpha.jacobian(torque), by_inertia]])
        self.by_parameters = rows(sf.Matrix.zeros(4, 9), of_omega)

    def at(self, time, state):
        """Rates and derivatives there."""
        here = [(self.time, time), *zip(self.state, state)]
        return [matrix.subs(here) for matrix in (self.rates, self.by_state, self.by_parameters)]


class Step:
    """A classical Runge-Kutta step by its stages: their derivatives and the state at the end."""

    def __init__(self, law, in_space):
        self.q, self.w = sf.V4.symbolic("q"), sf.V3.symbolic("w")
        self.inertia, self.torque, self.t = sf.V6.symbolic("i"), sf.V3.symbolic("m"), sf.Symbol("t")
        stage, state = Stage(law, in_space, self.inertia, self.torque), sf.Matrix([*self.q, *self.w])
        self.by_state, self.by_parameters, rates = [], [], []
        for length in (0, STEP / 2, STEP / 2, STEP):
            place = state + rates[-1] * length if rates else state
            rate, by_state, by_parameters = stage.at(self.t + length, place)
            rates.append(rate)
            self.by_state.append(by_state)
            self.by_parameters.append(by_parameters)
        end = state + weighed(rates)
        size = sf.V4(*end[:4]).norm()
        self.end = sf.Matrix([*(sf.V4(*end[:4]) / size), *end[4:]])
        # Of the attitude in a turn of the body side, before the step; and of that turn in the attitude, after it.
        x, y, z, w = self.q
        self.turned = sf.Matrix([[w, -z, y], [z, w, -x], [-y, x, w], [-x, -y, -z]]) / 2
        x, y, z, w = end[:4]
        self.turn = sf.Matrix([[w, z, -y, -x], [-z, w, x, -y], [y, -x, w, -z]]) * (2 / size**2)

    def along(self, direction):
        """The change of (θ, ω) with columns of (θ, ω, torque, inertia)."""
        start = rows(self.turned * block(direction, 0, 3), block(direction, 3, 6))
        parameters, changes = block(direction, 6, 15), []
        for i, length in enumerate((0, STEP / 2, STEP / 2, STEP)):
            moved = start + changes[-1] * length if changes else start
            changes.append(self.by_state[i] * moved + self.by_parameters[i] * parameters)
        end = start + weighed(changes)
        return rows(self.turn * block(end, 0, 4), block(end, 4, 7))

    def back(self, covector):
        """A covector of (θ, ω) after the step as one of (θ, ω, torque, inertia)."""
        end = rows(self.turn.T * block(covector, 0, 3), block(covector, 3, 6))
        state, parameters, pulled = end, sf.Matrix.zeros(9, 1), None
        for i, weight, length in ((3, 1, 0), (2, 2, STEP), (1, 2, STEP / 2), (0, 1, STEP / 2)):
            rate = end * (STEP * weight / 6)
            if pulled is not None:
                rate = rate + pulled * length
            pulled = self.by_state[i].T * rate
            state = state + pulled
            parameters = parameters + self.by_parameters[i].T * rate
        return rows(self.turned.T * block(state, 0, 4), block(state, 4, 7), parameters)


def weighed(stages):
    a, b, c, d = stages
    return (a + b * 2 + c * 2 + d) * (STEP / 6)


def block(matrix, first, end):
    return sf.Matrix(matrix[first:end, :])


def rows(*blocks):
    return sf.Matrix.block_matrix([[part] for part in blocks])


def functions(law, in_space):
    """The inputs and outputs of the step, its columns and products, in the tangent (θ, ω), the torque and the inertia."""
    step = Step(law, in_space)
    given = {"q": step.q, "w": step.w, "i": step.inertia, "m": step.torque, "t": step.t}
    after = {"end": step.end}
    yield "step", given, after
    for count in (6, 9, 15):
        matrix = step.along(sf.Matrix(sf.Matrix.eye(15, 15)[:, :count]))
        yield f"{count} columns", given, after | {"matrix": matrix}
    direction, covector = sf.Matrix(15, 1).symbolic("d"), sf.V6.symbolic("c")
    along, back = step.along(direction), step.back(covector)
    yield "Jacobian times a direction", given | {"d": direction}, after | {"product": along}
    yield "covector times Jacobian", given | {"c": covector}, after | {"product": back}


# Each function in turns; medians of the time of one call. Eigen's own types, and nothing copied. The last is a loop over the
# step and the product with a covector: a hundred steps and the gradient backwards.
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
static double t = 0, times[COUNT + 1][301];
static Matrix<7> end;
static Matrix<4> attitudes[101];
static Matrix<3> speeds[101], torques[100], gradient[100];
static Matrix<6> costs[101], of_inertia;
OUTPUTS
static void rollout() {
    attitudes[0] = q, speeds[0] = w;
    for (int k = 0; k < 100; k++) {
        rival::F0(attitudes[k], speeds[k], i, torques[k], k * STEP, &end);
        attitudes[k + 1] = end.head<4>(), speeds[k + 1] = end.tail<3>();
    }
    Matrix<6> covector = costs[100];
    Matrix<15> pulled;
    of_inertia.setZero();
    for (int k = 99; k >= 0; k--) {
        rival::F5(attitudes[k], speeds[k], i, torques[k], k * STEP, covector, &end, &pulled);
        covector = pulled.head<6>() + costs[k], gradient[k] = pulled.segment<3>(6), of_inertia += pulled.tail<6>();
    }
}
static void call(int which) { switch (which) { CALLS } }
int main() {
    i << 0.6, 0.8, 1, 0.02, -0.03, 0.05;
    for (int k = 0; k < 6; k++) c[k] = 0.3 * k - 0.7;
    for (int k = 0; k < 15; k++) d[k] = 0.1 * k - 0.7;
    for (int k = 0; k < 100; k++) torques[k] << 0.1, 0, -0.2;
    for (int k = 0; k < 101; k++) costs[k] = c;
    // One and the same is timed.
    for (int which = 3; which < COUNT; which++) call(which);
    if ((f3_matrix * d - f4_product).norm() + (f3_matrix.transpose() * c - f5_product).norm() > 1e-12) return 1;
    for (int turn = 0; turn < 301; turn++)
        for (int which = 0; which <= COUNT; which++) {
            int calls = which < COUNT ? 64 : 1;
            double begun = now();
            for (int n = 0; n < calls; n++) {
                __asm__ volatile("" : : "g"(&q), "g"(&w), "g"(&t) : "memory");
                call(which);
            }
            times[which][turn] = (now() - begun) / calls;
        }
    for (auto &of : times) { std::sort(of, of + 301); printf("%f\\n", of[150]); }
    printf("%.17g\\n", f3_matrix.sum());
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
        main = HARNESS
        includes, outputs, calls = ("\n".join(part) for part in zip(*parts))
        calls += f"\ncase {len(rows)}: rollout(); break;"
        for name, value in {"COUNT": len(rows), "STEP": STEP, "INCLUDES": includes, "OUTPUTS": outputs, "CALLS": calls}.items():
            main = main.replace(name, str(value))
        (folder / "main.cc").write_text(main)
        flags = ["-O3", "-std=c++17", "-isystem", "/usr/include/eigen3"] + (["-march=native"] if native else [])
        subprocess.run(["c++", *flags, "main.cc", "-o", "main"], cwd=folder, check=True)
        printed = subprocess.run([folder / "main"], capture_output=True, text=True, check=True).stdout
    return zip([*rows, "100 steps with gradient", "sum of entries"], printed.split())


asked = [name for name in LAWS if name in sys.argv] or LAWS
for name in asked:
    for row, time in times(LAWS[name], name in IN_SPACE, "--native" in sys.argv):
        print(name, row, time, sep="\t", flush=True)
