"""Read-outs of tracks, as the program computes them (src/tracks/readouts.hpp), by the compiled module."""
from __future__ import annotations

from collections.abc import Iterable
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np

from ._load_core import core

if TYPE_CHECKING:
    from . import _core

needs = {
    "directionality_ratio": "needs tracks of more than ten intervals",
    "directionality_time_min": "needs tracks on which the ratio falls below one half",
    "persistence_min": "needs three lags, and a time between half an interval and the largest lag",
    "msd_slope_short": "needs tracks of three positions",
    "msd_slope_long": "needs tracks of five positions",
    "anisotropy": "needs tracks of four positions that move both along and across",
    "turning_angle_deg": "needs two steps after one another",
    "turning_cosine": "needs two steps after one another",
}  #: of tracks, by the read-out; the others need two positions

farthest = 1e9  # um, a kilometre: squares of what is beyond would not be numbers


@cache
def meanings() -> dict[str, str]:
    """By the name of a read-out of tracks what it means; none without the compiled module, which computes them."""
    try:
        return dict(core().track_readouts)
    except (ImportError, AttributeError):  # no module, or one of an earlier version
        return {}


def parts(tracks: Iterable[np.ndarray[Any, Any]], interval: float) -> _core.TrackParts:
    """What each track contributes to read-outs.

    :raises CoreNotFound: without the compiled module
    """
    found: _core.TrackParts = core().TrackParts(list(tracks), interval)
    return found


def drift(tracks: Iterable[np.ndarray[Any, Any]], starts: Iterable[float], interval: float) -> tuple[np.ndarray[Any, Any], str]:
    """The drift of tracks [um], a row an interval from the first start [s] on, and what is said of it; nothing if no interval has any.

    :raises CoreNotFound: without the compiled module
    """
    found: tuple[np.ndarray[Any, Any], str] = core().drift(list(tracks), list(starts), interval)
    return found


def standard_errors(values: list[float], drawn: np.ndarray[Any, Any]) -> list[float]:
    """Standard errors of read-outs; NaN of what few of the resampled sets define.

    :param drawn: their read-outs, a row a set
    """
    found: list[float] = core().standard_errors(values, drawn)
    return found
