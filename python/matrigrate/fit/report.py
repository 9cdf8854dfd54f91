"""The page of a fit: one file with tables and figures in the colours of the page, light or dark."""
from __future__ import annotations

import html
import io
import re
from collections.abc import Callable, Iterable
from datetime import datetime, timezone
from typing import TYPE_CHECKING, Any

import numpy as np

from .._version import __version__
from ..base.files import require_pandas
from ..draw import words as _words
from ..draw.words import blue, grey, red

if TYPE_CHECKING:
    import pandas

    from .comparison import Comparison
    from .emulator import Array, Prior
    from .posterior import Fit
    from ..tracks import Tracks

_ink = "#1a2b3d"  # of figures; the page replaces it by the colour of its text
_style = """:root{--text:#1f2328;--soft:#57606a;--line:#d0d7de;--ground:#fff;--blue:#0072b2;--red:#d55e00;color-scheme:light dark}
@media (prefers-color-scheme:dark){:root{--text:#e9edf1;--soft:#a3adb8;--line:#343b43;--ground:#14171a;--blue:#56b4e9;--red:#e8743b}}
@media print{:root{--text:#1f2328;--soft:#57606a;--line:#d0d7de;--ground:#fff;--blue:#0072b2;--red:#d55e00}}
body{font:16px/1.5 system-ui,"Segoe UI",Helvetica,Arial,sans-serif;max-width:76rem;margin:2rem auto;padding:0 1.5rem;color:var(--text);background:var(--ground)}
table{border-collapse:collapse;font-size:.85rem;display:block;overflow-x:auto}td,th{padding:.2rem .5rem;text-align:right;border-bottom:1px solid var(--line)}
th{font-weight:600;vertical-align:bottom}td:first-child,th:first-child{text-align:left}figure{margin:1rem 0}figure svg{max-width:100%;height:auto}
figcaption,small,dt{color:var(--soft)}li{margin:.2rem 0}dl{display:grid;grid-template-columns:max-content 1fr;gap:.1rem 1rem;font-size:.9rem}dd{margin:0}"""
_heads = {"prior_5": "prior 5 %", "prior_95": "prior 95 %", "posterior_5": "5 %", "posterior_50": "50 %", "posterior_95": "95 %", "at_bound": "at bound",
          "standard_error": "standard error", "posterior_mean": "posterior mean", "first_5": "first 5 %", "first_95": "first 95 %",
          "total_5": "total 5 %", "total_95": "total 95 %"}
_compared_heads = {"ratio_5": "treated over control, 5 %", "ratio_50": "50 %", "ratio_95": "95 %",
                   "times": "times as likely as nothing",
                   "over_nothing": "score over nothing", "over_nothing_error": "±",
                   "over_everything": "score over everything", "over_everything_error": "± ",
                   "effective_sample_size": "independent draws", "nothing": "if nothing differs",
                   "first": "if the most probable one differs", "everything": "if everything differs"}
_ratio_caption = "treated over control, if it alone differs (90 % of the posterior, and its median)"
_compared_caption = (f"Left: {_ratio_caption}. Right: cross-validated logarithmic score over that of nothing, "
                     "with its standard error")


