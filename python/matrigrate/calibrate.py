"""Parameters from measured tracks: which points of a study give cells like the measured ones.

    from matrigrate import calibrate, tracks

    cells = tracks.read("spots.csv", pixel=0.65, interval=120)
    study = matrigrate.load_study("design-study")         # a Latin hypercube: its ranges are the prior
    fit = calibrate.fit(study, cells, ["speed_um_per_h", "straightness"])
    fit.write("fit")                                      # fit/report.html, and tables
"""
from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from . import tracks as _tracks
from ._files import _pandas
from ._fit import Emulators, Fit, emulate, fit, varied
from ._match import Match, Wave, match
from ._measurement import differences, measurement, require_study, simulated, size_faults
from ._outcomes import Outcome, read_outcomes
from ._posterior import at_bound, bound_note, constrained_width
from .errors import ConfigurationError
from .studies import Study

if TYPE_CHECKING:
    import pandas

__all__ = ["Emulators", "Fit", "Match", "Outcome", "Posterior", "Wave", "by_tracks", "emulate", "fit", "match", "read_outcomes", "weigh"]

_least_sample = 20.0


@dataclass(frozen=True)
class Posterior:
    """Posterior of the parameters, given measured read-outs."""

    weights: np.ndarray[Any, Any]  #: of the points; their sum is 1
    table: pandas.DataFrame
    """A row a parameter that varies: quantiles of prior and posterior, ``width`` (of the 90 % interval, over that of the prior),
    ``constrained``: whether the width is below 0.8 and the prior cuts off neither end, and ``at_bound``: the bound of the prior at
    which the posterior ends, "lower" or "upper"."""
    fit: pandas.DataFrame  #: a row a read-out: measured value, its error, weighted mean of the points, and their range
    widened: float  #: factor on the errors, above 1 where fewer than 20 points would have counted
    notes: list[str]

    def __repr__(self) -> str:
        return "\n".join([self.table.to_string(), "", self.fit.to_string(), *self.notes])


def weigh(points: pandas.DataFrame, found: pandas.DataFrame, measured: pandas.DataFrame) -> Posterior:
    """Approximate Bayesian computation with a normal kernel as wide as the standard errors of the measured read-outs. The scatter
    of simulations is in ``found``, so it widens the posterior: intervals err on the wide side.

    :param points: a row a simulation, a column a parameter, drawn from the prior
    :param found: the same rows, a column a read-out
    :param measured: a row a read-out, with ``value`` and ``standard_error``
    """
    names = list(measured.index)
    known = [name for name in names if name in found]
    whole = np.isfinite(found[known].to_numpy(float)).all(axis=1)
    if faults := _faults(points, found, measured, known, whole):
        raise ConfigurationError("\n".join(faults))
    notes = [f"{int((~whole).sum())} simulations without all read-outs are left out"] if not whole.all() else []
    notes += [f"{name}: is {value:.6g} in all simulations, so it is left out: nothing can be said of it"
              for name, value in varied(points[whole])[1].items()]
    value, error = measured["value"].to_numpy(float), measured["standard_error"].to_numpy(float)
    used = found.loc[whole, names].to_numpy(float)
    distance = np.full(len(points), np.inf)
    distance[whole] = (((used - value) / error)**2).sum(axis=1)

    def weights_at(factor: float) -> np.ndarray[Any, Any]:
        weights = np.exp(-(distance - distance.min()) / (2 * factor**2))
        return np.asarray(weights / weights.sum())

    factor = 1.0
    while 1 / np.sum(weights_at(factor)**2) < _least_sample:
        factor *= 1.1
    weights = weights_at(factor)
    if factor > 1:
        notes.append(f"errors are widened by a factor of {factor:.2g}, so that {_least_sample:g} points count: more points near "
                     "the measured read-outs would narrow the intervals")
    table = _table(points[whole], weights[whole], notes)
    fit = _pandas().DataFrame({"measured": value, "standard_error": error,
                               "posterior_mean": (used * weights[whole, None]).sum(axis=0),
                               "least": used.min(axis=0), "most": used.max(axis=0)}, index=names)
    notes += [f"no simulation reaches the measured {name}" for name, row in fit.iterrows()
              if not row["least"] - 2 * row["standard_error"] <= row["measured"] <= row["most"] + 2 * row["standard_error"]]
    return Posterior(weights, table, fit, factor, notes)


