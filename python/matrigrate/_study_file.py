"""A study file of given points, like another study."""
from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from . import _program, _schema
from ._files import read_text
from .errors import ConfigurationError, InputOutputError
from .studies import Study

if TYPE_CHECKING:
    import pandas

_of_its_points = ("points", "claims", "statistics", "sweep", "latin_hypercube")  # sections
_section = re.compile(r"^\[+\s*\"?([a-z_]+)", re.MULTILINE)


def write_points(file: Path, points: pandas.DataFrame, like: Study | str | os.PathLike[str], keys: Mapping[str, str]) -> None:
    """:param like: the study, or its file, from which all but the points is taken
    :param keys: of parameters by the columns of points, where these are no columns of tables of a study
    :raises ConfigurationError: with all that is wrong with the file; it is not kept then
    :raises InputOutputError: if the file is there already
    """
    source = like.folder / "study.resolved.toml" if isinstance(like, Study) else Path(like)
    named = {column: keys.get(column) or key_of(column) for column in points}
    named = {column: key if key in _schema.parameters() else "" for column, key in named.items()}
    if unknown := [f"{column}: is no parameter; keys={{\"{column}\": \"ecm.youngs_modulus\"}} names the one that is meant"
                   for column, key in named.items() if not key]:
        raise ConfigurationError("\n".join(unknown))
    text = _without_points(read_text(source), source.parent, file.parent)
    first = _next_wave(text)
    for k, row in enumerate(points.to_dict("records"), 1):
        text += f"\n[[points]]\nlabel = \"wave {first}, point {k}\"\n"
        text += "".join(f"{named[column]} = {_value(named[column], value)}\n" for column, value in row.items())
    try:
        with file.open("x", encoding="utf-8") as out:
            out.write(text)
    except FileExistsError:
        raise InputOutputError(f"{file}: exists already; give another name", file) from None
    except OSError as error:
        raise InputOutputError(f"{file}: {error.strerror}", file) from None
    try:
        _program.check(file)
    except ConfigurationError:
        file.unlink()
        raise


def _next_wave(text: str) -> int:
    """One more than the number that ``_without_points`` put at the head."""
    return max((int(number) for number in re.findall(r"^# after wave (\d+)$", text, re.MULTILINE)), default=1) + 1


def key_of(column: str) -> str:
    """The path of a parameter, from the column of a table of a study, which may end in a unit; empty if there is none."""
    return max((path for path in _schema.parameters() if column == path or column.startswith(f"{path}_")), key=len, default="")


def _value(key: str, value: float) -> str:
    parameter = _schema.parameters()[key]
    if parameter.kind == "integer":
        return str(round(value))
    return f"{value:.6g}" if parameter.unit in ("", "1") else f"\"{value:.6g} {parameter.unit}\""


def _without_points(text: str, here: Path, there: Path) -> str:
    """The text of a study without its points, and without what names them; a scenario beside it is named from the new place."""
    document: dict[str, Any] = tomllib.loads(text)
    starts = [*(found.start() for found in _section.finditer(text)), len(text)]
    parts = [text[:starts[0]]]
    for start, end in zip(starts, starts[1:], strict=False):
        name = _section.match(text, start)
        if name is not None and name[1] not in _of_its_points:
            parts.append(text[start:end])
    head = re.sub(r"^#.*\n", "", parts[0], flags=re.MULTILINE)
    if "scenario" in document:
        place = os.path.relpath(here / document["scenario"], there)
        head = re.sub(r"^scenario\s*=.*$", lambda _: f"scenario = {_schema.toml_text(place)}", head, flags=re.MULTILINE)
    waves = [int(number) for number in re.findall(r"^label = \"wave (\d+), point", text, re.MULTILINE)]
    return f"# after wave {max(waves, default=1)}\n" + head + "".join(parts[1:]).rstrip() + "\n"
