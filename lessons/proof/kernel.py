"""The numbers of a run. A value of a run is a pair: the number in use, and the exact one, which is right for the scene.

Under filtered, grid and exact the run decides by the exact number, so both are the same. `None` is an exact number that is undefined.
"""

import ctypes
import functools
import math
import struct
from fractions import Fraction
from typing import NamedTuple


class Number(NamedTuple):
    used: object  # a float; a Fraction under the kernels that are always right; None if the trace does not tell it
    exact: object  # a Fraction, minus infinity where there is no depth yet, or None

    def difference(self, used, exact):
        """What else an operand of the trace should be; None if it is this number."""
        if parsed(exact) != self.exact:
            return f"exactly {self.exact}, not {exact}"
        if self.used is not None and parsed(used) != self.used and not (used == "nan" and math.isnan(self.used)):
            return f"{self.used} in use, not {used}"
        return None


def parsed(text):
    """A number of the trace: a fraction, an infinite number, or None for an undefined one."""
    return Fraction(text) if text is not None and "/" in text else text and float(text)


FARTHEST = Number(-math.inf, -math.inf)


class Rounded:
    """A float whose every result is rounded."""

    __slots__ = ("value", "rounded")

    def __init__(self, value, rounded):
        self.value, self.rounded = value, rounded

    def result(self, value):
        return Rounded(self.rounded(value), self.rounded)

    def __add__(self, other):
        return self.result(self.value + other.value)

    def __sub__(self, other):
        return self.result(self.value - other.value)

    def __mul__(self, other):
        return self.result(self.value * other.value)

    def __truediv__(self, other):
        if other.value != 0:
            return self.result(self.value / other.value)
        if self.value == 0 or math.isnan(self.value):
            return self.result(math.nan)
        return self.result(math.copysign(math.inf, self.value) * math.copysign(1, other.value))

    def __neg__(self):
        return Rounded(-self.value, self.rounded)

    def __lt__(self, other):
        return self.value < other.value

    def __le__(self, other):
        return self.value <= other.value

    def __gt__(self, other):
        return self.value > other.value

    def __ge__(self, other):
        return self.value >= other.value

    def __eq__(self, other):
        return self.value == other.value

    def __floor__(self):
        return math.floor(self.value)


def to_float(value):
    return ctypes.c_float(value).value


def to_bits(count, value):
    """The nearest number of `count` significant bits; a tie goes to the even one. The exponent is that of a double."""
    if not math.isfinite(value):
        return value
    pattern = struct.unpack("<Q", struct.pack("<d", value))[0]
    lowest = 1 << (53 - count)
    tie_to_even = lowest // 2 if pattern & lowest else lowest // 2 - 1
    return struct.unpack("<d", struct.pack("<Q", (pattern + tie_to_even) & -lowest & (2**64 - 1)))[0]


class Kernel:
    def __init__(self, name):
        self.name, _, parameter = name.partition(":")
        self.is_always_right = self.name in ("filtered", "grid", "exact")
        self.is_exact = self.name == "exact"
        self.rounded = {"float": to_float, "bits": functools.partial(to_bits, int(parameter or 0))}.get(self.name, float)

    def number(self, value):
        """A number that computes as the run does: what the run makes of a double, or one of its own numbers."""
        if self.is_always_right:
            return Fraction(value) if math.isfinite(value) else value
        return Rounded(self.rounded(float(value)), self.rounded)

    def given(self, value):
        """A number of the scene or the screen, a double."""
        exact = Fraction(value)
        return Number(exact if self.is_always_right else self.rounded(value), exact)

    def told(self, value, exact):
        """A number that an event tells, and the exact one."""
        return Number(exact if self.is_always_right else float(value), exact)

    def in_use(self, result):
        """A result of the run's arithmetic, of which the exact one is not known."""
        return Number(getattr(result, "value", result), None)

    def tells(self, value, number):
        """Can this be what the trace tells of the number? filtered and grid tell a double near it, which need not be the nearest."""
        if number.used is None or self.name in ("filtered", "grid"):
            return True
        if self.is_exact and isinstance(value, str) and "/" in value:
            return Fraction(value) == number.used
        return float(value) == number.used or (math.isnan(float(value)) and math.isnan(number.used))
