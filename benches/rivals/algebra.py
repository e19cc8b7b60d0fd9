"""Times the exact work of benches/algebra.rs in python-flint and SymPy, each the best of several runs."""

import sys
import timeit

NAMES = "xx yy zz xy xz yz wx wy wz ax ay az mx my mz".split()


def best(work):
    """Microseconds of one call, the least of seven runs of at least a hundredth of a second."""
    timer = timeit.Timer(work)
    count, taken = 1, 0.0
    while taken < 0.01:
        taken = timer.timeit(count)
        count *= 2
    count //= 2
    return min(timer.repeat(7, count)) / count * 1e6


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def apply(matrix, vector):
    return [sum((m * v for m, v in zip(row[1:], vector[1:])), row[0] * vector[0]) for row in matrix]


def adjugate(m):
    columns = list(zip(*m))
    return [cross(columns[1], columns[2]), cross(columns[2], columns[0]), cross(columns[0], columns[1])]


class Body:
    """The component line, the angular acceleration and the rate of L·L, over any ring."""

    def __init__(self, symbols):
        self.symbols = symbols
        xx, yy, zz, xy, xz, yz = symbols[:6]
        self.tensor = [[xx, -xy, -xz], [-xy, yy, -yz], [-xz, -yz, zz]]
        self.omega, self.alpha, self.moment = symbols[6:9], symbols[9:12], symbols[12:15]

    def line(self):
        xx, yy, zz, xy, xz, yz = self.symbols[:6]
        (x, y, z), (ax, ay, az) = self.omega, self.alpha
        expanded = xx * ax - xy * ay - xz * az + y * (-xz * x - yz * y + zz * z) - z * (-xy * x + yy * y - yz * z)
        grouped = xx * ax - (yy - zz) * y * z - xy * (ay - z * x) - xz * (az + x * y) - yz * (y * y - z * z)
        return expanded - grouped

    def acceleration(self, moment):
        gyroscopic = cross(self.omega, apply(self.tensor, self.omega))
        return apply(adjugate(self.tensor), [m - g for m, g in zip(moment, gyroscopic)])

    def rate(self):
        zero = self.symbols[0] - self.symbols[0]
        momentum = apply(self.tensor, self.omega)
        rate = apply(self.tensor, self.acceleration([zero] * 3))
        return momentum[0] * rate[0] + momentum[1] * rate[1] + momentum[2] * rate[2]


def flint_times():
    from flint import Ordering, fmpz_mpoly_ctx

    context = fmpz_mpoly_ctx.get(NAMES, Ordering.lex)
    body = Body(context.gens())
    assert body.line() == 0 and body.rate() == 0
    yield "zero test on polynomials", best(body.line)
    yield (
        "jacobian of the angular acceleration",
        best(lambda: [n.derivative(v) for n in body.acceleration(body.moment) for v in (6, 7, 8)]),
    )
    yield "conservation of L·L", best(body.rate)
    eight = fmpz_mpoly_ctx.get([f"s{i}" for i in range(8)], Ordering.lex)
    total = sum(eight.gens()[1:], eight.gens()[0])
    yield "sixth power of eight symbols", best(lambda: total**6)


def sympy_times():
    from sympy import expand, symbols

    body = Body(symbols(NAMES))
    assert expand(body.line()) == 0
    yield "zero test on polynomials", best(lambda: expand(body.line()))


def main():
    for library, times in [("python-flint", flint_times), ("SymPy", sympy_times)]:
        try:
            for name, microseconds in times():
                print(f"{name:<44}{library:<14}{microseconds:10.2f} µs")
        except ImportError:
            print(f"{library} is not installed and was left out: pip install python-flint sympy", file=sys.stderr)


if __name__ == "__main__":
    main()
