"""Folders of studies: many runs, and what they say."""
from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..base import arguments
from ..base.files import require_pandas, read_table
from ..errors import InputOutputError
from .results import Run, load

if TYPE_CHECKING:
    import pandas

_texts = ("run", "label", "status", "reason", "cause", "trajectory_hash", "point", "point_a", "point_b", "readout", "set",
          "condition", "test")


class Runs(Mapping[str, Run]):
    """The runs of a study by the names of their folders. Each is loaded when it is asked for."""

    def __init__(self, folder: Path, study: Study | None = None) -> None:
        self._folder = arguments.path("folder", folder)
        self.study = study if (folder.parent / "results.csv").is_file() else None  #: with its table of runs, if it was written yet
        self._names = sorted(path.parent.name for path in self._folder.glob("*/run.json"))

    def __getitem__(self, name: str) -> Run:
        if name not in self._names:
            raise KeyError(f"{name}: there is no such run in {self._folder}")
        return load(self._folder / name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return f"Runs({len(self)} in {str(self._folder)!r})"


class Study:
    """The folder of a study. Tables are made by ``matrigrate study collect``, with units in their column names."""

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = arguments.path("folder", folder, "the path of a study")
        if not (self.folder / "study.resolved.toml").is_file():
            why = "there is no such folder" if not self.folder.exists() else \
                "is a single run; matrigrate.load reads it" if (self.folder / "run.json").exists() else \
                "is no folder of a study: it has no study.resolved.toml"
            raise InputOutputError(f"{self.folder}: {why}", self.folder)

    def __repr__(self) -> str:
        return f"Study({str(self.folder)!r}: {len(self.runs)} runs)"

    @cached_property
    def results(self) -> pandas.DataFrame:
        """A row per run: folder ``run``, ``label`` of the point, swept parameters, replicate, seed, status, read-outs."""
        return self._table("results.csv")

    @cached_property
    def groups(self) -> pandas.DataFrame:
        """A row for each point and read-out: n, mean with its 95 % interval, standard deviation, quartiles."""
        return self._table("groups.csv")

    @cached_property
    def statistics(self) -> pandas.DataFrame:
        """A row for each pair of points and read-out: difference with interval, test, p, p after Holm, effect size."""
        return self._table("statistics.csv")

    @cached_property
    def msd(self) -> pandas.DataFrame:
        """Mean square displacement [um^2] over the runs of each point, with its standard error, over lags [s]."""
        return self._table("msd.csv")

    def table(self, name: str) -> pandas.DataFrame:
        """Any table of the study by its name: "correlations", "paths", "adhesions"."""
        arguments.text("name", name, "the name of a table")
        return self._table(name if name.endswith(".csv") else f"{name}.csv")

    @property
    def parameters(self) -> list[str]:
        """The columns of the parameters that differ between points, such as "ecm.youngs_modulus_Pa"."""
        columns = list(self.results.columns)
        return columns[columns.index("label") + 1:columns.index("replicate")]

    @cached_property
    def points(self) -> pandas.DataFrame:
        """A row for each point: ``label``, its parameters, and how many of its runs there are and are done."""
        keys = ["label", *self.parameters]
        grouped = self.results.groupby(keys, sort=False, dropna=False)["status"]
        counts = grouped.agg(runs="size", done=lambda status: int((status == "done").sum()))
        return counts.reset_index()

    @cached_property
    def runs(self) -> Runs:
        """The runs that have begun, by the names of their folders."""
        return Runs(self.folder / "runs", self)

    def tracks(self) -> pandas.DataFrame:
        """The tracks of all runs that have begun, in one frame: ``Run.tracks`` of each, with the columns ``run``,
        ``label``, the parameters, ``replicate`` and ``seed`` in front."""
        return self._all("tracks")

    def protrusions(self) -> pandas.DataFrame:
        """The protrusions of all runs that have begun, in one frame, with the same columns in front."""
        return self._all("protrusions")

    def _all(self, name: str) -> pandas.DataFrame:
        pandas, tables = require_pandas(), []
        keys = ["run", "label", *self.parameters, "replicate", "seed"]
        units: dict[str, Any] = {}
        for row in self.results[keys].to_dict("records"):
            if row["run"] not in self.runs:
                continue
            table = getattr(self.runs[row["run"]], name)
            units = dict.fromkeys(keys, "1") | table.attrs["units"]
            front = pandas.DataFrame({key: [value] * len(table) for key, value in row.items()}, index=table.index)
            tables.append(pandas.concat([front, table], axis=1))
        if not tables:
            raise InputOutputError(f"{self.folder}: none of its runs has begun", self.folder)
        together = pandas.concat(tables, ignore_index=True)
        together.attrs["units"] = units | {k: v for k, v in self.results.attrs["units"].items() if k in keys}
        return together

    def _table(self, name: str) -> pandas.DataFrame:
        path = self.folder / name
        if not path.exists():
            if name == "discrepancy.csv":
                raise InputOutputError(f"{self.folder}: has no {name}: points are not ranked any more; calibrate.fit(study) fits the [[targets]]", self.folder)
            raise InputOutputError(f"{self.folder}: has no {name}; matrigrate study collect {self.folder} writes it",
                                   self.folder)
        table = read_table(path, texts=_texts, strict=False)
        if name == "results.csv" and not {"run", "label", "replicate", "status"} <= set(table.columns):
            raise InputOutputError(f"{path}: is damaged: it lacks columns", self.folder)
        return table


def load_study(folder: str | os.PathLike[str]) -> Study:
    """Loads the folder of a study, whether all its runs are done or not.

    :raises InputOutputError: if it is none, or is damaged
    :raises TypeError: if it is no path
    """
    return Study(folder)
