"""Simulated cells as ground truth for programs that segment and track: label masks, pictures of fluorescence, tracks.

    from matrigrate import truth

    movie = truth.Movie(matrigrate.load("cell-seed1"), pixel=0.5)    # um per pixel
    movie.labels()                                                   # uint16: the number of the cell in each pixel
    movie.fluorescence(seed=1)                                       # uint16: cortex and matrix, blurred, with photon noise
    movie.tracks()                                                   # for a tracks layer of napari
    movie.save("truth")                                              # TIFF and CSV files
"""
from __future__ import annotations

import math
import os
import warnings
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .base import arguments
from .base.files import require_pandas
from .base.load_core import library
from .draw import drawing
from .errors import ConfigurationError, InputOutputError
from .results import raster
from .results.fields import Fields, evenly
from .results.results import Run

if TYPE_CHECKING:
    import pandas

__all__ = ["Movie"]

Array = np.ndarray[Any, Any]
_files = ("labels.tif", "fluorescence.tif", "tracks.csv")


class Movie:
    """The frames of a run on pixels. Row 0 is at the top, so y of the model points up; pixel (row, column) has its centre at
    ``top - (row + 0.5) pixel``, ``left + (column + 0.5) pixel``.

    All frames are at one interval. If the run ended sooner than that after the frame before, its last frame is left out, with a
    warning.

    :param pixel: width of a pixel [um]
    :param window: left, right, bottom, top [um]; left out, where the cells are in the course of the run; "all" is the whole matrix
    :raises ConfigurationError: if the frames are not evenly spaced
    """

    def __init__(self, run: Run, *, pixel: float = 0.5, window: tuple[float, float, float, float] | str | None = None) -> None:
        self.run = arguments.one_of("run", run, Run)
        fields = run.fields
        if not math.isfinite(pixel) or pixel <= 0:
            raise ConfigurationError(f"pixel: {pixel:g} um is no width of a pixel")
        self.interval, self.frames = _even(np.asarray(fields.times, dtype=float))
        """Time between two frames [s], and which of ``run.fields`` the movie has: all at this interval."""
        self.left_out = list(range(len(self.frames), len(fields.times)))
        """The last frame, if the run ended sooner than an interval after the one before it."""
        if self.left_out:
            warnings.warn(f"frame {self.left_out[0]}, the last one, at {fields.times[-1]:g} s, is left out: it comes sooner than "
                          f"{self.interval:g} s after the one before it", stacklevel=2)
        drawing.check_view(window, None, [])
        self.grid = raster.Grid.over(drawing.window_of(fields, 0, window, None), pixel)
        if self.grid.rows * self.grid.columns > 10**8:
            raise ConfigurationError(f"pixel: {pixel:g} um makes {self.grid.columns} x {self.grid.rows} pixels; 10^8 are the most")

    @property
    def times(self) -> Array:
        """Simulated time of each frame [s]."""
        return np.asarray(self.run.fields.times)[self.frames]

    def __repr__(self) -> str:
        return (f"Movie({len(self.frames)} frames every {self.interval:g} s, {self.grid.columns} x {self.grid.rows} pixels of "
                f"{self.grid.pixel:g} um)")

    def labels(self) -> Array:
        """The number of the cell, from 1, in each pixel, 0 where there is none: uint16, shape (frames, rows, columns)."""
        out = np.zeros((len(self.frames), *self.grid.shape), dtype=np.uint16)
        for picture, k in zip(out, self.frames, strict=True):
            picture[...] = raster.labels(self.grid, self.run.fields.outlines(k))
        return out

    def fluorescence(self, *, seed: int = 1, psf: float = 0.25, cortex: float = 200.0, matrix: float = 60.0,
                     background: float = 10.0) -> Array:
        """Photons of a labelled cortex (channel 0) and of labelled solid matrix (channel 1): uint16, shape (frames, 2, rows,
        columns). Light of both is blurred by a Gaussian, and counts are drawn from a Poisson distribution. The same seed gives
        the same counts in each frame, whichever frames there are.

        :param psf: standard deviation of the point spread function [um]
        :param cortex: mean photons of a pixel on a straight cortex
        :param matrix: mean photons of a pixel of intact matrix; degraded matrix has less, compressed matrix more
        :param background: mean photons of each pixel
        """
        for name, value in (("psf", psf), ("cortex", cortex), ("matrix", matrix), ("background", background)):
            if not math.isfinite(value) or value < 0:
                raise ConfigurationError(f"{name}: {value:g} is not 0 or more")
        width = max(psf, 0.3 * self.grid.pixel)  # of a line: a pixel blurs, too
        around = math.ceil(4 * width / self.grid.pixel) + 1  # light comes from beyond the rim of a picture
        grid = self.grid.wider(around)
        out = np.zeros((len(self.frames), 2, *self.grid.shape), dtype=np.uint16)
        for pictures, k in zip(out, self.frames, strict=True):
            light = np.stack([cortex * _cortex(grid, self.run.fields, k, width),
                              matrix * _blurred(_matrix(grid, self.run.fields, k), psf / grid.pixel)])
            inner = light[:, around:around + self.grid.rows, around:around + self.grid.columns]
            counts = np.random.default_rng([seed, k]).poisson(inner + background)
            pictures[...] = np.minimum(counts, np.iinfo(np.uint16).max)
        return out

    def tracks(self) -> pandas.DataFrame:
        """A row for each cell in each frame: ``track_id``, ``t`` (number of the frame), ``y``, ``x`` in pixels, as a tracks layer of
        napari takes them, then ``t_s`` [s], ``x_um``, ``y_um`` [um] of the model, and ``area_um2``. The place is the
        centre of the area, as a segmentation finds it; the centre in ``run.tracks`` is the mean of the particles of the cortex."""
        rows = []
        for t, k in enumerate(self.frames):
            for number, outline in self.run.fields.outlines(k).items():
                area, x, y = _centre(outline.astype(float))
                rows.append((number, t, (self.grid.top - y) / self.grid.pixel - 0.5, (x - self.grid.left) / self.grid.pixel - 0.5,
                             float(self.run.fields.times[k]), x, y, area))
        table = require_pandas().DataFrame(rows, columns=["track_id", "t", "y", "x", "t_s", "x_um", "y_um", "area_um2"])
        return table.sort_values(["track_id", "t"], ignore_index=True)

    def napari_tracks(self) -> tuple[Array, dict[str, Array], dict[int, list[int]]]:
        """``data, properties, graph`` of napari: ``viewer.add_tracks(data, properties=properties, graph=graph)``. data has the columns
        track, frame, y, x in pixels; the graph is empty, since no cell divides."""
        table = self.tracks()
        properties = {name: table[name].to_numpy() for name in ("track_id", "t_s", "x_um", "y_um", "area_um2")}
        return table[["track_id", "t", "y", "x"]].to_numpy(float), properties, {}

    def save(self, folder: str | os.PathLike[str], *, overwrite: bool = False, **options: Any) -> list[Path]:
        """Writes ``labels.tif``, ``fluorescence.tif`` (both with the size of a pixel and the interval, as ImageJ reads them) and
        ``tracks.csv`` (as ``matrigrate.tracks.read`` and napari read it).

        :param options: of ``fluorescence``
        :raises InputOutputError: if one of them is there and ``overwrite`` is not set; nothing is written then
        """
        folder = arguments.path("folder", folder, "the path of a folder")
        _tifffile()
        there = [name for name in _files if (folder / name).exists()]
        if there and not overwrite:
            raise InputOutputError(f"{folder}: has {', '.join(there)}; overwrite=True replaces them", folder)
        pictures = self.fluorescence(**options)
        folder.mkdir(parents=True, exist_ok=True)
        self._write_tiff(folder / "labels.tif", self.labels()[:, None])
        self._write_tiff(folder / "fluorescence.tif", pictures)
        self.tracks().to_csv(folder / "tracks.csv", index=False)
        return [folder / name for name in _files]

    def _write_tiff(self, path: Path, stack: Array) -> None:
        """:param stack: shape (frames, channels, rows, columns)"""
        axes = "TCYX" if stack.shape[1] > 1 else "TYX"
        words = {"axes": axes, "unit": "um", "finterval": self.interval, "mode": "grayscale",
                 "min": int(stack.min()), "max": int(stack.max())}
        _tifffile().imwrite(path, stack if axes == "TCYX" else stack[:, 0], imagej=True, metadata=words,
                            resolution=(1.0 / self.grid.pixel, 1.0 / self.grid.pixel))


