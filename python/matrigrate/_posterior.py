"""What a posterior tells of one parameter, however it was computed: whether it is constrained, and whether it ends at a bound."""
from __future__ import annotations

from typing import Any

import numpy as np

from ._files import unit_of

constrained_width = 0.8  #: of the 90 % interval of the prior: a wider one is not called constrained


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
