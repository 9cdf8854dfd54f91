"""Measured and simulated tracks, with the same read-outs.

    from matrigrate import tracks

    cells = tracks.read("spots.csv", pixel=0.65, interval=120)    # um per pixel, s per frame
    cells.readouts()                                              # value and standard error of each read-out
    tracks.of(matrigrate.load("cell-seed1"), interval=120).readouts()
"""
from __future__ import annotations

import math
import os
from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arguments, _motility
from ._files import _pandas, unit_of
from ._track_files import Faults, Position, content
from .errors import ConfigurationError, InputOutputError
from .results import Run
from .studies import Study

if TYPE_CHECKING:
    import pandas

__all__ = ["Tracks", "meaning", "of", "read"]

_off_grid = 0.01  # of an interval
_longest = 10_000  # intervals of a track
_resamples = 200  # of the bootstrap


def meaning(readout: str) -> str:
    """The meaning of a read-out of tracks, in words."""
    return _motility.meanings.get(readout, readout)


class Tracks(Mapping[str, Any]):
    """Tracks at one interval: by the name of a track an array of positions [um], one row an interval, NaN in gaps."""

    def __init__(self, positions: Mapping[str, np.ndarray[Any, Any]], interval: float, notes: list[str],
                 starts: Mapping[str, int] | None = None) -> None:
        self._positions = dict(positions)
        self._starts = dict(starts or dict.fromkeys(positions, 0))
        self.interval = interval
        """Time between positions [s]."""
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
        """A row a position: ``track``, ``t_s``, ``x_um``, ``y_um``; without gaps."""
        rows = [(name, (self._starts[name] + k) * self.interval, *track[k]) for name, track in self.items()
                for k in np.flatnonzero(np.isfinite(track[:, 0]))]
        return _pandas().DataFrame(rows, columns=["track", "t_s", "x_um", "y_um"])

    def every(self, interval: float) -> Tracks:
        """The positions at a longer interval [s], a whole multiple of this one; from the start of each track on."""
        share = interval / self.interval
        many = round(share)
        if many < 1 or abs(share - many) > _off_grid:
            raise ConfigurationError(f"interval: {interval:g} s is no whole multiple of {self.interval:g} s")
        # Starts in the new interval are rounded: only the removal of drift, which comes before, compares tracks.
        return self if many == 1 else Tracks({name: track[::many] for name, track in self.items()}, interval,
                                             list(self.notes), {k: round(v / many) for k, v in self._starts.items()})

    def drift(self) -> np.ndarray[Any, Any]:
        """Mean step of the tracks that are there at each time, summed up [um]: the drift of the stage, if cells have no
        common direction of their own. With n tracks its error is their mean step over the root of n."""
        last = max(self._starts[name] + len(track) for name, track in self.items())
        steps: list[list[Any]] = [[] for _ in range(last - 1)]
        for name, track in self.items():
            for k, step in enumerate(track[1:] - track[:-1], self._starts[name]):
                if np.isfinite(step[0]):
                    steps[k].append(step)
        means = [np.mean(of, axis=0) if of else np.zeros(2) for of in steps]
        return np.vstack([np.zeros((1, 2)), np.cumsum(means, axis=0).reshape(-1, 2)])

    def without_drift(self) -> Tracks:
        """The tracks less ``drift()``. It takes a common direction of the cells away, too."""
        if len(self) < 5:
            raise ConfigurationError(f"drift: {len(self)} tracks cannot tell drift from migration; 5 are needed")
        drift = self.drift()
        moved = {name: track - drift[self._starts[name]:self._starts[name] + len(track)] for name, track in self.items()}
        said = f"a drift of {math.hypot(*drift[-1]):.3g} um from start to end is taken away"
        return Tracks(moved, self.interval, [*self.notes, said], self._starts)

    def with_error(self, error: float, seed: int = 1) -> Tracks:
        """The tracks with a normal error of each coordinate [um]: simulated ones as a microscope would see them."""
        random = np.random.default_rng(seed)
        return Tracks({name: track + random.normal(0.0, error, track.shape) for name, track in self.items()},
                      self.interval, [*self.notes, f"an error of {error:g} um is added"], self._starts)

    def readouts(self, interval: float | None = None, *, error: float = 0.0, resamples: int = _resamples) -> pandas.DataFrame:
        """A row a read-out: ``value``, ``standard_error`` (bootstrap over tracks; NaN of a single track), ``unit``,
        ``meaning``. NaN is what the tracks do not define; ``notes`` then says it if ``error`` is the reason.

        :param interval: [s] if a longer one than that of the tracks
        :param error: localisation error of a coordinate [um], taken off the mean square displacement, and so of its slopes
            and of the persistence time; speeds, ratios and angles keep theirs: give simulated tracks the same with
            ``with_error``
        :param resamples: of the bootstrap; it always draws the same ones
        :raises ConfigurationError: if the error is none, or positions are too far apart for any read-out
        """
        if not isinstance(error, (int, float)):
            raise _arguments.wrong("error", error, "a number of um")
        if error < 0 or not math.isfinite(error):
            raise ConfigurationError(f"error: {error:g} um is no localisation error")
        parts = self._parts if interval is None else self.every(interval)._parts
        if square := parts.buried(error):
            said = (f"MSD at one interval, {square:.3g} um2, is below 4 error^2 = {4 * error**2:.3g} um2: the error is larger than "
                    "the cells move, so slopes and the persistence time are not defined")
            self.notes.extend([said] if said not in self.notes else [])
        values = parts.readouts(error=error)
        errors = dict.fromkeys(values, float("nan"))
        drawn = self._drawn if interval is None and error == 0 and resamples == _resamples else _resampled(parts, error, resamples)
        for name in values:
            known = [one[name] for one in drawn if math.isfinite(one[name])]
            if math.isfinite(values[name]) and len(known) > 1 and len(known) >= 0.9 * resamples:
                errors[name] = float(np.std(known, ddof=1))
        return _pandas().DataFrame({"value": values, "standard_error": errors,
                                    "unit": {name: unit_of(name) for name in values}, "meaning": _motility.meanings})

    def covariance(self, readouts: Sequence[str]) -> np.ndarray[Any, Any]:
        """Of the errors of these read-outs, by the bootstrap of ``readouts()``."""
        table = np.array([[one[name] for name in readouts] for one in self._drawn])
        return np.atleast_2d(np.cov(table[np.isfinite(table).all(axis=1)].T))

    def msd(self) -> pandas.DataFrame:
        """Mean square displacement of all tracks: ``lag_s``, ``msd_um2``."""
        square = self._parts.msd()
        return _pandas().DataFrame({"lag_s": self.interval * np.arange(1, len(square) + 1), "msd_um2": square})

    @cached_property
    def _parts(self) -> _motility.Parts:
        far = [name for name, track in self.items() if not np.nanmax(np.abs(track), initial=0.0) <= _motility.farthest]
        if far:
            raise ConfigurationError("\n".join(f"track {name}: positions reach {np.nanmax(np.abs(self[name])):.3g} um; read-outs "
                                               f"are defined up to {_motility.farthest:g} um (pixel)" for name in far))
        return _motility.Parts(list(self.values()), self.interval)

    @cached_property
    def _drawn(self) -> list[dict[str, float]]:
        """Read-outs of the bootstrap's sets, without an error."""
        return _resampled(self._parts, 0.0, _resamples)


