"""Measured read-outs, and the same read-outs of the points of a study."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _motility
from . import tracks as _tracks
from ._files import _pandas
from .errors import ConfigurationError
from .studies import Study

if TYPE_CHECKING:
    import pandas

_means = ("speed_um_per_h", "net_speed_um_per_h", "straightness", "directionality_ratio", "turning_angle_deg",
          "turning_cosine")  # of tracks: their expectation does not depend on the number of tracks


@dataclass(frozen=True)
class Measurement:
    """Measured read-outs with their errors."""

    table: pandas.DataFrame  #: a row a read-out: ``value``, ``standard_error``
    covariance: np.ndarray[Any, Any]  #: of the measured values
    cells: int  #: tracks that were measured; 0 if only published means are known
    positions: int  #: of a track, median; 0 if only published means are known
    notes: list[str]


@dataclass(frozen=True)
class Points:
    """Simulations of a study, a row a point."""

    parameters: pandas.DataFrame
    values: pandas.DataFrame  #: a column a read-out
    runs: np.ndarray[Any, Any]  #: that are done
    positions: int  #: of a track, median; 0 if no read-out is one of tracks
    notes: list[str]
    tracks: list[_tracks.Tracks] = field(default_factory=list)  #: of each point; none if no read-out is one of tracks


Means = Mapping[str, tuple[float, float]]


def measurement(measured: _tracks.Tracks | Means, names: Sequence[str], besides: Means | None = None) -> Measurement:
    """:param measured: tracks, or by the name of a read-out its mean and standard error
    :param names: of the read-outs
    :param besides: means and standard errors of read-outs that tracks do not have
    :raises ConfigurationError: with all that is wrong
    """
    is_tracks = isinstance(measured, _tracks.Tracks)
    means = dict(besides or {}) if is_tracks else {**measured, **(besides or {})}
    table = _pandas().DataFrame.from_dict(means, orient="index", columns=["value", "standard_error"], dtype=float)
    own = [name for name in names if name in _motility.meanings and name not in means] if is_tracks else []
    if own:
        n = len(measured)
        share = n / max(1, n - 1)  # the bootstrap's variance is too small by it
        found = measured.readouts().loc[own, ["value", "standard_error"]] * [1.0, share**0.5]
        table = _pandas().concat([found, table])
    lacking = [name for name in names if name not in table.index]
    known = f"; tracks have {', '.join(_motility.meanings)}" if is_tracks else ""
    faults = [f"{name}: has no measured value{known}" for name in lacking]
    faults += _faults(table.loc[[name for name in names if name not in lacking]])
    if not names:
        faults.append("one read-out is needed")
    if faults:
        raise ConfigurationError("\n".join(faults))
    table = table.loc[list(names)]
    covariance = np.diag(table["standard_error"].to_numpy(float)**2)
    if own:
        at = [list(names).index(name) for name in own]
        covariance[np.ix_(at, at)] = share * measured.covariance(own)
    if not is_tracks:
        return Measurement(table, covariance, 0, 0, [])
    return Measurement(table, covariance, len(measured), int(np.median([len(track) for track in measured.values()])),
                       list(measured.notes))


def _faults(table: pandas.DataFrame) -> list[str]:
    return [f"{name}: has no value" if not np.isfinite(row["value"]) else f"{name}: has no standard error above 0"
            for name, row in table.iterrows() if not np.isfinite(row["value"]) or not row["standard_error"] > 0]


def simulated(study: Study, names: Sequence[str], interval: float | None, error: float = 0.0) -> Points:
    """The read-outs of all points with runs that are done: those of tracks from all tracks of a point, others as the mean
    of its runs.

    :param interval: [s] between positions of the measured tracks
    :param error: localisation error of a coordinate [um], added to the simulated tracks
    """
    results = study.results
    own = list(results.columns)
    known = own[own.index("trajectory_hash") + 1:]
    of_tracks = [name for name in names if name in _motility.meanings]
    of_runs = [name for name in names if name not in of_tracks]
    texts = [name for name in study.parameters if results[name].dtype == object]
    faults = [f"{name}: only numbers can be fitted" for name in texts]
    if unknown := [name for name in of_runs if name not in known]:
        faults.append(f"there is no read-out {', '.join(unknown)}; there are {', '.join([*_motility.meanings, *known])}")
    if of_tracks and interval is None:
        faults.append("interval: that of the measured tracks is needed [s]: speed, ratios and angles depend on it")
    if not names:
        faults.append("one read-out is needed")
    if faults:
        raise ConfigurationError("\n".join(faults))
    rows, points, counts, all_seen = [], [], [], list[_tracks.Tracks]()
    for _, runs in results[results["status"] == "done"].groupby("label", sort=False):
        row = {name: runs[name].mean() for name in of_runs}
        if of_tracks:
            cells = {f"{run}/{track}": positions for run in runs["run"]
                     for track, positions in _tracks.of(study.runs[run], interval).items()}
            seen = _tracks.Tracks(cells, interval or 1.0, [])
            seen = seen.with_error(error, seed=len(rows) + 1) if error > 0 else seen
            all_seen.append(seen)
            row |= dict(seen.readouts(resamples=0)["value"][of_tracks])
        rows.append(row)
        points.append(runs[study.parameters].iloc[0])
        counts.append(len(runs))
    undone = int((results["status"] != "done").sum())
    notes = [f"{undone} runs of the study are not done, and left out"] if undone else []
    lengths = [len(track) for seen in all_seen for track in seen.values()]
    frame = _pandas().DataFrame
    return Points(frame(points, columns=study.parameters).reset_index(drop=True), frame(rows, columns=list(names)).reset_index(drop=True),
                  np.array(counts, dtype=float), int(np.median(lengths)) if lengths else 0, notes, all_seen)


def differences(points: Points, wanted: Measurement) -> list[str]:
    """In what simulated and measured tracks differ, where a read-out depends on it."""
    notes = []
    few = int(points.runs.min(initial=0))
    biased = [name for name in wanted.table.index if name in _motility.meanings and name not in _means]
    if biased and few != wanted.cells:
        notes.append(f"{', '.join(biased)}: depends on the number of tracks; a point has {few}, "
                     + (f"{wanted.cells} were measured" if wanted.cells else "give it as many as were measured"))
    if points.positions and wanted.positions and abs(points.positions - wanted.positions) > 0.1 * wanted.positions:
        notes.append(f"measured tracks have {wanted.positions} positions, simulated ones {points.positions}: ratios and slopes "
                     "depend on it")
    return notes
