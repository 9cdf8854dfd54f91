"""Where in the unit cube a function stays below a level: a uniform sample, its share, and points that fill it."""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .emulator import Array

_enough = 400  # points below the level
_walkers = 3000
_kept = 0.15  # of the points, for the next level
_most_levels = 25


@dataclass(frozen=True)
class Region:
    """The part of the unit cube below a level."""

    sample: Array  #: uniform over it, a row per point; none if it was not found
    share: float  #: of the cube
    best: Array  #: the point where the function was least


def below(function: Callable[[Array], Array], level: float, cube: Array, known: Array, seed: int) -> Region:
    """A region that is too small to be met by chance is closed in on by ever lower levels, each with a walk from the points below it (subset
    simulation, Au and Beck 2001, Probabilist Eng Mech 16: 263).

    :param cube: uniform over the unit cube   :param known: the function there
    """
    random = np.random.default_rng(seed)
    share, place, value = 1.0, cube, known
    best, least = cube[np.argmin(known)], float(known.min())
    for _ in range(_most_levels):
        inside = value < level
        if inside.sum() >= min(_enough, 0.5 * len(value)):
            break
        step = max(level, float(np.quantile(value, _kept)))
        keep = value < step
        if keep.sum() < 10:
            break
        share *= float(keep.mean())
        place, value = _walk(function, step, place[keep], value[keep], random)
        if value.min() < least:
            best, least = place[np.argmin(value)], float(value.min())
        elif step > level and value.min() > level and np.quantile(value, _kept) > 0.999 * step:
            break  # the levels fall no further
    inside = value < level
    return Region(place[inside], share * float(inside.mean()) if inside.any() else 0.0, best)


def _walk(function: Callable[[Array], Array], level: float, place: Array, value: Array, random: np.random.Generator) -> tuple[Array, Array]:
    """As many walkers, uniform over what lies below the level, from points that are: steps of Metropolis, as wide as a quarter of them is
    accepted."""
    chosen = random.integers(len(place), size=_walkers)
    root = np.linalg.cholesky(np.cov(place.T).reshape(place.shape[1], -1) + 1e-10 * np.eye(place.shape[1]))
    place, value, width = place[chosen], value[chosen], 1.0 / np.sqrt(place.shape[1])
    for _ in range(12):
        tried = place + width * random.standard_normal(place.shape) @ root.T
        ok = np.flatnonzero(np.all((tried >= 0) & (tried <= 1), axis=1))
        found = function(tried[ok])
        ok, found = ok[found < level], found[found < level]
        place[ok], value[ok] = tried[ok], found
        width *= np.exp(len(ok) / len(place) - 0.25)
    return place, value


def filling(sample: Array, many: int, there: Array) -> Array:
    """As many points of a sample, each as far as can be from those before and from points that are there."""
    distance = np.full(len(sample), np.inf)
    for one in there:
        distance = np.minimum(distance, np.sum((sample - one)**2, axis=1))
    chosen: list[int] = []
    for _ in range(min(many, len(sample))):
        centre = np.sum((sample - sample.mean(axis=0))**2, axis=1)
        chosen.append(int(np.argmin(centre) if np.isinf(distance).all() else np.argmax(distance)))
        distance = np.minimum(distance, np.sum((sample - sample[chosen[-1]])**2, axis=1))
    return sample[chosen]
