"""Pictures as arrays: particles smoothed onto pixels, and areas inside of outlines."""
from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]


@dataclass(frozen=True)
class Grid:
    """Pixels over a part of the plane. The first row is the top one, as in pictures."""

    left: float  #: [um]
    top: float  #: [um]
    pixel: float  #: width of a pixel [um]
    columns: int
    rows: int

    @classmethod
    def over(cls, window: tuple[float, float, float, float], pixel: float) -> Grid:
        """:param window: left, right, bottom, top [um]"""
        left, right, bottom, top = window
        return cls(left, top, pixel, max(1, round((right - left) / pixel)), max(1, round((top - bottom) / pixel)))

    def wider(self, around: int) -> Grid:
        """The same with more pixels on each side."""
        return Grid(self.left - around * self.pixel, self.top + around * self.pixel, self.pixel, self.columns + 2 * around,
                    self.rows + 2 * around)

    @property
    def shape(self) -> tuple[int, int]:
        return self.rows, self.columns

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """left, right, bottom, top [um], as matplotlib's imshow takes it."""
        return self.left, self.left + self.columns * self.pixel, self.top - self.rows * self.pixel, self.top

    def centres(self) -> tuple[Array, Array]:
        """x of each column and y of each row [um]."""
        return (self.left + (np.arange(self.columns) + 0.5) * self.pixel,
                self.top - (np.arange(self.rows) + 0.5) * self.pixel)


def smoothed(grid: Grid, places: Array, values: list[Array], reach: float) -> list[Array]:
    """Sums over particles of value times (1 - (r/reach)^2)^3 at each pixel.

    :param places: of the particles [um], shape (n, 2)
    :param values: one array a sum
    :param reach: of the kernel [um]
    """
    column = np.floor((places[:, 0] - grid.left) / grid.pixel).astype(int)
    row = np.floor((grid.top - places[:, 1]) / grid.pixel).astype(int)
    around = int(np.ceil(reach / grid.pixel)) + 1
    near = ((column > -around) & (column < grid.columns + around) & (row > -around) & (row < grid.rows + around))
    column, row, places = column[near], row[near], places[near]
    step = np.arange(-around, around + 1)
    columns, rows = column[:, None] + step, row[:, None] + step  # of each particle
    x = (grid.left + (columns + 0.5) * grid.pixel - places[:, :1]) / reach
    y = (grid.top - (rows + 0.5) * grid.pixel - places[:, 1:]) / reach
    square = np.where((rows >= 0) & (rows < grid.rows), y**2, np.inf)[:, :, None] \
        + np.where((columns >= 0) & (columns < grid.columns), x**2, np.inf)[:, None, :]
    particle, i, j = np.nonzero(square < 1.0)
    weight = (1.0 - square[particle, i, j])**3
    pixel = rows[particle, i] * grid.columns + columns[particle, j]
    many = grid.rows * grid.columns
    return [np.bincount(pixel, weight * value[near][particle], many).reshape(grid.shape) for value in values]


def inside(grid: Grid, outline: Array) -> Array:
    """True at the pixels whose centres lie inside of a closed outline [um], shape (n, 2), by the even-odd rule."""
    start, end = outline, np.roll(outline, -1, axis=0)
    row_y = grid.centres()[1][:, None]
    crosses = (start[:, 1] > row_y) != (end[:, 1] > row_y)  # (rows, edges)
    row, edge = np.nonzero(crosses)
    share = (row_y[row, 0] - start[edge, 1]) / (end[edge, 1] - start[edge, 1])
    x = start[edge, 0] + share * (end[edge, 0] - start[edge, 0])
    first = np.clip(np.ceil((x - grid.left) / grid.pixel - 0.5), 0, grid.columns).astype(int)  # pixel right of it
    flips = np.bincount(row * (grid.columns + 1) + first, minlength=grid.rows * (grid.columns + 1))
    within: Array = np.cumsum(flips.reshape(grid.rows, grid.columns + 1), axis=1)[:, :-1] % 2 == 1
    return within


def labels(grid: Grid, outlines: Mapping[int, Array]) -> Array:
    """The number of the cell, from 1, in each pixel, 0 where there is none: uint16."""
    numbers = np.zeros(grid.shape, dtype=np.uint16)
    for number, outline in outlines.items():
        numbers[inside(grid, outline.astype(float))] = number
    return numbers
