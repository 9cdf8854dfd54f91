"""Folders of runs."""
from __future__ import annotations

import base64
import functools
import html
import io
import math
import os
import tomllib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, overload

import numpy as np

from ..base import arguments
from ..base.files import read_json, read_table, read_text, unit_of
from ..errors import InputOutputError
from ..scenario.schema import table
from .fields import Fields

if TYPE_CHECKING:
    import pandas

try:
    import fcntl
except ImportError:  # results can be read where the program does not run
    fcntl = None  # type: ignore[assignment]

try:
    import xxhash
except ImportError:
    xxhash = None


@functools.cache
def readout_table() -> dict[str, dict[str, Any]]:
    """The rows of docs/readouts.json by the names of read-outs."""
    return {entry["name"]: entry for entry in table("readouts.json")}


def meaning(readout: str) -> str:
    """The meaning of a read-out, in words.

    >>> meaning("tau_prot_min")
    'lifetime of a mature adhesion, mean'
    """
    return readout_table().get(readout, {}).get("meaning", readout)


class _Named(Mapping[Any, Any]):
    """What one cell and several have: values by the names of read-outs, with units and meanings."""

    @property
    def names(self) -> list[str]:
        return list(self)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name not in self.names:
            raise AttributeError(f"there is no read-out {name}")
        return self[name]

    def __dir__(self) -> list[str]:
        return [*self.names, "names", "unit", "meaning"]

    def unit(self, name: str) -> str:
        """The unit of a read-out, such as "um/h"; "1" of counts and ratios."""
        self[name]
        return unit_of(name)

    def meaning(self, name: str) -> str:
        """The meaning of a read-out, in words."""
        self[name]
        return meaning(name)

    def _lines(self) -> list[str]:
        """A line for each read-out; those of uniaxial fibres and of several cells only if a cell has a value."""
        lines = []
        for name in self.names:
            known, values = readout_table().get(name, {}), np.atleast_1d(self[name])
            if (known.get("of_uniaxial_fibres") or known.get("of_several_cells")) and all(map(math.isnan, values)):
                continue
            unit = unit_of(name) if unit_of(name) != "1" else ""
            lines.append(f"{name:<26}{''.join(f'{value:>12.4g}' for value in values)} {unit:<6} {meaning(name)}")
        return lines


class Readouts(dict[str, float], _Named):
    """The read-outs of a run by their names, also as attributes; NaN where one is not defined.

    >>> readouts = Readouts({"v_migr_abs_um_per_h": 5.25, "f_mat": None})
    >>> readouts.v_migr_abs_um_per_h
    5.25
    >>> readouts.unit("v_migr_abs_um_per_h"), readouts["f_mat"]
    ('um/h', nan)
    """

    def __init__(self, values: Mapping[str, Any]) -> None:
        arguments.mapping("values", values, "a dictionary of read-outs")
        super().__init__({name: math.nan if value is None else value for name, value in values.items()})

    def __repr__(self) -> str:
        return "\n".join(self._lines())


class ReadoutsOfCells(_Named):
    """The read-outs of a run of several cells: by the number of a cell, from 1, the read-outs of one cell; by the name of a
    read-out, also as an attribute, an array with its value of each cell in their order.

    >>> readouts = ReadoutsOfCells([{"cell": 1, "f_mat": 0.5}, {"cell": 2, "f_mat": None}])
    >>> readouts[1].f_mat, readouts.f_mat.tolist()
    (0.5, [0.5, nan])
    """

    def __init__(self, cells: Sequence[Mapping[str, Any]]) -> None:
        self._cells = {int(cell["cell"]): Readouts({name: value for name, value in cell.items() if name != "cell"})
                       for cell in cells}

    @overload
    def __getitem__(self, key: int) -> Readouts: ...
    @overload
    def __getitem__(self, key: str) -> np.ndarray[Any, Any]: ...

    def __getitem__(self, key: int | str) -> Any:
        if isinstance(key, str):
            return np.array([cell[key] for cell in self._cells.values()], dtype=float)
        if key not in self._cells:
            raise KeyError(f"{key}; the cells are {', '.join(map(str, self._cells))}")
        return self._cells[key]

    def __iter__(self) -> Iterator[int]:
        return iter(self._cells)

    def __len__(self) -> int:
        return len(self._cells)

    @property
    def names(self) -> list[str]:
        """The names of the read-outs."""
        return list(next(iter(self._cells.values()), {}))

    def __repr__(self) -> str:
        return "\n".join([" " * 26 + "".join(f"{f'cell {number}':>12}" for number in self._cells), *self._lines()])


