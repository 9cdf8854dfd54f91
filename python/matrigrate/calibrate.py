"""Parameters from measured cells: which points of a study give cells like the measured ones.

    from matrigrate import calibrate, tracks

    cells = tracks.read("spots.csv", pixel=0.65, frame_interval=120)
    study = matrigrate.load_study("design-study")         # a Latin hypercube: its ranges are the prior
    fit = calibrate.fit(study, cells, ["speed_um_per_h", "straightness"])
    fit.write("fit")                                      # fit/report.html, and tables
    fit.next(40, "second.toml")                           # points where cells are like the measured ones, ready to run
    found = calibrate.compare(study, cells, treated, ["speed_um_per_h"])    # which parameter must differ?
    print(*found.words, sep="\\n")
"""
from __future__ import annotations

from typing import Any

from .errors import ConfigurationError
from .fit.comparison import Comparison, compare
from .fit.fit import Emulators, emulate, fit
from .fit.posterior import Fit

__all__ = ["Comparison", "Emulators", "Fit", "compare", "emulate", "fit"]


def _gone(*_: Any, **__: Any) -> Any:
    raise ConfigurationError("match, Match, Outcome, Wave and read_outcomes have gone: "
                             "calibrate.fit takes numbers and ranges by condition, as in "
                             "fit(study, {\"50 Pa\": {\"l_prot_um\": (13.1, 0.4)}}, held_back=[...]), and its next(n) gives the next wave")


match = Match = Outcome = Wave = read_outcomes = _gone
