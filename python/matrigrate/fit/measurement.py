"""Measured read-outs, and the same read-outs of the points of a study."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import tracks as _tracks
from ..base import arguments
from ..base.files import require_pandas
from ..base.load_core import core
from ..errors import ConfigurationError, refuse
from .conditions import Runs

if TYPE_CHECKING:
    import pandas

means_of_tracks = ("speed_um_per_h", "v_migr_abs_um_per_h", "straightness", "directionality_ratio", "turning_angle_deg",
                   "turning_cosine")  #: read-outs of tracks whose expectation does not depend on the number of tracks

_least_widths, _most_widths = 1e-9, 1e6  # of the range of simulated values, for measured values and their errors


@dataclass(frozen=True)
class Measurement:
    """Measured read-outs with their errors."""

    table: pandas.DataFrame
    """A row per read-out: ``value``, ``standard_error``, ``low``, ``high``; these two differ if a range was measured, and may be infinite."""
    covariance: np.ndarray[Any, Any]  #: of the measured values
    cells: int  #: tracks that were measured; 0 if only published means are known
    positions: int  #: of a track, median; 0 if only published means are known
    notes: list[str]

    def only(self, names: Sequence[str]) -> Measurement:
        """Of some of the read-outs."""
        at = [list(self.table.index).index(name) for name in names]
        return replace(self, table=self.table.iloc[at], covariance=self.covariance[np.ix_(at, at)])


@dataclass(frozen=True)
class Points:
    """Simulations of a study, a row per point with a run that is done."""

    parameters: pandas.DataFrame
    values: pandas.DataFrame  #: a column a read-out; NaN where it is not defined
    counts: pandas.DataFrame  #: as ``values``: of how many runs each is the mean
    runs: int  #: that are done, at the point with the fewest
    positions: int  #: of a track, median; 0 if no read-out is one of tracks
    notes: list[str]
    tracks: list[_tracks.Tracks]  #: of each point; none if no read-out is one of tracks
    design: pandas.DataFrame  #: parameters of all points of the study, whatever became of their runs

    def only(self, names: list[str]) -> Points:
        """With some of the read-outs."""
        own = [note for note in self.notes if note.partition(": ")[0] in names or note.partition(": ")[0] not in self.values]
        return replace(self, values=self.values[names], counts=self.counts[names], notes=own)

    @property
    def whole(self) -> np.ndarray[Any, Any]:
        """Which points have all read-outs."""
        return np.asarray(np.isfinite(self.values.to_numpy(float)).all(axis=1))

    def lacking(self) -> list[str]:
        """Which read-outs are missing, in how many points, and why."""
        missing = ~np.isfinite(self.values.to_numpy(float))
        return [f"{name}: {n} of {len(missing)} points lack it: it {self._need(name)}"
                for name, n in zip(self.values.columns, missing.sum(axis=0), strict=True) if n]

    def _need(self, name: str) -> str:
        if name not in _tracks.meanings():
            return "is not defined in their runs, or no number"
        need = _tracks.needs.get(name, "needs tracks of two positions")
        return need + (f"; simulated ones have {self.positions - 1}" if self.positions and "intervals" in need else "")


Means = Mapping[str, tuple[float | tuple[float, float], float]]
"""By the name of a read-out its mean, or the two ends of a range, and the standard error."""


def asked_for(measured: Any, readouts: Sequence[str] | None, besides: Means | None) -> list[str]:
    """The names of read-outs; those of published means if left out."""
    if isinstance(readouts, str):
        raise arguments.wrong("readouts", readouts, "a list of read-outs")
    own = measured if isinstance(measured, Mapping) and not isinstance(measured, _tracks.Tracks) else []
    return list(dict.fromkeys([*(own if readouts is None else readouts), *arguments.mapping("besides", besides)]))


def measurement(measured: _tracks.Tracks | Means, names: Sequence[str], besides: Means | None = None) -> Measurement:
    """:param measured: tracks, or by the name of a read-out its mean, or range, and standard error
    :param names: of the read-outs
    :param besides: means and standard errors of read-outs that tracks do not have
    :raises ConfigurationError: with all that is wrong
    """
    if isinstance(measured, (str, os.PathLike)):
        raise TypeError(f"measured is the text {str(measured)!r}; tracks are expected, as "
                        f"matrigrate.tracks.read({str(measured)!r}) gives them, or a dictionary of means and standard errors")
    if not isinstance(measured, Mapping):
        raise arguments.wrong("measured", measured, "tracks, or a dictionary of means and standard errors,")
    is_tracks = isinstance(measured, _tracks.Tracks)
    if is_tracks:
        core()  # without it there is no read-out of tracks: it says so
    arguments.mapping("besides", besides, "a dictionary of means and standard errors")
    means = dict(besides or {}) if is_tracks else {**measured, **(besides or {})}
    refuse([f"{name}: {value!r} is no mean with its standard error; write {{\"{name}\": (14.4, 4.8)}}, or ((12, 16), 4.8) of a range"
            for name, value in means.items() if not _is_measured(value)])
    rows = {name: _row(value, error) for name, (value, error) in means.items()}
    table = require_pandas().DataFrame.from_dict(rows, orient="index", columns=["value", "standard_error", "low", "high"], dtype=float)
    own = [name for name in names if name in _tracks.meanings() and name not in means] if is_tracks else []
    if own:
        n = len(measured)
        share = n / max(1, n - 1)  # the bootstrap's variance is too small by it
        found = measured.readouts().loc[own, ["value", "standard_error"]] * [1.0, share**0.5]
        found = found.assign(low=found["value"], high=found["value"])
        table = require_pandas().concat([found, table])
    lacking = [name for name in names if name not in table.index]
    known = f"; tracks have {', '.join(_tracks.meanings())}" if is_tracks else ""
    faults = [f"{name}: has no measured value{known}" for name in lacking]
    faults += [f"{name}: is measured, but not among the read-outs {', '.join(names)}" for name in means if names and name not in names]
    faults += _faults(table.loc[[name for name in names if name not in lacking]], measured)
    if not names:
        faults.append("one read-out is needed, such as readouts=[\"speed_um_per_h\", \"straightness\"]" + known)
    refuse(faults)
    table = table.loc[list(names)]
    with np.errstate(over="ignore"):  # errors that tell nothing are faults later, beside what was simulated
        covariance = np.diag(table["standard_error"].to_numpy(float)**2)
    if own:
        at = [list(names).index(name) for name in own]
        covariance[np.ix_(at, at)] = share * measured.covariance(own)
    if not is_tracks:
        return Measurement(table, covariance, 0, 0, [])
    return Measurement(table, covariance, len(measured), int(np.median([len(track) for track in measured.values()])),
                       list(measured.notes))


def _is_pair(value: Any) -> bool:
    return isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, (str, bytes)) and len(value) == 2


def _is_measured(value: Any) -> bool:
    return _is_pair(value) and all(isinstance(one, (int, float, np.number)) and not isinstance(one, (bool, np.bool_))
                                   for one in (*(value[0] if _is_pair(value[0]) else value[:1]), value[1]))


def _row(value: Any, error: float) -> tuple[float, float, float, float]:
    """Of a range, its middle stands for the value, or its finite end."""
    low, high = (float(end) for end in value) if _is_pair(value) else (float(value), float(value))
    middle = low + 0.5 * (high - low) if np.isfinite([low, high]).all() else high if np.isinf(low) else low
    return (middle if low <= high else float("nan")), float(error), low, high


def _faults(table: pandas.DataFrame, measured: Any) -> list[str]:
    faults = []
    for name, row in table.iterrows():
        why = f": it {_tracks.needs[name]}" if isinstance(measured, _tracks.Tracks) and name in _tracks.needs else ""
        if not row["low"] <= row["high"] and np.isfinite(row["low"]):
            faults.append(f"{name}: ({row['low']:g}, {row['high']:g}) is no range from a lower to a higher end")
        elif not np.abs(row["value"]) < np.inf:
            faults.append(f"{name}: has no value{why}")
        elif not (row["standard_error"] > 0 and np.isfinite(row["standard_error"])):
            faults.append(f"{name}: has no standard error above 0")
    return faults


def size_faults(table: pandas.DataFrame, values: pandas.DataFrame) -> list[str]:
    """Measured values and errors that simulated ones cannot be compared with: most often another unit.

    :param values: simulated, a column a read-out
    """
    faults = []
    for name, row in table.iterrows():
        known = values[name].to_numpy(float)
        known = known[np.isfinite(known)]
        width = float(np.ptp(known)) if len(known) else 0.0
        if not 0 < width < np.inf:
            continue
        value, error = float(row["value"]), float(row["standard_error"])
        simulated = f"simulated ones reach from {known.min():.3g} to {known.max():.3g}"
        if abs(value - known.mean()) > _most_widths * width:
            faults.append(f"{name}: the measured value is {value:.3g}, {simulated}: is the unit right?")
        if not _least_widths * width <= error <= _most_widths * width:
            faults.append(f"{name}: the standard error is {error:.3g}, {simulated}: nothing can be told with such an error")
    return faults


def lost(results: pandas.DataFrame) -> list[str]:
    """What runs that are not done mean for those that are."""
    undone = results["status"] != "done"
    at_rim = int((results["cause"] == "rim").sum()) if "cause" in results else 0
    notes = [f"{int(undone.sum())} runs of the study are not done, and left out"] if undone.any() else []
    if at_rim:
        notes.append(f"{at_rim} of {len(results)} runs ended at the rim of the matrix: what is left are the slower cells, and the fit leans "
                     "to parameters of faster ones; run the study in a larger ecm.radius")
    return notes


def simulated(runs: Runs, names: Sequence[str], interval: float | None, error: float = 0.0) -> Points:
    """The read-outs of all points with runs that are done: those of tracks from all tracks of a point, others as the mean
    of its runs.

    :param interval: [s] between positions of the measured tracks; none: a read-out that the runs have themselves is theirs
    :param error: localisation error of a coordinate [um], added to the simulated tracks
    """
    if isinstance(names, str):
        raise arguments.wrong("readouts", names, "a list of read-outs")
    if not 0 <= error < float("inf"):
        raise ConfigurationError(f"error: {error:g} um is no localisation error")
    if interval is not None:
        core()  # as above
    known, results = runs.readouts, runs.table
    of_tracks = [name for name in names if name in _tracks.meanings() and (interval is not None and runs.studies or name not in known)]
    of_runs = [name for name in names if name not in of_tracks]
    _require_numbers(runs, of_tracks, of_runs, interval)
    rows, points, counts, done, all_seen, positions = [], [], [], [], list[_tracks.Tracks](), list[int]()
    for _, of_point in results[results["status"] == "done"].groupby("point", sort=False):
        own = of_point[of_runs].where(np.isfinite(of_point[of_runs].astype(float)))
        row = dict(own.mean())
        if of_tracks:
            cells = {f"{run}/{track}": positions for run in of_point["run"]
                     for track, positions in _tracks.of(runs.studies[run].runs[run], interval).items()}
            seen = _tracks.Tracks(cells, interval or 1.0, [])
            seen = seen.with_error(error, seed=len(rows) + 1) if error > 0 else seen
            all_seen.append(seen)
            positions += map(len, seen.values())
            row |= dict(seen.readouts(resamples=0)["value"][of_tracks])
        rows.append(row)
        points.append(of_point[runs.parameters].iloc[0])
        counts.append(dict.fromkeys(of_tracks, len(of_point)) | dict(own.count()))
        done.append(len(of_point))
    frame = require_pandas().DataFrame
    of_all = frame(counts, columns=list(names))
    notes = [f"{name}: {int(few)} of {sum(done)} runs that are done do not have it; their points have the mean of the others, or none"
             for name, few in (sum(done) - of_all.sum()).items() if few > 0]
    if error > 0 and not of_tracks:
        notes.append(f"error: {error:g} um is not added: no read-out is computed from simulated tracks")
    return Points(frame(points, columns=runs.parameters).reset_index(drop=True), frame(rows, columns=list(names)), of_all, min(done, default=0),
                  int(np.median(positions)) if positions else 0, [*lost(results), *notes], all_seen, runs.design)


def _require_numbers(runs: Runs, of_tracks: Sequence[str], of_runs: Sequence[str], interval: float | None) -> None:
    known = runs.readouts
    faults = [f"{name}: only numbers can be fitted" for name in runs.parameters if runs.table[name].dtype == object]
    if unknown := [name for name in of_runs if name not in known]:
        faults.append(f"there is no read-out {', '.join(unknown)}; there are {', '.join([*_tracks.meanings(), *known])}")
    faults += [f"{name}: is no number in the runs" for name in of_runs if name in known and runs.table[name].dtype == object]
    if of_tracks and not runs.studies:
        faults.append(f"{', '.join(of_tracks)}: the table has no such column, and no tracks")
    elif of_tracks and interval is None:
        faults.append("interval: that of the measured tracks is needed [s]: speed, ratios and angles depend on it")
    if not (of_tracks or of_runs):
        faults.append("one read-out is needed")
    refuse(faults)


def differences(points: Points, wanted: Measurement) -> list[str]:
    """In what simulated and measured tracks differ, where a read-out depends on it."""
    notes = []
    biased = [name for name in wanted.table.index if name in _tracks.meanings() and name not in means_of_tracks]
    if biased and points.runs != wanted.cells:
        notes.append(f"{', '.join(biased)}: depends on the number of tracks; a point has {points.runs}, "
                     + (f"{wanted.cells} were measured" if wanted.cells else "give it as many as were measured"))
    if points.positions and wanted.positions and abs(points.positions - wanted.positions) > 0.1 * wanted.positions:
        notes.append(f"measured tracks have {wanted.positions} positions, simulated ones {points.positions}: ratios and slopes "
                     "depend on it")
    return notes