class Run:
    """The folder of a run. Files are read when they are asked for, tables once.

    Of a run that is going on, was stopped or failed, there is what its files hold so far.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = arguments.path("folder", folder, "the path of a run")
        if not (self.folder / "run.json").is_file():
            why = "there is no such folder" if not self.folder.exists() else \
                "is a file; the folder of a run is expected" if not self.folder.is_dir() else \
                "is a study; matrigrate.load_study reads it" if (self.folder / "study.resolved.toml").exists() else \
                "is no folder of a run: it has no run.json"
            raise InputOutputError(f"{self.folder}: {why}", self.folder)
        self.record: dict[str, Any] = read_json(self.folder / "run.json")
        """run.json: version, seed, steps, wall_time_s, trajectory_hash, lineage and more, as when the run was loaded."""
        if not isinstance(self.record.get("status"), str):
            raise InputOutputError(f"{self.folder / 'run.json'}: is damaged: it has no status", self.folder)
        if not isinstance(self.record.get("seed", 0), int):
            raise InputOutputError(f"{self.folder / 'run.json'}: is damaged: its seed is no whole number", self.folder)

    def __repr__(self) -> str:
        reached = self.record.get("t_s") if self.record.get("exit_code") is not None else None  # else of a checkpoint
        until = f", {reached / 3600:.3g} h" if isinstance(reached, (int, float)) else ""
        return f"Run({str(self.folder)!r}: {self.status}{until}, seed {self.seed})"

    def _repr_html_(self) -> str:
        """In a notebook: the last frame of the run, where there are frames and matplotlib, and where its page is."""
        said = [f"<p>{html.escape(repr(self))}</p>"]
        page = self.folder / "report.html"
        if (self.folder / "fields.h5").is_file() and (picture := self._last_frame()):
            said.append(f'<img src="data:image/png;base64,{picture}">')
        if page.is_file():
            said.append(f'<p><a href="{html.escape(page.as_posix())}">its page</a>, with the player</p>')
        return "\n".join(said)

    def _last_frame(self) -> str:
        """A picture as base64; "" without matplotlib."""
        try:
            from matplotlib.figure import Figure
        except ImportError:
            return ""
        from .. import plot

        figure, file = Figure(figsize=(6.6, 5.6), layout="constrained"), io.BytesIO()
        plot.frame(self, axes=figure.subplots())
        figure.savefig(file, format="png")
        return base64.b64encode(file.getvalue()).decode()

    @property
    def status(self) -> str:
        """"done", "failed", "interrupted" (stopped with a checkpoint), "running", or "unfinished" (nothing works on it,
        and nobody asked it to stop: it was killed)."""
        status = str(self.record["status"])
        return "unfinished" if status == "running" and not self._is_worked_on() else status

    @property
    def reason(self) -> str:
        """Why it ended early, in the words of the program; empty if it did not."""
        return str(self.record.get("reason", ""))

    @property
    def cause(self) -> str | None:
        """Why the computation could not continue: "solver", "step_limit", "rim", "crossing", "nucleus_outside",
        "collapse", "solid_inside", "not_finite", "law" or "imbalance"; None if it did not end so."""
        cause = self.record.get("cause")
        return str(cause) if cause is not None else None

    @property
    def seed(self) -> int:
        return int(self.record.get("seed", 0))

    @property
    def trajectory_hash(self) -> str:
        """Fingerprint of all that the cell did: the same for the same bits; empty while the run goes on."""
        return str(self.record.get("trajectory_hash", ""))

    @functools.cached_property
    def tracks(self) -> pandas.DataFrame:
        """A row each minute, and of each cell: ``track`` (its number, from 1), ``t_s`` [s], ``x_um``, ``y_um`` [um], area,
        perimeter, polarization, protrusions. ``cells[2].tracks`` are the rows of cell 2."""
        return self._table("tracks.csv")

    @functools.cached_property
    def cells(self) -> CellsOfRun:
        """The cells by their numbers, from 1: ``cells[2]`` has tracks, protrusions, read-outs and outline of cell 2."""
        return CellsOfRun(self)

    @functools.cached_property
    def protrusions(self) -> pandas.DataFrame:
        """A row for each protrusion: times [s], length [um], maturation, force [nN], cause of its end."""
        return self._table("protrusions.csv", ["cause"])

    @functools.cached_property
    def health(self) -> pandas.DataFrame:
        """A row each minute: solver, balance of forces, area, density, solid inside the cell."""
        return self._table("health.csv")

    @functools.cached_property
    def msd(self) -> pandas.DataFrame:
        """Mean square displacement [um^2] over lags [s] of 10 min to half the run, of several cells for each ``cell``;
        written when the run ends."""
        return self._table("msd.csv")

    @functools.cached_property
    def group(self) -> pandas.DataFrame:
        """Collective measures of several cells, a row each minute: ``t_s`` [s], centroid and spread [um], speed
        [um/h], order, distances [um], contacts.

        :raises InputOutputError: of a run of one cell, which has none
        """
        if not (self.folder / "group.csv").exists():
            raise InputOutputError(f"{self.folder}: has no group.csv, which runs of several cells have", self.folder)
        return self._table("group.csv")

    @property
    def group_readouts(self) -> Readouts:
        """What several cells do together, with the names and values of ``results.csv`` of a study: ``parting_index``,
        ``share_in_contact``, ``nearest_um``, ``order``. Written when the run ends.

        :raises InputOutputError: of a run of one cell, which has none; of a run by version 0.2.0, whose summary.json lacks them
        """
        readouts = self.readouts
        if not isinstance(readouts, ReadoutsOfCells):
            raise InputOutputError(f"{self.folder}: has no read-outs of several cells: it is a run of one", self.folder)
        names = [name for name, entry in readout_table().items() if entry["of_several_cells"]]
        if not set(names) <= set(readouts.names):
            raise InputOutputError(f"{self.folder}: summary.json has no {', '.join(names)}; results.csv of a study has them", self.folder)
        defined = {name: [value for value in readouts[name] if not math.isnan(value)] for name in names}
        return Readouts({name: sum(values) / len(values) if values else None for name, values in defined.items()})

    @functools.cached_property
    def readouts(self) -> Readouts | ReadoutsOfCells:
        """The paper's read-outs by name, with units; of several cells, of each. Written when the run ends."""
        path = self._existing("summary.json")
        values = read_json(path)
        cells = values.get("cells", [values])
        if not isinstance(cells, list) or not cells or not all(isinstance(cell, dict) for cell in cells):
            raise InputOutputError(f"{path}: is damaged: its cells are no list of read-outs", self.folder)
        for cell in cells:
            for name, value in cell.items():
                if isinstance(value, bool) or not isinstance(value, (int, float, type(None))):
                    raise InputOutputError(f"{path}: is damaged: {name} is no number", self.folder)
        several = "cells" in values
        numbers = [cell.get("cell") for cell in cells]
        if several and (numbers != list(range(1, len(cells) + 1)) or len(set(map(frozenset, cells))) > 1):
            raise InputOutputError(f"{path}: is damaged: its cells are not numbered from 1, with the same read-outs",
                                   self.folder)
        self._require_unchanged("summary.json")
        return ReadoutsOfCells(cells) if several else Readouts(values)

    @functools.cached_property
    def scenario(self) -> dict[str, Any]:
        """Every parameter, as in scenario.resolved.toml: ``run.scenario["ecm"]["youngs_modulus"]`` is "200 Pa".

        ``matrigrate.Scenario(run.scenario)`` makes a scenario of it.
        """
        path = self._existing("scenario.resolved.toml")
        try:
            return tomllib.loads(read_text(path))
        except tomllib.TOMLDecodeError as error:
            raise InputOutputError(f"{path}: is damaged: it is no TOML: {error}", self.folder) from None

    @functools.cached_property
    def fields(self) -> Fields:
        """Frames of cell and matrix, read when they are asked for."""
        for name in ("fields.h5", "export/fields.h5"):
            if (self.folder / name).is_file():
                return Fields(self.folder / name)
        if (self.folder / "fields.part").is_file():
            raise InputOutputError(f"{self.folder}: has no fields.h5 yet ({self.status}); matrigrate export "
                                   f"{self.folder} --fields writes the frames so far", self.folder)
        raise InputOutputError(f"{self.folder}: has no fields.h5: it was made without frames (output.field_interval)",
                               self.folder)

    def _table(self, name: str, texts: list[str] | None = None) -> pandas.DataFrame:
        unfinished = self.status in ("running", "unfinished")
        table = read_table(self._existing(name), texts=texts or (), unfinished=unfinished)
        self._require_unchanged(name)
        return table

    def _require_unchanged(self, name: str) -> None:
        """
        :raises InputOutputError: if the run is done, and the file is no longer what run.json says of it; without the
            package xxhash this is not known
        """
        known = self.record.get("files")
        if xxhash is None or self.record["status"] != "done" or not isinstance(known, dict) or name not in known:
            return
        path = self.folder / name
        if xxhash.xxh3_64_hexdigest(path.read_bytes()) != known[name]:
            raise InputOutputError(f"{path}: has been cut or changed since the run ended", self.folder)

    def _existing(self, name: str) -> Path:
        path = self.folder / name
        if not path.exists():
            raise InputOutputError(f"{self.folder}: has no {name} (the run is {self.status})", self.folder)
        return path

    def _is_worked_on(self) -> bool:
        """True if a process of this machine works in the folder, that is, holds its lock."""
        if fcntl is None:
            return False
        try:
            with open(self.folder / ".lock", "rb") as lock:
                fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
        except OSError as error:
            return isinstance(error, BlockingIOError)
        return False


