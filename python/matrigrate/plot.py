"""Figures of runs and studies with matplotlib. Each function draws into ``axes`` or a new figure, and returns the axes.

    axes = matrigrate.plot.path(run)
    axes.figure.savefig("path.png")
"""
from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from .base import arguments
from .base.load_core import library
from .draw import drawing, fibres, words as _words
from .results.results import Run
from .results.studies import Runs, Study
from .tracks import Tracks

if TYPE_CHECKING:
    import pandas
    from matplotlib.axes import Axes

_colours = _words.colours
_fields = {"youngs_modulus": "Young's modulus", "f_degr": "intact matrix, f_degr: 0 fluid, 1 intact", "von_mises": "von Mises stress", "fibre_von_mises": "von Mises stress of fibres"}


def path(run: Run | Tracks | Mapping[str, Run], axes: Axes | None = None, *, together: bool = False) -> Axes:
    """The path of the centre of mass [um] of each cell, from its ring to its dot; of several runs by their names, of runs of a study by
    their points; of measured tracks. The path of a single cell has the colours of time.

    :param together: whether all begin at one point, which shows short paths of cells that are far apart
    """
    if isinstance(run, Tracks):
        axes = axes or _new_axes()
        drawing.track_paths(axes, run, together)
        _plane(axes)
        return axes
    runs = {"": arguments.one_of("run", run, Run)} if not isinstance(run, Mapping) else dict(run)
    _pyplot()  # says what is missing before tables are read
    named_by: Mapping[str, str] = {}
    if isinstance(run, Runs) and run.study is not None:
        named_by = run.study.results.set_index("run")["label"].map(_points(run.study, with_name=True)[0]).to_dict()
    paths = [(named_by.get(name, _words.plain(name)) if len(runs) > 1 else f"cell {number}", number, cell.tracks)
             for name, one in runs.items() for number, cell in one.cells.items()]
    if together:
        paths = [(name, number, track.assign(**{axis: track[axis] - track[axis].iloc[0] for axis in ("x_um", "y_um")}))
                 for name, number, track in paths]
    axes = axes or _new_axes(figsize=_shape([table for _, _, table in paths]))
    lines: list[str] = []  # each has a colour and its name
    for name, number, track in paths:
        label = None if name in lines else name
        if label:
            lines.append(name)
        colour = _colours[lines.index(name) % len(_colours)]
        if len(runs) == 1 and len(paths) > 1:  # as in frames
            colour = drawing.colours_of(number, len(paths))[0]
        x, y = track["x_um"], track["y_um"]
        axes.plot(x, y, color=colour, linewidth=1.2, label=label)
        axes.plot(x.iloc[:1], y.iloc[:1], "o", color=colour, markerfacecolor="white", zorder=4)
        axes.plot(x.iloc[-1:], y.iloc[-1:], "o", color=colour, zorder=4)
    if len(paths) == 1 and len(paths[0][2]) > 1:
        track = paths[0][2]
        shown = drawing.path_in_time(axes, track["x_um"].to_numpy(), track["y_um"].to_numpy(), track["t_s"].to_numpy() / 60)
        axes.figure.colorbar(shown, ax=axes, label="time (min)", shrink=0.8)
    _plane(axes)
    if 1 < len(lines) <= 8:
        axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return axes


