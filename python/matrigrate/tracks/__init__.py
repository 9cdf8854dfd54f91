"""Measured and simulated tracks, with the same read-outs.

    from matrigrate import tracks

    cells = tracks.read("spots.csv", pixel=0.65, frame_interval=120)    # um per pixel, s per frame
    cells.readouts()                                                    # value and standard error of each read-out
    tracks.of(matrigrate.load("cell-seed1"), interval=120).readouts()

Files are read as ``matrigrate tracks`` reads them.
"""
from __future__ import annotations

import math
import numbers
import os
from collections import Counter
from collections.abc import Mapping, Sequence
from functools import cache, cached_property
from itertools import combinations
from typing import TYPE_CHECKING, Any, SupportsFloat

import numpy as np

from ..base import arguments
from ..base.files import require_pandas, unit_of
from ..base.load_core import core
from ..errors import ConfigurationError, InputOutputError, refuse
from ..results.results import Run
from ..results.studies import Study

if TYPE_CHECKING:
    import pandas

    from .. import _core

__all__ = ["Tracks", "from_frame", "meaning", "of", "read"]

needs = {
    "directionality_ratio": "needs tracks of more than ten intervals",
    "directionality_time_min": "needs tracks on which the ratio falls below one half",
    "persistence_min": "needs three lags, and a time between half an interval and the largest lag",
    "msd_slope_short": "needs tracks of three positions",
    "msd_slope_long": "needs tracks of five positions",
    "anisotropy": "needs tracks of four positions that move both along and across",
    "turning_angle_deg": "needs two steps after one another",
    "turning_cosine": "needs two steps after one another",
}  #: of tracks, by the read-out; the others need two positions

_farthest = 1e9  # um, a kilometre: squares of what is beyond would not be numbers
_off_grid = 0.01  # of an interval
_resamples = 200  # of the bootstrap
_leap = 10.0  # over the median step
_alike = 0.8  # correlation of the steps of a cell that was found twice
_least_steps = 5  # of both tracks of a pair


@cache
def meanings() -> dict[str, str]:
    """By the name of a read-out of tracks what it means; none without the compiled module, which computes them."""
    try:
        return dict(core().track_readouts)
    except (ImportError, AttributeError):  # no module, or one of an earlier version
        return {}


def meaning(readout: str) -> str:
    """The meaning of a read-out of tracks, in words."""
    return meanings().get(readout, readout)


