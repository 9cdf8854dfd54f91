"""The page of a fit: figures of matplotlib and tables in one file."""
from __future__ import annotations

import base64
import html
import io
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

from . import results, tracks
from ._version import __version__

if TYPE_CHECKING:
    import pandas

    from ._fit import Fit

_blue, _red, _grey = "#0072b2", "#d55e00", "#999999"  # told apart by all eyes
_style = """body{font:16px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color:#222}
table{border-collapse:collapse;font-size:.85rem;display:block;overflow-x:auto}td,th{padding:.2rem .6rem;text-align:right;border-bottom:1px solid #ddd}
td:first-child,th:first-child{text-align:left}img{max-width:100%}li{margin:.2rem 0}small{color:#555}"""


def page(fit: Fit) -> str:
    """report.html: it needs no other file and no network."""
    short = fit.table[["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]]
    notes = "".join(f"<li>{html.escape(note)}</li>" for note in fit.notes) or "<li>none</li>"
    return f"""<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>Fitted parameters</title><style>{_style}</style></head><body>
<h1>Fitted parameters</h1>
<p>{fit.plausible:.1%} of the prior is plausible: there no read-out is off by more than three standard errors.</p>
<h2>Parameters</h2>
{_table(short)}
<p><small>Quantiles of prior and posterior in per cent. <i>width</i>: of the 90 % interval, over that of the prior. <i>constrained</i>: it is below
0.8, and the prior cuts off neither end. <i>at_bound</i>: the posterior ends at this bound of the prior.</small></p>
{_figure(lambda: _corner(fit), "Posterior of each parameter, and of each pair")}
<h2>What the data cannot tell</h2>
<ul>{notes}</ul>
{_figure(lambda: _widths(fit), "Width of the 90 % interval over that of the prior; at 1 the data tell nothing")}
<h2>Fit against data</h2>
{_table(fit.readouts)}
<p><small>{_meanings(fit)} <i>implausibility</i>: standard errors between measured value and emulator, where the largest of them is least.
<i>predicted</i>: share of the variance of points that an emulator predicts when they are left out; the rest is scatter of cells.
<i>coverage</i>: share of points within its 90 % interval.</small></p>
{_figure(lambda: _against_data(fit), "Measured with two standard errors (red), and 90 % of the posterior (blue)")}
{_figure(lambda: _paths(fit), "Measured tracks (red) over simulated ones of the points that fit best (blue), each from its start [um]")
 if fit.measured is not None and fit.simulated is not None else ""}
<h2>Which parameters the read-outs depend on</h2>
{_figure(lambda: _sobol(fit), "Sobol's first (light) and total (dark) indices of the mean read-outs, with 90 % intervals")}
{_table(fit.sensitivity.set_index("readout"))}
<p><small>Matrigrate {__version__}. The effective sample size is {fit.effective_sample_size:.0f} independent draws.</small></p>
</body></html>
"""


def _meanings(fit: Fit) -> str:
    return " ".join(f"<i>{html.escape(name)}</i>: {html.escape(results.meaning(tracks.meaning(name)))}." for name in fit.readouts.index)


def _table(table: pandas.DataFrame) -> str:
    def cell(value: Any) -> str:
        if isinstance(value, (bool, np.bool_)):
            return "yes" if value else "no"
        if isinstance(value, float):
            return f"{value:.3g}" if np.isfinite(value) else ""
        return html.escape(str(value))

    head = "".join(f"<th>{html.escape(str(name))}</th>" for name in ["", *table.columns])
    rows = "".join("<tr>" + "".join(f"<td>{cell(value)}</td>" for value in (name, *row)) + "</tr>"
                   for name, row in zip(table.index, table.itertuples(index=False), strict=True))
    return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _figure(draw: Callable[[], Any], title: str) -> str:
    """A figure that is drawn without a display and without the state of pyplot."""
    figure = draw()
    image = io.BytesIO()
    figure.savefig(image, format="png", dpi=110, metadata={"Software": None})
    text = base64.b64encode(image.getvalue()).decode()
    return f'<figure><img alt="{html.escape(title)}" src="data:image/png;base64,{text}"><figcaption>{html.escape(title)}</figcaption></figure>'


def _new(width: float, height: float) -> Any:
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    FigureCanvasAgg(figure)
    return figure


def _corner(fit: Fit) -> Any:
    names, prior = fit.prior.names, fit.prior
    n = len(names)
    figure = _new(2.3 * n + 0.6, 2.1 * n + 0.4)
    axes = figure.subplots(n, n, squeeze=False)
    for row in range(n):
        for column in range(n):
            ax = axes[row][column]
            if column > row:
                ax.set_axis_off()
                continue
            ends = (prior.low[column], prior.high[column])
            edges = prior.from_cube(np.linspace(0, 1, 31)[:, None] * np.ones(n))
            if row == column:
                ax.hist(fit.sample[names[row]], edges[:, row], color=_blue, density=False)
                ax.axhline(len(fit.sample) / 30, color=_grey, linewidth=1, label="prior")
                ax.set_yticks([])
            else:
                ax.hist2d(fit.sample[names[column]], fit.sample[names[row]], [edges[:, column], edges[:, row]], cmap="Blues")
                ax.set_ylim(prior.low[row], prior.high[row])
                ax.set_yscale("log" if prior.is_log[row] else "linear")
            ax.set_xlim(ends)
            ax.set_xscale("log" if prior.is_log[column] else "linear")
            ticks = prior.from_cube(np.array([[0.1], [0.5], [0.9]]) * np.ones(n)).T
            for axis, k in ((ax.xaxis, column), *(((ax.yaxis, row),) if row != column else ())):
                axis.set_ticks(ticks[k], [f"{tick:.3g}" for tick in ticks[k]], fontsize=7)
                axis.set_ticks([], minor=True)
            if row == n - 1:
                ax.set_xlabel(names[column], fontsize=8)
            if column == 0 and row > 0:
                ax.set_ylabel(names[row], fontsize=8)
    return figure


def _widths(fit: Fit) -> Any:
    figure = _new(7, 0.6 + 0.4 * len(fit.table))
    ax = figure.subplots()
    constrained = fit.table["constrained"].to_numpy(bool)
    ax.barh(fit.table.index, fit.table["width"], color=np.where(constrained, _blue, _red))
    ax.axvline(0.8, color=_grey, linestyle="--", linewidth=1)
    ax.set_xlim(0, 1.1)
    ax.invert_yaxis()
    return figure


def _against_data(fit: Fit) -> Any:
    table = fit.readouts
    figure = _new(7, 0.8 + 0.4 * len(table))
    ax = figure.subplots()
    scale = table["standard_error"]
    at = np.arange(len(table))
    low, high = ((table[name] - table["measured"]) / scale for name in ("posterior_5", "posterior_95"))
    ax.errorbar(np.zeros(len(table)), at, xerr=2.0, fmt="o", color=_red, capsize=4)
    ax.hlines(at + 0.18, low, high, color=_blue, linewidth=4)
    ax.set_yticks(at, [f"{name} = {row.measured:.3g}" for name, row in zip(table.index, table.itertuples(), strict=True)])
    ax.set_xlabel("distance from the measured value, in standard errors")
    ax.set_ylim(len(table) - 0.4, -0.6)
    return figure


def _paths(fit: Fit) -> Any:
    figure = _new(6, 6)
    ax = figure.subplots()
    for cells, colour in ((fit.simulated, _blue), (fit.measured, _red)):
        for track in (cells or {}).values():
            ax.plot(*(track - track[0]).T, color=colour, linewidth=1, alpha=0.7)
    ax.set_aspect("equal")
    return figure


def _sobol(fit: Fit) -> Any:
    names, parameters = list(fit.readouts.index), fit.prior.names
    figure = _new(2.6 * len(parameters) + 2, 0.9 + 0.45 * len(names))
    axes = figure.subplots(1, len(parameters), sharey=True, squeeze=False)[0]
    for ax, parameter in zip(axes, parameters, strict=True):
        rows = fit.sensitivity[fit.sensitivity["parameter"] == parameter]
        for shift, kind, colour in ((-0.17, "first", "#7fb8d8"), (0.17, "total", _blue)):
            value = rows[kind].to_numpy(float)
            span = np.abs(rows[[f"{kind}_5", f"{kind}_95"]].to_numpy(float).T - value)
            ax.barh(np.arange(len(rows)) + shift, value, 0.32, color=colour, xerr=span, ecolor=_grey)
        ax.set_yticks(np.arange(len(names)), names)
        ax.set_title(parameter, fontsize=8)
        ax.set_xlim(0, 1.05)
    axes[0].invert_yaxis()
    return figure
