"""Read-outs of tracks, as the program computes them (src/tracks/readouts.hpp), by the compiled module."""
from __future__ import annotations

from functools import cache

from ..base.load_core import core

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