class Tracks(Mapping[str, Any]):
    """Tracks at one interval: by the name of a track an array of positions [um], one row an interval, NaN in gaps."""

    def __init__(self, positions: Mapping[str, np.ndarray[Any, Any]], interval: float, notes: list[str],
                 starts: Mapping[str, float] | None = None) -> None:
        self._positions = dict(positions)
        self._starts = dict(starts or dict.fromkeys(positions, 0.0))  # [s]
        self.interval = interval
        """Time between positions [s]."""
        self.source = ""
        """The file that they were read from; empty if they were not."""
        self.notes = notes
        """What was left out or changed, one sentence for each change."""

    def __getitem__(self, track: str) -> np.ndarray[Any, Any]:
        return self._positions[track]

    def __iter__(self) -> Any:
        return iter(self._positions)

    def __len__(self) -> int:
        return len(self._positions)

    def __repr__(self) -> str:
        positions = sum(int(np.isfinite(track[:, 0]).sum()) for track in self.values())
        return "\n".join([f"{len(self)} tracks, {positions} positions, every {self.interval:g} s", *self.notes])

    def table(self) -> pandas.DataFrame:
        """A row per position: ``track``, ``t_s``, ``x_um``, ``y_um``; without gaps."""
        rows = [(name, self._starts[name] + k * self.interval, *track[k]) for name, track in self.items()
                for k in np.flatnonzero(np.isfinite(track[:, 0]))]
        return require_pandas().DataFrame(rows, columns=["track", "t_s", "x_um", "y_um"])

    def every(self, interval: float) -> Tracks:
        """The positions at a longer interval [s], a whole multiple of this one; from the start of each track on."""
        sparse = core().at_interval(list(self.values()), self.interval, interval)
        return Tracks(dict(zip(self, sparse, strict=True)), interval, list(self.notes), self._starts)

    def _firsts(self) -> dict[str, int]:
        """Start of each track, in intervals from the start of the first one: of a track that is out of step the nearest."""
        first = min(self._starts.values())
        return {name: math.floor((start - first) / self.interval + 0.5) for name, start in self._starts.items()}

    def drift(self) -> np.ndarray[Any, Any]:
        """Mean step of the tracks that go on at each time, summed up [um], a row an interval from the first start on: the drift of the
        stage, if cells have no common direction of their own. With n tracks its error is their mean step over the root of n; where fewer
        than five go on there is none."""
        return np.column_stack(core().drift(list(self.values()), list(self._starts.values()), self.interval))

    def without_drift(self) -> Tracks:
        """The tracks less ``drift()``. It takes a common direction of the cells away, too.

        :raises ConfigurationError: if at no time five tracks go on together
        """
        moved, said = core().without_drift(list(self.values()), list(self._starts.values()), self.interval)
        return Tracks(dict(zip(self, moved, strict=True)), self.interval, [*self.notes, said], self._starts)

    def with_error(self, error: float, seed: int = 1) -> Tracks:
        """The tracks with a normal error of each coordinate [um]: simulated ones as a microscope would see them."""
        random = np.random.default_rng(seed)
        return Tracks({name: track + random.normal(0.0, error, track.shape) for name, track in self.items()},
                      self.interval, [*self.notes, f"an error of {error:g} um is added"], self._starts)

    def readouts(self, interval: float | None = None, *, error: float = 0.0, resamples: int = _resamples) -> pandas.DataFrame:
        """A row per read-out: ``value``, ``standard_error`` (bootstrap over tracks; NaN of a single track), ``unit``,
        ``meaning``. NaN is what the tracks do not define; ``notes`` then says it if ``error`` is the reason.

        :param interval: [s] if longer than the interval of the tracks
        :param error: localisation error of a coordinate [um], taken off the mean square displacement, and so of its slopes
            and of the persistence time; speeds, ratios and angles keep theirs: give simulated tracks the same with
            ``with_error``
        :param resamples: of the bootstrap; it always draws the same ones
        :raises ConfigurationError: if the error is none, or positions are too far apart for any read-out
        """
        if not isinstance(error, (int, float)):
            raise arguments.wrong("error", error, "a number of um")
        if error < 0 or not math.isfinite(error):
            raise ConfigurationError(f"error: {error:g} um is no localisation error")
        parts = self._parts if interval is None else self.every(interval)._parts
        if (said := parts.buried(error)) and said not in self.notes:
            self.notes.append(said)
        words = meanings()
        values = parts.readouts(error)
        drawn = self._drawn if interval is None and error == 0 and resamples == _resamples else _resampled(parts, error, resamples)
        return require_pandas().DataFrame({"value": values, "standard_error": core().standard_errors(values, drawn),
                                    "unit": [unit_of(name) for name in words], "meaning": list(words.values())}, index=list(words))

    def covariance(self, readouts: Sequence[str]) -> np.ndarray[Any, Any]:
        """Of the errors of these read-outs, by the bootstrap of ``readouts()``."""
        names = list(meanings())
        table = self._drawn[:, [names.index(name) for name in readouts]]
        return np.atleast_2d(np.cov(table[np.isfinite(table).all(axis=1)].T))

    def msd(self) -> pandas.DataFrame:
        """Mean square displacement of all tracks: ``lag_s``, ``msd_um2``."""
        square = np.array(self._parts.msd())
        return require_pandas().DataFrame({"lag_s": self.interval * np.arange(1, len(square) + 1), "msd_um2": square})

    def pairs(self) -> pandas.DataFrame:
        """A row for each pair of tracks that are there together for at least five steps: ``track``, ``other``, mean ``distance_um``, and the
        ``correlation`` of their steps: 1 if both walk alike."""
        firsts, found = self._firsts(), []
        for name, other in combinations(self, 2):
            begin = max(firsts[name], firsts[other])
            a, b = self[name][begin - firsts[name]:], self[other][begin - firsts[other]:]
            many = min(len(a), len(b))
            steps = np.hstack([np.diff(a[:many], axis=0), np.diff(b[:many], axis=0)]) if many > 1 else np.empty((0, 4))
            steps = steps[np.isfinite(steps).all(axis=1)]
            if len(steps) < _least_steps:
                continue
            size = math.sqrt(float((steps[:, :2]**2).sum() * (steps[:, 2:]**2).sum()))
            alike = float((steps[:, :2] * steps[:, 2:]).sum()) / size if size else float("nan")
            found.append((name, other, float(np.nanmean(np.hypot(*(a[:many] - b[:many]).T))), alike))
        return require_pandas().DataFrame(found, columns=["track", "other", "distance_um", "correlation"])

    def suspects(self, nearer: float = 10.0) -> pandas.DataFrame:
        """What a tracker may have got wrong, a row each: ``kind``, ``track``, ``other``, ``t_s``, ``value``. A ``"leap"`` is a step (``value``
        [um], at ``t_s``) of more than ten times the median step of all tracks: a wrong link. A ``"double"`` are two tracks that stay within
        ``nearer`` [um] and walk alike (correlation of their steps, ``value``, above 0.8): one cell that was found twice.
        """
        rows: list[tuple[Any, ...]] = []
        sizes = {name: np.hypot(*(track[1:] - track[:-1]).T) for name, track in self.items()}
        usual = float(np.nanmedian(np.concatenate(list(sizes.values()))))
        for name, steps in sizes.items():
            rows += [("leap", name, "", self._starts[name] + k * self.interval, float(steps[k]))
                     for k in np.flatnonzero(steps > _leap * usual)]
        pairs = self.pairs()
        pairs = pairs[(pairs["distance_um"] < nearer) & (pairs["correlation"] > _alike)]
        rows += [("double", row.track, row.other, float("nan"), row.correlation) for row in pairs.itertuples()]
        return require_pandas().DataFrame(rows, columns=["kind", "track", "other", "t_s", "value"])

    @cached_property
    def _parts(self) -> _core.TrackParts:
        reach = {name: np.nanmax(np.abs(track), initial=0.0) for name, track in self.items()}
        refuse([f"track {name}: positions reach {far:.3g} um; read-outs are defined up to {_farthest:g} um (pixel)"
                for name, far in reach.items() if not far <= _farthest])
        return core().TrackParts(list(self.values()), self.interval)

    @cached_property
    def _drawn(self) -> np.ndarray[Any, Any]:
        """Read-outs of the bootstrap's sets, a row a set, without an error."""
        return _resampled(self._parts, 0.0, _resamples)


