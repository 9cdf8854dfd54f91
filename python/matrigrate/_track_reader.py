"""The reader of tracks, which is the program's: arguments as its options."""
from __future__ import annotations

import json
import math
import numbers
import os
from collections.abc import Mapping
from typing import Any

from . import _arguments, _program
from .errors import ConfigurationError, Fault, InputOutputError

def read(file: str | os.PathLike[str], options: Mapping[str, Any]) -> dict[str, Any]:
    """What ``matrigrate tracks --json`` finds in a file: see ``docs/how-to/tracks.md``.

    :param options: by their names, with _ for -; None where one is not given
    :raises ConfigurationError: with the faults of the file
    """
    path = _arguments.path("file", file, "the path of a file of tracks")
    words = [word for name, value in options.items() for word in _words(name, value)]
    if path.is_dir():
        raise InputOutputError(f"{path}: is a folder; tracks.of(matrigrate.load(...)) has the tracks of a run", path)
    outcome = _program.call(["tracks", os.fspath(path), "--json", "--resamples", "0", "--words", "python", *words])
    if outcome.code == 2:
        raise ConfigurationError([Fault("", line) for line in outcome.words.splitlines()])
    _program.raise_for(outcome, None)
    return dict(json.loads(outcome.out))


def _words(name: str, value: Any) -> list[str]:
    """An argument as words of the command line. :raises TypeError: of a wrong type"""
    option = "--" + name.replace("_", "-")
    if name == "drift":
        return [option] if _arguments.one_of(name, value, bool) else []
    if value is None:
        return []
    if name == "columns":
        return [word for key, column in _arguments.mapping(name, value, "a dictionary of columns").items()
                for one in (column if isinstance(column, (list, tuple)) else [column]) for word in (option, f"{key}={_column(key, one)}")]
    if name in ("time_unit", "layout", "splits"):
        return [option, _arguments.text(name, value)]
    return [option, _number(name, value, whole=name in ("shortest", "fewest"))]


def _column(key: str, value: Any) -> str:
    """A column by its name, by its number, or none."""
    if value is None:
        return "none"
    if isinstance(value, bool) or not isinstance(value, (str, numbers.Integral)):
        raise _arguments.wrong(f"columns[{key!r}]", value, "the name of a column, or its number from 1,")
    return str(value)


def _number(name: str, value: Any, whole: bool) -> str:
    try:
        number = float("nan") if isinstance(value, (bool, str)) else float(value)
    except (TypeError, ValueError):
        number = float("nan")
    if isinstance(value, (bool, str)) or (math.isnan(number) and not isinstance(value, float)):
        raise _arguments.wrong(name, value, "a whole number" if whole else "a number")
    if whole and (not math.isfinite(number) or number != math.floor(number) or number < 1):
        raise ConfigurationError(f"{name}: {value} is no whole number of at least 1")
    if not whole and not (math.isfinite(number) and (number > 0 or name == "jitter" and number == 0)):
        raise ConfigurationError(f"{name}: {number:g} is no positive number")
    return str(int(number)) if whole else repr(number)
