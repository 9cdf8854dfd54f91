"""Figures of measured tracks: paths, mean square displacement, and whether the tracker can be trusted."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _words
from .tracks import Tracks

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_grey, _blue, _red = _words.grey, _words.blue, _words.red


def path(tracks: Tracks, axes: Axes, together: bool) -> None:
    """A line per track in its own colour, from its ring to its dot.

    :param together: whether all begin at one point
    """
    from matplotlib import colormaps

    for k, track in enumerate(tracks.values()):
        at = track - (track[np.isfinite(track[:, 0])][0] if together else 0.0)
        there = at[np.isfinite(at[:, 0])]
        colour = colormaps["viridis"](0.9 * k / max(1, len(tracks) - 1))
        axes.plot(there[:, 0], there[:, 1], color=colour, linewidth=1.0)
        axes.plot(*there[-1], "o", color=colour, markersize=3.5, zorder=4)
        if not together:
            axes.plot(*there[0], "o", color=colour, markerfacecolor="white", markersize=3.5, zorder=4)
    if together:
        axes.plot(0, 0, "+", color="black", markersize=9, zorder=5)


def msd(tracks: Tracks, axes: Axes) -> tuple[Any, Any]:
    """Mean square displacement over lags [min]; its lags and values."""
    table = tracks.msd().dropna()
    lag, square = table["lag_s"].to_numpy(float) / 60, table["msd_um2"].to_numpy(float)
    axes.plot(lag, square, "o-", color=_blue, markersize=3)
    return lag, square


def quality(tracks: Tracks, axes: Any) -> None:
    """Three panels: steps with those that are too long; distance of each pair of tracks that are there together over how alike they walk;
    drift."""
    suspects = tracks.suspects()
    steps, pairs, drift = axes
    lengths = np.concatenate([np.hypot(*(track[1:] - track[:-1]).T) for track in tracks.values()])
    lengths = lengths[np.isfinite(lengths)]
    steps.hist(lengths, bins=40, color=_grey)
    leaps = suspects[suspects["kind"] == "leap"]
    for _, row in leaps.iterrows():
        steps.axvline(row["value"], color=_red, linewidth=1)
    steps.set(xlabel="step between positions (µm)", ylabel="steps", title=f"leaps: {len(leaps)}")
    of_pairs = tracks.pairs()
    double = set(zip(suspects.loc[suspects["kind"] == "double", "track"], suspects.loc[suspects["kind"] == "double", "other"]))
    colours = [_red if (row.track, row.other) in double else _grey for row in of_pairs.itertuples()]
    pairs.scatter(of_pairs["distance_um"], of_pairs["correlation"], s=9, c=colours)
    pairs.set(xlabel="mean distance of two tracks (µm)", ylabel="correlation of their steps", ylim=(-1.05, 1.05), title=f"doubles: {len(double)}")
    way = tracks.drift()
    drift.plot(way[:, 0], way[:, 1], color=_blue)
    drift.plot(0, 0, "o", color=_blue, markerfacecolor="white")
    drift.set(xlabel="x (µm)", ylabel="y (µm)", title="drift: sum of mean steps", aspect="equal", adjustable="datalim")
