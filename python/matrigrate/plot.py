"""Figures of runs and studies with matplotlib. Each function draws into ``axes`` or a new figure, and returns the axes.

    axes = matrigrate.plot.path(run)
    axes.figure.savefig("path.png")
"""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arguments
from ._files import unit_of
from .results import Run, meaning
from .studies import Study

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_colours = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000")  # told apart by all eyes
_words = {"f_degr": "intact share", "von_mises": "von Mises stress", "fibre_von_mises": "von Mises stress of fibres"}


def path(run: Run | Mapping[str, Run], axes: Axes | None = None) -> Axes:
    """The path of the centre of mass [um] of each cell, from its ring to its dot; of several runs by their names."""
    runs = {"": _arguments.one_of("run", run, Run)} if not isinstance(run, Mapping) else dict(run)
    axes = axes or _new_axes()
    paths = [(name, number, track) for name, one in runs.items() for number, track in one.tracks.groupby("track")]
    lines = list(runs) if len(runs) > 1 else [number for _, number, _ in paths]  # each has a colour and its name
    named = set()
    for name, number, track in paths:
        line = name if len(runs) > 1 else number
        label = None if line in named else name if len(runs) > 1 else f"cell {number}"
        named.add(line)
        x, y, colour = track["x_um"], track["y_um"], _colours[lines.index(line) % len(_colours)]
        axes.plot(x, y, color=colour, linewidth=1.2, label=label)
        axes.plot(x.iloc[:1], y.iloc[:1], "o", color=colour, markerfacecolor="white")
        axes.plot(x.iloc[-1:], y.iloc[-1:], "o", color=colour)
    _plane(axes)
    if 1 < len(lines) <= len(_colours):
        axes.legend(frameon=False, loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return axes


def frame(run: Run, t: float | None = None, field: str = "displacement", axes: Axes | None = None, *,
          fluid: bool = False) -> Axes:
    """Cells and matrix at a time: particles of the matrix coloured by a field, the outlines, nuclei, adhesions as dots.

    :param t: simulated time [s]; the frame nearest to it is drawn, the last one if left out
    :param field: of the matrix: "displacement", "velocity", "pressure", "von_mises", "degradation" or "f_degr" (the same); of
        vectors the length
    :param fluid: whether degraded matrix is coloured, too; it is left white if not
    :raises KeyError: with the fields that there are, if there is no such field
    """
    from matplotlib.collections import EllipseCollection

    fields = _arguments.one_of("run", run, Run).fields
    axes = axes or _new_axes()
    k = len(fields.times) - 1 if t is None else fields.nearest(t)
    known = [name.removeprefix("matrix/") for name in fields if name.startswith("matrix/") and fields.has_frames(name)]
    if field not in (*known, "degradation"):
        raise KeyError(f"{field}; the fields of the matrix are {', '.join(known)}")
    shown = fields[f"matrix/{field}"]
    field = shown.name.removeprefix("matrix/")
    values, place = shown[k].astype(float), fields["matrix/position"][k][:, :2]
    values = np.linalg.norm(values, axis=1) if values.ndim == 2 else values
    kept = np.full(len(values), True) if fluid else fields["matrix/solid"][k] == 1
    size = np.full(int(kept.sum()), float(fields["matrix/spacing"][0]))
    particles = EllipseCollection(size, size, np.zeros_like(size), units="xy", offsets=place[kept],
                                  offset_transform=axes.transData, array=values[kept], cmap=_map(field), linewidth=0)
    if field == "pressure" and kept.any():  # zero in the middle
        largest = float(np.abs(values[kept]).max()) or 1.0
        particles.set_clim(-largest, largest)
    axes.add_collection(particles)
    outline = fields["outline/position"][k][:, :2]
    cell = fields["outline/cell"][k] if "outline/cell" in fields else np.ones(len(outline))
    for number in np.unique(cell):
        axes.fill(*outline[cell == number].T, facecolor="#f4efe6", edgecolor="black", linewidth=1.5, zorder=3)
    if "nucleus/position" in fields:
        for nucleus in np.split(fields["nucleus/position"][k][:, :2], len(np.unique(cell))):  # all have as many particles
            axes.fill(*nucleus.T, facecolor="#c9c2d9", edgecolor="#5b4b8a", linewidth=1, zorder=3.5)
    adhered = fields.anchors[fields.anchors["frame"] == k]
    if len(adhered):
        axes.plot(adhered["position_x"], adhered["position_y"], "o", color="#d55e00", markeredgecolor="white",
                  markersize=6, zorder=4)
    unit = "" if shown.units == "1" else f" [{_shown_unit(shown.units)}]"
    axes.figure.colorbar(particles, ax=axes, label=_words.get(field, field) + unit, shrink=0.8)
    axes.set_title(f"{fields.times[k] / 60:g} min")
    _plane(axes)
    reach = float(np.abs(place).max()) + size[0] / 2 if len(size) else 1.0
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach))
    return axes


