"""The page of a history match: figures of matplotlib and tables in one file."""
from __future__ import annotations

import html
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._fit_report import _blue, _figure, _grey, _new, _red, _style, _table
from ._version import __version__

if TYPE_CHECKING:
    import pandas

    from ._match import Match

_waves = ("#cccccc", "#9ecae1", "#4292c6", "#08519c")  # from the first to the last


def page(match: Match) -> str:
    """report.html: it needs no other file and no network."""
    notes = "".join(f"<li>{html.escape(note)}</li>" for note in match.notes) or "<li>none</li>"
    fitted, held = match.outcomes[~match.outcomes["held_back"]], match.outcomes[match.outcomes["held_back"]]
    rows = f"at most {match.allowed} rows are" if match.allowed else "no row is"
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Plausible parameters</title><style>{_style}</style></head><body>
<h1>Plausible parameters</h1>
<p>{html.escape(_shares(match))} There {rows} off by {match.cutoff:g} standard errors or more.</p>
{_figure(lambda: _share_figure(match), "Share of the prior that is plausible after each wave") if len(match.waves) > 1 else ""}
<h2>Parameters</h2>
{_table(_ranges(match))}
<p><small>Of each parameter the quantiles of what is plausible after each wave, the last one's middle, and the best point: the one whose rows are least off in
the mean square. ranges.csv has the ends of what is plausible.</small></p>
{_figure(lambda: _corner(match), "Plausible points over each parameter and pair: the darker, the later the wave; the best point in red")}
<h2>Rows</h2>
{_table(match.rows)}
<p><small><i>plausible</i>: share of the prior where this row is not off by {match.cutoff:g} standard errors. <i>least</i>: the least implausibility within the
prior. <i>point</i>: at the best point.</small></p>
<h2>Rows that exclude each other</h2>
{_exclusions(match)}
<h2>Outcomes that were fitted</h2>
{_outcome_part(match, fitted)}
<h2>Outcomes that were held back</h2>
{_outcome_part(match, held) if len(held) else "<p>None.</p>"}
<h2>Emulators</h2>
<p><small><i>predicted</i>: share of the variance of points that an emulator predicts when they are left out; the rest is the scatter of seeds.
<i>coverage</i>: share of points within its 90 % interval.</small></p>
{_table(match.outcomes[["points", "predicted", "coverage", "told"]])}
{_figure(lambda: _checks(match), "Each point as the others predict it, over what was simulated")}
<h2>Notes</h2>
<ul>{notes}</ul>
<p><small>Matrigrate {__version__}.</small></p>
</body></html>
"""


def _exclusions(match: Match) -> str:
    against = match.exclusions[~match.exclusions["both"]].set_index("a")
    if not len(against):
        return "<p>Each pair of rows has points that satisfy both.</p>"
    return f"""{_table(against)}