def _resampled(parts: _motility.Parts, error: float, resamples: int) -> list[dict[str, float]]:
    """Read-outs of sets of tracks drawn with replacement: always the same ones; none of a single track."""
    n, random = len(parts.lengths), np.random.default_rng(1)
    if n < 2 or resamples < 2:
        return []
    return [parts.readouts(random.integers(n, size=n), error) for _ in range(resamples)]


def read(file: str | os.PathLike[str], *, pixel: float | None = None, interval: float | None = None, shortest: int = 4,
         fewest: int = 2, drift: bool = False) -> Tracks:
    """Tracks from a file of TrackMate (spots as CSV, tracks as XML), celltrackR, napari, trackpy or this program, or any
    CSV file with columns for track, time, x and y.

    :param pixel: um per unit of length of the file; only where the file does not state um
    :param interval: s per frame, or per unit of time of the file; only where the file does not state it
    :param shortest: tracks of fewer positions are left out, and counted in ``notes``
    :param fewest: fewer tracks than this are refused
    :param drift: whether to take the mean motion of all tracks away
    :raises ConfigurationError: with all that is wrong with the file, each with its line
    """
    path = _arguments.path("file", file, "the path of a file of tracks")
    for name, value in (("pixel", pixel), ("interval", interval)):
        if value is not None and not (math.isfinite(value) and value > 0):
            raise ConfigurationError(f"{name}: {value:g} is no positive number")
    if path.is_dir():
        raise InputOutputError(f"{path}: is a folder; tracks.of(matrigrate.load(...)) has the tracks of a run", path)
    faults = Faults(path)
    found = content(path, pixel, interval, faults)
    faults.raise_if_any()
    tracks = _on_grid(found.positions, shortest, found.notes, faults)
    if not faults.found and len(tracks) < fewest:
        faults.add(f"has {len(tracks)} tracks of at least {shortest} positions; {fewest} are needed to tell how cells "
                   "differ (shortest, fewest)")
    if not faults.found and all(np.nanmax(np.ptp(_there(track), axis=0)) == 0.0 for track in tracks.values()):
        faults.add("no track moves: all positions of a track are the same")
    faults.raise_if_any()
    return tracks.without_drift() if drift else tracks


