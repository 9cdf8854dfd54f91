"""Emulators of a study, or of several, and what is fitted by them. ``matrigrate.calibrate.fit`` is their user."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from .. import tracks
from ..base import arguments
from ..base.files import require_pandas
from ..draw import words
from ..errors import refuse
from ..results.studies import Study
from .conditions import by_condition, first_study, require_study, runs_of, Source, targets_of
from .emulator import Array, Emulator, Prior, sobol
from .measurement import Means, Measurement, Points, asked_for, measurement, simulated, size_faults
from .posterior import Fit, Part, each, joint, said
from .process import scipy

if TYPE_CHECKING:
    import pandas

_draws = 12000  # from the prior
_least_points = 10  # for each parameter
_many_parameters = 6  # above which emulators have a linear part
_largest_discrepancy = 1e100  # its square is a number


@dataclass(frozen=True)
class Emulators:
    """Gaussian processes of read-outs of a study, for one fit or several."""

    prior: Prior
    names: list[str]  #: of the read-outs
    processes: list[Emulator]
    points: Points
    sensitivity: pandas.DataFrame  #: as ``Fit.sensitivity``
    notes: list[str]
    study: str = ""  #: its folder

    def __repr__(self) -> str:
        return "\n".join(f"{name}: predicts {one.explained:.0%} ± {one.explained_error:.0%} of the variance of points; the 90 % intervals have "
                         f"{one.coverage:.0%}" for name, one in zip(self.names, self.processes, strict=True))

    def fit(self, measured: tracks.Tracks | Means, *, besides: Means | None = None,
            discrepancy: Mapping[str, float] | None = None, seed: int = 1) -> Fit:
        """The posterior of the parameters: the likelihood has the errors of the measured read-outs, of the emulators and of
        the model.

        :param measured: tracks; or published means, or ranges, and standard errors by the names of read-outs
        :param besides: means and standard errors of read-outs that tracks do not have: ``{"l_prot_um": (13.1, 0.4)}``
        :param discrepancy: standard error of the model itself, by the names of read-outs
        :raises ConfigurationError: with all that is wrong
        """
        wanted = measurement(measured, self.names, besides)
        faults, own = discrepancies(discrepancy, {"": self.names})
        refuse(faults + size_faults(wanted.table, self.points.values))
        return joint([Part("", self, wanted, own, measured)], [], seed)

    def predicted(self, cube: Array) -> tuple[Array, Array]:
        """Means and standard errors at points, a column a read-out."""
        both = [process(cube) for process in self.processes]
        return np.column_stack([mean for mean, _ in both]), np.column_stack([error for _, error in both])

    @cached_property
    def of_prior(self) -> tuple[Array, Array, Array]:
        """Points drawn from the prior, and what the emulators say there: the same for all fits."""
        cube = self.prior.snapped(np.random.default_rng(1).random((_draws, len(self.prior.names))))
        return cube, *self.predicted(cube)


def emulate(study: Study, readouts: Sequence[str], *, interval: float | None = None, error: float = 0.0,
            prior: Mapping[str, tuple[float, float] | tuple[float, float, str]] | None = None, seed: int = 1) -> Emulators:
    """Gaussian processes of read-outs over the parameters of a study, from its runs that are done.

    :param study: a Latin hypercube, whose runs are as long as the measured tracks
    :param readouts: of tracks, such as ``"speed_um_per_h"``, or of ``study.results``, such as ``"l_prot_um"``
    :param interval: [s] between positions of the measured tracks
    :param error: localisation error of a coordinate [um], added to the simulated tracks
    :param prior: ranges by the columns of ``study.parameters``: ``{"ecm.youngs_modulus_Pa": (50, 400, "log")}``; those of
        the points of the study if left out, whatever became of their runs
    :raises ConfigurationError: with all that is wrong
    :raises ImportError: without SciPy
    """
    scipy()
    require_study(study)
    points = simulated(runs_of(study, [], [])[""], readouts, interval, error)
    return replace(of_points(points, prior, seed), study=str(study.folder))


def fit(study: Source | Mapping[str, Source], measured: Any = None, readouts: Sequence[str] | None = None, *,
        besides: Any = None, held_back: Sequence[str] = (), interval: float | None = None, error: float = 0.0,
        prior: Mapping[str, tuple[float, float] | tuple[float, float, str]] | None = None,
        discrepancy: Mapping[str, float] | None = None, seed: int = 1) -> Fit:
    """The posterior of the parameters of a study, from what was measured under one condition or several.

    :param study: a Latin hypercube; or a list of studies, of one wave after the other; or a dictionary of these by the name of a condition. In
        place of a study a data frame may stand: a row per run, columns of parameters, which ``prior`` names, of read-outs, and ``condition``
    :param measured: tracks, whose interval is taken; or means and standard errors by the names of read-outs, such as
        ``{"l_prot_um": (8.2, 0.5)}``, or of a range ``{"l_prot_um": ((8, 12), 0.5)}``, whose ends may be infinite. Under several conditions a
        dictionary of these by the names of ``[[conditions]]``. The ``[[targets]]`` of the study if left out
    :param readouts: of tracks; those of published means if left out
    :param besides: means and standard errors of read-outs that tracks do not have: ``{"l_prot_um": (13.1, 0.4)}``; by condition, if ``measured`` is
    :param held_back: numbers that are predicted, not fitted: ``["l_prot_um at 400 Pa"]``, or ``["l_prot_um"]`` at all conditions
    :param discrepancy: standard error of the model itself, by the names of numbers or read-outs
    :raises ConfigurationError: with all that is wrong
    """
    require_study(study)
    if measured is None:
        measured = targets_of(study)
    several = by_condition(measured)
    given = dict(measured) if several else {"": measured}
    refuse([f"measured: {name}: is neither tracks nor a dictionary of numbers, as other conditions have"
            for name, one in given.items() if several and not isinstance(one, Mapping)])
    more = arguments.mapping("besides", besides) if several else {"": besides}
    refuse([f"besides: {name}: nothing was measured under such a condition" for name in more if name not in given])
    wanted = each(given, lambda name: measurement(given[name], asked_for(given[name], readouts, more.get(name)), more.get(name)))
    faults, own = discrepancies(discrepancy, {name: list(one.table.index) for name, one in wanted.items()})
    kept = _held_back(wanted, held_back)
    runs = runs_of(study, list(given) if several else [], list(arguments.mapping("prior", prior, "a dictionary of ranges")))
    intervals = {name: one.interval if isinstance(one, tracks.Tracks) else interval for name, one in given.items()}
    points = each(given, lambda name: simulated(runs[name], list(wanted[name].table.index), intervals[name], error))
    faults += [fault for name, one in points.items() for fault in said(name, size_faults(wanted[name].table, one.values))]
    refuse(faults)
    scipy()

    def of(names: Mapping[str, list[str]]) -> list[Part]:
        made = each([name for name in given if names[name]], lambda name: of_points(points[name].only(names[name]), prior, seed))
        return [Part(name, one, wanted[name].only(names[name]), own, given[name]) for name, one in made.items()]

    parts = of({name: [one for one in points[name].values if one not in kept[name]] for name in given})
    made = joint(parts, of(kept), seed)
    folders = list(dict.fromkeys(str(one.folder) for part in runs.values() for one in part.studies.values()))
    return replace(made, source={**made.source, "study": ", ".join(folders)}, _like=first_study(study))


def _held_back(wanted: Mapping[str, Measurement], given: Sequence[str]) -> dict[str, list[str]]:
    """The read-outs of each condition that are held back."""
    if isinstance(given, str):
        raise arguments.wrong("held_back", given, "a list of numbers")
    names = {condition: list(one.table.index) for condition, one in wanted.items()}
    kept = {condition: [name for name in own if name in given or words.at(name, condition) in given] for condition, own in names.items()}
    all_names = [words.at(name, condition) for condition, own in names.items() for name in own]
    faults = [f"held_back: {name}: was not measured; there are {', '.join(all_names)}" for name in given
              if name not in all_names and not any(name in own for own in names.values())]
    if not faults and kept == names:
        faults = ["held_back: one number is needed that is not held back"]
    refuse(faults)
    return kept


def of_points(points: Points, prior: Mapping[str, Any] | None = None, seed: int = 1) -> Emulators:
    names, whole = list(points.values.columns), points.whole
    parameters, fixed = varied(points.parameters[whole] if whole.any() else points.parameters)
    faults = [f"{name}: is the same in all simulations, {points.values.loc[whole, name].iloc[0]:.4g}: no parameter changes it; leave it out"
              for name in names if whole.sum() > 1 and points.values.loc[whole, name].nunique() == 1]
    if not parameters:
        faults.append("the study varies no parameter")
    elif whole.sum() < _least_points * len(parameters):
        faults.append(f"{int(whole.sum())} points have all read-outs; {_least_points * len(parameters)} are needed: "
                      f"{_least_points} for each parameter")
        faults += [*points.lacking(), *points.notes]
    ranges, prior_faults, prior_notes = prior_of(points.parameters.loc[whole, parameters], points.design[parameters], prior, fixed)
    refuse(faults + prior_faults)
    notes = [*points.notes, *(f"{name}: is {value:.6g} at all points with read-outs, so it is left out: nothing can be said of it"
                              for name, value in fixed.items()), *prior_notes]
    if not whole.all():
        notes.append(f"{int((~whole).sum())} points without all read-outs are left out: {'; '.join(points.lacking())}")
    cube = ranges.to_cube(points.parameters.loc[whole, parameters].to_numpy(float))
    processes = [Emulator(cube, *(table.loc[whole, name].to_numpy(float) for table in (points.values, points.counts)), seed,
                          len(parameters) > _many_parameters) for name in names]
    notes += [f"{name}: depends on no parameter, as far as the points can tell: it is left out of the likelihood, and so are its Sobol indices"
              for name, process in zip(names, processes, strict=True) if not process.tells]
    return Emulators(ranges, names, processes, points, _sensitivity(names, parameters, processes, seed), notes)


def varied(parameters: pandas.DataFrame) -> tuple[list[str], dict[str, float]]:
    """The parameters that vary, and the values of those that do not."""
    names = [name for name in parameters if parameters[name].nunique() > 1]
    return names, {name: float(parameters[name].iloc[0]) for name in parameters if name not in names and len(parameters)}


def prior_of(points: pandas.DataFrame, design: pandas.DataFrame, given: Mapping[str, Any] | None,
             fixed: Mapping[str, float]) -> tuple[Prior, list[str], list[str]]:
    """What is given, else the ranges of the design: in the logarithm where that is spread more evenly.

    :param points: those with read-outs   :param design: all of them   :param fixed: parameters that do not vary
    :return: the prior, faults, notes
    """
    given = arguments.mapping("prior", given, "a dictionary of ranges")
    faults = [f"prior: {name}: is {fixed[name]:.6g} at all points, so no range can be fitted" if name in fixed else
              f"prior: the study does not vary {name}; it varies {', '.join(design)}" for name in given if name not in design]
    low, high, is_log, notes = [], [], [], []
    for name in design:
        values = np.sort(design[name].to_numpy(float))
        entry = _range_of(given[name]) if name in given else ()
        if entry is None:
            faults.append(f"prior: {name}: {given[name]!r} is no range (low, high) or (low, high, \"log\") of finite numbers")
        ends = entry[:2] if entry else (float(values[0]), float(values[-1]))
        low.append(ends[0])
        high.append(ends[1])
        is_log.append(entry[2:] == ("log",) if entry else bool(values[0] > 0 and _unevenness(np.log(values)) < _unevenness(values)))
        done = points[name].to_numpy(float)
        if is_log[-1] and values[0] <= 0:
            faults.append(f"prior: {name}: points reach down to {values[0]:.4g}, which has no logarithm")
        elif len(done) and (side := beyond(done, ends, is_log[-1])):
            notes.append(f"prior: {name}: {ends[0]:.4g} to {ends[1]:.4g} goes {side} the points with read-outs, {done.min():.4g} to "
                         f"{done.max():.4g}: nothing is known there, and the emulators extrapolate")
    whole = [(known := words.parameter_of(name)) is not None and known.kind == "integer" for name in design]
    return Prior(list(design), np.array(low), np.array(high), [log and not one for log, one in zip(is_log, whole, strict=True)], whole), faults, notes


def _range_of(entry: Any) -> tuple[Any, ...] | None:
    """(low, high) or (low, high, "log"), or None if it is no range."""
    if isinstance(entry, str) or not isinstance(entry, Sequence) or len(entry) not in (2, 3) or list(entry[2:]) not in ([], ["log"]) \
            or not all(map(arguments.is_number, entry[:2])):
        return None
    low, high = float(entry[0]), float(entry[1])
    return (low, high, *entry[2:]) if low < high and (len(entry) == 2 or low > 0) else None


def beyond(values: Array, ends: tuple[float, float], is_log: bool) -> str:
    """By more than the gap that a Latin hypercube leaves at its ends."""
    scale = np.log if is_log else np.asarray
    first, last, low, high = (float(scale(value)) for value in (values.min(), values.max(), *ends))
    gap = max(0.05, 1.0 / len(values)) * (last - first)
    sides = [side for side, off in (("below", first - low), ("above", high - last)) if off > gap]
    return " and ".join(sides)


def discrepancies(given: Mapping[str, float] | None,
                  names: Mapping[str, Sequence[str]]) -> tuple[list[str], dict[str, float]]:
    """Standard errors of the model, by the names of numbers or of read-outs; and faults.  :param names: of read-outs, by condition"""
    own = dict(arguments.mapping("discrepancy", given, "a dictionary of standard errors"))
    known = {wanted for condition, readouts in names.items() for name in readouts for wanted in (name, words.at(name, condition))}
    faults = [f"discrepancy: {name}: is no read-out of the emulators" for name in own if name not in known]
    faults += [f"discrepancy: {name}: {value!r} is no standard error" for name, value in own.items()
               if not (arguments.is_number(value) and 0 <= value < _largest_discrepancy)]
    return faults, own


def _unevenness(values: Array) -> float:
    spread = np.ptp(values)
    return float(np.abs((values - values[0]) / (spread or 1.0) - np.linspace(0, 1, len(values))).max())


def _sensitivity(names: list[str], parameters: list[str], emulators: Sequence[Emulator], seed: int) -> pandas.DataFrame:
    rows = []
    for name, emulator in zip(names, emulators, strict=True):
        first, total = sobol(emulator, len(parameters), seed) if emulator.tells else np.full((2, len(parameters), 3), np.nan)
        rows += [[name, parameter, *first[k], *total[k]] for k, parameter in enumerate(parameters)]
    return require_pandas().DataFrame(rows, columns=["readout", "parameter", "first", "first_5", "first_95", "total", "total_5",
                                              "total_95"])
