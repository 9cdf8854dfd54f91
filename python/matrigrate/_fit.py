"""Posteriors on emulators. ``matrigrate.calibrate.fit`` is their user."""
from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arguments, _emulator
from . import tracks as _tracks
from ._emulator import Array, Emulator, Prior
from ._files import _pandas
from ._measurement import Means, Points, differences, measurement, simulated
from .errors import ConfigurationError, InputOutputError
from .studies import Study

if TYPE_CHECKING:
    import pandas

_constrained = 0.8  # of the width of the prior
_implausible = 3.0
_draws = 12000  # from the prior
_least_explained = 0.05  # of the variance of points, for a read-out that depends on parameters
_least_points = 10  # for each parameter


@dataclass(frozen=True)
class Fit:
    """What measured read-outs say of parameters, by emulators of a study."""

    table: pandas.DataFrame
    """A row a parameter: quantiles of prior and posterior, ``width`` of the 90 % interval over that of the prior, ``constrained``
    (whether it is below 0.8), and the range ``plausible_low`` to ``plausible_high`` that history matching leaves."""
    readouts: pandas.DataFrame
    """A row a read-out: measured value and error; mean and 5 and 95 % quantiles over the posterior; ``implausibility`` at
    the best point; of the emulator, ``predicted`` share of the variance of points and ``coverage`` of its 90 % intervals."""
    sensitivity: pandas.DataFrame
    """A row for each read-out and parameter: Sobol's ``first`` and ``total`` index, each with its 90 % interval."""
    sample: pandas.DataFrame  #: drawn from the posterior, a row a draw
    correlations: pandas.DataFrame  #: of the sample
    plausible: float  #: share of the prior that no read-out excludes by three standard errors
    effective_sample_size: float  #: independent draws with the same information as the weighted ones
    notes: list[str]
    prior: Prior
    measured: _tracks.Tracks | None = None  #: if tracks were measured
    simulated: _tracks.Tracks | None = None  #: of the points that fit best

    def __repr__(self) -> str:
        shown = ["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained"]
        return "\n".join([self.table[shown].to_string(float_format="%.4g"), "",
                          self.readouts.to_string(float_format="%.3g"), *self.notes])

    def write(self, folder: str | os.PathLike[str]) -> Path:
        """Writes posterior.csv, sample.csv, readouts.csv, sensitivity.csv and report.html, which needs no other file, into a
        new folder.

        :return: report.html
        """
        from ._fit_report import page

        path = _arguments.path("folder", folder)
        text = page(self)
        try:
            path.mkdir(parents=True)
        except FileExistsError:
            raise InputOutputError(f"{path}: exists already; give a new folder", path) from None
        except OSError as error:
            raise InputOutputError(f"{path}: {error.strerror}", path) from None
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

    def __repr__(self) -> str:
        return "\n".join(f"{name}: predicts {one.explained:.0%} of the variance of points; the 90 % intervals have {one.coverage:.0%}"
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
        wanted = measurement(measured, self.names, besides)
        own = dict(discrepancy or {})
        faults = [f"discrepancy: {name}: is no read-out of the emulators" for name in own if name not in self.names]
        faults += [f"discrepancy: {name}: {value:g} is no standard error" for name, value in own.items()
                   if not (np.isfinite(value) and value >= 0)]
        if faults:
            raise ConfigurationError("\n".join(faults))
        value = wanted.table["value"].to_numpy(float)
        covariance = wanted.covariance + np.diag([own.get(name, 0.0)**2 for name in self.names])
        parameters = self.prior.names
        even, means, errors = self._of_prior
        used = np.flatnonzero([one.explained >= _least_explained for one in self.processes])  # others would add their noise only

        def likelihood(means: Array, errors: Array) -> Array:
            return _log_likelihood(means[:, used], errors[:, used], value[used], covariance[np.ix_(used, used)], wanted.cells)

        drawn, effective = _emulator.sampled(lambda at: likelihood(*_predictions(self.processes, at)), even, likelihood(means, errors),
                                         seed=seed)
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
        notes += _untold(table, correlations, self.sensitivity)
        after, _ = _predictions(self.processes, drawn[:1000])
        low, high = np.percentile(after, [5, 95], axis=0)
        shown = _pandas().DataFrame({
            "measured": value, "standard_error": wanted.table["standard_error"].to_numpy(float),
            "posterior_mean": after.mean(axis=0), "posterior_5": low, "posterior_95": high, "implausibility": best,
            "predicted": [one.explained for one in self.processes], "coverage": [one.coverage for one in self.processes]}, index=self.names)
        sample = _pandas().DataFrame(self.prior.from_cube(drawn), columns=parameters)
        both = (measured, self._nearest(likelihood, len(measured))) if isinstance(measured, _tracks.Tracks) else ()
        return Fit(table, shown, self.sensitivity, sample, correlations, len(kept) / len(even), effective, notes, self.prior, *both)

    @cached_property
    def _of_prior(self) -> tuple[Array, Array, Array]:
        """Points drawn from the prior, and what the emulators say there: the same for all fits."""
        cube = np.random.default_rng(1).random((_draws, len(self.prior.names)))
        return cube, *_predictions(self.processes, cube)

    def _nearest(self, likelihood: Callable[[Array, Array], Array], many: int) -> _tracks.Tracks | None:
        """As many tracks of the points whose emulated read-outs are nearest to the measured ones."""
        if not self.points.tracks:
            return None
        at = self.prior.to_cube(self.points.parameters.to_numpy(float))
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
        the points of the study if left out
    :raises ConfigurationError: with all that is wrong
    :raises ImportError: without scikit-learn
    """
    _emulator.sklearn()
    return of_points(simulated(study, list(readouts), interval, error), prior, seed)


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
    if isinstance(measured, _tracks.Tracks):
        interval = measured.interval
    given = {} if isinstance(measured, _tracks.Tracks) else measured
    names = list(dict.fromkeys([*(given if readouts is None else readouts), *(besides or {})]))
    measurement(measured, names, besides)  # its faults come before the work
    emulators = emulate(study, names, interval=interval, error=error, prior=prior, seed=seed)
    return emulators.fit(measured, besides=besides, discrepancy=discrepancy, seed=seed)


def of_points(points: Points, prior: Mapping[str, Any] | None = None, seed: int = 1) -> Emulators:
    names, parameters = list(points.values.columns), list(points.parameters.columns)
    whole = points.values.notna().all(axis=1).to_numpy(bool)
    faults = [f"{name}: is the same in all simulations" for name in names
              if whole.sum() > 1 and points.values.loc[whole, name].nunique() == 1]
    if not parameters:
        faults.append("the study varies no parameter")
    elif whole.sum() < _least_points * len(parameters):
        faults.append(f"{int(whole.sum())} points have all read-outs; {_least_points * len(parameters)} are needed: "
                      f"{_least_points} for each parameter")
    ranges, prior_faults = prior_of(points.parameters, prior)
    if faults + prior_faults:
        raise ConfigurationError("\n".join(faults + prior_faults))
    notes = list(points.notes)
    if not whole.all():
        notes.append(f"{int((~whole).sum())} points without all read-outs are left out")
    cube = ranges.to_cube(points.parameters[whole].to_numpy(float))
    processes = [Emulator(cube, points.values.loc[whole, name].to_numpy(float), points.runs[whole], seed) for name in names]
    notes += [f"{name}: depends on no parameter, as far as the points can tell: it is left out of the likelihood, and so are its Sobol indices"
              for name, process in zip(names, processes, strict=True) if process.explained < _least_explained]
    return Emulators(ranges, names, processes, points, _sensitivity(names, parameters, processes, seed), notes)


def prior_of(points: pandas.DataFrame, given: Mapping[str, Any] | None) -> tuple[Prior, list[str]]:
    """What is given, else the ranges of the points: in the logarithm where that is spread more evenly."""
    faults = [f"prior: the study does not vary {name}; it varies {', '.join(points)}" for name in given or {} if name not in points]
    low, high, is_log = [], [], []
    for name in points:
        values = np.sort(points[name].to_numpy(float))
        entry = tuple((given or {}).get(name, ()))
        if entry and not (len(entry) in (2, 3) and entry[0] < entry[1] and entry[2:] in ((), ("log",))
                          and (len(entry) == 2 or entry[0] > 0)):
            faults.append(f"prior: {name}: {entry} is no range (low, high) or (low, high, \"log\")")
            entry = ()
        ends = entry[:2] or (values[0], values[-1])
        low.append(float(ends[0]))
        high.append(float(ends[1]) if ends[1] > ends[0] else float(ends[0]) + 1.0)
        is_log.append(entry[2:] == ("log",) if entry else bool(values[0] > 0 and _unevenness(np.log(values)) < _unevenness(values)))
    return Prior(list(points), np.array(low), np.array(high), is_log), faults


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
        first, total = _emulator.sobol(emulator, len(parameters), seed) if emulator.explained >= _least_explained else \
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
    return _pandas().DataFrame({"prior_5": before[0], "prior_50": before[1], "prior_95": before[2], "posterior_5": after[0],
                                "posterior_50": after[1], "posterior_95": after[2], "width": width, "constrained": width < _constrained,
                                "plausible_low": left[0], "plausible_high": left[1]}, index=prior.names)


def _untold(table: pandas.DataFrame, correlations: pandas.DataFrame, sensitivity: pandas.DataFrame) -> list[str]:
    """What the data cannot tell, and why."""
    notes = []
    for name, row in table.iterrows():
        others = correlations[name].drop(name)
        tied = [f"{other} ({r:.2f})" for other, r in others.items() if abs(r) > 0.7]
        if tied:
            notes.append(f"{name} is constrained only together with {', '.join(tied)}: the correlation in the posterior")
        if row["constrained"]:
            continue
        total = sensitivity.loc[sensitivity["parameter"] == name, "total_95"].max()
        total = 0.0 if np.isnan(total) else total
        reason = f"no read-out depends on it (total index below {max(total, 0.01):.2f})" if total < 0.1 else \
            "the read-outs depend on it, but their errors are too large" if not tied else "see the correlation"
        notes.append(f"the data cannot tell {name}: its 90 % interval is {row['width']:.0%} of the prior's; {reason}")
    return notes