class CellOfRun:
    """One cell of a run: its rows of the run's tables, and its shape in frames."""

    def __init__(self, run: Run, number: int) -> None:
        self.run, self.number = run, number

    def __repr__(self) -> str:
        return f"CellOfRun(cell {self.number} of {self.run!r})"

    @functools.cached_property
    def tracks(self) -> pandas.DataFrame:
        """A row each minute: ``t_s`` [s], ``x_um``, ``y_um`` [um], area, perimeter, polarization, protrusions."""
        return self._rows(self.run.tracks)

    @functools.cached_property
    def protrusions(self) -> pandas.DataFrame:
        """A row for each protrusion."""
        return self._rows(self.run.protrusions)

    @functools.cached_property
    def msd(self) -> pandas.DataFrame:
        """Mean square displacement [um^2] over lags [s]."""
        return self._rows(self.run.msd)

    @property
    def readouts(self) -> Readouts:
        """The paper's read-outs of this cell."""
        readouts: Any = self.run.readouts
        return readouts[self.number] if self.number in readouts else readouts

    def outline(self, frame: int = -1) -> np.ndarray[Any, Any]:
        """The particles of its cortex [um] in a frame of ``run.fields``: x, y, in their order around the cell."""
        return self.run.fields.outlines(frame)[self.number]

    def nucleus(self, frame: int = -1) -> np.ndarray[Any, Any]:
        """The particles of its nucleus [um] in a frame of ``run.fields``: x, y.

        :raises KeyError: if the cells have no nucleus
        """
        return self.run.fields.nuclei(frame)[self.number]

    def _rows(self, table: pandas.DataFrame) -> pandas.DataFrame:
        column = next((name for name in ("track", "cell") if name in table), None)  # tables of one cell may have neither
        rows = table if column is None else table[table[column] == self.number].reset_index(drop=True)
        rows.attrs["units"] = table.attrs["units"]
        return rows


class CellsOfRun(dict[int, CellOfRun]):
    """The cells of a run by their numbers, from 1."""

    def __init__(self, run: Run) -> None:
        super().__init__((number, CellOfRun(run, number)) for number in map(int, run.tracks["track"].unique()))

    def __missing__(self, number: int) -> CellOfRun:
        raise KeyError(f"{number}; the cells are {', '.join(map(str, self))}")

    def __repr__(self) -> str:
        return f"CellsOfRun({len(self)}: {', '.join(map(str, self))})"


def load(folder: str | os.PathLike[str]) -> Run:
    """Loads the folder of a run, whether it is done or not.

    :raises InputOutputError: if it is none, or is damaged
    :raises TypeError: if it is no path
    """
    return Run(folder)