def of(result: Run | Study, interval: float | None = None) -> Tracks:
    """The tracks of a run or of all runs of a study: of each cell.

    :param interval: [s] that of the microscope: a whole multiple of ``output.track_interval``
    """
    if not isinstance(result, (Run, Study)):
        raise TypeError(f"result must be a run or a study, not {type(result).__name__}")
    table = result.tracks if isinstance(result, Run) else result.tracks()
    keys: Any = "track" if isinstance(result, Run) else ["run", "track"]
    positions, notes, last = [], list[str](), 0
    for key, rows in table.groupby(keys, sort=False):
        name = "/".join(map(str, key if isinstance(key, tuple) else (key,)))
        times = rows["t_s"].to_numpy(float)
        if len(times) > 2 and times[-1] - times[-2] < (1 - _off_grid) * (times[1] - times[0]):
            rows, times, last = rows[:-1], times[:-1], last + 1  # the run ended between two rows
        positions += [Position(name, *row, 0) for row in
                      zip(times, rows["x_um"].to_numpy(float), rows["y_um"].to_numpy(float), strict=True)]
    if last:
        notes.append(f"{last} last positions are left out: they come less than an interval after the one before")
    faults = Faults(result.folder)
    tracks = _on_grid(positions, 2, notes, faults)
    faults.raise_if_any()
    return tracks if interval is None else tracks.every(interval)


def _on_grid(positions: list[Position], shortest: int, notes: list[str], faults: Faults) -> Tracks:
    """Tracks at the most frequent step of time. Missing positions are NaN; any other step is a fault."""
    by_track: dict[str, list[Position]] = defaultdict(list)
    for position in positions:
        by_track[position.track].append(position)
    short = [name for name, own in by_track.items() if len(own) < shortest]
    for name in short:
        del by_track[name]
    if short:
        notes.append(f"{len(short)} tracks of fewer than {shortest} positions are left out")
    for own in by_track.values():
        own.sort(key=lambda position: position.t)
    steps = Counter(float(f"{after.t - before.t:.6g}") for own in by_track.values()
                    for before, after in zip(own, own[1:], strict=False) if after.t > before.t)
    interval = steps.most_common(1)[0][0] if steps else 1.0
    start = min((own[0].t for own in by_track.values()), default=0.0)
    result, starts, gaps = {}, {}, 0
    for name, own in by_track.items():
        indices, smallest = [0], math.inf
        for before, after in zip(own, own[1:], strict=False):
            step = (after.t - before.t) / interval
            smallest = min(smallest, step)
            if after.t == before.t:
                faults.add(f"track {name} has two positions at {after.t:g} s: tracks that split or merge must be cut",
                           after.line)
            elif round(step) < 1 or abs(step - round(step)) > _off_grid:
                faults.add(f"track {name} has a step of {after.t - before.t:g} s, most have {interval:g} s: one interval "
                           "is needed", after.line)
            indices.append(indices[-1] + max(1, round(step)))
        if round(smallest) > 1:
            faults.add(f"track {name} has steps of {smallest * interval:g} s and more, most tracks have {interval:g} s: "
                       "one interval is needed", own[1].line)
        if indices[-1] > _longest:
            faults.add(f"track {name} spans {indices[-1]} intervals of {interval:g} s; {_longest} are the most", own[-1].line)
            continue
        array = np.full((indices[-1] + 1, 2), np.nan)
        array[indices] = [(position.x, position.y) for position in own]
        gaps += len(array) - len(own)
        result[name], starts[name] = array, round((own[0].t - start) / interval)
    if gaps:
        notes.append(f"{gaps} positions are missing; gaps are not filled")
    return Tracks(result, interval, notes, starts)


def _there(track: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    return track[np.isfinite(track[:, 0])]