def frame(run: Run, t: float | None = None, field: str = "displacement", axes: Axes | None = None, *,
          fluid: bool = False, window: float | tuple[float, float, float, float] | str | None = None,
          follow: int | bool | None = None, limits: tuple[float, float] | None = None, hide: Iterable[str] = ()) -> Axes:
    """Cells and matrix at a time, as the page of the run shows them: the matrix as a smooth field, cells with rear and front,
    nuclei, protrusions in the colours of their phases, adhesions and their pull, fibres by their strain, paths, a scale bar.

    :param t: simulated time [s]; the frame nearest to it is drawn, the last one if left out
    :param field: of the matrix: "displacement", "velocity", "pressure", "von_mises", "f_degr" or "degradation" (the same: 0 fluid,
        1 intact), or one that the scenario gives, such as "youngs_modulus"; of vectors the length
    :param fluid: whether degraded matrix is coloured, too; it is left light if not
    :param window: what is seen: left, right, bottom, top [um]; a number is the width [um] of a square; "all" is the whole
        matrix. Left out, it is where the cells are in the course of the run, or the size that a followed cell needs
    :param follow: the number of the cell in the middle of the window, or True for the middle of all cells
    :param limits: of the colours; the same in all figures of a run if left out
    :param hide: what is not drawn, of "fibres", "cell", "nucleus", "protrusions", "adhesions", "path", "traction", "numbers",
        "scale bar" (there are axes in um instead), "legend", "colour bar"
    :raises KeyError: with the fields that there are, if there is no such field
    :raises ValueError: if there is no such window, cell or part
    """
    fields = arguments.one_of("run", run, Run).fields
    k = len(fields.times) - 1 if t is None else fields.nearest(t)
    particles = fields["matrix/f_degr"].shape[1]
    known = [name.removeprefix("matrix/") for name in fields if name.startswith("matrix/") and name != "matrix/reference"
             and (fields.has_frames(name) or fields[name].shape == (particles,))]
    if field not in (*known, "degradation"):
        raise KeyError(f"{field}; the fields of the matrix are {', '.join(known)}")
    outlines = fields.outlines(k)
    hidden = drawing.check_view(window, follow, hide, outlines)
    shown = fields[f"matrix/{field}"]
    field = shown.name.removeprefix("matrix/")
    axes = axes or _new_axes(figsize=(6.6, 5.6))
    seen = drawing.window_of(fields, k, window, follow)
    axes.set(xlim=seen[:2], ylim=seen[2:], title=_words.time_text(fields.times[k]))
    _plane(axes)
    low, high, beyond = drawing.limits_of(fields, field) if limits is None else (*limits, "neither")
    colours = drawing.matrix(axes, fields, field, k, seen, (low, high), fluid)
    strain = None if "fibres" in hidden else fibres.paint(axes, fields, run.scenario, k)
    unit = _draw_cells(axes, run, k, outlines, hidden)
    axes.set(xlim=seen[:2], ylim=seen[2:])
    if "colour bar" not in hidden:
        words = _fields.get(field, field.replace("_", " ")) + (f" ({_words.shown_unit(shown.units)})" if _words.shown_unit(shown.units) else "")
        axes.figure.colorbar(colours, ax=axes, label=_words.typeset(words), shrink=0.8, extend=beyond)
        if strain is not None:
            axes.figure.colorbar(strain, ax=axes, label="strain of fibres", shrink=0.8, extend="both")
    if "scale bar" not in hidden:
        axes.set(xticks=[], yticks=[], xlabel="", ylabel="")
        drawing.scale_bar(axes, unit, list(outlines.values()))
    if "legend" not in hidden:
        drawing.legend(axes, fields, hidden, len(outlines), k > 0)
    return axes


def _draw_cells(axes: Axes, run: Run, k: int, outlines: Mapping[int, Any], hidden: set[str]) -> float:
    """Cells and what belongs to them; returns the length of an arrow of 1 nN [um], 0 without arrows."""
    fields, many = run.fields, len(outlines)
    of_cell = fields["outline/cell"][k] if "outline/cell" in fields else np.ones(len(fields["outline/front"][k]))
    alive = fields.protrusions[fields.protrusions["frame"] == k]
    nuclei = {} if "nucleus" in hidden else fields.nuclei(k)
    for number, outline in outlines.items():
        own = of_cell == number
        if "cell" not in hidden:
            drawing.cell(axes, outline, fields["outline/front"][k][own], number, many)
        if number in nuclei:
            drawing.nucleus(axes, nuclei[number], number)
        if "protrusions" not in hidden:
            drawing.protrusions(axes, outline, fields["outline/protrusion"][k][own], fields["outline/phase"][k][own])
    unit = drawing.adhesions(axes, dict(outlines), alive, hidden)
    for number, outline in outlines.items():
        if "path" not in hidden:
            track = run.cells[number].tracks
            track = track[track["t_s"] <= fields.times[k] + 1e-6]
            drawing.path(axes, track["x_um"], track["y_um"], number, many)
        if many > 1 and not {"cell", "numbers"} & hidden:
            drawing.number_of(axes, outline, number)
    return 0.0 if "traction" in hidden else unit


