"""Gaussian processes whose lengths, variances and scatter are averaged over what the points allow."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ..base.load_core import library

Array = np.ndarray[Any, np.dtype[np.float64]]

_constant = 1.0  # variance of the mean of a process, of values with variance 1
_jitter = 1e-8
_waves = 1000  # of a function that is drawn
_most_members, _least_members = 12, 5  # settings that are averaged
_most_tries, _least_tries = 192, 48  # settings that these are chosen of
_less = 0.25  # of the tries, for a part of the points
_deep = 2  # members whose variance is asked for


def scipy() -> Any:
    return library("scipy", "an emulator needs SciPy")


@dataclass(frozen=True)
class _Setting:
    """Variances and lengths of a process over the unit cube, of values with variance 1."""

    reach: Array  #: inverse square of the length of each parameter
    smooth: float  #: variance of the smooth part
    linear: float  #: of the slopes of the linear part
    scatter: float  #: of one run, in the middle
    slopes: Array  #: of the logarithm of this variance

    def covariance(self, a: Array, b: Array) -> Array:
        """Of the means at points a and b, a row a point."""
        root = np.sqrt(self.reach)
        x, y = a * root, b * root
        whole = np.concatenate([x, -0.5 * (x**2).sum(axis=1)[:, None], np.ones((len(x), 1))], axis=1) @ np.concatenate(
            [y.T, np.ones((1, len(y))), -0.5 * (y**2).sum(axis=1)[None]])
        np.exp(whole, out=whole)
        whole *= self.smooth
        whole += _constant
        if self.linear:
            whole += self.linear * (a - 0.5) @ (b - 0.5).T
        return np.asarray(whole)

    def between(self, a: Array, b: Array) -> Array:
        """Covariance of the means at each point of a and that of b beside it, without any values."""
        smooth = self.smooth * np.exp(-0.5 * ((a - b)**2 @ self.reach))
        return np.asarray(_constant + smooth + self.linear * ((a - 0.5) * (b - 0.5)).sum(axis=1))

    def drawn(self, a: Array, draws: int, random: np.random.Generator) -> Array:
        """Means at points, without any values: a column a draw."""
        waves = random.standard_normal((len(self.reach), _waves)) * np.sqrt(self.reach)[:, None]
        smooth = np.sqrt(2 * self.smooth / _waves) * np.cos(a @ waves + random.uniform(0, 2 * np.pi, _waves))
        slopes = np.sqrt(self.linear) * random.standard_normal((a.shape[1], draws))
        return np.asarray(np.sqrt(_constant) * random.standard_normal(draws) + smooth @ random.standard_normal((_waves, draws)) + (a - 0.5) @ slopes)

    def of_run(self, a: Array) -> Array:
        """Variance of one run at points."""
        return np.asarray(self.scatter * np.exp((a - 0.5) @ self.slopes))


class _Likelihood:
    """Of settings that stand as logarithms, in units of their prior: normal, about values that favour smooth and weak functions.

    Lengths have the median (d/4)^(1/4) for d parameters, so that more parameters do not make a rougher function (Hvarfner, Hellsten and Nardi 2024,
    ICML 41), within a factor of e; the scatter has the variance of the values, the smooth part too, within e^1.5.
    """

    def __init__(self, cube: Array, y: Array, runs: Array, linear: bool) -> None:
        n, d = cube.shape
        self.cube, self.y, self.runs, self.linear = cube, y, runs, linear
        self._apart = np.ascontiguousarray(((cube[:, None] - cube)**2).transpose(2, 0, 1).reshape(d, n * n))
        self._off = cube - 0.5
        self._products = self._off @ self._off.T
        middle = [-0.25 * np.log(d / 4)] * d + [0.0] + [np.log(0.3)] * linear + [0.0] + [0.0] * d
        width = [1.0] * d + [1.5] + [1.5] * linear + [1.5] + [1.5 / np.sqrt(d)] * d
        self._middle, self._width = np.array(middle), np.array(width)
        self.many = len(middle)

    def setting(self, place: Array) -> _Setting:
        d, logs = self.cube.shape[1], self._middle + self._width * place
        return _Setting(np.exp(2 * logs[:d]), float(np.exp(logs[d])), float(np.exp(logs[d + 1])) if self.linear else 0.0,
                        float(np.exp(logs[d + 1 + self.linear])), logs[d + 2 + self.linear:])

    def __call__(self, place: Array) -> tuple[float, Array]:
        """Minus the logarithm of the posterior of a setting, and its slopes."""
        linalg, n = scipy().linalg, len(self.y)
        at, smooth, scatter, root = self._parts(place)
        weights = linalg.cho_solve((root, True), self.y, check_finite=False)
        value = 0.5 * self.y @ weights + np.log(np.diag(root)).sum() + 0.5 * place @ place
        inverse = linalg.lapack.dpotri(root, lower=1)[0]  # its lower half; what it is multiplied with is symmetric
        off = 0.5 * np.outer(weights, weights) - inverse
        off.flat[::n + 1] += 0.5 * np.diag(inverse)
        of_smooth, of_scatter = off * smooth, np.diag(off) * scatter
        slopes = [-at.reach * (self._apart @ of_smooth.ravel()), [of_smooth.sum()],
                  [at.linear * (off * self._products).sum()] * self.linear, [of_scatter.sum()], self._off.T @ of_scatter]
        return float(value), np.asarray(place - np.concatenate(slopes) * self._width)

    def value(self, place: Array) -> float:
        """As the call, without slopes."""
        root = self._parts(place)[-1]
        half = scipy().linalg.solve_triangular(root, self.y, lower=True, check_finite=False)
        return float(0.5 * half @ half + np.log(np.diag(root)).sum() + 0.5 * place @ place)

    def _parts(self, place: Array) -> tuple[_Setting, Array, Array, Array]:
        """The setting; of the covariance of the values the smooth part, the scatter, and the root of all."""
        at, n = self.setting(place), len(self.y)
        smooth = at.smooth * np.exp(-0.5 * (at.reach @ self._apart)).reshape(n, n)
        scatter = at.of_run(self.cube) / self.runs
        whole = _constant + smooth + at.linear * self._products
        whole.flat[::n + 1] += scatter + _jitter
        return at, smooth, scatter, scipy().linalg.cholesky(whole, lower=True, check_finite=False)


class Process:
    """A function of the unit cube, known by values with scatter of variance 1: a mean of processes, each with a setting drawn from the posterior.

    The draws are from a normal distribution about the best setting (Laplace), resampled by their weights (Rubin 1988, Bayesian Statistics 3: 395).
    """

    def __init__(self, cube: Array, y: Array, runs: Array, seed: int, linear: bool, like: Process | None = None) -> None:
        """:param like: of more points: the search begins at its best setting, and draws about it as widely; the weights are of these points"""
        linalg = scipy().linalg
        self._cube, self._runs = cube, runs
        likelihood = _Likelihood(cube, y, runs, linear)
        begin = np.zeros(likelihood.many) if like is None else like.best
        self.best = np.asarray(scipy().optimize.minimize(likelihood, begin, jac=True, method="L-BFGS-B", bounds=[(-6.0, 6.0)] * likelihood.many,
                                                         options={"maxiter": 60, "ftol": 1e-7}).x)  # the setting with the highest posterior
        self.roots: Array = _roots(likelihood, self.best) if like is None else like.roots
        self._members = []
        for setting, share in _settings(likelihood, self.best, self.roots, np.random.default_rng(seed), 1.0 if like is None else _less):
            root = linalg.cholesky(setting.covariance(cube, cube) + self._noise(setting), lower=True)
            self._members.append((setting, share, root, linalg.cho_solve((root, True), y)))

    def __call__(self, cube: Array) -> tuple[Array, Array, Array]:
        """At points: the mean, its variance, and the variance of a run about it."""
        mean, off = self.together(cube[None])
        return mean[0], off[0, 0], self.of_run(cube)

    def together(self, cube: Array) -> tuple[Array, Array]:
        """At sets of points, (point of a set, set, parameter): the means, and for each two points of a set the covariance of
        their errors, (point, point, set). How far single members are off is taken from some of them."""
        points, sets, parameters = cube.shape
        pairs = [(i, j) for i in range(points) for j in range(i + 1)]
        means, offs, shares = [], [], np.array([share for _, share, *_ in self._members])
        deep = np.argsort(-shares, kind="stable")[:_deep]
        for k, (setting, _, root, weights) in enumerate(self._members):
            with_points = setting.covariance(self._cube, cube.reshape(-1, parameters))
            means.append(weights @ with_points)
            if k in deep:
                half = scipy().linalg.solve_triangular(root, with_points, lower=True, check_finite=False, overwrite_b=True)
                half = half.reshape(-1, points, sets)
                offs.append([setting.between(cube[i], cube[j]) - np.einsum("ij,ij->j", half[:, i], half[:, j])
                             for i, j in pairs])
        mean = shares @ means
        apart = (np.array(means) - mean).reshape(-1, points, sets)
        off = np.average(offs, axis=0, weights=shares[np.sort(deep)])
        whole = np.empty((points, points, sets))
        for (i, j), one in zip(pairs, off, strict=True):
            whole[i, j] = whole[j, i] = (np.maximum(one, 0.0) if i == j else one) + shares @ (apart[:, i] * apart[:, j])
        return mean.reshape(points, sets), whole

    def mean(self, cube: Array) -> Array:
        return np.asarray(sum(share * (weights @ setting.covariance(self._cube, cube)) for setting, share, _, weights in self._members))

    def of_run(self, cube: Array) -> Array:
        """Variance of a run about the mean."""
        return np.asarray(sum(share * setting.of_run(cube) for setting, share, *_ in self._members))

    def drawn(self, cube: Array, draws: int, random: np.random.Generator) -> Array:
        """Functions that the values allow, a row each: drawn without the values, from waves (Rahimi and Recht 2007, NIPS 20), then moved to where
        the values want them (Wilson et al. 2020, ICML 37)."""
        linalg = scipy().linalg
        both, rows = np.concatenate([cube, self._cube]), []
        ends = np.rint(draws * np.cumsum([share for _, share, *_ in self._members])).astype(int)
        for many, (setting, _, root, weights) in zip(np.diff(ends, prepend=0), self._members, strict=True):
            free = setting.drawn(both, many, random)
            noise = np.sqrt(np.diag(self._noise(setting)))[:, None] * random.standard_normal((len(self._cube), many))
            moved = weights[:, None] - linalg.cho_solve((root, True), free[len(cube):] + noise)
            rows.append((free[:len(cube)] + setting.covariance(cube, self._cube) @ moved).T)
        return np.concatenate(rows)

    def _noise(self, setting: _Setting) -> Array:
        return np.diag(setting.of_run(self._cube) / self._runs + _jitter)


def _roots(likelihood: _Likelihood, best: Array) -> Array:
    """A matrix that makes of independent normal numbers those with the curvature of the posterior at the best setting."""
    step, slopes = 1e-3, likelihood(best)[1]
    bent = np.array([(likelihood(best + step * one)[1] - slopes) / step for one in np.eye(likelihood.many)])
    curvature, axes = np.linalg.eigh(0.5 * (bent + bent.T))
    return np.asarray(axes / np.sqrt(np.maximum(curvature, 0.5)))  # of the prior alone the curvature is 1


def _settings(likelihood: _Likelihood, best: Array, roots: Array, random: np.random.Generator, less: float) -> list[tuple[_Setting, float]]:
    """Drawn from their posterior, each with its share."""
    n = len(likelihood.y)
    members, tries = int(np.clip(2000 // n, _least_members, _most_members)), int(less * np.clip(20000 // n, _least_tries, _most_tries))
    normal = random.standard_normal((tries, likelihood.many))
    places = best + normal @ roots.T
    logs = 0.5 * (normal**2).sum(axis=1) - np.array([likelihood.value(place) for place in places])
    weights = np.cumsum(np.exp(logs - logs.max()))
    chosen, times = np.unique(np.searchsorted(weights / weights[-1], (np.arange(members) + 0.5) / members), return_counts=True)
    return [(likelihood.setting(places[k]), float(many) / members) for k, many in zip(chosen, times, strict=True)]
