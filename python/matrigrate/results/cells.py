"""The cells of a run, one by one and as a group."""
from __future__ import annotations

import functools
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import pandas

    from .results import Readouts, Run


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