def boxes(study: Study, readout: str = "v_migr_abs_um_per_h", axes: Axes | None = None) -> Axes:
    """A read-out of each run of a study as a dot, with a box for each point of five runs or more."""
    arguments.one_of("study", study, Study)
    axes = axes or _new_axes()
    done = study.results[study.results["status"] == "done"]
    if readout not in done.columns:
        known = [name for name in done.columns[list(done.columns).index("trajectory_hash") + 1:]]
        raise KeyError(f"{readout}; the read-outs are {', '.join(known)}")
    names, title = _points(study)
    samples = [done.loc[done["label"] == label, readout].dropna().to_numpy(float) for label in names]
    boxed = [k for k, sample in enumerate(samples, 1) if len(sample) >= _words.least_for_box]
    if boxed:
        axes.boxplot([samples[k - 1] for k in boxed], positions=boxed, widths=0.5, manage_ticks=False, showfliers=False,
                     medianprops={"color": _colours[0], "linewidth": 2})
    for k, sample in enumerate(samples, 1):
        axes.plot(k + _spread(len(sample)), sample, "o", color=_colours[0], alpha=0.5 if k in boxed else 0.8, markersize=4)
    axes.set_xticks(range(1, len(names) + 1), list(names.values()))
    axes.set(xlim=(0.5, len(names) + 0.5), xlabel=title, ylabel=_words.axis_title(readout, 40))
    whole = all(float(value).is_integer() for sample in samples for value in sample)
    if whole and not _words.unit(readout):
        axes.yaxis.get_major_locator().set_params(integer=True)
    if not any(len(sample) for sample in samples):
        axes.set(yticks=[])
        axes.text(0.5, 0.5, "no run has a value", transform=axes.transAxes, horizontalalignment="center")
    if max(map(len, names.values())) * len(names) > 60:
        for text in axes.get_xticklabels():
            text.set(rotation=30, horizontalalignment="right", rotation_mode="anchor")
    return axes


def _spread(n: int) -> Any:
    """Where dots of n runs are beside the middle of their point: few stay near it, so that none seems to have another value."""
    return 0.03 * (np.arange(n) - 0.5 * (n - 1)) * min(1.0, 8 / max(n, 1))


def quality(tracks: Tracks) -> Any:
    """Whether a tracker can be trusted, in three panels: steps, with leaps in red; pairs of tracks, with cells that were found twice in red
    (``Tracks.suspects``); drift of all cells. Returns the figure."""
    arguments.one_of("tracks", tracks, Tracks)
    figure, axes = _pyplot().subplots(1, 3, figsize=(11, 3.6), layout="constrained")
    drawing.track_quality(axes, tracks)
    return figure


def msd(results: Run | Study | Tracks, axes: Axes | None = None) -> Axes:
    """Mean square displacement [um^2] over lags [min], both logarithmic; of a run for each cell, of a study for each point,
    with its standard error. The dashed lines have the slopes of a random walk (1) and of a straight path (2). A run of
    less than 20 min has none, and the figure says so. Measured tracks have one curve together."""
    axes = axes or _new_axes()
    axes.set(xlabel="lag (min)", ylabel="mean square displacement (µm²)")
    if isinstance(results, Tracks):
        table = results.msd().dropna()
        axes.plot(table["lag_s"] / 60, table["msd_um2"], "o-", color=_words.blue, markersize=3)
        _slopes(axes, table)
        return axes
    table = arguments.one_of("results", results, Run, Study).msd
    if table["lag_s"].nunique() < 2:
        why = "no mean square displacement: its lags are 10 min\nto half a run, so a run of 20 min has the first" if not len(table) \
            else f"a single lag, {table['lag_s'].iloc[0] / 60:g} min: two are needed for a curve,\nof a run of 40 min"
        axes.text(0.5, 0.5, why, transform=axes.transAxes, horizontalalignment="center", verticalalignment="center")
        axes.set(xticks=[], yticks=[])
        return axes
    groups: list[tuple[Any, Any]] = [("", table)]
    if "cell" in table:
        groups = [(f"cell {number}", rows) for number, rows in table.groupby("cell")]
    elif not isinstance(results, Run):
        known = _points(results, with_name=True)[0]
        groups = [(known.get(name, _words.plain(name)), rows) for name, rows in table.groupby("point", sort=False)]
    for k, (name, rows) in enumerate(groups):
        colour, lag = _colours[k % len(_colours)], rows["lag_s"] / 60
        axes.plot(lag, rows["msd_um2"], "o-", color=colour, markersize=3, label=str(name) or None)
        if "sem_um2" in rows:
            low = (rows["msd_um2"] - rows["sem_um2"]).clip(lower=rows["msd_um2"] / 10)
            axes.fill_between(lag, low, rows["msd_um2"] + rows["sem_um2"], color=colour, alpha=0.15, linewidth=0)
    _slopes(axes, table)
    if len(groups) > 1 or not isinstance(results, Run):
        axes.legend(frameon=False)
    return axes


