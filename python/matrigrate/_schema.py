"""The parameters of a scenario, from the JSON schema that the program writes, and what is allowed for each."""
from __future__ import annotations

import datetime
import functools
import json
import math
import operator
import re
from dataclasses import dataclass
from fractions import Fraction
from importlib import resources
from typing import Any

from ._names import did_you_mean, nearest, nearest_parameter
from ._units import dimension_words, exact, number_text, parse_quantity, parse_unit

Value = str | int | float | bool  #: of a parameter, as it is typed

_description = re.compile(r"(?P<meaning>.*); (?P<allowed>[^;]*)\. Default: (?P<source>.*?)\."
                          r"(?: A bare number is in (?P<unit>[^;]*?)(?P<angle>;.*)?\.)?")
_bounds = {"minimum": operator.ge, "exclusiveMinimum": operator.gt, "maximum": operator.le,
           "exclusiveMaximum": operator.lt}


@dataclass(frozen=True)
class Parameter:
    """A parameter of a scenario: name, unit, range, default and meaning."""

    path: str  #: "ecm.youngs_modulus"
    kind: str  #: "quantity", "angle", "ratio", "integer", "boolean", "choice" or "field"
    meaning: str
    symbol: str  #: of the paper; may be empty
    allowed: str  #: in words: "> 0 and <= 1e7 Pa"
    unit: str  #: of a bare number; "1" of ratios, empty of flags and choices
    default: Value
    source: str  #: where the default is from
    bounds: dict[str, float]
    choices: tuple[str, ...]

    @property
    def key(self) -> str:
        return self.path.rsplit(".", 1)[1]

    @property
    def example(self) -> str:
        """The default as it stands in a file."""
        return toml_text(self.default)

    def number(self, value: Value) -> Value:
        """A value that is allowed, as a number in the documented unit; choices and flags as they are."""
        if self.kind not in ("quantity", "angle", "ratio"):
            return value
        return float(self._real(value)[0])

    def fault(self, value: Any) -> str:
        """What is wrong with a value, in the words of the program; empty if nothing is."""
        if self.kind == "boolean":
            return "" if isinstance(value, bool) else f"is {type_words(value)}; write {self.allowed}, without quotes"
        if self.kind == "choice":
            return self._choice_fault(value)
        if self.kind == "field":  # what stands in it, the program judges
            return "" if isinstance(value, str) else f"is {type_words(value)}; write {self.allowed}, in quotes"
        if self.kind == "integer":
            return self._whole_fault(value)
        try:
            number, shown = self._real(value)
        except ValueError as error:
            return str(error)
        return "" if self._within(number) else self._out_of_range(shown)

    def _choice_fault(self, value: Any) -> str:
        if not isinstance(value, str):
            return f"is {type_words(value)}; write {self.allowed}"
        if value in self.choices:
            return ""
        return f'"{excerpt(value)}" is not known; allowed is {self.allowed}{did_you_mean(nearest(value, self.choices))}'

    def _whole_fault(self, value: Any) -> str:
        if isinstance(value, float):
            return f"has a decimal point or an exponent; write a whole number, such as {self.example}"
        if isinstance(value, str):
            return f"is a string; write a whole number without quotes, such as {self.example}"
        if isinstance(value, bool) or not isinstance(value, int):
            return self._wrong_type(value)
        return "" if self._within(value) else self._out_of_range(str(value))

    def _wrong_type(self, value: Any) -> str:
        expected = "a number with its unit" if self.kind == "quantity" else "a number without quotes"
        return f"is {type_words(value)}, but {expected} is expected, such as {self.example}"

    def _out_of_range(self, shown: str) -> str:
        return f"{shown} is out of range; allowed is {self.allowed}{' ' + self.unit if self.kind == 'angle' else ''}"

    def _within(self, number: Fraction | float) -> bool:
        return all(_bounds[name](number, Fraction(repr(bound))) for name, bound in self.bounds.items())

    def _real(self, value: Any) -> tuple[Fraction | float, str]:
        """In the documented unit, and as it was typed. ValueError says what is wrong with it."""
        if isinstance(value, str):
            return self._typed(value)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ValueError(self._wrong_type(value))
        if not math.isfinite(value):
            raise ValueError(f"{number_text(value)} is not a finite number")
        text = number_text(value)
        return Fraction(text), text if self.unit == "1" else f"{text} {self.unit}"

    def _typed(self, text: str) -> tuple[Fraction | float, str]:
        if self.kind == "ratio":
            raise ValueError(f"is a string; write a bare number without quotes, such as {self.example}")
        shown = f'"{excerpt(text)}"'
        such = "write it like " + ('"30 deg"' if self.kind == "angle" else self.example)
        try:
            number, unit_text = parse_quantity(text)
            unit = parse_unit(unit_text)
        except ValueError as error:
            what = str(error)
            if what.startswith("has a comma"):
                raise ValueError(f"{shown} {what}") from None
            joint = ": " if what.startswith(('"', "the ")) else " "
            advice = "" if what.endswith("?") else f"; {such}"  # it has its own
            raise ValueError(f"{shown}{joint}{excerpt(what, 120)}{advice}") from None
        if not unit_text:
            raise ValueError(f"{shown} has no unit; {such}, or as a bare number in {self.unit}")
        own = parse_unit(self.unit)
        if unit.dimension != own.dimension:
            raise ValueError(f"{shown} is {dimension_words(unit)}, but {dimension_words(own)} is expected; {such}")
        if unit == own:
            return exact(number), shown
        ratio = unit.times(own, Fraction(-1)).scale()
        return exact(number) * ratio, shown


