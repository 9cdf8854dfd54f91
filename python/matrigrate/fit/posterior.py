"""What measured numbers say of parameters: posterior, plausible space, which number excludes what."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

from .. import tracks as _tracks
from ..base import arguments
from ..base.files import require_pandas, unit_of, write_report
from ..draw import words
from ..errors import ConfigurationError, refuse
from ..results.studies import Study
from . import space
from .emulator import Array, Prior, shares, weighted
from .measurement import Measurement, differences

if TYPE_CHECKING:
    import pandas

    from .fit import Emulators

constrained_width = 0.8  #: of the 90 % interval of the prior: a wider one is not called constrained
_implausible = 3.0
_sample = 4000  # draws
_Made = TypeVar("_Made")


@dataclass(frozen=True)
class Fit:
    """What measured numbers say of parameters, by emulators of a study or of several. A number is a read-out, or a read-out at a condition:
    ``l_prot_um at 50 Pa``."""

    table: pandas.DataFrame
    """A row per parameter: quantiles of prior and posterior, ``width`` of the 90 % interval over that of the prior, ``constrained``
    (whether it is below 0.8 and the prior cuts off neither end), ``at_bound`` ("lower" or "upper", the bound of the prior at which the
    posterior ends), and the range ``plausible_low`` to ``plausible_high`` that history matching leaves."""
    readouts: pandas.DataFrame
    """A row per number: measured value and error, ``low`` and ``high`` end of a measured range; mean and 5 and 95 % quantiles over the
    posterior; ``implausibility`` at the best point; of the emulator, ``predicted`` share of the variance of points and ``coverage`` of its
    90 % intervals; and whether it was ``held_back``: predicted, not fitted."""
    sensitivity: pandas.DataFrame
    """A row for each number and parameter: Sobol's ``first`` and ``total`` index, each with its 90 % interval."""
    alone: pandas.DataFrame
    """A row for each fitted number and parameter: the ``plausible`` share of the prior that this number alone leaves, and the range of the
    parameter there, ``low`` to ``high``."""
    exclusions: pandas.DataFrame
    """A row for each pair of fitted numbers: shares of the prior that are plausible by ``a``, by ``b`` and by ``both``; and ``least``, the
    smallest distance within the prior at which both are met, in standard errors. Those that exclude each other come first."""
    sample: pandas.DataFrame  #: drawn from the posterior, a row per draw
    correlations: pandas.DataFrame  #: of the sample
    plausible: float  #: share of the prior that no number excludes by three standard errors
    effective_sample_size: float  #: independent draws with the same information as the weighted ones
    notes: list[str]
    prior: Prior
    tracks: dict[str, tuple[_tracks.Tracks, _tracks.Tracks | None]]
    """By condition, "" without one: measured tracks, and simulated ones of the points that fit best."""
    source: dict[str, str]  #: folders of studies, file of the tracks, seed
    _left: Array  # plausible points of the unit cube
    _there: Array  # those that were simulated
    _like: Study | None = None  # of which the next wave is

    @property
    def measured(self) -> _tracks.Tracks | None:
        """Measured tracks, if there is one condition."""
        return self.tracks[""][0] if "" in self.tracks else None

    @property
    def simulated(self) -> _tracks.Tracks | None:
        """As many tracks of the points that fit best."""
        return self.tracks[""][1] if "" in self.tracks else None

    def __repr__(self) -> str:
        shown = ["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]
        return "\n".join([self.table[shown].to_string(float_format="%.4g"), "",
                          self.readouts.to_string(float_format="%.3g"), *self.notes])

    def next(self, many: int, file: str | os.PathLike[str] | None = None, *, like: Study | str | os.PathLike[str] | None = None) -> pandas.DataFrame:
        """Points for the next wave, a row each: they fill what is plausible, and stay away from points that were simulated.

        :param file: written as a study for ``matrigrate study run``, and checked by the program
        :param like: the study, or its file, from which all but the points is taken; if left out, the one that was fitted
        :raises ConfigurationError: if nothing is plausible, or it is not known what the study is like
        """
        if isinstance(many, bool) or not isinstance(many, (int, np.integer)) or many < 1:
            raise ConfigurationError(f"many: {many!r} is no number of points from 1 on")
        if not len(self._left):
            raise ConfigurationError("nothing within the prior is plausible: widen the ranges, or give a discrepancy of the model")
        points = require_pandas().DataFrame(self.prior.from_cube(space.filling(self._left, many, self._there)), columns=self.prior.names)
        if file is not None:
            from .study_file import write_points

            if like is None and self._like is None:
                raise ConfigurationError("like: is needed, since the fit is not of one study: it names the study from which all but the points "
                                         "is taken")
            write_points(arguments.path("file", file), points, self._like if like is None else like)
        return points

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes posterior.csv, sample.csv, readouts.csv, sensitivity.csv, alone.csv, exclusions.csv and report.html, which needs no other
        file, into a new folder.

        :param overwrite: whether to replace these files in a folder that is there already
        :return: report.html
        """
        from .report import page_of_fit

        return write_report(arguments.path("folder", folder), overwrite, page_of_fit(self), {
            "posterior": self.table.rename_axis("parameter").reset_index(), "readouts": self.readouts.rename_axis("readout").reset_index(),
            "sensitivity": self.sensitivity, "sample": self.sample, "alone": self.alone, "exclusions": self.exclusions})


class Part:
    """What was measured under one condition, with the emulators of the same read-outs."""

    def __init__(self, condition: str, emulators: Emulators, wanted: Measurement, discrepancy: Mapping[str, float], measured: Any) -> None:
        """:param discrepancy: standard errors of the model, by the names of numbers or of read-outs"""
        self.condition, self.emulators, self.wanted, self.measured = condition, emulators, wanted, measured
        self.names = [words.at(name, condition) for name in emulators.names]
        self.low, self.high = (wanted.table[end].to_numpy(float) for end in ("low", "high"))
        self.tells = np.array([one.tells for one in emulators.processes])
        own = [discrepancy.get(name, discrepancy.get(readout, 0.0)) for name, readout in zip(self.names, emulators.names, strict=True)]
        self.covariance: Array = wanted.covariance + np.diag(np.square(own))

    @property
    def sensitivity(self) -> pandas.DataFrame:
        found = self.emulators.sensitivity
        return found.assign(readout=[words.at(name, self.condition) for name in found["readout"]])

    def likelihood(self, means: Array, errors: Array) -> Array:
        """In the logarithm. Errors of emulators are independent: each read-out has its own. Numbers whose emulators predict nothing would add
        noise only."""
        exact, ranges = (np.flatnonzero(self.tells & one) for one in (self.low == self.high, self.low < self.high))
        found = np.zeros(len(means))
        if len(exact):
            whole = self.covariance[np.ix_(exact, exact)] + errors[:, exact, None] * np.eye(len(exact)) * errors[:, None, exact]
            found = log_density((means[:, exact] - self.low[exact])[:, None], whole, self.wanted.cells)[:, 0]
        for k in ranges:
            found = found + _log_inside(self.low[k], self.high[k], means[:, k], np.sqrt(errors[:, k]**2 + self.covariance[k, k]))
        return found

    def far(self, means: Array, errors: Array) -> Array:
        """Distances from what was measured, in standard errors. A read-out that is not predicted has one value everywhere, with the scatter
        of points."""
        values = [one.values for one in self.emulators.processes]
        means = np.where(self.tells, means, [one.mean() for one in values])
        errors = np.where(self.tells, errors, [one.std() for one in values])
        off = np.maximum(0.0, np.maximum(self.low - means, means - self.high))
        return np.asarray(off / np.sqrt(errors**2 + np.diag(self.covariance)))

    def missed(self) -> list[str]:
        """Read-outs that no parameter changes, and that are met nowhere."""
        off = self.far(np.zeros((1, len(self.names))), np.zeros((1, len(self.names))))[0]
        notes = []
        for k in np.flatnonzero(~self.tells & (off >= _implausible)):
            values, low, high = self.emulators.processes[k].values, self.low[k], self.high[k]
            notes.append(f"{self.names[k]}: is {values.mean():.4g} ({values.min():.4g} to {values.max():.4g}) at all points, measured is "
                         f"{low:.4g}{'' if low == high else f' to {high:.4g}'}: it is met nowhere")
        return notes

    def nearest(self) -> _tracks.Tracks | None:
        """As many tracks as were measured, of the points whose emulated read-outs are nearest to the measured ones."""
        points, prior = self.emulators.points, self.emulators.prior
        if not points.tracks:
            return None
        at = prior.to_cube(points.parameters[prior.names].to_numpy(float))
        many, likely = len(self.measured), self.likelihood(*self.emulators.predicted(at))
        chosen = {name: track for k in np.argsort(-likely)[:many] for name, track in points.tracks[k].items()}
        return _tracks.Tracks(dict(list(chosen.items())[:many]), points.tracks[0].interval, [])


def said(condition: str, lines: Iterable[str]) -> list[str]:
    return [f"{condition}: {line}" if condition else line for line in lines]


def each(conditions: Iterable[str], made: Callable[[str], _Made]) -> dict[str, _Made]:
    """What is made for each condition; or the faults of all, with the name of the condition."""
    found, faults = {}, list[str]()
    for name in conditions:
        try:
            found[name] = made(name)
        except ConfigurationError as error:
            faults += said(name, str(error).splitlines())
    refuse(faults)
    return found


def joint(parts: list[Part], held: list[Part], seed: int) -> Fit:
    """The posterior of the parameters that all parts have.

    :param held: predicted, not fitted
    """
    _require_same([*parts, *held])
    prior, even = parts[0].emulators.prior, parts[0].emulators.of_prior[0]
    known = [(part, part.emulators.of_prior[1:]) for part in parts]

    def likelihood(cube: Array) -> Array:
        return np.sum([part.likelihood(*part.emulators.predicted(prior.snapped(cube))) for part in parts], axis=0)

    def far(cube: Array) -> Array:
        return np.hstack([part.far(*part.emulators.predicted(prior.snapped(cube))) for part in parts])

    random = np.random.default_rng(seed)
    cube, log_weight = weighted(likelihood, even, np.sum([part.likelihood(*one) for part, one in known], axis=0), np.zeros(len(even)), random)
    weight, effective = shares(log_weight)
    drawn = cube[random.choice(len(cube), size=_sample, p=weight)]
    off = np.hstack([part.far(*one) for part, one in known])
    region = space.below(lambda cube: far(cube).max(axis=1), _implausible, even, off.max(axis=1), seed)
    names, left = [name for part in parts for name in part.names], prior.snapped(region.sample)
    with np.errstate(invalid="ignore"):  # of a whole number that has one value
        correlations = require_pandas().DataFrame(np.atleast_2d(np.corrcoef(drawn.T)), prior.names, prior.names)
    notes = _notes_of(parts, held, effective)
    if not len(left):
        best = far(region.best[None])[0]
        notes.append(f"no parameters within the ranges give such cells: {names[int(np.argmax(best))]} is off by "
                     f"{best.max():.1f} standard errors even at the best ones")
    table, sensitivity = _table(prior, drawn, left), require_pandas().concat([part.sensitivity for part in (*parts, *held)], ignore_index=True)
    notes += [bound_note(name, side, (prior.low if side == "lower" else prior.high)[k])
              for k, (name, side) in enumerate(table["at_bound"].items()) if side]
    notes += _untold(table, correlations, sensitivity)
    shown = require_pandas().concat([_shown(part, drawn, region.best, part in held) for part in (*parts, *held)])
    there = np.concatenate([prior.to_cube(part.emulators.points.parameters[prior.names].to_numpy(float)) for part in parts])
    of_tracks = [part for part in parts if isinstance(part.measured, _tracks.Tracks)]
    files = ", ".join(part.measured.source for part in of_tracks if part.measured.source)
    return Fit(table, shown, sensitivity, _alone(names, off, even, prior), _exclusions(names, off),
               require_pandas().DataFrame(prior.from_cube(drawn), columns=prior.names), correlations, region.share, effective, notes, prior,
               {part.condition: (part.measured, part.nearest()) for part in of_tracks},
               {"study": parts[0].emulators.study, "tracks": files, "seed": str(seed)},
               np.unique(left, axis=0) if any(prior.whole) else left, np.unique(there, axis=0))


def _notes_of(parts: Sequence[Part], held: Sequence[Part], effective: float) -> list[str]:
    notes = []
    for part in parts:
        notes += said(part.condition, [*part.wanted.notes, *part.emulators.notes, *differences(part.emulators.points, part.wanted)])
    notes += [note for part in held for note in said(part.condition, part.emulators.notes) if note not in notes]
    if effective < 200:
        notes.append(f"the effective sample size is only {effective:.0f}: quantiles are rough")
    return notes + [note for part in parts for note in part.missed()]


def _require_same(parts: Sequence[Part]) -> None:
    """All emulators are over the same parameters, or there are reasons why not."""
    own = [set(part.emulators.prior.names) for part in parts]
    if odd := sorted(set.union(*own) - set.intersection(*own)):
        notes = [note for part in parts for note in said(part.condition, part.emulators.notes)]
        raise ConfigurationError("\n".join(note for note in notes if any(f"{name}: is " in note for name in odd)))


def log_density(off: Array, whole: Array, cells: int) -> Array:
    """Up to a constant. A covariance that is itself estimated from n tracks makes a t distribution of the normal one (Sellentin and Heavens 2016).

    :param off: (point, case, number)   :param whole: covariance of the numbers at each point
    :param cells: that it was estimated from; or 0
    :return: (point, case)
    """
    squared = squared_distance(off, whole)
    fit = -0.5 * squared if cells < 2 else -0.5 * cells * np.log1p(squared / (cells - 1))
    return np.asarray(fit - 0.5 * np.linalg.slogdet(whole)[1][:, None])


def squared_distance(off: Array, whole: Array) -> Array:
    return np.asarray(np.einsum("ijk,ikj->ij", off, np.linalg.solve(whole, off.transpose(0, 2, 1))))


def _log_inside(low: float, high: float, means: Array, errors: Array) -> Array:
    """Logarithm of the probability that a value with a normal error lies in a range."""
    from scipy.special import log_ndtr

    a, b = (low - means) / errors, (high - means) / errors
    a, b = np.where(a > 0, -b, a), np.where(a > 0, -a, b)  # the tail that can be told from 0
    return np.asarray(log_ndtr(b) + np.log1p(-np.exp(np.minimum(log_ndtr(a) - log_ndtr(b), -1e-300))))


def _shown(part: Part, drawn: Array, best: Array, held: bool) -> pandas.DataFrame:
    """Rows of ``Fit.readouts``."""
    after, _ = part.emulators.predicted(drawn[:1000])
    low, high = np.percentile(after, [5, 95], axis=0)
    processes, cube = part.emulators.processes, part.emulators.prior.snapped(best[None])
    return require_pandas().DataFrame({
        "measured": part.wanted.table["value"].to_numpy(float), "standard_error": part.wanted.table["standard_error"].to_numpy(float),
        "low": part.low, "high": part.high, "posterior_mean": after.mean(axis=0), "posterior_5": low, "posterior_95": high,
        "implausibility": part.far(*part.emulators.predicted(cube))[0], "predicted": [one.explained for one in processes],
        "predicted_error": [one.explained_error for one in processes], "coverage": [one.coverage for one in processes],
        "held_back": held}, index=part.names)


def _alone(names: list[str], off: Array, even: Array, prior: Prior) -> pandas.DataFrame:
    rows = []
    for name, own in zip(names, off.T, strict=True):
        left = even[own < _implausible]
        ends = prior.from_cube(np.array([left.min(axis=0), left.max(axis=0)])) if len(left) else np.full((2, len(prior.names)), np.nan)
        rows += [[name, parameter, len(left) / len(even), *ends[:, k]] for k, parameter in enumerate(prior.names)]
    return require_pandas().DataFrame(rows, columns=["readout", "parameter", "plausible", "low", "high"])


def _exclusions(names: list[str], off: Array) -> pandas.DataFrame:
    kept = off < _implausible
    rows = [[names[i], names[j], kept[:, i].mean(), kept[:, j].mean(), (kept[:, i] & kept[:, j]).mean(), off[:, [i, j]].max(axis=1).min()]
            for i, j in combinations(range(len(names)), 2)]
    table = require_pandas().DataFrame(rows, columns=["a", "b", "plausible_a", "plausible_b", "both", "least"])
    return table.sort_values("least", ascending=False, ignore_index=True, kind="stable")


def _table(prior: Prior, drawn: Array, kept: Array) -> pandas.DataFrame:
    ends = np.percentile(drawn, [5, 50, 95], axis=0)
    before = prior.from_cube(np.array([[0.05], [0.5], [0.95]]) * np.ones(len(prior.names)))
    after = prior.from_cube(ends)
    left = prior.from_cube(np.array([kept.min(axis=0), kept.max(axis=0)])) if len(kept) else np.full((2, len(prior.names)), np.nan)
    width = (ends[2] - ends[0]) / 0.9
    bounds = [at_bound(column) for column in drawn.T]
    constrained = (width < constrained_width) & (np.array(bounds) == "")
    return require_pandas().DataFrame({"prior_5": before[0], "prior_50": before[1], "prior_95": before[2], "posterior_5": after[0],
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