def boxes(study: Study, readout: str = "v_migr_abs_um_per_h", axes: Axes | None = None) -> Axes:
    """Box plots of a read-out, a box for each point of a study, with a dot for each run."""
    _arguments.one_of("study", study, Study)
    axes = axes or _new_axes()
    done = study.results[study.results["status"] == "done"]
    if readout not in done.columns:
        known = [name for name in done.columns[list(done.columns).index("trajectory_hash") + 1:]]
        raise KeyError(f"{readout}; the read-outs are {', '.join(known)}")
    labels = list(study.points["label"])
    samples = [done.loc[done["label"] == label, readout].dropna().to_numpy(float) for label in labels]
    axes.boxplot(samples, labels=labels, showfliers=False, medianprops={"color": _colours[0], "linewidth": 2})
    for k, sample in enumerate(samples, 1):
        spread = np.linspace(-0.12, 0.12, len(sample)) if len(sample) > 1 else np.zeros(len(sample))
        axes.plot(k + spread, sample, "o", color=_colours[0], alpha=0.5, markersize=4)
    unit = unit_of(readout)
    axes.set_ylabel(_wrapped(meaning(readout)) + ("" if unit == "1" else f" [{_shown_unit(unit)}]"))
    if len(labels) > 3:
        for text in axes.get_xticklabels():
            text.set(rotation=30, horizontalalignment="right", rotation_mode="anchor")
    return axes


def msd(results: Run | Study, axes: Axes | None = None) -> Axes:
    """Mean square displacement [um^2] over lags [min], both logarithmic; of a run for each cell, of a study for each point,
    with its standard error. The dashed lines have the slopes of a random walk (1) and of a straight path (2). A run of
    less than 20 min has none, and the figure says so."""
    table = _arguments.one_of("results", results, Run, Study).msd
    axes = axes or _new_axes()
    axes.set(xlabel="lag [min]", ylabel="mean square displacement [µm²]")
    if not len(table):
        axes.text(0.5, 0.5, "no mean square displacement: its lags are 10 min\nto half a run, so a run of 20 min has the first",
                  transform=axes.transAxes, horizontalalignment="center", verticalalignment="center")
        axes.set(xticks=[], yticks=[])
        return axes
    groups: list[tuple[Any, Any]] = [("", table)]
    if "cell" in table:
        groups = [(f"cell {number}", rows) for number, rows in table.groupby("cell")]
    elif not isinstance(results, Run):
        groups = list(table.groupby("point", sort=False))
    for k, (name, rows) in enumerate(groups):
        colour, lag = _colours[k % len(_colours)], rows["lag_s"] / 60
        axes.plot(lag, rows["msd_um2"], "o-", color=colour, markersize=3, label=str(name) or None)
        if "sem_um2" in rows:
            low = (rows["msd_um2"] - rows["sem_um2"]).clip(lower=rows["msd_um2"] / 10)
            axes.fill_between(lag, low, rows["msd_um2"] + rows["sem_um2"], color=colour, alpha=0.15, linewidth=0)
    lags = np.array([table["lag_s"].min(), table["lag_s"].max()]) / 60
    start = float(table["msd_um2"].iloc[0]) or 1.0
    for slope in (1, 2):
        axes.plot(lags, start * (lags / lags[0]) ** slope, "--", color="#999999", linewidth=1)
    axes.set(xscale="log", yscale="log")
    if len(groups) > 1 or not isinstance(results, Run):
        axes.legend(frameon=False)
    return axes


def _new_axes() -> Any:
    try:
        from matplotlib import pyplot
    except ImportError:
        raise ImportError("figures need matplotlib: apt install python3-matplotlib, "
                          "or pip install matplotlib") from None
    return pyplot.subplots(layout="constrained")[1]


def _plane(axes: Axes) -> None:
    axes.set(xlabel="x [µm]", ylabel="y [µm]", aspect="equal")


def _map(field: str) -> str:
    return {"pressure": "RdBu_r", "f_degr": "cividis"}.get(field, "viridis")


def _shown_unit(unit: str) -> str:
    return unit.replace("um", "µm").replace("^2", "²")


def _wrapped(text: str, width: int = 40) -> str:
    words = text.split(", ")
    return ",\n".join(words) if len(text) > width else text