def document(heading: str, facts: Iterable[tuple[str, str]], body: str) -> str:
    """report.html: it needs no other file and no network.

    :param facts: names and values, of what the page was made; empty ones are left out
    """
    now = datetime.now(timezone.utc).strftime("%Y-%m-%d")
    shown = "".join(f"<dt>{html.escape(name)}</dt><dd>{html.escape(value)}</dd>"
                    for name, value in [*facts, ("date", now), ("program", f"matrigrate {__version__}")] if value)
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>{html.escape(heading)}</title><style>{_style}</style></head><body>
<h1>{html.escape(heading)}</h1>
<dl>{shown}</dl>
{body}
</body></html>
"""


def note(text: str) -> str:
    """A note of the program with parameters and read-outs in words."""
    name = re.compile(r"[A-Za-z][\w.]*_\w+|[a-z]+\.[a-z_]\w*")
    return _words.lettered(html.escape(name.sub(lambda m: _words.words(m[0]) if _is_named(m[0]) else m[0], text)))


def _is_named(name: str) -> bool:
    name = name.partition(" at ")[0]
    return _words.words(name) != name.replace("_", " ")


def table(made: pandas.DataFrame, heads: dict[str, str]) -> str:
    """A table, its rows by parameter or read-out in words with symbol and unit.

    :param heads: of columns, if other than their names
    """
    def cell(value: Any) -> str:
        if isinstance(value, (bool, np.bool_)):
            return "yes" if value else "no"
        if isinstance(value, float):
            return f"{value:.3g}".replace("-", "−") if np.isfinite(value) else ""
        return named(str(value)) if _is_named(str(value)) else html.escape(str(value))

    said = [heads.get(name, name if " " in name else name.replace("_", " ")) for name in map(str, made.columns)]
    head = "".join(f"<th>{_words.lettered(html.escape(text))}</th>" for text in ["", *said])
    rows = "".join("<tr>" + "".join(f"<td>{cell(value)}</td>" for value in (name, *row)) + "</tr>"
                   for name, row in zip(made.index, made.itertuples(index=False), strict=True))
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def named(name: str) -> str:
    """A parameter, several joined by +, or a read-out for HTML: words, symbol and unit."""
    readout, between, condition = name.partition(" at ")
    words = " + ".join(_words.lettered(html.escape(_words.title(one))) for one in readout.split(" + "))
    return words + html.escape(between + condition)


def figure(draw: Callable[[], Any], caption: str) -> str:
    """A figure as SVG in the page, with the page's colour of text, drawn without a display and without the state of pyplot."""
    import matplotlib

    options = _words.style | {"svg.fonttype": "none", "svg.hashsalt": "matrigrate", "text.color": _ink, "axes.labelcolor": _ink,
                              "axes.edgecolor": _ink, "xtick.color": _ink, "ytick.color": _ink, "font.family": "sans-serif"}
    image = io.StringIO()
    with matplotlib.rc_context(options):
        draw().savefig(image, format="svg", transparent=True, metadata={"Date": None, "Creator": None})
    text = image.getvalue()
    text = text[text.index("<svg"):].replace(_ink, "currentColor").replace(blue, "var(--blue)").replace(red, "var(--red)")
    text = re.sub(r' id="(?:figure|axes|patch|text|matplotlib\.axis|line2d|xtick|ytick|PathCollection|QuadContourSet|LineCollection|legend)_\d+"', "", text)
    text = re.sub(r' xmlns(?::xlink)?="[^"]*"', "", text).replace("xlink:href", "href")
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    return (f'<figure role="img" aria-label="{html.escape(caption)}">{text}<figcaption>{html.escape(caption)}</figcaption></figure>')


def new(width: float, height: float) -> Any:
    from matplotlib.figure import Figure

    return Figure(figsize=(width, height), layout="constrained")


def wrapped(name: str, letters: int) -> str:
    """Words, symbol and unit of a parameter or read-out, in lines, for a figure."""
    readout, between, condition = name.partition(" at ")
    lines = _words.axis_title(readout, letters)
    return f"{lines}\nat {_words.plain(condition)}" if between else lines


def density(sample: Array, cells: int = 80) -> tuple[Array, Array]:
    """The density of a sample in the unit cube, of one or two columns, on a grid of cells and their centres: kernels of Scott's width, mirrored
    at the ends, so that a uniform sample has an even density up to them."""
    from scipy.ndimage import gaussian_filter

    n, columns = sample.shape
    counts, _ = np.histogramdd(np.clip(sample, 0, 1), [np.linspace(0, 1, cells + 1)] * columns)
    widths = np.maximum(sample.std(axis=0) * n ** (-1 / (columns + 4)) * cells, 0.7)
    smooth = gaussian_filter(counts, widths, mode="reflect")
    return (np.arange(cells) + 0.5) / cells, np.asarray(smooth / smooth.sum() * cells**columns)


def level_of(share: float, values: Array) -> float:
    """The density above which a share of the sample lies."""
    falling = np.sort(values.ravel())[::-1]
    return float(falling[np.searchsorted(np.cumsum(falling), share * falling.sum())])


def ticks(prior: Prior, column: int) -> tuple[Array, list[str]]:
    """Places in the unit cube, and words, of round values of a parameter: decades, or 1, 2, 5."""
    from matplotlib.ticker import MaxNLocator

    low, high = float(prior.low[column]), float(prior.high[column])
    if prior.is_log[column]:
        steps = (1.0,) if high > 99 * low else (1.0, 2.0, 5.0)
        decades = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
        values = np.array([step * 10.0**k for k in decades for step in steps])
    else:
        values = MaxNLocator(3, steps=[1, 2, 5, 10]).tick_values(low, high)
    values = values[(values >= low * (1 - 1e-9) - 1e-300) & (values <= high * (1 + 1e-9))]
    values = values[:: max(1, int(np.ceil(len(values) / 4)))]
    every = np.ones((len(values), len(prior.names))) * prior.low
    every[:, column] = values
    return prior.to_cube(every)[:, column], [f"{value:.6g}".replace("-", "−") for value in values]