def _faults(points: pandas.DataFrame, found: pandas.DataFrame, measured: pandas.DataFrame, known: list[str], whole: Any) -> list[str]:
    """:param known: read-outs that the simulations have   :param whole: which simulations have all of them"""
    faults = [f"{name}: has no value" if not np.isfinite(row["value"]) else f"{name}: has no standard error above 0"
              for name, row in measured.iterrows() if not (np.isfinite(row["value"]) and 0 < row["standard_error"] < np.inf)]
    faults += [f"{name}: the simulations do not have it" for name in measured.index if name not in found]
    faults += [f"{name}: is the same in all simulations" for name in known if found.loc[whole, name].nunique() == 1]
    if not faults and whole.sum() < 2 * _least_sample:
        faults.append(f"{int(whole.sum())} simulations have all read-outs; {2 * _least_sample:g} are needed")
        faults += [f"{name}: {n} of {len(found)} simulations lack it" for name, n in (~np.isfinite(found[known])).sum().items() if n]
    elif not faults:
        faults += size_faults(measured, found[whole])
    if not len(measured) or not len(points.columns):
        faults.append("one read-out and one parameter are needed")
    elif whole.any() and not varied(points[whole])[0]:
        faults.append("no parameter varies")
    return faults


def _table(points: pandas.DataFrame, weights: Any, notes: list[str]) -> pandas.DataFrame:
    """A row a parameter that varies; to the notes is added what the data do not constrain."""
    rows = {}
    for name in varied(points)[0]:
        column = points[name].to_numpy(float)
        prior, after = _quantiles(column, np.ones(len(column))), _quantiles(column, weights)
        width = (after[2] - after[0]) / (prior[2] - prior[0]) if prior[2] > prior[0] else 1.0
        order = np.sort(column)
        rank = (np.searchsorted(order, column, "left") + np.searchsorted(order, column, "right")) / 2 / len(column)
        side = at_bound(rank, weights)
        rows[name] = [*prior, *after, width, bool(width < constrained_width and not side), side]
        if side:
            notes.append(bound_note(name, side, order[-1 if side == "upper" else 0]))
        if not width < constrained_width:
            notes.append(f"the data do not constrain {name}: its 90 % interval is {width:.0%} of the prior's")
    columns = ["prior_5", "prior_50", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]
    return _pandas().DataFrame.from_dict(rows, orient="index", columns=columns)


def by_tracks(study: Study, measured: _tracks.Tracks, readouts: Sequence[str], *, error: float = 0.0) -> Posterior:
    """What measured tracks say of the parameters of a study, by ``weigh``: without an emulator, and so with wider intervals
    than those of ``fit``.

    :param study: a Latin hypercube over the prior, whose runs are as long as the tracks
    :param readouts: those of tracks to compare, such as ``["speed_um_per_h", "straightness"]``
    :param error: localisation error of a coordinate [um], added to the simulated tracks
    """
    require_study(study)
    wanted = measurement(measured, readouts)
    points = simulated(study, readouts, measured.interval, error)
    posterior = weigh(points.parameters, points.values, wanted.table)
    posterior.notes[:0] = [*points.notes, *differences(points, wanted)]
    return posterior


def _quantiles(values: Any, weights: Any) -> tuple[float, float, float]:
    order = np.argsort(values)
    reached = np.cumsum(weights[order]) - weights[order] / 2
    low, middle, high = np.interp([0.05, 0.5, 0.95], reached / weights.sum(), values[order])
    return float(low), float(middle), float(high)
