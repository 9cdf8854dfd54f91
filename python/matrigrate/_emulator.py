"""Gaussian processes that stand for the program: the mean of a read-out over the parameters, its error, and the scatter of a
run. Sobol indices of them."""
from __future__ import annotations

import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[np.float64]]

_euler = 1.27  # less the mean of log chi-squared with one degree of freedom
_draws = 60


def sklearn() -> Any:
    try:
        from sklearn import gaussian_process
    except ImportError:
        raise ImportError("an emulator needs scikit-learn: apt install python3-sklearn, or pip install scikit-learn") from None
    return gaussian_process


@dataclass(frozen=True)
class Prior:
    """Independent ranges of parameters, uniform in the value or in its logarithm, and the unit cube that stands for them."""

    names: list[str]
    low: Array
    high: Array
    is_log: list[bool]

    def to_cube(self, values: Array) -> Array:
        low, high = self._ends()
        return (self._of(np.asarray(values, dtype=float)) - low) / (high - low)

    def from_cube(self, cube: Array) -> Array:
        low, high = self._ends()
        shifted = low + np.asarray(cube) * (high - low)
        return np.where(self.is_log, np.exp(np.where(self.is_log, shifted, 0.0)), shifted)

    def _ends(self) -> tuple[Array, Array]:
        return self._of(self.low), self._of(self.high)

    def _of(self, values: Array) -> Array:
        return np.where(self.is_log, np.log(np.where(self.is_log, values, 1.0)), values)


