"""Tables and JSON files of the program, checked as they are read."""
from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import InputOutputError
from .load_core import library

if TYPE_CHECKING:
    import pandas

_units = {"um_per_h": "um/h", "um_per_s": "um/s", "nm_per_s": "nm/s", "um2_per_s": "um^2/s", "N_s_per_m": "N s/m", "N_per_m": "N/m",
          "N_per_m2": "N/m^2", "N_per_m1.5": "N/m^1.5", "per_s": "1/s", "per_nN": "1/nN", "per_um": "1/um", "N_m": "N m",
          "nN_um2": "nN um^2", "Pa_s": "Pa s", "um2": "um^2", "um": "um", "min": "min", "s": "s", "nN": "nN", "Pa": "Pa",
          "rad": "rad", "deg": "deg"}
_guarded = re.compile(r"\A'(?=[=+\-@\t\r\n])")


def unit_of(column: str) -> str:
    """The unit that stands in the name of a column or read-out; "1" if none does.

    >>> unit_of("v_migr_abs_um_per_h"), unit_of("n_protrusions"), unit_of("polarization.rate_per_s")
    ('um/h', '1', '1/s')
    """
    return _units.get(unit_suffix(column), "1")


def unit_suffix(column: str) -> str:
    """"um_per_h" of "v_migr_abs_um_per_h"; "" where there is no unit."""
    return next((suffix for suffix in _units if column.endswith("_" + suffix)), "")


def write_report(path: Path, overwrite: bool, page: str, tables: Mapping[str, pandas.DataFrame]) -> Path:
    """Writes report.html, whose path is returned, and tables as CSV files into a folder.

    :param overwrite: whether the folder may be there already
    :raises InputOutputError: if it is there and may not, or cannot be made
    """
    try:
        path.mkdir(parents=True, exist_ok=overwrite)
    except FileExistsError:
        said = "is no folder" if not path.is_dir() else "exists already; give a new folder, or overwrite=True"
        raise InputOutputError(f"{path}: {said}", path) from None
    except OSError as error:
        raise InputOutputError(f"{path}: {error.strerror}", path) from None
    for name, table in tables.items():
        table.to_csv(path / f"{name}.csv", index=False)
    (path / "report.html").write_text(page, encoding="utf-8")
    return path / "report.html"


def require_regular(path: Path) -> None:
    """:raises InputOutputError: of a device or pipe, which may have no end"""
    if path.exists() and not path.is_file() and not path.is_dir():
        raise InputOutputError(f"{path}: cannot be read: it is no regular file", path.parent)


def read_text(path: Path) -> str:
    require_regular(path)
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise InputOutputError(f"{path}: is damaged: it is no text", path.parent) from None
    except OSError as error:
        raise InputOutputError(f"{path}: cannot be read: {error.strerror}", path.parent) from None


def read_json(path: Path) -> dict[str, Any]:
    try:
        document = json.loads(read_text(path))
    except ValueError as error:
        raise InputOutputError(f"{path}: is damaged: it is no JSON: {error}", path.parent) from None
    if not isinstance(document, dict):
        raise InputOutputError(f"{path}: is damaged: it holds no object", path.parent)
    return document


def read_table(path: Path, *, texts: Collection[str] = (), strict: bool = True,
               unfinished: bool = False) -> pandas.DataFrame:
    """A CSV file; ``attrs["units"]`` holds the unit of each column.

    :param texts: the columns that are no numbers
    :param strict: whether all others are; if not, those that hold anything else are texts as well
    :param unfinished: whether its last row may be cut short, because it is being written
    """
    pandas = require_pandas()
    text = read_text(path)
    if unfinished and not text.endswith("\n"):
        text = text[:text.rfind("\n") + 1]
    rows = list(csv.reader(io.StringIO(text)))
    if not rows or not text.endswith("\n"):
        raise InputOutputError(f"{path}: is damaged: it {'is cut short' if rows else 'is empty'}", path.parent)
    for number, row in enumerate(rows, 1):
        if len(row) != len(rows[0]):
            raise InputOutputError(f"{path}: is damaged: row {number} has {len(row)} fields, its header "
                                   f"{len(rows[0])}", path.parent)
    table = pandas.DataFrame({name: _column(path, name, [row[k] for row in rows[1:]], name in texts, strict)
                              for k, name in enumerate(rows[0])})
    table.attrs["units"] = {name: unit_of(name) for name in table.columns}
    return table


def _column(path: Path, name: str, values: list[str], is_text: bool, strict: bool) -> Any:
    """Numbers, whole ones where all are; or texts, as they were before they were guarded against spreadsheets."""
    pandas = require_pandas()
    if not is_text:
        try:
            if values and all(re.fullmatch(r"-?\d{1,18}", value) for value in values):
                return pandas.Series([int(value) for value in values], dtype="int64")
            return pandas.Series([float(value) if value else float("nan") for value in values], dtype="float64")
        except ValueError as error:
            if strict:
                raise InputOutputError(f"{path}: is damaged: column {name}: {error}", path.parent) from None
    return pandas.Series([_guarded.sub("", value) for value in values], dtype="object")


def require_pandas() -> Any:
    return library("pandas", "tables need pandas")
