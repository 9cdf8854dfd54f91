"""A study file of given points, like another study."""
from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..base import arguments, program
from ..base.files import read_text
from ..draw import words
from ..errors import InputOutputError, refuse
from ..results.studies import Study
from ..scenario import constants, schema

if TYPE_CHECKING:
    import pandas

_of_its_points = ("points", "claims", "statistics", "sweep", "latin_hypercube")  # sections
_section = re.compile(r"^\[+\s*\"?([a-z_]+)", re.MULTILINE)


def write_points(file: Path, points: pandas.DataFrame, like: Study | str | os.PathLike[str]) -> None:
    """:param like: the study, or its file, from which all but the points is taken
    :raises ConfigurationError: with all that is wrong with the file; it is not kept then
    :raises InputOutputError: if the file is there already
    """
    source = like.folder / "study.resolved.toml" if isinstance(like, Study) else arguments.path("like", like)
    text = read_text(source)
    varied = list(_varied(tomllib.loads(text)))
    named = {column: _parameter(column, varied) for column in points}
    refuse([f"{column}: is no parameter of the program; the next wave is written of a fit whose columns are named as in the tables of a study"
            for column, known in named.items() if known is None])
    text = _without_points(text, source.parent, file.parent)
    first = max((int(number) for number in re.findall(r"^# after wave (\d+)$", text, re.MULTILINE)), default=1) + 1  # at the head
    for k, row in enumerate(points.to_dict("records"), 1):
        text += f"\n[[points]]\nlabel = \"wave {first}, point {k}\"\n"
        text += "".join(f"{known.path} = {_value(known, row[column])}\n" for column, known in named.items() if known)
    try:
        with file.open("x", encoding="utf-8") as out:
            out.write(text)
    except FileExistsError:
        raise InputOutputError(f"{file}: exists already; give another name", file) from None
    except OSError as error:
        raise InputOutputError(f"{file}: {error.strerror}", file) from None
    try:
        program.check(file)
    except BaseException:
        file.unlink()
        raise


def _varied(table: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    """Paths of constants of the laws that a study names."""
    for key, value in table.items():
        path = f"{prefix}{key}"
        for inner in value if isinstance(value, list) else [value]:
            if isinstance(inner, Mapping):
                yield from _varied(inner, "" if path in (*_of_its_points, "set", "conditions") else f"{path}.")
        if constants.name_in(path):
            yield path


def _parameter(column: str, varied: Iterable[str]) -> schema.Parameter | None:
    """The parameter of a column. A bare number of a constant of the laws is in the unit of the column."""
    known = max((path for path in varied if column == path or column.startswith(f"{path}_")), key=len, default="")
    return schema.Parameter(known, "ratio", "", "", "", "1", 1.0, "", ()) if known else words.parameter_of(column)


def _value(parameter: schema.Parameter, value: float) -> str:
    if parameter.kind == "integer":
        return str(round(value))
    return f"{value:.6g}" if parameter.unit in ("", "1") else f"\"{value:.6g} {parameter.unit}\""


def _without_points(text: str, here: Path, there: Path) -> str:
    """The text of a study without its points, and without what names them; files beside it are named from the new place."""
    starts = [*(found.start() for found in _section.finditer(text)), len(text)]
    parts = [text[:starts[0]]]
    for start, end in zip(starts, starts[1:], strict=False):
        name = _section.match(text, start)
        if name is not None and name[1] not in _of_its_points:
            parts.append(text[start:end])
    kept = re.sub(r"^#.*\n", "", parts[0], flags=re.MULTILINE) + "".join(parts[1:]).rstrip() + "\n"
    kept = re.sub(r"^(scenario|tracks)\s*=.*$", lambda line: _from(there, here, line[0]), kept, flags=re.MULTILINE)
    waves = [int(number) for number in re.findall(r"^label = \"wave (\d+), point", text, re.MULTILINE)]
    return f"# after wave {max(waves, default=1)}\n" + kept


def _from(there: Path, here: Path, line: str) -> str:
    """A line that names a file from one folder, as it stands in another."""
    return "".join(f"{key} = {schema.toml_text(os.path.relpath(here / name, there))}" for key, name in tomllib.loads(line).items())