def excerpt(text: str, most: int = 60) -> str:
    shown = "".join("?" if (ord(c) < 32 and c != "\t") or ord(c) == 127 else c for c in text[:most])
    return shown + ("..." if len(text) > most else "")


def type_words(value: Any) -> str:
    if isinstance(value, bool):
        return "a flag"
    kinds: list[tuple[Any, str]] = [(str, "a string"), ((int, float), "a number"), (dict, "a table"),
                                    ((list, tuple), "an array"),
                                    ((datetime.date, datetime.time, datetime.timedelta), "a date or time")]
    return next((words for kind, words in kinds if isinstance(value, kind)), f"of the type {type(value).__name__}")


def toml_text(value: Value) -> str:
    """A value as it stands in a scenario file.

    >>> print(toml_text("200 Pa"), toml_text(0.45), toml_text(True))
    "200 Pa" 0.45 true
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    return number_text(value) if isinstance(value, int) else repr(value)


def _parameter(path: str, entry: dict[str, Any]) -> Parameter:
    text = _description.fullmatch(entry["description"])
    if text is None:
        raise AssertionError(f"{path}: a description of another form")
    number: dict[str, Any] = next((e for e in entry.get("anyOf", [entry])
                                   if e.get("type") in ("number", "integer")), {})
    kind = ("choice" if "enum" in entry else "boolean" if entry.get("type") == "boolean" else
            "field" if entry.get("type") == "string" else
            "integer" if number["type"] == "integer" else "ratio" if "anyOf" not in entry else
            "angle" if text["angle"] else "quantity")
    symbol = re.search(r" \(([^()\s]+)\)$", text["meaning"])
    unit = text["unit"] or ("1" if kind in ("ratio", "integer") else "")
    bounds = {name: number[name] for name in _bounds if name in number}
    return Parameter(path, kind, text["meaning"], symbol.group(1) if symbol else "", text["allowed"], unit,
                     entry["default"], text["source"], bounds, tuple(entry.get("enum", ())))


@functools.cache
def sections() -> dict[str, str]:
    """Each section and what it is about."""
    return {name: entry["description"] for name, entry in _section_entries()}


@functools.cache
def parameters() -> dict[str, Parameter]:
    """All parameters by their path, in the order of the file."""
    return {f"{section}.{key}": _parameter(f"{section}.{key}", entry)
            for section, table in _section_entries() for key, entry in table["properties"].items()
            if entry.get("type") != "object"}


@functools.cache
def cell_parameters() -> dict[str, Parameter]:
    """The keys of one table of [[cells]]."""
    entries = _document()["properties"]["cells"]["items"]["properties"]
    return {key: _parameter(f"cells.{key}", entry) for key, entry in entries.items()}


def _section_entries() -> list[tuple[str, dict[str, Any]]]:
    """Sections and what the schema says of them, those inside of others ("ecm.fields") after these."""
    found: list[tuple[str, dict[str, Any]]] = []
    for name, entry in _document()["properties"].items():
        if entry["type"] == "array":  # [[cells]]
            continue
        found.append((name, entry))
        found += [(f"{name}.{inner}", table) for inner, table in entry["properties"].items()
                  if table.get("type") == "object"]
    return found


@functools.cache
def _document() -> dict[str, Any]:
    text = resources.files(__package__).joinpath("scenario.schema.json").read_text(encoding="utf-8")
    document: dict[str, Any] = json.loads(text)
    return document


def unknown_words(path: str, is_section: bool = False) -> str:
    """What is said of a name that nothing has."""
    symbols = {name: parameter.symbol for name, parameter in parameters().items()}
    kind = "section" if is_section else "parameter"
    return f"there is no such {kind}{did_you_mean(nearest_parameter(path, symbols, sections()))}"