def _even(times: Array) -> tuple[float, list[int]]:
    """The interval [s], and the frames without a last one that comes too soon."""
    odd, interval = evenly(times)
    if odd == len(times) or odd == len(times) - 1 and times[-1] - times[-2] < interval:
        return interval, list(range(odd))
    steps = np.diff(times)
    raise ConfigurationError(f"the frames of the run are unevenly spaced, {steps.min():g} to {steps.max():g} s apart: the first that does "
                             f"not fit is frame {odd}, at {times[odd]:g} s, where {times[0] + odd * interval:g} s is expected. A "
                             "movie has one interval; frames are evenly spaced where output.field_interval is a multiple of "
                             "run.time_step")


def _cortex(grid: raster.Grid, fields: Fields, k: int, width: float) -> Array:
    """Blurred length of cortex, 1 on a straight one.  :param width: standard deviation of the blur [um]"""
    points, lengths = [], []
    for outline in fields.outlines(k).values():
        start = outline.astype(float)
        way = np.roll(start, -1, axis=0) - start
        length = np.hypot(*way.T)
        parts = np.maximum(1, np.ceil(4 * length / grid.pixel)).astype(int)
        which = np.repeat(np.arange(len(parts)), parts)
        share = (np.arange(len(which)) - np.repeat(np.cumsum(parts) - parts, parts) + 0.5) / parts[which]
        points.append(start[which] + share[:, None] * way[which])
        lengths.append(length[which] / parts[which])
    place, ds = np.concatenate(points), np.concatenate(lengths)
    column = np.floor((place[:, 0] - grid.left) / grid.pixel).astype(int)
    row = np.floor((grid.top - place[:, 1]) / grid.pixel).astype(int)
    there = (column >= 0) & (column < grid.columns) & (row >= 0) & (row < grid.rows)
    line = np.bincount((row * grid.columns + column)[there], ds[there], grid.rows * grid.columns)
    density = line.reshape(grid.shape) / grid.pixel**2  # [1/um]
    return _blurred(density, width / grid.pixel) * math.sqrt(2 * math.pi) * width