class Emulator:
    """The mean of a read-out over the unit cube of parameters, from simulations with scatter.

    First the process and one scatter for all points are fitted by maximum likelihood; then the logarithm of the scatter, as a
    linear function of the parameters, to the squared residuals of leaving points out; last the process again, with that
    scatter held.
    """

    def __init__(self, cube: Array, values: Array, runs: Array, seed: int = 1, linear: bool = False) -> None:
        """:param runs: at each point, whose mean ``values`` has
        :param linear: whether the process has a linear part beside the smooth one: better of many parameters and few points
        """
        processes = sklearn()
        kernels = processes.kernels
        self._offset = 0.5 if linear else 0.0  # the linear part is none in the middle
        basis = np.column_stack([np.ones(len(cube)), cube - 0.5])
        cube = cube - self._offset
        self._cube, self._centre, self._scale = cube, float(values.mean()), float(values.std())
        y = (values - self._centre) / self._scale
        smooth = kernels.ConstantKernel(1.0, (1e-3, 1e2)) * kernels.RBF(np.full(cube.shape[1], 0.5), (0.1, 10.0))
        if linear:
            smooth += kernels.ConstantKernel(0.3, (1e-4, 1e2)) * kernels.DotProduct(0.0, "fixed")
        first = self._fitted(processes, smooth + kernels.WhiteKernel(0.3, (1e-4, 2.0)), 1e-8, y, seed)
        share = 1.0 / runs
        left_out, _ = _left_out(first.kernel_(cube), y)
        sizes = np.log(np.maximum(left_out**2, 1e-12) / share) + _euler
        ridge = np.diag([0.0] + [0.02 * len(cube)] * cube.shape[1])
        self._scatter = np.linalg.solve(basis.T @ basis + ridge, basis.T @ sizes)
        self._scatter[0] += np.log(np.mean(left_out**2 / share / np.exp(basis @ self._scatter)))
        alpha = np.maximum(np.exp(basis @ self._scatter) * share, 1e-6)
        self._process = self._fitted(processes, first.kernel_.k1, alpha, y, seed)
        left_out, errors = _left_out(self._process.kernel_(cube) + np.diag(alpha), y)
        self.explained = float(max(0.0, 1.0 - np.mean(left_out**2) / np.mean((y - y.mean())**2)))
        """Share of the variance of points that the others predict; the rest is scatter and what the emulator misses."""
        self.coverage = float(np.mean(np.abs(left_out) <= 1.645 * errors))
        """Share of points within the 90 % interval that the others predict."""
        self.values, self.left_out = values, self._centre + self._scale * (y - left_out)
        """Of points, and as the others predict them."""

    def _fitted(self, processes: Any, kernel: Any, alpha: Any, y: Array, seed: int) -> Any:
        process = processes.GaussianProcessRegressor(kernel, alpha=alpha, random_state=seed)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # a length at its bound is a parameter without effect
            return process.fit(self._cube, y)

    def __call__(self, cube: Array) -> tuple[Array, Array]:
        """Mean of the read-out, and the standard error of this mean."""
        mean, error = zip(*(self._process.predict(part - self._offset, return_std=True)
                            for part in np.array_split(cube, max(1, len(cube) // 5000))), strict=True)
        return self._centre + self._scale * np.concatenate(mean), self._scale * np.concatenate(error)

    @property
    def parameters(self) -> int:
        return int(self._cube.shape[1])

    def scatter(self, cube: Array) -> Array:
        """Standard deviation of one run."""
        basis = np.column_stack([np.ones(len(cube)), cube - 0.5])
        return np.asarray(self._scale * np.exp(0.5 * basis @ self._scatter))

    def drawn(self, cube: Array, draws: int, random: np.random.Generator) -> Array:
        """Functions that the simulations allow, a row each."""
        mean, covariance = self._process.predict(cube - self._offset, return_cov=True)
        root = np.linalg.cholesky(covariance + 1e-6 * np.eye(len(cube)) * max(1e-3, covariance.max()))
        return np.asarray(self._centre + self._scale * (mean + random.standard_normal((draws, len(cube))) @ root.T))


def _left_out(covariance: Array, y: Array) -> tuple[Array, Array]:
    """What is left of each value, and its error, as the other values predict it."""
    inverse = np.linalg.inv(covariance)
    return np.asarray(inverse @ y / np.diag(inverse)), np.asarray(1.0 / np.sqrt(np.diag(inverse)))


def sobol(emulator: Emulator, parameters: int, seed: int = 1) -> tuple[Array, Array]:
    """First and total indices by Jansen's estimators: a row per parameter with the estimate and the ends of its 90 % interval,
    over the functions that the simulations allow. Those are drawn at fewer points, and compared with the mean there."""
    random = np.random.default_rng(seed)
    estimate = _jansen(emulator(_radial(parameters, 1024, seed))[0], parameters)
    few = _radial(parameters, 128, seed)
    middle = _jansen(emulator(few)[0], parameters)
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


def sampled(log_likelihood: Callable[[Array], Array], cube: Array, known: Array, size: int = 4000,
            seed: int = 1) -> tuple[Array, float]:
    """Points of the unit cube drawn from the posterior of a uniform prior, and their effective sample size:
    importance sampling, from a normal distribution about the earlier points where the prior alone meets too few.

    :param cube: drawn from the prior   :param known: their log likelihoods
    """
    random = np.random.default_rng(seed)
    tries, parameters = cube.shape
    log_prior = np.zeros(tries)
    for last in range(6):
        log_weight = (known if last == 0 else log_likelihood(cube)) - log_prior
        weight = np.exp(log_weight - log_weight.max())
        weight /= weight.sum()
        effective = float(1.0 / np.sum(weight**2))
        if effective >= 1500 or last == 5:
            break
        centre = weight @ cube
        covariance = 2.0 * ((cube - centre).T * weight) @ (cube - centre) + 1e-8 * np.eye(parameters)
        near = random.multivariate_normal(centre, covariance, 40 * tries)
        inside = np.all((near >= 0) & (near <= 1), axis=1)
        share = max(float(inside.mean()), 1e-4)
        near = near[inside][:int(0.85 * tries)]
        cube = np.concatenate([near, random.random((tries - len(near), parameters))])
        away = cube - centre
        density = np.exp(-0.5 * np.sum(away @ np.linalg.inv(covariance) * away, axis=1)) / np.sqrt(
            np.linalg.det(2 * np.pi * covariance)) / share
        log_prior = np.log((len(near) * density + (tries - len(near))) / tries)
    return cube[random.choice(len(cube), size=size, p=weight)], effective
