"""Error forms of rounded formulas, in rational numbers.

A Form is the value of a formula as computed: a sum of monomials, each times a product of factors (1 + e), one for each
rounding on the monomial's way; |e| <= U = 2^-52 for doubles and |e| <= V = 2^-23 for floats, in any rounding mode.
A form is affine in each e, so its extremes are at e = +-U, and the extreme of |(1 + e1) ... (1 + ek) - 1| is
(1 + U)^k - 1, exactly. Fused multiply-add sets some e to 0. No monomials are cancelled against each other: each keeps
its own roundings, and the triangle inequality adds them up. An input that is off is written x + ~x, where ~x is the
error. Each operation that may underflow adds the monomial `eta`, if it is asked for.

Sizes of variables are polynomials with coefficients >= 0 in letters >= 0, and so are bounds. A bound holds for all
values of the letters if it holds coefficient by coefficient.
"""
import math
import pathlib
import re
import sys
from fractions import Fraction as Q

U = Q(1, 2**52)  # u' of the sources: two_u
V = Q(1, 2**23)
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

# `--too-good=I` makes constant number I of a script smaller, a factor 16 times and a power of two, which mostly is a
# slack or a guard, 2^64 times: the claim must then be refused.
_too_good = int(sys.argv[1].split("=")[1]) if len(sys.argv) > 1 else -1
_constant_count = 0


def number(path, pattern):
    """The number that the first group of the pattern finds in a source file: the claim is about the code as it is."""
    text = re.sub(r"\s+", " ", (ROOT / path).read_text())
    found = re.search(pattern, text)
    if not found:
        raise SystemExit(f"{path}: there is no {pattern}")
    return Q(float.fromhex(found.group(1)) if "x" in found.group(1) else float(found.group(1)))


def constant(path, pattern):
    """The same, of a constant that cannot be smaller by a factor of 16 (of 2^64 if it is a power of two)."""
    global _constant_count
    value = number(path, pattern)
    if _constant_count == _too_good:
        value /= 16 if value > 2**-7 else 2**64
    _constant_count += 1
    return value


def claim(holds, what):
    if not holds:
        raise SystemExit(f"refused: {what}")


def end():
    """The last line of a script: says how many constants the claim has."""
    print(_constant_count)


class Poly:
    """A polynomial with coefficients >= 0 in letters >= 0."""

    def __init__(self, terms=None):
        self.terms = dict(terms or {})

    @staticmethod
    def of(x):
        if isinstance(x, Poly):
            return x
        if isinstance(x, str):
            return Poly({(x,): Q(1)})
        return Poly({(): Q(x)})

    def __add__(self, other):
        result = dict(self.terms)
        for m, c in Poly.of(other).terms.items():
            result[m] = result.get(m, 0) + c
        return Poly(result)

    def __mul__(self, other):
        result = {}
        for m, c in self.terms.items():
            for n, d in Poly.of(other).terms.items():
                key = tuple(sorted(m + n))
                result[key] = result.get(key, 0) + c * d
        return Poly(result)

    __radd__, __rmul__ = __add__, __mul__

    def __le__(self, other):
        other = Poly.of(other)
        return all(c <= other.terms.get(m, 0) for m, c in self.terms.items())

    def at(self, **letters):
        """The polynomial with numbers, or other polynomials, in place of some letters."""
        result = Poly()
        for m, c in self.terms.items():
            term = Poly.of(c)
            for letter in m:
                term = term * letters.get(letter, letter)
            result = result + term
        return result

    def number(self, **letters):
        return self.at(**letters).terms.get((), Q(0))