<p><small>No point within the prior satisfies both. <i>least</i>: the least that the worse of the two is off, in standard errors; <i>alone</i>: the same of
each by itself.</small></p>"""


def _shares(match: Match) -> str:
    said = [f"{wave.share:.2g} after {wave.points} points" if wave.share else f"nothing after {wave.points} points" for wave in match.waves]
    return f"Share of the prior that is plausible: {', '.join(said)}."


def _ranges(match: Match) -> pandas.DataFrame:
    table = match.waves[-1].ranges[[]].copy()
    table["prior_low"], table["prior_high"] = match.prior.low, match.prior.high
    for k, wave in enumerate(match.waves, 1):
        table[f"wave {k}: 5 %"], table[f"wave {k}: 95 %"] = wave.ranges["5"], wave.ranges["95"]
    table["50 %"], table["best"] = match.waves[-1].ranges["50"], match.best
    return table


def _share_figure(match: Match) -> Any:
    figure = _new(5, 2.4)
    ax = figure.subplots()
    shares = [wave.share for wave in match.waves]
    ax.bar([f"{k}: {wave.points} points" for k, wave in enumerate(match.waves, 1)], shares, color=_blue)
    if min(shares) > 0 and max(shares) > 20 * min(shares):
        ax.set_yscale("log")
    ax.set_xlabel("wave")
    return figure


def _corner(match: Match) -> Any:
    names, prior = match.prior.names, match.prior
    n = len(names)
    figure = _new(1.5 * n + 1, 1.4 * n + 0.8)
    axes = figure.subplots(n, n, squeeze=False)
    colours = _waves[-len(match.waves):] if len(match.waves) <= len(_waves) else [_waves[0]] * (len(match.waves) - 3) + list(_waves[1:])
    for row in range(n):
        for column in range(n):
            ax = axes[row][column]
            if column > row:
                ax.set_axis_off()
                continue
            for wave, colour in zip(match.waves, colours, strict=True):
                if not len(wave.cube):
                    continue
                if row == column:
                    ax.hist(wave.cube[:, row], np.linspace(0, 1, 21), color=colour, density=True, alpha=0.8)
                else:
                    ax.plot(*wave.cube[:800, [column, row]].T, ".", color=colour, markersize=2, alpha=0.6)
            best = prior.to_cube(match.best[names].to_numpy(float)[None])[0]
            if row == column:
                ax.axvline(best[row], color=_red, linewidth=1)
                ax.set_yticks([])
            else:
                ax.plot(best[column], best[row], "o", color=_red, markersize=4)
                ax.set_ylim(0, 1)
            ax.set_xlim(0, 1)
            _name_ends(ax, match, row, column, n)
    return figure


def _name_ends(ax: Any, match: Match, row: int, column: int, n: int) -> None:
    """Axes are those of the unit cube; what is written is the parameter."""
    ends = match.prior.from_cube(np.array([[0.1], [0.9]]) * np.ones(n)).T
    ax.set_xticks([0.1, 0.9], [f"{end:.2g}" for end in ends[column]] if row == n - 1 else ["", ""], fontsize=6)
    if column < row:
        ax.set_yticks([0.1, 0.9], [f"{end:.2g}" for end in ends[row]] if column == 0 else ["", ""], fontsize=6)
    if row == n - 1:
        ax.set_xlabel(match.prior.names[column], fontsize=7)
    if column == 0 and row > 0:
        ax.set_ylabel(match.prior.names[row], fontsize=7)


def _outcome_part(match: Match, table: pandas.DataFrame) -> str:
    shown = table[["row", "low", "high", "error", "mean", "5", "95", "implausibility"]]
    return f"""{_table(shown)}
<p><small><i>low</i>, <i>high</i>: measured. <i>error</i>: of the measured value and the model. <i>mean</i>, <i>5</i>, <i>95</i>: predicted over what is
plausible. <i>implausibility</i>: at the best point.</small></p>
{_figure(lambda: _predicted(table), "Measured with two errors (red), and 90 % of the predictions (blue), in errors from the measured value")}"""


def _predicted(table: pandas.DataFrame) -> Any:
    table = table[np.isfinite(table["mean"])]
    figure = _new(7, 0.9 + 0.28 * len(table))
    ax = figure.subplots()
    at = np.arange(len(table))
    low, high = table["low"].to_numpy(float), table["high"].to_numpy(float)
    middle = np.where(np.isinf(low), high, np.where(np.isinf(high), low, (low + high) / 2))
    scale = np.maximum(table["error"].to_numpy(float), 1e-12 + 0.02 * np.abs(middle))
    reach = 10.0
    for k in range(len(table)):
        left, right = (np.clip((end - middle[k]) / scale[k], -reach, reach) for end in (low[k], high[k]))
        ax.plot([max(left - 2, -reach), min(right + 2, reach)], [at[k]] * 2, color=_red, linewidth=2, alpha=0.6)
    first, last = ((table[name].to_numpy(float) - middle) / scale for name in ("5", "95"))
    ax.hlines(at + 0.2, np.clip(first, -reach, reach), np.clip(last, -reach, reach), color=_blue, linewidth=4)
    ax.axvline(0, color=_grey, linewidth=0.8)
    ax.set_yticks(at, list(table.index), fontsize=7)
    ax.set_ylim(len(table) - 0.4, -0.6)
    return figure


def _checks(match: Match) -> Any:
    many, columns = len(match.emulators), 6
    lines = math.ceil(many / columns)
    figure = _new(9, 1.6 * lines + 0.3)
    axes = figure.subplots(lines, columns, squeeze=False).ravel()
    for ax, (name, emulator) in zip(axes, match.emulators.items(), strict=False):
        ax.plot(emulator.values, emulator.left_out, ".", color=_blue, markersize=3)
        ax.axline((float(np.mean(emulator.values)),) * 2, slope=1, color=_grey, linewidth=0.8)
        ax.set_title(f"{name[:34]}: {emulator.explained:.2f}", fontsize=5.5)
        ax.tick_params(labelsize=5)
    for ax in axes[many:]:
        ax.set_axis_off()
    return figure
