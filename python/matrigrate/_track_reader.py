"""The reader of tracks, which is the program's: arguments as its options, its faults in the words of Python."""
from __future__ import annotations

import json
import math
import numbers
import os
import re
from collections.abc import Mapping
from typing import Any

from . import _arguments, _program
from .errors import ConfigurationError, Fault, InputOutputError

_names = {"interval": "frame_interval", "time-unit": "time_unit"}
_option = re.compile(r"--(?P<name>pixel|interval|time-unit|columns|layout|splits|jitter|recalibrate|shortest|fewest)\b"
                     r'(?: (?:"(?P<columns>[^"]+)"|(?P<word>refuse|cut|drop|ms|s|min|h|d)\b|(?P<value>[A-Z]+\b(?![=:])|[\d.]*\d)))?')


def read(file: str | os.PathLike[str], options: Mapping[str, Any]) -> dict[str, Any]:
    """What ``matrigrate tracks --json`` finds in a file: see ``docs/how-to/tracks.md``.

    :param options: by their names, with _ for -; None where one is not given
    :raises ConfigurationError: with the faults of the file
    """
    path = _arguments.path("file", file, "the path of a file of tracks")
    words = [word for name, value in options.items() for word in _words(name, value)]
    if path.is_dir():
        raise InputOutputError(f"{path}: is a folder; tracks.of(matrigrate.load(...)) has the tracks of a run", path)
    outcome = _program.call(["tracks", os.fspath(path), "--json", "--resamples", "0", *words])
    if outcome.code == 2 and outcome.words.startswith("--"):
        raise ConfigurationError([Fault("", in_python(line)) for line in outcome.words.splitlines()])
    try:
        _program.raise_for(outcome, None)
    except ConfigurationError as error:
        raise ConfigurationError([Fault(one.key, in_python(one.message), one.file, one.line, one.column)
                                  for one in error.faults]) from None
    return dict(json.loads(outcome.out))


def in_python(message: str) -> str:
    """A message of the program with the arguments of ``matrigrate.tracks.read`` for its options.

    >>> in_python('give --interval S, or --splits cut, or --columns "track=NAME,t=2"; see --jitter')
    'give frame_interval=S, or splits="cut", or columns={"track": "NAME", "t": 2}; see jitter'
    """
    def argument(match: re.Match[str]) -> str:
        name = _names.get(match["name"], match["name"])
        if match["columns"]:
            pairs = [pair.split("=", 1) for pair in match["columns"].split(",")]
            return f"{name}={{{', '.join(f'{json.dumps(key)}: {of if of.isdigit() else json.dumps(of)}' for key, of in pairs)}}}"
        if name == "recalibrate":
            return "recalibrate=True" + (f" {match['value']}" if match["value"] else "")
        if match["word"]:
            return f'{name}="{match["word"]}"'
        return f"{name}={match['value']}" if match["value"] else name
    return _option.sub(argument, message)


def _words(name: str, value: Any) -> list[str]:
    """An argument as words of the command line. :raises TypeError: of a wrong type"""
    option = "--" + name.replace("_", "-")
    if name in ("recalibrate", "drift"):
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