def _slopes(axes: Axes, table: pandas.DataFrame) -> None:
    """Logarithmic axes, with the slopes of a random walk and of a straight path from the first value on."""
    lags = np.array([table["lag_s"].min(), table["lag_s"].max()]) / 60
    start = float(table["msd_um2"].iloc[0]) or 1.0
    for slope in (1, 2):
        line = start * (lags / lags[0]) ** slope
        axes.plot(lags, line, "--", color="#999999", linewidth=1)
        axes.annotate(f"slope {slope}", (lags[1], line[1]), (3, 0), textcoords="offset points", va="center", fontsize=8, color="#666666")
    axes.set(xscale="log", yscale="log")
    _words.plain_decades(axes.xaxis, *axes.get_xlim())
    _words.plain_decades(axes.yaxis, *axes.get_ylim())


def _pyplot() -> Any:
    return library("matplotlib.pyplot", "figures need matplotlib")


def _new_axes(**options: Any) -> Any:
    from matplotlib import rc_context

    pyplot = _pyplot()
    with rc_context(_words.style):
        return pyplot.subplots(layout="constrained", **options)[1]


def _points(study: Study, with_name: bool = False) -> tuple[dict[str, str], str]:
    """What matplotlib calls each point of a study by its label, and the title of an axis of them: of a single parameter the values alone.

    :param with_name: whether values have the name of their parameter beside them
    """
    points, parameters = study.points, study.parameters
    labels = list(points["label"])
    own = all(_words.parameter_of(name) and _is_named_by(label, name) for label in labels for name in parameters)
    if not parameters or not own:
        return {label: _words.plain(label) for label in labels}, ""
    rows = points[parameters].to_dict("records")
    if len(parameters) == 1 and not with_name:
        return {label: _words.plain(_words.number(row[parameters[0]])) for label, row in zip(labels, rows, strict=True)}, _words.axis_title(parameters[0])
    return {label: ", ".join(_words.setting(name, value) for name, value in row.items()) for label, row in zip(labels, rows, strict=True)}, ""


def _is_named_by(label: str, column: str) -> bool:
    """Whether a label was made of the name of a parameter, not given by the author of the study."""
    parameter = _words.parameter_of(column)
    return parameter is not None and any(re.search(rf"(^|[ .]){re.escape(name)} ", label) for name in (parameter.key, parameter.symbol) if name)


def _shape(tracks: list[Any]) -> tuple[float, float]:
    """Size of a figure that has the shape of what it shows [inch], so that distant cells use all of it."""
    x, y = (np.concatenate([track[name].to_numpy(float) for track in tracks]) for name in ("x_um", "y_um"))
    share = float(np.clip((np.ptp(y) + 1e-9) / (np.ptp(x) + 1e-9), 0.45, 1.2))
    return 6.4, 0.9 + 5.2 * share


def _plane(axes: Axes) -> None:
    axes.set(xlabel="x (µm)", ylabel="y (µm)")
    axes.set_aspect("equal", "datalim" if axes.get_autoscale_on() else "box")