def _resampled(parts: _core.TrackParts, error: float, resamples: int) -> np.ndarray[Any, Any]:
    """Read-outs of sets of tracks drawn with replacement, a row a set: always the same ones; none of a single track."""
    return np.reshape(parts.drawn(error, max(0, resamples)), (-1, len(meanings())))


def read(file: str | os.PathLike[str], *, pixel: float | None = None, frame_interval: float | None = None,
         time_unit: str | None = None, columns: Mapping[str, str | int | Sequence[str | int] | None] | None = None,
         layout: str | None = None, splits: str | None = None, jitter: float | None = None, recalibrate: bool = False,
         shortest: int = 4, fewest: int = 2, drift: bool = False, interval: float | None = None) -> Tracks:
    """Tracks from a file of TrackMate (spots as CSV, tracks as XML), Manual Tracking, MTrackJ, MOSAIC, CellProfiler, Imaris,
    trackpy, btrack, napari, CellTracksColab, celltrackR or this program, or any table with columns for track, time, x and y:
    what ``matrigrate tracks`` reads.

    What is given counts, whatever the file states; ``notes`` then says so.

    :param pixel: um per unit of length of the file
    :param frame_interval: s per frame
    :param time_unit: unit of a column of times: ``"ms"``, ``"s"``, ``"min"``, ``"h"`` or ``"d"``
    :param columns: names of columns, or their numbers from 1, where they are not found by themselves:
        ``{"track": "Cell no.", "t": 2, "x": "east", "y": "north"}``. Keys are ``track``, ``t``, ``frame``, ``x``, ``y``, ``z``,
        ``group`` (one or several that separate tracks of the same number), ``measured`` and ``made_up`` (whether a position
        was seen); None for a group or made_up that is there and is not meant
    :param layout: names of this program only, such as ``"imaris"``
    :param splits: what is done with tracks that divide or merge: ``"refuse"``, ``"cut"`` before it, or ``"drop"``
    :param jitter: by how much a step of time may differ from a whole number of intervals, as a share of one; 0.1
    :param recalibrate: of earlier versions; it has no effect
    :param shortest: tracks of fewer positions are left out, and counted in ``notes``
    :param fewest: fewer tracks than this are refused
    :param drift: whether to take the mean motion of all tracks away, where five go on together
    :param interval: the older name of ``frame_interval``
    :raises ConfigurationError: with all that is wrong with the file, each with its line
    """
    if interval is not None and frame_interval is not None:
        raise ConfigurationError("interval: is the older name of frame_interval; give one of them")
    options = {"pixel": pixel, "interval": interval if frame_interval is None else frame_interval, "time_unit": time_unit,
               "columns": columns, "layout": layout, "splits": splits, "jitter": jitter, "shortest": shortest, "fewest": fewest, "drift": drift}
    given = {name: _checked(name, value) for name, value in options.items() if value is not None or name == "drift"}
    if isinstance(file, _Text):
        found = core().read_tracks("the data frame", file, given)
    else:
        path = arguments.path("file", file, "the path of a file of tracks")
        if path.is_dir():
            raise InputOutputError(f"{path}: is a folder; tracks.of(matrigrate.load(...)) has the tracks of a run", path)
        found = core().read_tracks(os.fsencode(path), None, given)
    step, notes, names, starts, positions = found
    tracks = Tracks(dict(zip(names, positions, strict=True)), step, notes, dict(zip(names, starts, strict=True)))
    tracks.source = "" if isinstance(file, _Text) else str(file)
    return tracks


