"""The parameters of a scenario, from the JSON schema that the program writes, and what is allowed for each."""
from __future__ import annotations

import functools
import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..base.arguments import type_words
from ..base.load_core import core

Value = str | int | float | bool  #: of a parameter, as it is typed

_description = re.compile(r"(?P<meaning>.*); (?P<allowed>[^;]*)\. Default: (?P<source>.*?)\."
                          r"(?: A bare number is in (?P<unit>[^;]*?)(?P<angle>;.*)?\.)?")


@dataclass(frozen=True)
class Parameter:
    """A parameter of a scenario: name, unit, range, default and meaning."""

    path: str  #: "ecm.youngs_modulus"
    kind: str  #: "quantity", "angle", "ratio", "integer", "boolean", "choice", "field", "law" or "constants"
    meaning: str
    symbol: str  #: of the paper; may be empty
    allowed: str  #: in words: "> 0 and <= 1e7 Pa"
    unit: str  #: of a bare number; "1" of ratios, empty of flags and choices
    default: Value
    source: str  #: where the default is from
    choices: tuple[str, ...]
    before: Value | None = None  #: what stands for files that were written when there was no such parameter

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
        return judge(self.path, value)[1] if isinstance(value, str) else float(value)

    def fault(self, value: Any) -> str:
        """The fault of a value, in the words of the program; empty for a good value."""
        return judge(self.path, value)[0]


def plain(value: Any) -> Any:
    """Numbers of numpy as numbers of Python."""
    return value.item() if type(value).__module__ == "numpy" and getattr(value, "ndim", 1) == 0 else value


def toml_text(value: Any) -> str:
    """A value as it stands in a scenario file.

    >>> print(toml_text("200 Pa"), toml_text(0.45), toml_text(True), toml_text({"n": [1, 2]}))
    "200 Pa" 0.45 true { n = [1, 2] }
    """
    if isinstance(value, Mapping):
        pairs = ((key if re.fullmatch(r"\w+", key, re.ASCII) else toml_text(key), one) for key, one in value.items())
        return f"{{ {', '.join(f'{key} = {toml_text(one)}' for key, one in pairs)} }}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(toml_text, value))}]"
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
    number = plain(value)
    return repr(number) if isinstance(number, (int, float)) else toml_text(str(value))


def _parameter(path: str, entry: dict[str, Any]) -> Parameter:
    text = _description.fullmatch(entry["description"])
    if text is None:
        raise AssertionError(f"{path}: a description of another form")
    number: dict[str, Any] = next((e for e in entry.get("anyOf", [entry])
                                   if e.get("type") in ("number", "integer")), {})
    kind = ("choice" if "enum" in entry else "boolean" if entry.get("type") == "boolean" else
            "law" if "x-law" in entry else "constants" if "object" in entry.get("type", "") else
            "field" if entry.get("type") == "string" else
            "integer" if number["type"] == "integer" else "ratio" if "anyOf" not in entry else
            "angle" if text["angle"] else "quantity")
    symbol = re.search(r" \(([^()\s]+)\)$", text["meaning"])
    unit = text["unit"] or ("1" if kind in ("ratio", "integer") else "")
    return Parameter(path, kind, text["meaning"], symbol.group(1) if symbol else "", text["allowed"], unit,
                     entry["default"], text["source"], tuple(entry.get("enum", ())), entry.get("x-before"))


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


def gone() -> dict[str, dict[str, Any]]:
    """Parameters that earlier versions had, by their path: the value that is ``left``, and the ``fate`` of the others, which stand for {}."""
    return dict(_document()["x-gone"])


def _section_entries() -> list[tuple[str, dict[str, Any]]]:
    """Sections and what the schema says of them, those inside of others ("ecm.fields") after these."""
    found: list[tuple[str, dict[str, Any]]] = []
    for name, entry in _document()["properties"].items():
        if entry["type"] != "object":  # [[cells]], version
            continue
        found.append((name, entry))
        found += [(f"{name}.{inner}", table) for inner, table in entry["properties"].items()
                  if table.get("type") == "object"]
    return found


@functools.cache
def _document() -> dict[str, Any]:
    return dict(table("scenario.schema.json"))


def table(name: str) -> Any:
    """A table that the program wrote, or that the pages have as well: of an installed package, or of the source tree."""
    folder = Path(__file__).parents[1]
    places = (folder / name, folder.parents[1] / "docs" / name, folder.parents[1] / "viewer" / "src" / name)
    return json.loads(next(place for place in places if place.exists()).read_text(encoding="utf-8"))


def judge(path: str, value: Any) -> tuple[str, float]:
    """What is wrong with the value of a parameter, in the words of the program, and nothing of a good one; and the value in the documented unit.

    :raises CoreNotFound: without the compiled module
    """
    words = "a number beyond 64 bits" if isinstance(value, int) else type_words(value)
    fault, number = core().judged(path, value.encode("utf-8", "replace").decode() if isinstance(value, str) else value, words)
    return fault, number