def _matrix(grid: raster.Grid, fields: Fields, k: int) -> Array:
    """Density of solid matrix, 1 where it is intact and as at the start."""
    spacing, radius = float(fields["matrix/spacing"][0]), float(fields["matrix/radius"][0])
    place, solid = fields["matrix/position"][k][:, :2].astype(float), fields["matrix/f_degr"][k].astype(float)
    solid = np.where(fields["matrix/solid"][k] == 1, solid, 0.0)
    total, = raster.smoothed(grid, place, [solid], 2 * spacing)
    of_lattice = math.pi * (2 * spacing)**2 / 4 * len(place) / (math.pi * radius**2)
    return total / of_lattice


def _centre(outline: Array) -> tuple[float, float, float]:
    """Area of a polygon, and x and y of the centre of its area."""
    origin = outline[0]
    (x, y), (x1, y1) = (outline - origin).T, (np.roll(outline, -1, axis=0) - origin).T
    cross = x * y1 - x1 * y
    area = 0.5 * float(cross.sum())
    return (abs(area), float(((x + x1) * cross).sum()) / (6 * area) + float(origin[0]),
            float(((y + y1) * cross).sum()) / (6 * area) + float(origin[1]))


def _blurred(picture: Array, width: float) -> Array:
    """A picture after a Gaussian; it is dark beyond its rim.  :param width: standard deviation of the Gaussian [pixels]"""
    if width <= 0:
        return picture
    reach = max(1, math.ceil(4 * width))
    weight = np.exp(-0.5 * (np.arange(-reach, reach + 1) / width)**2)
    weight /= weight.sum()
    for axis in (0, 1):
        padding = [(0, 0), (0, 0)]
        padding[axis] = (reach, reach)
        padded, many = np.pad(picture, padding), picture.shape[axis]
        picture = sum(w * padded.take(range(k, k + many), axis=axis) for k, w in enumerate(weight))
    return picture


def _tifffile() -> Any:
    return library("tifffile", "TIFF files need tifffile")