class Form:
    """A formula as computed: by monomial and numbers of roundings, the sum of coefficients and of their magnitudes."""

    def __init__(self, terms, unit=U, eta=False):
        self.terms, self.unit, self.eta = terms, unit, eta

    def _of(self, x):
        return x if isinstance(x, Form) else Form({((), 0, 0): (Q(x), abs(Q(x)))}, self.unit, self.eta)

    def _rounded(self, terms):
        du, dv = (1, 0) if self.unit == U else (0, 1) if self.unit == V else (0, 0)
        result = {(m, i + du, j + dv): c for (m, i, j), c in terms.items()}
        if self.eta and self.unit:
            _add(result, (("~eta",), 0, 0), (Q(1), Q(1)))
        return Form(result, self.unit, self.eta)

    def __add__(self, other):
        terms = dict(self.terms)
        for key, c in self._of(other).terms.items():
            _add(terms, key, c)
        return self._rounded(terms)

    def __mul__(self, other):
        terms = {}
        for (m, i, j), (c, a) in self.terms.items():
            for (n, k, l), (d, b) in self._of(other).terms.items():
                _add(terms, (tuple(sorted(m + n)), i + k, j + l), (c * d, a * b))
        return self._rounded(terms)

    def __neg__(self):
        return Form({key: (-c, a) for key, (c, a) in self.terms.items()}, self.unit, self.eta)

    def __sub__(self, other):
        return self + -self._of(other)

    __radd__, __rmul__ = __add__, __mul__

    def scaled(self, power):
        """Times a power of two: nothing is rounded."""
        return Form({key: (c * power, a * abs(power)) for key, (c, a) in self.terms.items()}, self.unit, self.eta)

    def to_float(self):
        """The form converted to a float, which is one rounding; operations on it are in floats from here on."""
        return Form(self.terms, V, self.eta)._rounded(self.terms)

    def value(self):
        """The exact formula: coefficients of the monomials without errors."""
        result = {}
        for (m, _, _), (c, _) in self.terms.items():
            if not any(x.startswith("~") for x in m):
                result[m] = result.get(m, 0) + c
        return {m: c for m, c in result.items() if c != 0}

    def error(self, sizes):
        """An upper bound of |computed - exact|."""
        result = Poly()
        for (m, i, j), (_, a) in self.terms.items():
            most = (1 + U) ** i * (1 + V) ** j
            is_error = any(x.startswith("~") for x in m)
            result = result + _size(m, sizes) * (a * (most if is_error else most - 1))
        return result

    def upper(self, sizes):
        """An upper bound of |computed|."""
        result = Poly()
        for (m, i, j), (_, a) in self.terms.items():
            result = result + _size(m, sizes) * (a * (1 + U) ** i * (1 + V) ** j)
        return result

    def lower(self, sizes):
        """A lower bound of what is computed if all monomials are >= 0 and have no error; sizes are their values."""
        result = Poly()
        for (m, i, j), (c, a) in self.terms.items():
            assert c == a and not any(x.startswith("~") for x in m)
            result = result + _size(m, sizes) * (a * (1 - U) ** i * (1 - V) ** j)
        return result


def _add(terms, key, c):
    old = terms.get(key, (0, 0))
    terms[key] = (old[0] + c[0], old[1] + c[1])


def _size(monomial, sizes):
    result = Poly.of(1)
    for x in monomial:
        result = result * sizes.get(x, x)
    return result


def exact(name, unit=U, eta=False):
    """An input without error; unit 0 makes a form of real numbers, on which no operation rounds."""
    return Form({((name,), 0, 0): (Q(1), Q(1))}, unit, eta)


def given(name, unit=U, eta=False):
    """An input that is off: the error is called ~name."""
    return Form({((name,), 0, 0): (Q(1), Q(1)), (("~" + name,), 0, 0): (Q(1), Q(1))}, unit, eta)


def vector(name, unit=U, of=exact):
    return [of(name + str(k), unit) for k in range(3)]


def dot(a, b):
    return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def root_above(x):
    """A rational that is at least sqrt(x), by less than 2^-200 of it."""
    x = Q(x)
    return Q(math.isqrt((x.numerator << 400) // x.denominator) + 1, 1 << 200)


def input_error(formula, names, sizes):
    """How far the real formula changes when inputs x of `sizes` change by ~x: `formula` takes forms for the names."""
    return formula(*[given(name, 0) for name in names]).error(sizes)


class Factor:
    """What is computed, over the real value: a number in [low, high]. For positive numbers."""

    def __init__(self, low=1, high=1, unit=U):
        self.low, self.high, self.unit = Q(low), Q(high), unit

    def rounded(self, times=1):
        return Factor(self.low * (1 - self.unit) ** times, self.high * (1 + self.unit) ** times, self.unit)

    def __mul__(self, other):
        return Factor(self.low * other.low, self.high * other.high, self.unit).rounded()

    def __truediv__(self, other):
        return Factor(self.low / other.high, self.high / other.low, self.unit).rounded()

    def __add__(self, other):  # a sum of positive numbers
        return Factor(min(self.low, other.low), max(self.high, other.high), self.unit).rounded()

    def root(self):
        low = 1 / root_above(1 / self.low)
        return Factor(low, root_above(self.high), self.unit).rounded()
