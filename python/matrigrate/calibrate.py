"""Parameters from measured tracks: which points of a study give cells like the measured ones.

    from matrigrate import calibrate, tracks

    cells = tracks.read("spots.csv", pixel=0.65, frame_interval=120)
    study = matrigrate.load_study("design-study")         # a Latin hypercube: its ranges are the prior
    fit = calibrate.fit(study, cells, ["speed_um_per_h", "straightness"])
    fit.write("fit")                                      # fit/report.html, and tables
"""
from __future__ import annotations

from ._fit import Emulators, Fit, emulate, fit
from ._match import Match, Wave, match
from ._outcomes import Outcome, read_outcomes

__all__ = ["Emulators", "Fit", "Match", "Outcome", "Wave", "emulate", "fit", "match", "read_outcomes"]
