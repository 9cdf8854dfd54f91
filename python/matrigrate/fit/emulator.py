"""Gaussian processes that stand for the program: the mean of a read-out over the parameters, its error, and the scatter of a
run. Sobol indices of them."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .process import Array, Process

_draws = 60
_tries = 5000  # points of a step of sampling
_folds = 8
_at_once = 500  # points, whose tables stay in the processor's cache


@dataclass(frozen=True)
class Prior:
    """Independent ranges of parameters, uniform in the value or in its logarithm, and the unit cube that stands for them."""

    names: list[str]
    low: Array
    high: Array
    is_log: list[bool]
    whole: list[bool]  #: whether only whole numbers can be run; each has the same share of the cube

    def to_cube(self, values: Array) -> Array:
        low, high = self._ends()
        return (self._of(np.asarray(values, dtype=float)) - low) / (high - low)

    def from_cube(self, cube: Array) -> Array:
        low, high = self._ends()
        shifted = low + np.asarray(cube) * (high - low)
        values = np.where(self.is_log, np.exp(np.where(self.is_log, shifted, 0.0)), shifted)
        return np.where(self.whole, np.clip(np.rint(values), self.low, self.high), values)

    def snapped(self, cube: Array) -> Array:
        """Points of the cube at which the program can run."""
        return np.where(self.whole, self.to_cube(self.from_cube(cube)), cube) if any(self.whole) else cube

    def _ends(self) -> tuple[Array, Array]:
        half = np.where(self.whole, np.where(self.is_log, 0.0, 0.5), 0.0)
        return self._of(self.low - half), self._of(self.high + half)

    def _of(self, values: Array) -> Array:
        return np.where(self.is_log, np.log(np.where(self.is_log, values, 1.0)), values)


class Emulator:
    """The mean of a read-out over the unit cube of parameters, its standard error, and the scatter of a run, from simulations with scatter.

    What it tells of points that it was not given comes from folds: in each an eighth of the points is left out, and all is fitted anew to the rest.
    """

    def __init__(self, cube: Array, values: Array, runs: Array, seed: int, linear: bool) -> None:
        """:param runs: at each point, whose mean ``values`` has
        :param linear: whether the process has a linear part beside the smooth one: better of many parameters and few points
        """
        self._centre, self._scale = float(values.mean()), float(values.std())
        y = (values - self._centre) / self._scale
        self._process = Process(cube, y, runs, seed, linear)
        left_out, errors, plain = _left_out(self._process, cube, y, runs, seed, linear)
        off, known = (y - left_out)**2, (y - plain)**2
        self.explained = float(1.0 - off.mean() / known.mean())
        """Share of the variance of points that the others predict, at most 1; below 0 where their mean alone predicts better."""
        self.explained_error = float(np.std(off - (1.0 - self.explained) * known) / known.mean() / np.sqrt(len(y)))
        """Standard error of this share."""
        self.coverage = float(np.mean(np.abs(y - left_out) <= 1.645 * errors))
        """Share of points within the 90 % interval that the others predict."""
        self.values = values

    @property
    def tells(self) -> bool:
        """Whether it predicts anything: the share of the variance is above 0 by two standard errors."""
        return self.explained > 2.0 * self.explained_error

    def __call__(self, cube: Array) -> tuple[Array, Array]:
        """Mean of the read-out, and the standard error of this mean."""
        parts = [self._process(part)[:2] for part in np.array_split(cube, max(1, len(cube) // _at_once))]
        mean, variance = (np.concatenate(one) for one in zip(*parts, strict=True))
        return self._centre + self._scale * mean, self._scale * np.sqrt(variance)

    def together(self, cube: Array) -> tuple[Array, Array]:
        """At sets of points, (point of a set, set, parameter): the means, and the covariance of their errors, (point,
        point, set)."""
        many = max(1, cube.shape[0] * cube.shape[1] // _at_once)
        parts = [self._process.together(part) for part in np.array_split(cube, many, axis=1)]
        mean, off = (np.concatenate(one, axis=-1) for one in zip(*parts, strict=True))
        return self._centre + self._scale * mean, self._scale**2 * off

    def mean(self, cube: Array) -> Array:
        return np.asarray(self._centre + self._scale * self._process.mean(cube))

    def drawn(self, cube: Array, draws: int, random: np.random.Generator) -> Array:
        """Functions that the simulations allow, a row each."""
        return np.asarray(self._centre + self._scale * self._process.drawn(cube, draws, random))


def _left_out(process: Process, cube: Array, y: Array, runs: Array, seed: int, linear: bool) -> tuple[Array, Array, Array]:
    """Each value as the points outside of its fold predict it, with the error of a run, and their mean."""
    order = np.random.default_rng(seed).permutation(len(y))
    left_out, errors, plain = np.empty(len(y)), np.empty(len(y)), np.empty(len(y))
    for out in np.array_split(order, min(_folds, len(y))):
        others = np.setdiff1d(order, out)
        mean, variance, of_run = Process(cube[others], y[others], runs[others], seed, linear, process)(cube[out])
        left_out[out], errors[out], plain[out] = mean, np.sqrt(variance + of_run / runs[out]), y[others].mean()
    return left_out, errors, plain


def sobol(emulator: Emulator, parameters: int, seed: int) -> tuple[Array, Array]:
    """First and total indices by Jansen's estimators: a row per parameter with the estimate and the ends of its 90 % interval,
    over the functions that the simulations allow. Those are drawn at fewer points, and compared with the mean there."""
    random = np.random.default_rng(seed)
    estimate = _jansen(emulator.mean(_radial(parameters, 1024, seed)), parameters)
    few = _radial(parameters, 128, seed)
    middle = _jansen(emulator.mean(few), parameters)
    off = np.percentile([_jansen(row, parameters) - middle for row in emulator.drawn(few, _draws, random)], [5, 95], axis=0)
    first, total = np.clip(np.stack([estimate, *(estimate + off)], axis=-1), 0.0, 1.0)
    return first, total


def _radial(parameters: int, size: int, seed: int) -> Array:
    """Two samples of the cube, and for each parameter the first with that of the second."""
    from scipy.stats import qmc

    both = qmc.Sobol(2 * parameters, seed=seed).random(size)
    a, b = both[:, :parameters], both[:, parameters:]
    return np.concatenate([a, b, *(np.where(np.arange(parameters) == k, b, a) for k in range(parameters))])


def _jansen(values: Array, parameters: int) -> Array:
    """First and total indices, a row each."""
    parts = values.reshape(parameters + 2, -1)
    a, b, mixed = parts[0], parts[1], parts[2:]
    variance = max(float(parts[:2].var()), 1e-300)
    return np.array([1.0 - ((b - mixed)**2).mean(axis=1) / 2 / variance, ((a - mixed)**2).mean(axis=1) / 2 / variance])


def weighted(log_likelihood: Callable[[Array], Array], cube: Array, known: Array, log_density: Array,
             random: np.random.Generator, enough: float = 1500, tries: int = _tries) -> tuple[Array, Array]:
    """Points of the unit cube and the logarithms of their weights, whose mean is the probability of the data: importance
    sampling, from a normal distribution about the earlier points where these have too little weight. The last call of
    the likelihood is for the points that are returned.

    :param cube: the first points   :param known: their log likelihoods   :param log_density: of their distribution
    :param enough: effective sample size
    """
    for last in range(6):
        log_weight = (known if last == 0 else log_likelihood(cube)) - log_density
        weight, effective = shares(log_weight)
        if effective >= enough or last == 5:
            break
        centre = weight @ cube
        cube, log_density = about(centre, ((cube - centre).T * weight) @ (cube - centre), tries, random)
    return cube, log_weight


def shares(log_weight: Array) -> tuple[Array, float]:
    """Weights with the sum 1, and the effective sample size."""
    weight = np.exp(log_weight - log_weight.max())
    weight /= weight.sum()
    return weight, float(1.0 / np.sum(weight**2))


def about(centre: Array, covariance: Array, tries: int, random: np.random.Generator) -> tuple[Array, Array]:
    """Points of the unit cube, most from a normal distribution of twice this covariance, the others from all of the cube;
    and the logarithm of their density."""
    wide = 2.0 * covariance + 1e-8 * np.eye(len(centre))
    near = random.multivariate_normal(centre, wide, 80 * tries)
    inside = np.all((near >= 0) & (near <= 1), axis=1)
    share = max(float(inside.mean()), 1e-4)
    near = near[inside][:int(0.85 * tries)]
    cube = np.concatenate([near, random.random((tries - len(near), len(centre)))])
    away = cube - centre
    squared = np.sum(away @ np.linalg.inv(wide) * away, axis=1)
    density = np.exp(-0.5 * squared) / np.sqrt(np.linalg.det(2 * np.pi * wide)) / share
    return cube, np.log((len(near) * density + (tries - len(near))) / tries)
