#!/usr/bin/env python3
"""Checks the proofs of one document again, by multiplying them out with SymPy.

Run `python3 recheck.py`. It prints each premise that was believed, and ends with exit code 1 if a proof does not hold.
"""
import sys

from sympy import Add, Integer, Rational, Symbol, cos, diff, div, exp, expand, log, pi, sin, sqrt, sympify


class Wrong(Exception):
    pass


def need(condition, message):
    if not condition:
        raise Wrong(message)


def shown(text):
    """The text with everything escaped that a terminal could take for an order."""
    return "".join(c if " " <= c <= "~" else ascii(c)[1:-1] for c in text)


def same(a, b):
    return expand(a - b) == 0


class Certificate:
    def __init__(self, place, source):
        self.place, self.source = place, source
        self.symbols, self.rates, self.kernels = {}, {}, {}
        self.conditions, self.facts, self.premises, self.goals = [], [], [], 0

    def symbol(self, name, latex):
        self.symbols[name] = latex
        return Symbol(name)

    def rate(self, variable, top, bottom):
        self.rates[variable] = (top, bottom)

    def kernel(self, variable, function, top, bottom):
        self.kernels[variable] = (function, top, bottom)

    def condition(self, value):
        need(expand(value) != 0, "zero is never different from zero")
        self.conditions.append(value)

    def divisor(self, value):
        """A divisor is a number that is not zero, times powers of conditions."""
        rest = expand(value)
        need(rest != 0, "divides by zero")
        for condition in self.conditions:
            while rest.free_symbols and expand(condition).free_symbols:
                quotient, remainder = div(rest, expand(condition))
                if expand(remainder) != 0:
                    break
                rest = expand(quotient)
        need(not rest.free_symbols, "a divisor without its condition")

    def add(self, value):
        self.facts.append(value)

    def premise(self, value, name):
        need(name, "a premise without a name")
        self.premises.append((name, value))
        self.add(value)

    def circle(self, value, sine, cosine):
        s, c = self.kernels[sine], self.kernels[cosine]
        need(s[0] == "sin" and c[0] == "cos", "not a sine and a cosine")
        need(same(s[1] * c[2], c[1] * s[2]), "two arguments")
        self.divisor(s[2])
        self.divisor(c[2])
        need(same(value, sine**2 + cosine**2 - 1), "not the circle")
        self.add(value)

    def root(self, value, root):
        function, top, bottom = self.kernels[root]
        need(function == "sqrt", "not a root")
        self.divisor(bottom)
        need(same(value, bottom * root**2 - top), "not the square of the root")
        self.add(value)

    def rate_of(self, value, of):
        before = self.facts[of]
        variables = sorted(expand(before).free_symbols, key=str)
        total = Integer(0)
        for variable in variables:
            top, bottom = self.rates[variable]
            self.divisor(bottom)
            term = diff(before, variable) * top
            for other in variables:
                if other != variable:
                    term *= self.rates[other][1]
            total += term
        need(same(value, total), "not the rate")
        self.add(value)

    def congruence(self, value, one, other, by):
        a, b = self.kernels[one], self.kernels[other]
        need(a[0] == b[0], "two functions")
        self.divisor(a[2])
        self.divisor(b[2])
        need(same(self.facts[by], a[1] * b[2] - b[1] * a[2]), "the arguments are not shown to be equal")
        need(same(value, one - other), "not the difference of the functions")
        self.add(value)

    def combines(self, value, multiplier, cofactors):
        self.divisor(multiplier)
        total = sum((cofactor * self.facts[fact] for fact, cofactor in cofactors), Integer(0))
        need(same(multiplier * value, total), "does not multiply out")

    def combination(self, value, multiplier, cofactors):
        self.combines(value, multiplier, cofactors)
        self.add(value)

    def goal(self, left, left_below, right, right_below, multiplier, cofactors):
        self.divisor(left_below)
        self.divisor(right_below)
        self.combines(left * right_below - right * left_below, multiplier, cofactors)
        self.goals += 1


    def number(self, value):
        """What a polynomial in functions of numbers is."""
        functions = {"sqrt": sqrt, "sin": sin, "cos": cos, "exp": exp, "ln": log}
        values = {}
        for symbol in expand(value).free_symbols:
            function, top, bottom = self.kernels[symbol]
            if function == "pi":
                values[symbol] = pi
            else:
                values[symbol] = functions[function](self.number(top) / self.number(bottom))
        return sympify(value).subs(values)

    def bound(self, top, bottom, lower, upper):
        value = (self.number(top) / self.number(bottom)).evalf(60)
        need(value.is_real and lower <= value <= upper, "a number out of its bounds")


def readable(certificate, value):
    names = sorted(value.free_symbols, key=lambda s: int(str(s)[1:]))
    return f"{value} = 0 with " + ", ".join(f"{n}: {certificate.symbols[str(n)]}" for n in names)


def main(document, lines):
    failed = 0
    print(shown(document))
    for line in lines:
        try:
            certificate = line()
            need(certificate.goals > 0, "nothing is shown")
        except (Wrong, KeyError, IndexError) as error:
            failed += 1
            print(f"{line.__name__}: does not hold: {error}")
            continue
        print(shown(f"{certificate.place}: holds: {certificate.source}"))
        for condition in certificate.conditions:
            print(shown(f"  where {expand(condition)} is not zero"))
        for name, value in certificate.premises:
            print(shown(f"  {name}: {readable(certificate, expand(value))}"))
    print(f"{len(lines) - failed} of {len(lines)} proofs hold")
    sys.exit(1 if failed else 0)