def corner(prior: Prior, sample: Array) -> Any:
    """Each parameter and each pair of them over the whole prior: densities of a sample of the unit cube, with lines around 50 and 90 %, the prior
    dashed."""
    n = len(prior.names)
    made = new(min(2.2 * n + 0.9, 12.0), min(2.0 * n + 0.8, 11.4))
    letters = max(11, int(60 / max(n, 2)))
    for (row, column), ax in np.ndenumerate(made.subplots(n, n, squeeze=False)):
        if column > row:
            ax.set_axis_off()
            continue
        _shown_density(ax, sample[:, [column, row][: 1 if row == column else 2]])
        _finish(ax, prior, (row, column), letters)
    return made


def _shown_density(ax: Any, sample: Array) -> None:
    at, values = density(sample, 80 if sample.shape[1] == 1 else 60)
    if sample.shape[1] == 1:
        ax.fill_between(at, values, color=blue, alpha=0.35, linewidth=0)
        ax.plot(at, values, color=blue)
        return
    levels = sorted({level_of(share, values) for share in (0.9, 0.5)})
    ax.contourf(at, at, values.T, [*levels, np.inf], colors=[blue], alpha=0.3)
    if len(levels) > 1:
        ax.contourf(at, at, values.T, [levels[-1], np.inf], colors=[blue], alpha=0.4)
    ax.contour(at, at, values.T, levels, colors=[blue], linewidths=0.9)


def _finish(ax: Any, prior: Prior, place: tuple[int, int], letters: int) -> None:
    """Axes are those of the unit cube; what is written is the parameter."""
    row, column = place
    n = len(prior.names)
    ax.set_xlim(0, 1)
    if row == column:
        ax.axhline(1, color=grey, linestyle="--", linewidth=1)  # the prior
        ax.set_ylim(0, None)
        ax.set_yticks([])
    else:
        ax.set_ylim(0, 1)
        at, said = ticks(prior, row)
        ax.set_yticks(at, said if column == 0 else [""] * len(at))
    at, said = ticks(prior, column)
    ax.set_xticks(at, said if row == n - 1 else [""] * len(at))
    if row == n - 1:
        ax.set_xlabel(wrapped(prior.names[column], letters), fontsize=8)
    if column == 0 and row > 0:
        ax.set_ylabel(wrapped(prior.names[row], letters), fontsize=8)


