"""Read-outs of tracks on a grid of times once more, as functions of arrays: what the program's are compared with.

A track is an array of shape (times, 2) [um] at equal intervals, with NaN where it has a gap. Only pairs of positions that
are both there count: nothing is interpolated.
"""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

Track = np.ndarray[Any, np.dtype[np.float64]]


class Parts:
    """What each track contributes, an entry or row a track: read-outs of a resampled set need no more."""

    def __init__(self, tracks: Sequence[Track], interval: float) -> None:
        self.interval = interval
        longest = max(map(len, tracks), default=1) - 1
        self.squares, self.pairs = np.zeros((len(tracks), longest)), np.zeros((len(tracks), longest))
        self.ratios = np.full((len(tracks), longest), np.nan)
        for k, track in enumerate(tracks):
            for lag in range(1, len(track)):
                squares = np.sum((track[lag:] - track[:-lag])**2, axis=1)
                self.squares[k, lag - 1] = np.nansum(squares)
                self.pairs[k, lag - 1] = np.count_nonzero(np.isfinite(squares))
            path = np.cumsum(_lengths(track))  # NaN from a gap on
            net = np.hypot(*(track[1:] - track[0]).T)
            self.ratios[k, :len(path)] = np.divide(net, path, out=np.full(len(path), np.nan), where=path > 0)
        self.lengths = np.array([len(track) - 1 for track in tracks])
        self.speed = np.array([_mean(_lengths(track)) for track in tracks]) * 3600.0 / interval
        self.v_migr_abs = np.array([_net(track, interval) for track in tracks])
        self.straightness = np.array([_straightness(track) for track in tracks])
        self.windowed = np.array([_windowed(track, 10) for track in tracks])
        self.anisotropy = np.array([_anisotropy(track) for track in tracks])
        turns = [_turning(track) for track in tracks]
        self.angle = np.array([_mean(np.degrees(np.abs(turn))) for turn in turns])
        self.cosine = np.array([_mean(np.cos(turn)) for turn in turns])

    def msd(self, which: Any = slice(None)) -> Track:
        """[um^2] over lags of 1, 2, ... intervals: over all pairs of positions of the tracks."""
        sums, counts = self.squares[which].sum(axis=0), self.pairs[which].sum(axis=0)
        return np.divide(sums, counts, out=np.full(len(sums), np.nan), where=counts > 0)

    def buried(self, error: float, which: Any = slice(None)) -> float:
        """The mean square displacement [um^2] at the shortest lag if the localisation error leaves nothing of it, else 0."""
        square = self.msd(which)
        shortest = float(square[np.isfinite(square)][:1].sum())
        return shortest if 0 < shortest <= 4.0 * error**2 else 0.0

    def readouts(self, which: Any = slice(None), error: float = 0.0) -> dict[str, float]:
        """All read-outs of the tracks with these numbers; NaN for a read-out that the tracks do not define.

        :param error: localisation error of a coordinate [um]; the mean square displacement is less by 4 error^2, and defines
            nothing if nothing is left of its shortest lag
        """
        speeds = self.speed[which]
        known = speeds[np.isfinite(speeds)]
        quartiles = np.percentile(known, [25, 50, 75]) if known.size else [np.nan] * 3
        square = self.msd(which) - 4.0 * error**2
        if self.buried(error, which):
            square[:] = np.nan
        longest = int(self.lengths[which].max(initial=0))
        return {
            "speed_um_per_h": _mean(speeds), "speed_median_um_per_h": float(quartiles[1]),
            "speed_q25_um_per_h": float(quartiles[0]), "speed_q75_um_per_h": float(quartiles[2]),
            "v_migr_abs_um_per_h": _mean(self.v_migr_abs[which]), "straightness": _mean(self.straightness[which]),
            "directionality_ratio": _mean(self.windowed[which]),
            "directionality_time_min": _directionality_time(self.ratios[which]) * self.interval / 60.0,
            "persistence_min": persistence(square[:max(3, longest // 3)], self.interval) / 60.0,
            "msd_slope_short": _slope(square, 1, min(4, longest)),
            "msd_slope_long": _slope(square, max(1, longest // 8), longest // 2),
            "anisotropy": _median(self.anisotropy[which]),
            "turning_angle_deg": _mean(self.angle[which]), "turning_cosine": _mean(self.cosine[which]),
        }


def persistence(square: Track, interval: float) -> float:
    """Persistence time P [s] of Fuerth's formula, MSD(t) = 2 S^2 P (t - P (1 - exp(-t/P))), by least relative squares;
    NaN where the lags cannot tell it: P below half an interval (a diffusive path) or above the largest lag (a straight
    one), or a lag without a displacement, as where the localisation error is larger than the cells move."""
    usable = np.isfinite(square)
    if np.count_nonzero(usable) < 3 or not (square[usable] > 0).all():
        return float("nan")
    t, y = interval * (np.flatnonzero(usable) + 1.0), square[usable]
    candidates = np.geomspace(interval / 4, 4 * t[-1], 400)
    P = candidates[:, None]
    model = P * (t - P * -np.expm1(-t / P)) / y  # up to the factor 2 S^2, which is fitted as well
    factor = model.sum(axis=1) / (model**2).sum(axis=1)
    best = float(candidates[np.argmin(((model * factor[:, None] - 1)**2).sum(axis=1))])
    return best if interval / 2 <= best <= t[-1] else float("nan")


def _steps(track: Track) -> Track:
    return track[1:] - track[:-1]


def _lengths(track: Track) -> Track:
    steps = _steps(track)
    return np.hypot(steps[:, 0], steps[:, 1])


def _ends(track: Track) -> Track:
    return np.flatnonzero(np.isfinite(track[:, 0]))


def _net(track: Track, interval: float) -> float:
    there = _ends(track)
    if len(there) < 2:
        return float("nan")
    return float(np.hypot(*(track[there[-1]] - track[there[0]])) / ((there[-1] - there[0]) * interval) * 3600.0)


def _straightness(track: Track) -> float:
    """A gap counts as a straight step."""
    there = track[_ends(track)]
    path = float(np.sum(_lengths(there)))
    return float(np.hypot(*(there[-1] - there[0]))) / path if path > 0 else float("nan")


def _windowed(track: Track, size: int) -> float:
    """Over the windows without a gap."""
    if len(track) <= size:
        return float("nan")
    path = np.convolve(_lengths(track), np.ones(size), "valid")
    net = np.hypot(*(track[size:] - track[:-size]).T)
    return _mean(np.divide(net, path, out=np.full(len(net), np.nan), where=path > 0))


def _directionality_time(ratios: Track) -> float:
    """Directionality time, in intervals, interpolated between two intervals; NaN if the ratio stays above one half."""
    mean = np.array([_mean(column) for column in ratios.T])
    below = np.flatnonzero(mean < 0.5)
    if not below.size or below[0] == 0:
        return float("nan")
    k = below[0]
    return float(k + (mean[k - 1] - 0.5) / (mean[k - 1] - mean[k]))


def _slope(square: Track, first: int, last: int) -> float:
    lags = np.arange(1, len(square) + 1)
    usable = (lags >= first) & (lags <= last) & np.isfinite(square)
    if np.count_nonzero(usable) < 2 or not (square[usable] > 0).all():
        return float("nan")
    return float(np.polyfit(np.log(lags[usable]), np.log(square[usable]), 1)[0])


def _anisotropy(track: Track) -> float:
    steps = _steps(track)
    steps = steps[np.isfinite(steps[:, 0])]
    if len(steps) < 3:
        return float("nan")
    across, along = np.linalg.eigvalsh(steps.T @ steps)
    return float(along / across) if across > 1e-12 * along else float("nan")


def _turning(track: Track) -> Track:
    """[rad]; without steps of length zero, which have no direction."""
    steps = _steps(track)
    steps = np.where((_lengths(track) > 0)[:, None], steps, np.nan)
    a, b = steps[:-1], steps[1:]
    return np.arctan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], np.sum(a * b, axis=1))


def _mean(values: Any) -> float:
    known = np.asarray(values, dtype=float)
    known = known[np.isfinite(known)]
    return float(known.mean()) if known.size else float("nan")


def _median(values: Any) -> float:
    known = np.asarray(values, dtype=float)
    known = known[np.isfinite(known)]
    return float(np.median(known)) if known.size else float("nan")
