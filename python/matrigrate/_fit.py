"""Posteriors on emulators. ``matrigrate.calibrate.fit`` is their user."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arguments, _emulator, _schema
from . import tracks as _tracks
from ._emulator import Array, Emulator, Prior
from ._files import _pandas, make_folder, unit_of
from ._measurement import Means, Measurement, Points, differences, measurement, require_study, simulated, size_faults
from ._process import scipy
from ._study_file import key_of
from .errors import ConfigurationError
from .studies import Study

if TYPE_CHECKING:
    import pandas

constrained_width = 0.8  #: of the 90 % interval of the prior: a wider one is not called constrained
_implausible = 3.0
_draws = 12000  # from the prior
_least_points = 10  # for each parameter
_largest_discrepancy = 1e100  # its square is a number


@dataclass(frozen=True)
class Fit:
    """What measured read-outs say of parameters, by emulators of a study."""

    table: pandas.DataFrame
    """A row per parameter: quantiles of prior and posterior, ``width`` of the 90 % interval over that of the prior, ``constrained``
    (whether it is below 0.8 and the prior cuts off neither end), ``at_bound`` ("lower" or "upper", the bound of the prior at which the
    posterior ends), and the range ``plausible_low`` to ``plausible_high`` that history matching leaves."""
    readouts: pandas.DataFrame
    """A row per read-out: measured value and error; mean and 5 and 95 % quantiles over the posterior; ``implausibility`` at
    the best point; of the emulator, ``predicted`` share of the variance of points and ``coverage`` of its 90 % intervals."""
    sensitivity: pandas.DataFrame
    """A row for each read-out and parameter: Sobol's ``first`` and ``total`` index, each with its 90 % interval."""
    sample: pandas.DataFrame  #: drawn from the posterior, a row per draw
    correlations: pandas.DataFrame  #: of the sample
    plausible: float  #: share of the prior that no read-out excludes by three standard errors
    effective_sample_size: float  #: independent draws with the same information as the weighted ones
    notes: list[str]
    prior: Prior
    measured: _tracks.Tracks | None = None  #: if tracks were measured
    simulated: _tracks.Tracks | None = None  #: of the points that fit best
    source: dict[str, str] = field(default_factory=dict)  #: folder of the study, file of the tracks, seed

    def __repr__(self) -> str:
        shown = ["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]
        return "\n".join([self.table[shown].to_string(float_format="%.4g"), "",
                          self.readouts.to_string(float_format="%.3g"), *self.notes])

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes posterior.csv, sample.csv, readouts.csv, sensitivity.csv and report.html, which needs no other file, into a
        new folder.

        :param overwrite: whether to replace these files in a folder that is there already
        :return: report.html
        """
        from ._report import page_of_fit

        path = _arguments.path("folder", folder)
        text = page_of_fit(self)
        make_folder(path, overwrite)
        for name, table in (("posterior", self.table), ("readouts", self.readouts)):
            table.to_csv(path / f"{name}.csv", index_label="parameter" if name == "posterior" else "readout")
        self.sensitivity.to_csv(path / "sensitivity.csv", index=False)
        self.sample.to_csv(path / "sample.csv", index=False)
        (path / "report.html").write_text(text, encoding="utf-8")
        return path / "report.html"


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
        return "\n".join(f"{name}: predicts {one.explained:.0%} ± {one.explained_error:.0%} of the variance of points; the 90 % intervals have {one.coverage:.0%}"
                         for name, one in zip(self.names, self.processes, strict=True))

    def fit(self, measured: _tracks.Tracks | Means, *, besides: Means | None = None,
            discrepancy: Mapping[str, float] | None = None, seed: int = 1) -> Fit:
        """The posterior of the parameters: the likelihood has the errors of the measured read-outs, of the emulators and of
        the model.

        :param measured: tracks; or published means and standard errors by the names of read-outs
        :param besides: means and standard errors of read-outs that tracks do not have: ``{"l_prot_um": (13.1, 0.4)}``
        :param discrepancy: standard error of the model itself, by the names of read-outs
        :raises ConfigurationError: with all that is wrong
        """
        return self._fit(measurement(measured, self.names, besides), measured, discrepancy, seed)

    def _fit(self, wanted: Measurement, measured: _tracks.Tracks | Means, discrepancy: Mapping[str, float] | None, seed: int) -> Fit:
        faults, own = _discrepancies(discrepancy, self.names)
        faults += size_faults(wanted.table, self.points.values)
        if faults:
            raise ConfigurationError("\n".join(faults))
        value = wanted.table["value"].to_numpy(float)
        covariance = wanted.covariance + np.diag([own.get(name, 0.0)**2 for name in self.names])
        parameters = self.prior.names
        even, means, errors = self._of_prior
        used = np.flatnonzero([one.tells for one in self.processes])  # others would add their noise only

        def likelihood(means: Array, errors: Array) -> Array:
            return _log_likelihood(means[:, used], errors[:, used], value[used], covariance[np.ix_(used, used)], wanted.cells)

        drawn, effective = _emulator.sampled(lambda at: likelihood(*_predictions(self.processes, self.prior.snapped(at))), even,
                                         likelihood(means, errors), seed=seed)
        notes = [*wanted.notes, *self.notes, *differences(self.points, wanted)]
        if effective < 200:
            notes.append(f"the effective sample size is only {effective:.0f}: quantiles are rough")
        far = np.abs(means - value) / np.sqrt(errors**2 + np.diag(covariance))
        kept = even[far.max(axis=1) < _implausible]
        best = far[np.argmin(far.max(axis=1))]
        if not len(kept):
            notes.append(f"no parameters within the ranges give such cells: {self.names[int(np.argmax(best))]} is off by "
                         f"{best.max():.1f} standard errors even at the best ones")
        correlations = _pandas().DataFrame(np.atleast_2d(np.corrcoef(drawn.T)), parameters, parameters)
        table = _table(self.prior, drawn, kept)
        notes += [bound_note(name, side, (self.prior.low if side == "lower" else self.prior.high)[k])
                  for k, (name, side) in enumerate(table["at_bound"].items()) if side]
        notes += _untold(table, correlations, self.sensitivity)
        after, _ = _predictions(self.processes, drawn[:1000])
        low, high = np.percentile(after, [5, 95], axis=0)
        shown = _pandas().DataFrame({
            "measured": value, "standard_error": wanted.table["standard_error"].to_numpy(float),
            "posterior_mean": after.mean(axis=0), "posterior_5": low, "posterior_95": high, "implausibility": best,
            "predicted": [one.explained for one in self.processes], "predicted_error": [one.explained_error for one in self.processes],
            "coverage": [one.coverage for one in self.processes]}, index=self.names)
        sample = _pandas().DataFrame(self.prior.from_cube(drawn), columns=parameters)
        both = (measured, self._nearest(likelihood, len(measured))) if isinstance(measured, _tracks.Tracks) else (None, None)
        source = {"study": self.study, "tracks": getattr(measured, "source", ""), "seed": str(seed)}
        return Fit(table, shown, self.sensitivity, sample, correlations, len(kept) / len(even), effective, notes, self.prior, *both, source)

    @cached_property
    def _of_prior(self) -> tuple[Array, Array, Array]:
        """Points drawn from the prior, and what the emulators say there: the same for all fits."""
        cube = self.prior.snapped(np.random.default_rng(1).random((_draws, len(self.prior.names))))
        return cube, *_predictions(self.processes, cube)

    def _nearest(self, likelihood: Callable[[Array, Array], Array], many: int) -> _tracks.Tracks | None:
        """As many tracks of the points whose emulated read-outs are nearest to the measured ones."""
        if not self.points.tracks:
            return None
        at = self.prior.to_cube(self.points.parameters[self.prior.names].to_numpy(float))
        likely = likelihood(*_predictions(self.processes, at))
        chosen = {name: track for k in np.argsort(-likely)[:many] for name, track in self.points.tracks[k].items()}
        return _tracks.Tracks(dict(list(chosen.items())[:many]), self.points.tracks[0].interval, [])


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
    return replace(of_points(simulated(study, readouts, interval, error), prior, seed), study=str(study.folder))


def fit(study: Study, measured: _tracks.Tracks | Means, readouts: Sequence[str] | None = None, *,
        besides: Means | None = None, interval: float | None = None, error: float = 0.0,
        prior: Mapping[str, tuple[float, float] | tuple[float, float, str]] | None = None,
        discrepancy: Mapping[str, float] | None = None, seed: int = 1) -> Fit:
    """``emulate`` and ``Emulators.fit`` in one: the posterior of the parameters of a study.

    :param measured: tracks, whose interval is taken; or published means and standard errors by the names of read-outs, such
        as ``{"l_prot_um": (8.2, 0.5)}``
    :param readouts: of tracks; those of published means if left out
    :param besides: means and standard errors of read-outs that tracks do not have: ``{"l_prot_um": (13.1, 0.4)}``
    """
    require_study(study)
    if isinstance(measured, _tracks.Tracks):
        interval = measured.interval
    given = measured if isinstance(measured, Mapping) and not isinstance(measured, _tracks.Tracks) else {}
    names = readouts if isinstance(readouts, str) else [*(given if readouts is None else readouts)]
    names = names if isinstance(names, str) else list(dict.fromkeys([*names, *_arguments.mapping("besides", besides)]))
    wanted = measurement(measured, names, besides)  # its faults come before the work
    emulators = emulate(study, names, interval=interval, error=error, prior=prior, seed=seed)
    return emulators._fit(wanted, measured, discrepancy, seed)


def of_points(points: Points, prior: Mapping[str, Any] | None = None, seed: int = 1) -> Emulators:
    names, whole = list(points.values.columns), points.whole
    design = points.parameters if points.design is None else points.design
    parameters, fixed = varied(points.parameters[whole] if whole.any() else points.parameters)
    faults = [f"{name}: is the same in all simulations" for name in names
              if whole.sum() > 1 and points.values.loc[whole, name].nunique() == 1]
    if not parameters:
        faults.append("the study varies no parameter")
    elif whole.sum() < _least_points * len(parameters):
        faults.append(f"{int(whole.sum())} points have all read-outs; {_least_points * len(parameters)} are needed: "
                      f"{_least_points} for each parameter")
        faults += [*points.lacking(), *points.notes]
    ranges, prior_faults, prior_notes = prior_of(points.parameters.loc[whole, parameters], design[parameters], prior, fixed)
    if faults + prior_faults:
        raise ConfigurationError("\n".join(faults + prior_faults))
    notes = [*points.notes, *(f"{name}: is {value:.6g} at all points with read-outs, so it is left out: nothing can be said of it"
                              for name, value in fixed.items()), *prior_notes]
    if not whole.all():
        notes.append(f"{int((~whole).sum())} points without all read-outs are left out: {'; '.join(points.lacking())}")
    cube = ranges.to_cube(points.parameters.loc[whole, parameters].to_numpy(float))
    processes = [Emulator(cube, points.values.loc[whole, name].to_numpy(float), points.runs[whole], seed) for name in names]
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
    given = _arguments.mapping("prior", given, "a dictionary of ranges")
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
    whole = [bool(key := key_of(name)) and _schema.parameters()[key].kind == "integer" for name in design]
    return Prior(list(design), np.array(low), np.array(high), [log and not one for log, one in zip(is_log, whole, strict=True)], whole), faults, notes


def _range_of(entry: Any) -> tuple[Any, ...] | None:
    """(low, high) or (low, high, "log"), or None if it is no range."""
    if isinstance(entry, str) or not isinstance(entry, Sequence) or len(entry) not in (2, 3) or list(entry[2:]) not in ([], ["log"]):
        return None
    if not all(isinstance(end, (int, float, np.number)) and np.isfinite(end) for end in entry[:2]):
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


def _discrepancies(given: Mapping[str, float] | None, names: Sequence[str]) -> tuple[list[str], dict[str, float]]:
    own = dict(_arguments.mapping("discrepancy", given, "a dictionary of standard errors"))
    faults = [f"discrepancy: {name}: is no read-out of the emulators" for name in own if name not in names]
    faults += [f"discrepancy: {name}: {value!r} is no standard error" for name, value in own.items()
               if not (isinstance(value, (int, float, np.number)) and np.isfinite(value) and 0 <= value < _largest_discrepancy)]
    return faults, own


def _unevenness(values: Array) -> float:
    spread = np.ptp(values)
    return float(np.abs((values - values[0]) / (spread or 1.0) - np.linspace(0, 1, len(values))).max())


def _predictions(emulators: Sequence[Emulator], at: Array) -> tuple[Array, Array]:
    both = [emulator(at) for emulator in emulators]
    return np.column_stack([mean for mean, _ in both]), np.column_stack([error for _, error in both])


def _log_likelihood(means: Array, errors: Array, value: Array, covariance: Array, cells: int) -> Array:
    """Errors of emulators are independent: each read-out has its own. A covariance that is itself estimated from n tracks
    makes a t distribution of the normal one (Sellentin and Heavens 2016)."""
    whole = covariance + errors[:, :, None] * np.eye(len(value)) * errors[:, None, :]
    off = means - value
    squared = np.einsum("ij,ij->i", off, np.linalg.solve(whole, off[:, :, None])[:, :, 0])
    fit = -0.5 * squared if cells < 2 else -0.5 * cells * np.log1p(squared / (cells - 1))
    return np.asarray(fit - 0.5 * np.linalg.slogdet(whole)[1])


def _sensitivity(names: list[str], parameters: list[str], emulators: Sequence[Emulator], seed: int) -> pandas.DataFrame:
    rows = []
    for name, emulator in zip(names, emulators, strict=True):
        first, total = _emulator.sobol(emulator, len(parameters), seed) if emulator.tells else \
            np.full((2, len(parameters), 3), np.nan)
        rows += [[name, parameter, *first[k], *total[k]] for k, parameter in enumerate(parameters)]
    return _pandas().DataFrame(rows, columns=["readout", "parameter", "first", "first_5", "first_95", "total", "total_5",
                                              "total_95"])


def _table(prior: Prior, drawn: Array, kept: Array) -> pandas.DataFrame:
    ends = np.percentile(drawn, [5, 50, 95], axis=0)
    before = prior.from_cube(np.array([[0.05], [0.5], [0.95]]) * np.ones(len(prior.names)))
    after = prior.from_cube(ends)
    left = prior.from_cube(np.array([kept.min(axis=0), kept.max(axis=0)])) if len(kept) else np.full((2, len(prior.names)), np.nan)
    width = (ends[2] - ends[0]) / 0.9
    bounds = [at_bound(column) for column in drawn.T]
    constrained = (width < constrained_width) & (np.array(bounds) == "")
    return _pandas().DataFrame({"prior_5": before[0], "prior_50": before[1], "prior_95": before[2], "posterior_5": after[0],
                                "posterior_50": after[1], "posterior_95": after[2], "width": width, "constrained": constrained, "at_bound": bounds,
                                "plausible_low": left[0], "plausible_high": left[1]}, index=prior.names)


def _untold(table: pandas.DataFrame, correlations: pandas.DataFrame, sensitivity: pandas.DataFrame) -> list[str]:
    """What the data cannot tell, and why."""
    notes = []
    for name, row in table.iterrows():
        others = correlations[name].drop(name)
        tied = [f"{other} ({r:.2f})" for other, r in others.items() if abs(r) > 0.7]
        if tied:
            notes.append(f"{name} is constrained only together with {', '.join(tied)}: the correlation in the posterior")
        if row["width"] < constrained_width:
            continue
        total = sensitivity.loc[sensitivity["parameter"] == name, "total_95"].max()
        total = 0.0 if np.isnan(total) else total
        reason = f"no read-out depends on it (total index below {max(total, 0.01):.2f})" if total < 0.1 else \
            "the read-outs depend on it, but their errors are too large" if not tied else "see the correlation"
        notes.append(f"the data cannot tell {name}: its 90 % interval is {row['width']:.0%} of the prior's; {reason}")
    return notes


def at_bound(places: Any) -> str:
    """"lower" or "upper", if the posterior is cut off by that bound of the prior; else "".

    It is where its density in the last tenth of the prior is at least the prior's, and half of its largest: so there is no sign that it
    falls towards the bound. A posterior like that at both ends is the prior itself.

    :param places: from 0 to 1 in the prior
    """
    shares = np.histogram(np.clip(places, 0, 1), np.linspace(0, 1, 11))[0].astype(float)
    shares /= shares.sum()
    lower, upper = (bool(share >= max(0.1, 0.5 * shares.max())) for share in (shares[0], shares[-1]))
    return "" if lower == upper else "lower" if lower else "upper"


def bound_note(name: str, side: str, end: float) -> str:
    unit = unit_of(name)
    return (f"{name}: the posterior ends at the {side} bound of the prior, {end:.3g}{'' if unit == '1' else ' ' + unit}: "
            "widen the range")
