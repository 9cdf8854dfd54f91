"""Numbers with units, as scenarios have them: "50 Pa", "6 h 30 min", "30 deg".

The rules and the words are those of the program (src/parameters/units.cpp); tests/python/test_scenario.py compares them.
"""
from __future__ import annotations

import math
import re
from dataclasses import dataclass
from fractions import Fraction

Exponents = tuple[Fraction, ...]


@dataclass(frozen=True)
class Unit:
    """A dimension in um, s, nN and rad, and a factor 2^a 3^b 10^c pi^d to these."""

    dimension: Exponents = (Fraction(0),) * 4
    factor: Exponents = (Fraction(0),) * 4

    def times(self, other: Unit, power: Fraction) -> Unit:
        def add(a: Exponents, b: Exponents) -> Exponents:
            return tuple(x + y * power for x, y in zip(a, b, strict=True))

        return Unit(add(self.dimension, other.dimension), add(self.factor, other.factor))

    def scale(self) -> Fraction | float:
        """How many um, s, nN and rad it is: exact unless a root or pi is in it."""
        exact, rest = Fraction(1), 1.0
        for base, exponent in zip((2, 3, 10, math.pi), self.factor, strict=True):
            if exponent.denominator == 1 and base != math.pi:
                exact *= Fraction(base) ** int(exponent)
            else:
                rest *= float(base) ** float(exponent)
        return exact if rest == 1.0 else float(exact) * rest


def _unit(length: int = 0, time: int = 0, force: int = 0, angle: int = 0, two: int = 0, three: int = 0, ten: int = 0,
          pi: int = 0) -> Unit:
    return Unit(tuple(map(Fraction, (length, time, force, angle))), tuple(map(Fraction, (two, three, ten, pi))))


_minute, _hour = _unit(time=1, two=1, three=1, ten=1), _unit(time=1, two=2, three=2, ten=2)
_day, _degree = _unit(time=1, two=5, three=3, ten=2), _unit(angle=1, two=-1, three=-2, ten=-1, pi=1)
_prefixed = {"m": _unit(1, ten=6), "s": _unit(time=1), "N": _unit(force=1, ten=9), "Pa": _unit(-2, force=1, ten=-3),
             "g": _unit(-1, 2, 1)}
_symbols = _prefixed | {"min": _minute, "h": _hour, "d": _day, "1": _unit(), "rad": _unit(angle=1), "deg": _degree,
                        "°": _degree, "degree": _degree, "second": _unit(time=1), "minute": _minute, "hour": _hour,
                        "day": _day}
_prefixes = {"p": -12, "n": -9, "u": -6, "µ": -6, "μ": -6, "m": -3, "c": -2, "k": 3, "M": 6, "G": 9}
_usual = ("Pa", "kPa", "um", "nm", "mm", "nN", "pN", "uN", "s", "ms", "min", "h", "d", "rad", "deg", "MPa", "GPa", "mPa", "m", "N",
          "g", "kg", "second", "minute", "hour", "day")  # the common ones come first
_slips = {"pascal": "Pa", "pascals": "Pa", "kilopascal": "kPa", "kilopascals": "kPa", "micron": "um", "microns": "um",
          "micrometer": "um", "micrometers": "um", "sec": "s", "secs": "s", "hr": "h", "hrs": "h"}
_number = re.compile(r"[-+]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?")
_symbol = re.compile(r"1|(?:[A-Za-z]|[^\x00-\x7f·])+")
_longest = 80
_words: dict[tuple[float | Fraction, ...], str] = {
    (0, 0, 0, 0): "a bare number", (1, 0, 0, 0): "a length", (2, 0, 0, 0): "an area", (0, 1, 0, 0): "a time",
    (0, -1, 0, 0): "a rate", (1, -1, 0, 0): "a speed", (0, 0, 1, 0): "a force", (0, 0, -1, 0): "an inverse force",
    (-2, 0, 1, 0): "a stress", (-2, 1, 1, 0): "a viscosity", (-1, 0, 1, 0): "a stiffness",
    (-1, 1, 1, 0): "a drag coefficient", (1, 0, 1, 0): "a bending stiffness", (-1, 0, 0, 0): "a curvature",
    (0, 0, 0, 1): "an angle",
}


def number_text(value: int | float | Fraction) -> str:
    """A number as the program writes it: 200, 0.5, 1e-05."""
    text = repr(value if isinstance(value, int) else float(value))
    return text.removesuffix(".0")


