"""The arguments of the reader of tracks, which is the program's (src/tracks), by the compiled module."""
from __future__ import annotations

import math
import numbers
import os
from collections.abc import Mapping
from typing import Any

from ..base import arguments
from ..base.load_core import core
from ..errors import ConfigurationError, InputOutputError


class Text(str):
    """A table in memory, in the place of a file."""


def read(file: str | os.PathLike[str], options: Mapping[str, Any]) -> tuple[Any, ...]:
    """Interval, notes, names, starts and positions of the tracks in a file.

    :param options: of the program, by their names, with _ for -; None where one is not given
    :raises ConfigurationError: with the faults of the file
    """
    given = {name: _checked(name, value) for name, value in options.items() if value is not None or name == "drift"}
    if isinstance(file, Text):
        return tuple(core().read_tracks("the data frame", file, given))
    path = arguments.path("file", file, "the path of a file of tracks")
    if path.is_dir():
        raise InputOutputError(f"{path}: is a folder; tracks.of(matrigrate.load(...)) has the tracks of a run", path)
    return tuple(core().read_tracks(os.fsencode(path), None, given))


def _checked(name: str, value: Any) -> Any:
    """An argument as the module takes it. :raises TypeError: of a wrong type"""
    if name == "drift":
        return arguments.one_of(name, value, bool)
    if name == "columns":
        return [f"{key}={_column(key, one)}" for key, column in arguments.mapping(name, value, "a dictionary of columns").items()
                for one in (column if isinstance(column, (list, tuple)) else [column])]
    if name in ("time_unit", "layout", "splits"):
        return arguments.text(name, value)
    return _number(name, value, whole=name in ("shortest", "fewest"))


def _column(key: str, value: Any) -> str:
    """A column by its name, by its number, or none."""
    if value is None:
        return "none"
    if isinstance(value, bool) or not isinstance(value, (str, numbers.Integral)):
        raise arguments.wrong(f"columns[{key!r}]", value, "the name of a column, or its number from 1,")
    return str(value)


def _number(name: str, value: Any, whole: bool) -> float:
    try:
        number = float("nan") if isinstance(value, (bool, str)) else float(value)
    except (TypeError, ValueError):
        number = float("nan")
    if isinstance(value, (bool, str)) or (math.isnan(number) and not isinstance(value, float)):
        raise arguments.wrong(name, value, "a whole number" if whole else "a number")
    if whole and (not math.isfinite(number) or number != math.floor(number) or number < 1):
        raise ConfigurationError(f"{name}: {value} is no whole number of at least 1")
    if not whole and not (math.isfinite(number) and (number > 0 or name == "jitter" and number == 0)):
        raise ConfigurationError(f"{name}: {number:g} is no positive number")
    return int(number) if whole else number