class _Text(str):
    """A table in memory, in the place of a file."""


def _checked(name: str, value: Any) -> Any:
    """An argument as the module takes it. :raises TypeError: of a wrong type"""
    if name == "drift":
        return arguments.one_of(name, value, bool)
    if name == "columns":
        return [f"{key}={_column(key, one)}" for key, column in arguments.mapping(name, value, "a dictionary of columns").items()
                for one in (column if isinstance(column, (list, tuple)) else [column])]
    if name in ("time_unit", "layout", "splits"):
        return arguments.text(name, value)
    return _number(name, value, whole=name in ("shortest", "fewest"))


def _column(key: str, value: Any) -> str:
    """A column by its name, by its number, or none."""
    if value is None:
        return "none"
    if isinstance(value, bool) or not isinstance(value, (str, numbers.Integral)):
        raise arguments.wrong(f"columns[{key!r}]", value, "the name of a column, or its number from 1,")
    return str(value)


def _number(name: str, value: Any, whole: bool) -> float:
    if isinstance(value, bool) or not isinstance(value, SupportsFloat) or np.size(value) != 1:
        raise arguments.wrong(name, value, "a whole number" if whole else "a number")
    number = float(value)
    if whole and (number < 1 or not number.is_integer()):
        raise ConfigurationError(f"{name}: {value} is no whole number of at least 1")
    if not whole and not (math.isfinite(number) and (number > 0 or name == "jitter" and number == 0)):
        raise ConfigurationError(f"{name}: {number:g} is no positive number")
    return int(number) if whole else number


def from_frame(frame: pandas.DataFrame, **options: Any) -> Tracks:
    """Tracks from a data frame with columns for track, time, x and y. Names of its index are columns, too; times may be
    timedelta or datetime. It is read as ``read`` reads a table, with the same options.

    >>> import pandas
    >>> spots = pandas.DataFrame({"cell": [1, 1, 1, 1], "min": [0, 5, 10, 15], "x_um": [0, 1, 2, 3], "y_um": [0, 0, 0, 0]})
    >>> from_frame(spots, columns={"track": "cell", "t": "min"}, time_unit="min", fewest=1)
    1 tracks, 4 positions, every 300 s
    """
    if not isinstance(frame, require_pandas().DataFrame):
        raise arguments.wrong("frame", frame, "a data frame")
    text = frame.to_csv(index=any(name is not None and name not in frame.columns for name in frame.index.names))
    return read(_Text(text), **options)


def of(result: Run | Study, interval: float | None = None) -> Tracks:
    """The tracks of a run or of all runs of a study: of each cell.

    :param interval: [s] of the microscope: a whole multiple of ``output.track_interval``
    """
    arguments.one_of("result", result, Run, Study)
    table = result.tracks if isinstance(result, Run) else result.tracks()
    keys: Any = "track" if isinstance(result, Run) else ["run", "track"]
    found, short, last = {}, 0, 0
    for key, rows in table.groupby(keys, sort=False):
        times = rows["t_s"].to_numpy(float)
        if len(times) > 2 and times[-1] - times[-2] < (1 - _off_grid) * (times[1] - times[0]):
            rows, times, last = rows[:-1], times[:-1], last + 1  # the run ended between two rows
        if len(times) < 2:
            short += 1
            continue
        name = "/".join(map(str, key if isinstance(key, tuple) else (key,)))
        found[name] = times, rows[["x_um", "y_um"]].to_numpy(float)
    steps = Counter(float(f"{step:.6g}") for times, _ in found.values() for step in np.diff(times))
    common = steps.most_common(1)[0][0] if steps else 1.0
    for name, (times, _) in found.items():
        if off := [step for step in np.diff(times) if abs(step / common - 1) > _off_grid]:
            raise ConfigurationError(f"{result.folder}: track {name} has a step of {off[0]:g} s, most have {common:g} s: one interval is needed")
    notes = [f"{last} last positions are left out: they come less than an interval after the one before"] if last else []
    notes += [f"{short} tracks of fewer than 2 positions are left out"] if short else []
    tracks = Tracks({name: at for name, (_, at) in found.items()}, common, notes,
                    {name: float(times[0]) for name, (times, _) in found.items()})
    return tracks if interval is None else tracks.every(interval)