def page_of_fit(fit: Fit) -> str:
    """report.html: it needs no other file and no network."""
    short = fit.table[["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]]
    cells = [f"{len(tracks)}, every {tracks.interval:g} s{' at ' * bool(name)}{name}" for name, (tracks, _) in fit.tracks.items()]
    facts = [("study", fit.source["study"]), ("measured tracks", fit.source["tracks"]), ("number of tracks", "; ".join(cells)), ("seed", fit.source["seed"])]
    return document("Fitted parameters", facts, f"""
<p>{share(fit.plausible)} of the prior is plausible: there no number is off by more than three standard errors.</p>
<h2>Parameters</h2>
{table(short, _heads)}
<p><small>Quantiles of prior and posterior. <i>width</i>: of the 90 % interval, over that of the prior. <i>constrained</i>: it is below
0.8, and the prior cuts off neither end. <i>at bound</i>: the posterior ends at this bound of the prior. The posterior has the weight of
{fit.effective_sample_size:.0f} independent draws.</small></p>
{figure(lambda: corner(fit.prior, fit.prior.to_cube(fit.sample[fit.prior.names].to_numpy(float))),
        "Posterior of each parameter (the prior is the dashed line), and of each pair, with 50 and 90 % of it, over the whole prior")}
<h2>What the data cannot tell</h2>
<ul>{_items(fit.notes) or "<li>none</li>"}</ul>
{figure(lambda: _widths(fit), "Width of the 90 % interval over that of the prior: at 1 the data tell nothing, and below 0.8 (dashed) a parameter is constrained")}
<h2>Fit against data</h2>
{table(fit.readouts, _heads)}
<p><small><i>low</i>, <i>high</i>: ends of a measured range. <i>implausibility</i>: standard errors between measured value and emulator, where the
largest of them is least. <i>predicted</i>: share of the variance of points that an emulator predicts when they are left out; the rest is scatter of
cells. <i>coverage</i>: share of points within its 90 % interval. <i>held back</i>: predicted, not fitted.</small></p>
{figure(lambda: _against_data(fit), "Measured values with two standard errors, and 90 % of the posterior")}
{"".join(figure(lambda both=both: _paths(*both), "Measured tracks beside simulated ones of the points that fit best, each from its start, to one "
                f"scale{': ' * bool(name)}{name}") for name, both in fit.tracks.items() if both[1] is not None)}
<h2>Which number excludes what</h2>
{table(_left(fit), _heads)}
<p><small><i>plausible</i>: share of the prior where this number alone is off by at most three standard errors; and the ranges of parameters
there.</small></p>
{_against_each_other(fit)}
<h2>Which parameters the read-outs depend on</h2>
{figure(lambda: _sobol(fit), "Sobol's first (light) and total (dark) indices of the mean read-outs, with 90 % intervals")}
{table(fit.sensitivity.set_index("readout"), _heads)}""")


def share(value: float) -> str:
    """A share in per cent, also a small one."""
    return f"{value:.1%}" if value == 0 or value >= 0.001 else f"{100 * value:.1e} %"


def _left(fit: Fit) -> pandas.DataFrame:
    """A row per number: what it alone leaves."""
    rows = {}
    for name, own in fit.alone.groupby("readout", sort=False):
        rows[name] = {"plausible": float(own["plausible"].iloc[0])}
        for parameter, low, high in zip(own["parameter"], own["low"], own["high"], strict=True):
            rows[name][_words.title(parameter)] = f"{_words.number(low)} to {_words.number(high)}" if np.isfinite(low) else ""
    return require_pandas().DataFrame.from_dict(rows, orient="index")


def _against_each_other(fit: Fit) -> str:
    against = fit.exclusions[fit.exclusions["both"] == 0]
    if not len(against):
        return "<p>Each pair of numbers is met somewhere.</p>" if len(fit.exclusions) else ""
    return f"""<p>No point of the prior meets both of these. <i>least</i>: what the worse of the two is off at least, in standard errors.</p>
{table(against.set_index("a"), {"b": "against", "plausible_a": "plausible by the first", "plausible_b": "by the second"})}"""


def _widths(fit: Fit) -> Any:
    made = new(7, 0.6 + 0.45 * len(fit.table))
    ax = made.subplots()
    constrained = fit.table["constrained"].to_numpy(bool)
    ax.barh([wrapped(str(name), 40) for name in fit.table.index], fit.table["width"], color=np.where(constrained, blue, red), height=0.6)
    ax.axvline(0.8, color=grey, linestyle="--", linewidth=1)
    ax.set_xlim(0, 1.1)
    ax.set_xlabel("width of the posterior over that of the prior")
    ax.invert_yaxis()
    return made


def _against_data(fit: Fit) -> Any:
    """For each number two bars: measured (red, above) and of the posterior (blue, below)."""
    rows, reach = fit.readouts, 20.0
    measured, scale = rows["measured"].to_numpy(float), rows["standard_error"].to_numpy(float)
    made = new(8.2, 0.9 + 0.42 * len(rows))
    ax, at = made.subplots(), np.arange(len(rows))
    for names, wider, shift, colour, said in ((("low", "high"), 2.0, -0.12, red, "measured, with two standard errors"),
                                              (("posterior_5", "posterior_95"), 0.0, 0.14, blue, "predicted, 90 %")):
        low, high = ((rows[name].to_numpy(float) - measured) / scale for name in names)
        ax.hlines(at + shift, np.clip(low - wider, -reach, reach), np.clip(high + wider, -reach, reach), color=colour, linewidth=4, label=said)
    ax.axvline(0, color=grey, linewidth=0.8)
    ax.set_yticks(at, [_measured(str(name), row) for name, row in rows.iterrows()])
    ax.set_ylim(len(rows) - 0.4, -0.6)
    ax.set_xlabel("distance from the measured value (standard errors)")
    ax.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    return made


def _measured(name: str, row: pandas.Series) -> str:
    """What was measured, for a figure."""
    readout, between, condition = name.partition(" at ")
    value = f"{row['measured']:.3g}" if row["low"] == row["high"] else f"{row['low']:.3g} to {row['high']:.3g}"
    words = _words.typeset(f"{_words.words(readout)}: {value} {_words.unit(readout)}".strip()) + between + _words.plain(condition)
    return words + " (held back)" * bool(row["held_back"])


def _paths(measured: Tracks, simulated: Tracks) -> Any:
    """Measured and simulated tracks beside each other, to one scale."""
    made = new(8.2, 4.2)
    axes = made.subplots(1, 2, sharex=True, sharey=True)
    for ax, cells, colour, said in zip(axes, (measured, simulated), (red, blue), ("measured", "simulated"), strict=True):
        for track in cells.values():
            ax.plot(*(track - track[np.isfinite(track[:, 0])][0]).T, color=colour, linewidth=1, alpha=0.7)
        ax.set(xlabel="x (µm)", title=f"{said}: {len(cells)} tracks", aspect="equal", adjustable="box")
    axes[0].set_ylabel("y (µm)")
    return made


def _sobol(fit: Fit) -> Any:
    names, parameters = list(fit.readouts.index), fit.prior.names
    made = new(min(2.3 * len(parameters) + 2.4, 12.0), 1.2 + 0.5 * len(names))
    axes = made.subplots(1, len(parameters), sharey=True, squeeze=False)[0]
    for ax, parameter in zip(axes, parameters, strict=True):
        rows = fit.sensitivity[fit.sensitivity["parameter"] == parameter]
        for shift, kind, colour in ((-0.17, "first", "#7fb8d8"), (0.17, "total", blue)):
            value = rows[kind].to_numpy(float)
            span = np.abs(rows[[f"{kind}_5", f"{kind}_95"]].to_numpy(float).T - value)
            ax.barh(np.arange(len(rows)) + shift, value, 0.32, color=colour, xerr=span, ecolor=grey)
        ax.set_yticks(np.arange(len(names)), [wrapped(name, 30) for name in names])
        ax.set_title(wrapped(parameter, 22), fontsize=8)
        ax.set_xlim(0, 1.05)
    axes[0].invert_yaxis()
    return made


def page_of_comparison(found: Comparison) -> str:
    """report.html: it needs no other file and no network."""
    parts = []
    for group in found.table["group"].unique():
        own = found.table[found.table["group"] == group].drop(columns="group").set_index("differs")
        own = own.dropna(axis=1, how="all")  # scores, where there are none
        caption = _compared_caption if "over_nothing" in own else _ratio_caption
        readouts = found.readouts[found.readouts["group"] == group]
        names = [f"{name} at {cells}" for name, cells in zip(readouts["readout"], readouts["cells"], strict=True)]
        readouts = readouts.drop(columns=["group", "cells", "readout"]).set_axis(names)
        words = [word.removeprefix(f"{group}: ") for word in found.words if word.startswith(f"{group}: ")]
        parts.append(f"""<h2>{html.escape(group)} beside control</h2>
<ul>{_items(words)}</ul>
{figure(lambda own=own: _treated_over_control(own), caption)}
{table(own, _compared_heads)}
{table(readouts, _compared_heads)}""")
    notes = f"<h2>Notes</h2><ul>{_items(found.notes)}</ul>" if found.notes else ""
    return document("Which parameter differs?", found.source.items(), f"""{''.join(parts)}
<p><small><i>times</i>: how many times as likely the data are as if nothing differs (Bayes factor).
<i>probability</i>: of a parameter, if just one differs and each was as probable before. <i>candidate</i>: one of the
fewest parameters that have 95 % of this probability; none if nothing differs. <i>score</i>: logarithm of the density of
each measured cell, or number, as all others predict it, summed up. <i>p</i>: share of data farther from what is
predicted than those measured; below 0.05 the hypothesis does not explain them. Last table: what was
measured, and what is predicted.</small></p>{notes}""")


def _items(texts: Iterable[str]) -> str:
    return "".join(f"<li>{note(text)}</li>" for text in texts)


def _treated_over_control(own: pandas.DataFrame) -> Any:
    """A row a parameter, the most probable first."""
    rows = own[np.isfinite(own["probability"])].sort_values("probability", ascending=False)
    made, at = new(9.0, 1.0 + 0.5 * len(rows)), np.arange(len(rows))
    left, right = made.subplots(1, 2, sharey=True)
    colours = np.where(rows["candidate"].to_numpy(bool), blue, grey)
    low, middle, high = rows[["ratio_5", "ratio_50", "ratio_95"]].to_numpy(float).T
    left.hlines(at, low, high, color=colours, linewidth=4)
    left.scatter(middle, at, color=colours, zorder=3)
    left.axvline(1, color=grey, linewidth=0.8)
    if np.isfinite(low).any() and np.nanmin(low) > 0:
        left.set_xscale("log")
        _words.plain_decades(left.xaxis, float(min(np.nanmin(low), 0.9)), float(max(np.nanmax(high), 1.1)))
    left.set_xlabel("treated over control")
    left.set_yticks(at, [f"{wrapped(name, 34)}: {share:.2g}" for name, share in rows["probability"].items()])
    left.invert_yaxis()
    if "over_nothing_error" not in rows:
        right.remove()
        return made
    right.errorbar(rows["over_nothing"], at, xerr=rows["over_nothing_error"], fmt="o", color=red, ecolor=red)
    right.axvline(0, color=grey, linewidth=0.8)
    right.set_xlabel("score over that of nothing")
    return made
