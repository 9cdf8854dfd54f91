"""The page of a fit."""
from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _words
from ._report import blue, corner, document, figure, grey, intervals, new, note, red, table, wrapped

if TYPE_CHECKING:
    from ._fit import Fit

_heads = {"prior_5": "prior 5 %", "prior_95": "prior 95 %", "posterior_5": "5 %", "posterior_50": "50 %", "posterior_95": "95 %", "at_bound": "at bound",
          "standard_error": "standard error", "posterior_mean": "posterior mean", "first_5": "first 5 %", "first_95": "first 95 %",
          "total_5": "total 5 %", "total_95": "total 95 %"}


def page(fit: Fit) -> str:
    """report.html: it needs no other file and no network."""
    short = fit.table[["prior_5", "prior_95", "posterior_5", "posterior_50", "posterior_95", "width", "constrained", "at_bound"]]
    notes = "".join(f"<li>{note(text)}</li>" for text in fit.notes) or "<li>none</li>"
    return document("Fitted parameters", facts(fit), f"""
<p>{fit.plausible:.1%} of the prior is plausible: there no read-out is off by more than three standard errors.</p>
<h2>Parameters</h2>
{table(short, _heads)}
<p><small>Quantiles of prior and posterior. <i>width</i>: of the 90 % interval, over that of the prior. <i>constrained</i>: it is below
0.8, and the prior cuts off neither end. <i>at bound</i>: the posterior ends at this bound of the prior. The posterior has the weight of
{fit.effective_sample_size:.0f} independent draws.</small></p>
{figure(lambda: corner(fit.prior, [(fit.prior.to_cube(fit.sample[fit.prior.names].to_numpy(float)), blue)]),
        "Posterior of each parameter (the prior is the dashed line), and of each pair, with 50 and 90 % of it, over the whole prior")}
<h2>What the data cannot tell</h2>
<ul>{notes}</ul>
{figure(lambda: _widths(fit), "Width of the 90 % interval over that of the prior: at 1 the data tell nothing, and below 0.8 (dashed) a parameter is constrained")}
<h2>Fit against data</h2>
{table(fit.readouts, _heads)}
<p><small><i>implausibility</i>: standard errors between measured value and emulator, where the largest of them is least.
<i>predicted</i>: share of the variance of points that an emulator predicts when they are left out; the rest is scatter of cells.
<i>coverage</i>: share of points within its 90 % interval.</small></p>
{figure(lambda: _against_data(fit), "Measured values with two standard errors, and 90 % of the posterior")}
{figure(lambda: _paths(fit), "Measured tracks beside simulated ones of the points that fit best, each from its start, to one scale")
 if fit.measured is not None and fit.simulated is not None else ""}
<h2>Which parameters the read-outs depend on</h2>
{figure(lambda: _sobol(fit), "Sobol's first (light) and total (dark) indices of the mean read-outs, with 90 % intervals")}
{table(fit.sensitivity.set_index("readout"), _heads)}""")


def facts(fit: Fit) -> list[tuple[str, str]]:
    """Of what the page was made."""
    tracks = fit.measured
    return [("study", fit.source.get("study", "")), ("measured tracks", fit.source.get("tracks", "")),
            ("number of tracks", "" if tracks is None else f"{len(tracks)}, every {tracks.interval:g} s"), ("seed", fit.source.get("seed", ""))]


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
    rows, scale = fit.readouts, fit.readouts["standard_error"]
    low, high = (((rows[name] - rows["measured"]) / scale).to_numpy(float) for name in ("posterior_5", "posterior_95"))
    names = [_words.typeset(f"{_words.words(str(name))}: {value:.3g} {_words.unit(str(name))}".strip())
             for name, value in zip(rows.index, rows["measured"], strict=True)]
    two = np.full(len(rows), 2.0)
    return intervals(names, (-two, two), (low, high), 20.0, "distance from the measured value (standard errors)")


def _paths(fit: Fit) -> Any:
    """Measured and simulated tracks beside each other, to one scale."""
    made = new(8.2, 4.2)
    axes = made.subplots(1, 2, sharex=True, sharey=True)
    for ax, cells, colour, said in zip(axes, (fit.measured, fit.simulated), (red, blue), ("measured", "simulated"), strict=True):
        for track in (cells or {}).values():
            ax.plot(*(track - track[np.isfinite(track[:, 0])][0]).T, color=colour, linewidth=1, alpha=0.7)
        ax.set(xlabel="x (µm)", title=f"{said}: {len(cells or {})} tracks", aspect="equal", adjustable="box")
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