def dimension_words(unit: Unit) -> str:
    """ "a stress", or "a quantity in um s^2"."""
    if unit.dimension in _words:
        return _words[unit.dimension]
    parts = [name if exponent == 1 else f"{name}^{number_text(exponent)}"
             for name, exponent in zip(("um", "s", "nN", "rad"), unit.dimension, strict=True) if exponent]
    return "a quantity in " + " ".join(parts)


def _find(text: str) -> Unit | None:
    for name, unit in _symbols.items():
        if text == name or (len(name) >= 3 and text == name + "s"):
            return unit
    for prefix, ten in _prefixes.items():
        if text.startswith(prefix) and text[len(prefix):] in _prefixed:
            return _prefixed[text[len(prefix):]].times(_unit(ten=ten), Fraction(1))
    return None


def _unit_meant(text: str) -> str:
    """ "; did you mean kPa?" of "kpa"; empty if no unit has these letters."""
    typed = text.lower()
    meant = next((unit for unit in _usual if typed == unit.lower() or (len(unit) >= 3 and typed == unit.lower() + "s")),
                 _slips.get(typed, ""))
    return f"; did you mean {meant}?" if meant else ""


def parse_unit(text: str) -> Unit:
    """The unit of a text such as "N/m^1.5" or "Pa s"; ValueError says what is wrong with it."""
    if len(text.encode()) > _longest:
        raise ValueError("is too long for a unit")
    rest, unit = text.strip(" \t"), Unit()
    sign = -1 if rest.startswith("/") else 1
    rest = rest[1:].lstrip(" \t") if sign < 0 else rest
    first = sign > 0
    while rest or not first:
        match = _symbol.match(rest)
        if match is None:
            raise ValueError(f'"{text}" is not a unit')
        factor = _find(match.group())
        if factor is None:
            raise ValueError(f'"{match.group()}" is not a unit{_unit_meant(match.group())}')
        rest, power = rest[match.end():].lstrip(" \t"), Fraction(1)
        if rest.startswith("^"):
            exponent = re.match(r"[ \t]*([-+]?)([0-9.]*)", rest[1:])
            number = re.fullmatch(r"[0-9]+\.?[0-9]*|\.[0-9]+", exponent.group(2)) if exponent else None
            power = Fraction(number.group().rstrip(".")) if number else Fraction(10)
            if exponent is None or power > 9 or (1000 * power).denominator != 1:
                raise ValueError(f'the exponent of {match.group()} in "{text}" cannot be read')
            power = -power if exponent.group(1) == "-" else power
            rest = rest[1 + exponent.end():].lstrip(" \t")
        unit = unit.times(factor, sign * power)
        if not rest:
            break
        sign, first = 1, True
        if rest[0] in "/*·":
            sign, first = (-1 if rest[0] == "/" else 1), rest[0] == "·"
            rest = rest[1:].lstrip(" \t")
    return unit


def parse_quantity(text: str) -> tuple[str, str]:
    """Number and unit of "50 Pa"; of a sum of times its seconds. ValueError says what is wrong with it."""
    if len(text.encode()) > _longest:
        raise ValueError("is too long for a number with a unit")
    text = text.strip(" \t")
    match = _number.match(text)
    if match is None:
        raise ValueError("is not a number with a unit")
    number, unit = match.group(), text[match.end():]
    if re.match(r",[0-9]", unit):
        raise ValueError(f'has a comma; did you mean "{number}.{unit[1:]}"?')
    seconds = _sum_of_times(text)
    return (seconds, "s") if seconds else (number, unit.lstrip(" \t"))


def _sum_of_times(text: str) -> str | None:
    terms = re.findall(rf"({_number.pattern})[ \t]*([A-Za-z]+)[ \t]*", text)
    joined = re.fullmatch(rf"(?:(?!-){_number.pattern}[ \t]*[A-Za-z]+[ \t]*){{2,}}", text)
    units = [_find(name) for _, name in terms]
    if joined is None or len(terms) < 2 or any(unit is None or unit.dimension != _hour.dimension for unit in units):
        return None
    numbers = [exact(number) for number, _ in terms]
    if any(isinstance(number, float) and math.isinf(number) for number in numbers):
        raise ValueError("is too large a number")
    return number_text(float(sum(number * unit.scale() for number, unit in zip(numbers, units, strict=True) if unit)))


def exact(number: str) -> Fraction | float:
    """The value of a decimal, unless its exponent is beyond any double."""
    value = float(number)
    return Fraction(number) if 1e-300 < abs(value) < 1e300 else value
