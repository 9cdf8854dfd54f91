"""The page of a history match."""
from __future__ import annotations

import html
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from ._report import blue, corner, document, figure, grey, intervals, new, note, table

if TYPE_CHECKING:
    import pandas

    from ._match import Match

_waves = ("#b4b9c0", "#8cc0e2", "#3f97cc", "#0072b2")  # from the first to the last


def page(match: Match) -> str:
    """report.html: it needs no other file and no network."""
    notes = "".join(f"<li>{note(text)}</li>" for text in match.notes) or "<li>none</li>"
    fitted, held = match.outcomes[~match.outcomes["held_back"]], match.outcomes[match.outcomes["held_back"]]
    rows = f"at most {match.allowed} rows are" if match.allowed else "no row is"
    return document("Plausible parameters", [("study", match.source.get("study", "")), ("seed", str(match._seed))], f"""
<p>{html.escape(_shares(match))} There {rows} off by {match.cutoff:g} standard errors or more.</p>
{figure(lambda: _share_figure(match), "Share of the prior that is plausible after each wave") if len(match.waves) > 1 else ""}
<h2>Parameters</h2>
{table(_ranges(match))}
<p><small>Of each parameter the quantiles of what is plausible after each wave, the last one's middle, and the best point: the one whose rows are least off in
the mean square. ranges.csv has the ends of what is plausible.</small></p>
{figure(lambda: _corner(match), "What is plausible of each parameter (the prior is the dashed line) and of each pair, with 50 and 90 % of it: the darker, the later the wave; the best point in red")}
<h2>Rows</h2>
{table(match.rows)}
<p><small><i>plausible</i>: share of the prior where this row is not off by {match.cutoff:g} standard errors. <i>least</i>: the least implausibility within the
prior. <i>point</i>: at the best point.</small></p>
<h2>Rows that exclude each other</h2>
{_exclusions(match)}
<h2>What meeting an outcome would take</h2>
{table(match.reach)}
<p><small>By the means of emulators, within the prior. <i>nearest</i>: the mean that is nearest to what was measured. <i>met</i>: share of the prior where it is
within the error. <i>others</i>: mean likelihood of the other rows there, as a multiple of that in the whole prior. <i>against</i>: the row whose
implausibility rises most there.</small></p>
<h2>Outcomes that were fitted</h2>
{_outcome_part(match, fitted)}
<h2>Outcomes that were held back</h2>
{_outcome_part(match, held) if len(held) else "<p>None.</p>"}
<h2>Emulators</h2>
<p><small><i>predicted</i>: share of the variance of points that an emulator predicts when they are left out; the rest is the scatter of seeds.
<i>coverage</i>: share of points within its 90 % interval.</small></p>
{table(match.outcomes[["points", "predicted", "predicted_error", "coverage", "told"]])}
{figure(lambda: _checks(match), "Each point as the others predict it, over what was simulated")}
<h2>Notes</h2>
<ul>{notes}</ul>""")


def _exclusions(match: Match) -> str:
    against = match.exclusions[~match.exclusions["both"].astype(bool)].set_index("a")
    if not len(against):
        return "<p>Each pair of rows has points that satisfy both.</p>"
    return f"""{table(against, {"alone_a": "the first alone", "alone_b": "the second alone", "b": "against"})}
<p><small>No point within the prior satisfies both. <i>least</i>: the least that the worse of the two is off, in standard errors; <i>alone</i>: the same of
each by itself.</small></p>"""


def _shares(match: Match) -> str:
    said = [f"{wave.share:.2g} after {wave.points} points" if wave.share else f"nothing after {wave.points} points" for wave in match.waves]
    return f"Share of the prior that is plausible: {', '.join(said)}."


def _ranges(match: Match) -> pandas.DataFrame:
    made = match.waves[-1].ranges[[]].copy()
    made["prior from"], made["to"] = match.prior.low, match.prior.high
    for k, wave in enumerate(match.waves, 1):
        made[f"wave {k}: 5 %"], made[f"wave {k}: 95 %"] = wave.ranges["5"], wave.ranges["95"]
    made["50 %"], made["best"] = match.waves[-1].ranges["50"], match.best
    return made


def _share_figure(match: Match) -> Any:
    made = new(5, 2.4)
    ax = made.subplots()
    shares = [wave.share for wave in match.waves]
    ax.bar([f"{k}: {wave.points} points" for k, wave in enumerate(match.waves, 1)], shares, color=blue)
    if min(shares) > 0 and max(shares) > 20 * min(shares):
        ax.set_yscale("log")
    ax.set_xlabel("wave")
    return made


def _corner(match: Match) -> Any:
    many = len(match.waves)
    colours = _waves[-many:] if many <= len(_waves) else [_waves[0]] * (many - 3) + list(_waves[1:])
    best = match.prior.to_cube(match.best[match.prior.names].to_numpy(float)[None])[0]
    return corner(match.prior, [(wave.cube, colour) for wave, colour in zip(match.waves, colours, strict=True)], best)


def _outcome_part(match: Match, outcomes: pandas.DataFrame) -> str:
    shown = outcomes[["row", "low", "high", "error", "mean", "5", "95", "implausibility"]]
    return f"""{table(shown)}
<p><small><i>low</i>, <i>high</i>: measured. <i>error</i>: of the measured value and the model. <i>mean</i>, <i>5</i>, <i>95</i>: predicted over what is
plausible. <i>implausibility</i>: at the best point.</small></p>
{figure(lambda: _predicted(outcomes), "Measured with two errors, and 90 % of the predictions")}"""


def _predicted(outcomes: pandas.DataFrame) -> Any:
    told = outcomes[np.isfinite(outcomes["mean"])]
    low, high = told["low"].to_numpy(float), told["high"].to_numpy(float)
    middle = np.where(np.isinf(low), high, np.where(np.isinf(high), low, (low + high) / 2))
    scale = np.maximum(told["error"].to_numpy(float), 1e-12 + 0.02 * np.abs(middle))
    measured = tuple(np.clip((end - middle) / scale, -10.0, 10.0) + shift for end, shift in ((low, -2.0), (high, 2.0)))
    predicted = tuple((told[name].to_numpy(float) - middle) / scale for name in ("5", "95"))
    return intervals([str(name) for name in told.index], (measured[0], measured[1]), (predicted[0], predicted[1]), 10.0,
                     "distance from the measured value (standard errors)")


def _checks(match: Match) -> Any:
    many, columns = len(match.emulators), 6
    lines = math.ceil(many / columns)
    made = new(9, 1.6 * lines + 0.3)
    axes = made.subplots(lines, columns, squeeze=False).ravel()
    for ax, (name, emulator) in zip(axes, match.emulators.items(), strict=False):
        ax.plot(emulator.values, emulator.left_out, ".", color=blue, markersize=3)
        ax.axline((float(np.mean(emulator.values)),) * 2, slope=1, color=grey, linewidth=0.8)
        ax.set_title(f"{name[:34]}: {emulator.explained:.2f}", fontsize=6.5)
        ax.tick_params(labelsize=6.5)
    for ax in axes[many:]:
        ax.set_axis_off()
    return made
