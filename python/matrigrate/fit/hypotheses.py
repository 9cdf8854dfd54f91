"""Hypotheses of what differs between two groups of cells, nothing, one parameter, two or all, and what data say."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations
from typing import TYPE_CHECKING, Any

import numpy as np

from .emulator import Array, about, shares, weighted
from .groups import LeftOut, Pair
from .posterior import at_bound, bound_note, log_density, squared_distance

if TYPE_CHECKING:
    from .fit import Emulators

asked = 20.0
"""Times as likely the data must be if something differs, for "nothing differs" not to be named. Over all data of cells
of which nothing differs the mean of these times is 1, if emulators and noise are right:
at most one in 20 reaches them."""
_set = 0.95  # of the probability: parameters that cannot be told from one another
_unexplained = 0.05  # posterior predictive p
_enough, _tries = 300, 1200  # points of the posterior of a hypothesis
_few = 50.0
_draws = 4000
nothing, everything = "nothing", "everything"


class Model:
    """What emulators predict of a pair of groups of which some parameters differ. A point has the values of control,
    then the treated ones of the parameters that differ."""

    def __init__(self, emulators: Emulators, pair: Pair, may: list[str], known: Sequence[Mapping[str, float]],
                 discrepancy: Array) -> None:
        """:param may: differ   :param known: values of parameters in both groups   :param discrepancy: by read-out"""
        self.prior, self.pair, self.may, self.discrepancy = emulators.prior, pair, may, discrepancy
        self.processes = [one for one in emulators.processes if one.tells]
        names = self.prior.names
        self.free = [name for name in names if name not in known[0]]
        self._at = [names.index(name) for name in self.free]
        rows = [[one.get(name, low) for name, low in zip(names, self.prior.low, strict=True)] for one in known]
        self._filled = self.prior.to_cube(np.array(rows))
        self._same = bool((self._filled[0] == self._filled[1]).all())

    def places(self, point: Array, differs: Sequence[str]) -> Array:
        """In the cube of all parameters: (group, point, parameter)."""
        d = len(self.free)
        places = np.repeat(self._filled[:, None], len(point), axis=1)
        places[:, :, self._at] = point[:, :d]
        places[1][:, [self.prior.names.index(name) for name in differs]] = point[:, d:]
        return np.stack([self.prior.snapped(one) for one in places])

    def predicted(self, point: Array, differs: Sequence[str]) -> tuple[Array, Array]:
        """The numbers of both groups, and the covariance of their errors: emulators err alike where groups are alike,
        and the model errs alike in both."""
        places, many = self.places(point, differs), self.pair.many
        alike = self._same and not differs
        means, whole = np.empty((len(point), 2, many)), np.zeros((len(point), 2, many, 2, many))
        for k, process in enumerate(self.processes):
            mean, off = process.together(places[:1] if alike else places)
            means[:, :, k] = mean.T
            whole[:, :, k, :, k] = off.transpose(2, 0, 1) + self.discrepancy[k]**2
        return means.reshape(len(point), -1), whole.reshape(len(point), 2 * many, 2 * many)


class _Likelihood:
    """Of points of a hypothesis by some of the numbers; it keeps what was predicted at the last points."""

    def __init__(self, model: Model, differs: Sequence[str], kept: Array, values: Array, covariance: Array,
                 cells: int) -> None:
        self.model, self.differs, self.kept = model, differs, kept
        self.values, self.covariance, self.cells = values, covariance, cells

    def __call__(self, point: Array) -> Array:
        self.means, self.errors = self.model.predicted(point, self.differs)
        return self.again(self.means, self.errors)[:, 0]

    def again(self, means: Array, errors: Array) -> Array:
        """Without a new prediction: a column a case."""
        whole = errors[:, self.kept[:, None], self.kept] + self.covariance
        return log_density(self.values - means[:, None, self.kept], whole, self.cells)


class _Hypothesis:
    """That some parameters differ: its posterior, and what the data say of it."""

    def __init__(self, model: Model, differs: tuple[str, ...], start: tuple[Array, Array], parts: Sequence[LeftOut],
                 seed: int) -> None:
        self.model, self.differs, self._random = model, differs, np.random.default_rng(seed)
        pair = model.pair
        every = np.arange(2 * pair.many)
        likelihood = _Likelihood(model, differs, every, pair.value[None], pair.covariance, pair.cells)
        cube, density = about(*start, _tries, self._random)
        self.cube, log_weight = weighted(likelihood, cube, likelihood(cube), density, self._random, _enough, _tries)
        self.weight, self.effective = shares(log_weight)
        self.means, self.errors = likelihood.means, likelihood.errors
        self._log_density = likelihood.again(self.means, self.errors)[:, 0] - log_weight
        self.evidence = _log_mean(log_weight)
        self.score = np.array([one for part in parts for one in self._score(part)])  #: of each case that was left out
        self.p = self._predictive_p()

    def _score(self, part: LeftOut) -> Array:
        """Logarithm of the density of what was left out, by the rest."""
        likelihood = _Likelihood(self.model, self.differs, part.kept, part.values, part.covariance, part.cells)
        means, errors = self.means, self.errors
        log_weight = likelihood.again(means, errors) - self._log_density[:, None]
        if len(part.values) == 1 and shares(log_weight[:, 0])[1] < _few:  # without it the posterior is another one
            known = log_weight[:, 0] + self._log_density
            _, one = weighted(likelihood, self.cube, known, self._log_density, self._random, 2 * _few, _tries)
            log_weight, means, errors = one[:, None], likelihood.means, likelihood.errors
        whole = errors[:, part.seen[:, None], part.seen] + part.scatter
        ahead = log_weight + log_density(part.left - means[:, None, part.seen], whole, part.cells)
        return np.array([_log_mean(both) - _log_mean(own) for both, own in zip(ahead.T, log_weight.T, strict=True)])

    def _predictive_p(self) -> float:
        """Probability of data that lie farther from what is predicted, over the posterior."""
        from scipy.stats import chi2, f

        pair, many = self.model.pair, 2 * self.model.pair.many
        squared = squared_distance((pair.value - self.means)[:, None], self.errors + pair.covariance)[:, 0]
        left = pair.cells - many  # degrees of freedom, of Hotelling's distribution
        if left > 0:
            return float(self.weight @ f.sf(squared * left / ((pair.cells - 1) * many), many, left))
        return float(self.weight @ chi2.sf(squared, many))

    def drawn(self) -> Array:
        """Places of the posterior in the unit cube: (group, draw, parameter)."""
        chosen = self._random.choice(len(self.cube), size=_draws, p=self.weight)
        return self.model.places(self.cube[chosen], self.differs)


class Compared:
    """One treated group beside control: rows of ``table``, ``ratios`` and ``readouts``, ``words`` and ``notes`` of
    ``Comparison``."""

    columns = {
        "table": ["group", "differs", "ratio_5", "ratio_50", "ratio_95", "times", "probability", "candidate",
                  "over_nothing", "over_nothing_error", "over_everything", "over_everything_error", "p",
                  "effective_sample_size"],
        "ratios": ["group", "differs", "parameter", "ratio_5", "ratio_50", "ratio_95", "control_50", "treated_50"],
        "readouts": ["group", "cells", "readout", "measured", "standard_error", nothing, "first", everything]}

    def __init__(self, model: Model, pairs: bool, scores: bool, seed: int) -> None:
        self.model, self.pair = model, model.pair
        own, parts = [_alone(model, k, seed) for k in (0, 1)], self.pair.parts() if scores else []
        singles = [(name,) for name in model.may]
        self._last = tuple(model.may)
        tried = dict.fromkeys([(), *singles, *(combinations(model.may, 2) if pairs else ()), self._last])
        self._found = {one: _Hypothesis(model, one, _start(model, one, own), parts, seed) for one in tried}
        evidence = {one: found.evidence - self._found[()].evidence for one, found in self._found.items()}
        self._times = {one: float(np.exp(min(value, 700.0))) for one, value in evidence.items()}
        logs = np.array([evidence[one] for one in singles])
        self._probability = dict(zip(model.may, shares(logs)[0].tolist(), strict=True))
        ranked = sorted(model.may, key=lambda name: -self._probability[name])
        held = np.cumsum([self._probability[name] for name in ranked])
        self._best, self._candidates = ranked[0], ranked[:int(np.searchsorted(held, _set)) + 1]
        self.something = 0.5 * (float(np.mean([self._times[one] for one in singles])) + self._times[self._last])
        if self.something < asked:
            self._candidates = []
        self.notes = [f"{self.pair.name}: {_title(one, self._last)}: the effective sample size is only "
                      f"{found.effective:.0f}: its row is rough"
                      for one, found in self._found.items() if found.effective < _few]
        self.ratios = self._ratios()
        self.table, self.readouts = self._table(), self._readouts()
        self.words = [f"{self.pair.name}: {word}" for word in self._words()]

    def _ratios(self) -> list[list[Any]]:
        rows, prior = [], self.model.prior
        for differs, found in self._found.items():
            cube = found.drawn()
            values = [prior.from_cube(one) for one in cube]
            for name in differs:
                k = prior.names.index(name)
                ratio = np.full(3, np.nan)
                if prior.low[k] >= 0:
                    with np.errstate(divide="ignore"):
                        ratio = np.percentile(values[1][:, k] / values[0][:, k], [5, 50, 95])
                middle = [float(np.median(one[:, k])) for one in values]
                rows.append([self.pair.name, _title(differs, self._last), name, *ratio, *middle])
                ends = {"lower": prior.low[k], "upper": prior.high[k]}
                sides = {at_bound(one[:, k]) for one in cube} - {""}
                if differs == (name,) and name in self._candidates:
                    self.notes += [f"{self.pair.name}: {bound_note(name, side, ends[side])}" for side in sorted(sides)]
        return rows

    def _table(self) -> list[list[Any]]:
        return [[self.pair.name, _title(one, self._last), *(self._ratio(one[0]) if len(one) == 1 else [np.nan] * 3),
                 self._times[one], self._probability[one[0]] if len(one) == 1 else np.nan,
                 len(one) == 1 and one[0] in self._candidates, *_over(found, self._found[()]),
                 *_over(found, self._found[self._last]), found.p, found.effective]
                for one, found in self._found.items()]

    def _readouts(self) -> list[list[Any]]:
        predicted = [self._found[one].weight @ self._found[one].means for one in ((), (self._best,), self._last)]
        rows = [[self.pair.name, group.name, name, row["value"], row["standard_error"]]
                for group in self.pair.groups for name, row in group.wanted.table.iterrows()]
        return [[*row, *values] for row, *values in zip(rows, *predicted, strict=True)]

    def _ratio(self, name: str) -> list[float]:
        """Quantiles, if it alone differs."""
        return next(row[3:6] for row in self.ratios if row[1:3] == [name, name])

    def _words(self) -> list[str]:
        """What the data say."""
        ratios = {name: "{1:.2g} ({0:.2g} to {2:.2g})".format(*self._ratio(name)) for name in self.model.may
                  if np.isfinite(self._ratio(name)).all()}
        times, p = _times(self.something), self._found[self._last].p
        unexplained = ["no parameters within the ranges give such cells, even if everything differs: posterior "
                       f"predictive p = {p:.2g}"] if p < _unexplained else []
        if not self._candidates:
            hidden = [f"{name} may still differ by a factor of {ratio} (90 %)" for name, ratio in ratios.items()]
            return [f"nothing differs, as far as these data tell: they are {times} as likely if something differs, and "
                    f"{asked:g} times are asked", *hidden, *unexplained]
        listed = [f"{name} ({self._probability[name]:.2g})" for name in self._candidates]
        found = [f"the data are {times} as likely if something differs as if nothing differs",
                 f"these data cannot tell {' from '.join(listed)}" if len(listed) > 1 else
                 f"if one parameter differs, it is {listed[0][:-1]} of the probability)"]
        found += [f"{name}, if it alone differs: treated over control {ratios[name]} (90 %)"
                  for name in self._candidates if name in ratios]
        return [*found, *self._more_than_one(), *unexplained]

    def _more_than_one(self) -> list[str]:
        """Whether one parameter is enough."""
        best, found = (self._best,), []
        pairs = [one for one in self._found if len(one) == 2]
        second = max(pairs, key=lambda one: self._times[one], default=self._last)
        if self._found[best].p < _unexplained:
            p = self._found[best].p
            found.append(f"{self._best} alone does not explain the data: posterior predictive p = {p:.2g}")
        over = self._times[second] / self._times[best]
        if over >= asked * max(1, len(pairs)):
            found.append(f"one parameter is not enough: the data are {_times(over)} as likely if "
                         f"{_title(second, self._last)} differs as if {self._best} alone does")
        return found


def _alone(model: Model, k: int, seed: int) -> tuple[Array, Array]:
    """Centre and covariance of the posterior of one group."""
    pair, random = model.pair, np.random.default_rng(seed)
    at = np.arange(k * pair.many, (k + 1) * pair.many)
    likelihood = _Likelihood(model, (), at, pair.value[None, at], pair.covariance[np.ix_(at, at)],
                             pair.groups[k].wanted.cells)
    cube = random.random((4 * _tries, len(model.free)))
    cube, log_weight = weighted(likelihood, cube, likelihood(cube), np.zeros(len(cube)), random, _enough, _tries)
    weight, _ = shares(log_weight)
    centre = weight @ cube
    return centre, ((cube - centre).T * weight) @ (cube - centre) + 1e-6 * np.eye(len(centre))


def _start(model: Model, differs: Sequence[str], own: Sequence[tuple[Array, Array]]) -> tuple[Array, Array]:
    """Where the posteriors of both groups, taken as normal, agree in what does not differ: centre and covariance."""
    d, size = len(model.free), len(model.free) + len(differs)
    precision, pull = np.zeros((size, size)), np.zeros(size)
    for k, (centre, covariance) in enumerate(own):
        at = list(range(d))
        for i, name in enumerate(differs if k else ()):
            at[model.free.index(name)] = d + i
        inverse = np.linalg.inv(covariance)
        precision[np.ix_(at, at)] += inverse
        pull[at] += inverse @ centre
    covariance = np.linalg.inv(precision)
    return np.clip(covariance @ pull, 0.02, 0.98), covariance


def _log_mean(logs: Array) -> float:
    return float(logs.max() + np.log(np.mean(np.exp(logs - logs.max()))))


def _over(one: _Hypothesis, other: _Hypothesis) -> tuple[float, float]:
    """How much better the score is, and the standard error of this over the cases that were left out."""
    off = one.score - other.score
    if len(off) < 2:
        return float("nan"), float("nan")
    return float(off.sum()), float(np.sqrt(len(off)) * off.std(ddof=1))


def _title(differs: Sequence[str], last: Sequence[str]) -> str:
    """Of one parameter its name, also if no other may differ."""
    return nothing if not differs else everything if len(differs) > 1 and differs == last else " + ".join(differs)


def _times(value: float) -> str:
    return f"{value:.2g} times" if value < 1e4 else f"more than {10**int(np.log10(value)):.0e} times"
