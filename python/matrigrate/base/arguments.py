"""Checks of arguments: an argument of a wrong type raises a TypeError that names it."""
from __future__ import annotations

import datetime
import math
import numbers
import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any


def wrong(name: str, value: Any, expected: str) -> TypeError:
    """The exception for an argument of a wrong type.

    >>> print(wrong("folder", 3, "a path"))
    folder is a number; a path is expected
    """
    return TypeError(f"{name} is {type_words(value)}; {expected} is expected")


def path(name: str, value: Any, expected: str = "a path") -> Path:
    """A path. :raises TypeError: if it is none"""
    if not isinstance(value, (str, os.PathLike)):
        raise wrong(name, value, expected)
    return Path(value)


def text(name: str, value: Any, expected: str = "a text") -> str:
    """A text. :raises TypeError: if it is none"""
    if not isinstance(value, str):
        raise wrong(name, value, expected)
    return value


def mapping(name: str, value: Any, expected: str = "a dictionary of parameters") -> Mapping[str, Any]:
    """A dictionary, empty for None. :raises TypeError: if it is none"""
    if value is not None and not isinstance(value, Mapping):
        raise wrong(name, value, expected)
    return value or {}


def one_of(name: str, value: Any, *types: type) -> Any:
    """The value, if it has one of the types. :raises TypeError: if it has none of them"""
    if not isinstance(value, types):
        raise wrong(name, value, " or ".join(f"a {one.__name__}" for one in types))
    return value


def is_number(value: Any) -> bool:
    """Whether it is a finite number, also one of numpy."""
    return isinstance(value, numbers.Real) and not isinstance(value, bool) and math.isfinite(value)


def function(name: str, value: Any) -> None:
    """Checks that a value is a function or None. :raises TypeError: if the value is neither"""
    if value is not None and not callable(value):
        raise wrong(name, value, "a function")


def type_words(value: Any) -> str:
    if isinstance(value, bool):
        return "a flag"
    kinds: list[tuple[Any, str]] = [(str, "a string"), ((int, float), "a number"), (dict, "a table"),
                                    ((list, tuple), "an array"),
                                    ((datetime.date, datetime.time, datetime.timedelta), "a date or time")]
    return next((words for kind, words in kinds if isinstance(value, kind)), f"of the type {type(value).__name__}")
