"""What figures of cells and matrix, and of measured tracks, are drawn of. The page of a run has the same colours and signs in the same order."""
from __future__ import annotations

from collections.abc import Collection, Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base.arguments import is_number
from ..results import raster
from ..results.fields import Fields
from ..scenario import schema
from . import words

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from ..tracks import Tracks

Array = np.ndarray[Any, Any]
Window = tuple[float, float, float, float]  # left, right, bottom, top [um]

overlays = ("fibres", "cell", "nucleus", "protrusions", "adhesions", "path", "traction", "numbers", "scale bar", "legend",
            "colour bar")

_colours = schema.table("colours.json")  # as on the pages
_single, _several, _nucleus, _ink, _obstacle, _traction = (_colours[name] for name in ("cell", "cells", "nucleus", "ink", "obstacle", "traction"))
_gel, _ground = _colours["gel"], _colours["gel"][0]
_phases = tuple(zip(("growing", "maturing", "contracting", "finishing"), _colours["phases"], strict=True))
_quantile = 0.999  # of the values of a layer within its limits


def colours_of(number: int, cells: int) -> tuple[str, str]:
    """Of the rear and of the front of a cell. :param number: of the cell, from 1"""
    rear, front = _single if cells < 2 else _several[(number - 1) % len(_several)]
    return rear, front


def colour_map(field: str) -> Any:
    from matplotlib.colors import LinearSegmentedColormap

    colours = {"pressure": _colours["blue_white_orange"], "f_degr": _gel}.get(field)
    return "viridis" if colours is None else LinearSegmentedColormap.from_list(field, colours)


def some_frames(fields: Fields) -> list[int]:
    """Four frames over the run, from which limits follow, so that all figures of a run share them."""
    return sorted({round(share * (len(fields.times) - 1)) for share in (0.25, 0.5, 0.75, 1.0)})


def limits_of(fields: Fields, field: str) -> tuple[float, float, str]:
    """Limits of the colours of a field, and where values may lie beyond: "neither", "max" or "both"."""
    if field == "f_degr":
        return 0.0, 1.0, "neither"
    values = np.concatenate([values_of(fields, field, k)[fields["matrix/solid"][k] == 1] for k in some_frames(fields)])
    if not len(values):
        return 0.0, 1.0, "neither"
    if field in ("displacement", "velocity", "von_mises", "fibre_von_mises", "pressure"):
        usual = float(f"{np.quantile(np.abs(values), _quantile):.2g}") or 1.0
        low, beyond = (-usual, "both") if field == "pressure" else (0.0, "max")
        return low, usual, "neither" if np.abs(values).max() <= usual else beyond
    low, high = float(values.min()), float(values.max())
    return low, high if high > low else low + 1.0, "neither"


def values_of(fields: Fields, field: str, k: int) -> Array:
    """A value of each particle of the matrix; of vectors the length. Those that the scenario gives are the same in all frames."""
    name = f"matrix/{field}"
    values: Array = (fields[name][k] if fields.has_frames(name) else fields[name][...]).astype(float)
    return np.linalg.norm(values, axis=1) if values.ndim == 2 else values


def check_view(window: Any, follow: Any, hide: Iterable[str], cells: Collection[int] = ()) -> set[str]:
    """What is hidden, once it and the view can be.  :raises ValueError: if not"""
    hidden = {hide} if isinstance(hide, str) else set(hide)
    if wrong := sorted(hidden - set(overlays)):
        raise ValueError(f"hide: there is no {wrong[0]}; there are {', '.join(overlays)}")
    if isinstance(window, (tuple, list)):
        if len(window) != 4 or not all(map(is_number, window)) or window[0] >= window[1] or window[2] >= window[3]:
            raise ValueError(f"window: {tuple(window)} is no left, right, bottom, top [um]")
        if follow is not None and follow is not False:
            raise ValueError("window: where a cell is followed, it is the width of the window [um]")
    elif not (window is None or window == "all" or is_number(window) and window > 0):
        raise ValueError(f'window: {window!r} is neither a width [um], nor left, right, bottom, top [um], nor "all"')
    if follow is not None and not isinstance(follow, bool) and follow not in cells:
        raise ValueError(f"follow: there is no cell {follow}; the cells are {', '.join(map(str, cells))}")
    return hidden


def window_of(fields: Fields, k: int, window: Any, follow: int | bool | None) -> Window:
    """The part of the plane that is seen."""
    reach = float(fields["matrix/radius"][0]) + 0.5 * float(fields["matrix/spacing"][0])
    if window == "all":
        return -reach, reach, -reach, reach
    if isinstance(window, (tuple, list)):
        left, right, bottom, top = map(float, window)
        return left, right, bottom, top
    many = range(len(fields.times))
    if follow is None or follow is False:
        seen = np.concatenate([outline for i in many for outline in fields.outlines(i).values()]
                              + [fields.anchors[["position_x", "position_y"]].to_numpy(float)])
        low, high = seen.min(axis=0), seen.max(axis=0)
        middle, side = 0.5 * (low + high), 1.2 * float((high - low).max())
        side = min(side, 2 * reach)
        if window is None:  # no view beyond the rim
            middle = np.clip(middle, -reach + side / 2, reach - side / 2)
    else:
        middle, _ = _place(fields, k, follow)
        side = 1.35 * max(_place(fields, i, follow)[1] for i in many)
    side = side if window is None else float(window)
    return middle[0] - side / 2, middle[0] + side / 2, middle[1] - side / 2, middle[1] + side / 2


def _place(fields: Fields, k: int, follow: int | bool) -> tuple[Array, float]:
    """Middle [um] and extent [um] of a cell, or of all of them."""
    outlines = fields.outlines(k)
    seen = np.concatenate(list(outlines.values())) if follow is True else outlines[int(follow)]
    return seen.mean(axis=0), float(np.ptp(seen, axis=0).max())


def matrix(axes: Axes, fields: Fields, field: str, k: int, window: Window, limits: tuple[float, float], fluid: bool) -> Any:
    """The matrix as a smooth field, and obstacles; returns what a colour bar is made of."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import Normalize, to_rgb

    place, spacing = fields["matrix/position"][k][:, :2].astype(float), float(fields["matrix/spacing"][0])
    solid, values = fields["matrix/solid"][k].astype(float), values_of(fields, field, k)
    if fluid or field == "f_degr":
        solid = np.ones_like(solid)
    shown = ScalarMappable(Normalize(*limits), colour_map(field))
    grid = raster.Grid.over(window, (window[1] - window[0]) / 400)
    every, kept, sums = raster.smoothed(grid, place, [np.ones_like(solid), solid, solid * values], 2.0 * spacing)
    with np.errstate(invalid="ignore", divide="ignore"):
        share, mean = np.nan_to_num(kept / every), np.nan_to_num(sums / kept)
    x, y = grid.centres()
    radius = np.hypot(x[None, :], y[:, None])
    rim = float(fields["matrix/radius"][0]) + 0.5 * spacing
    within = np.clip((rim - radius) / grid.pixel + 0.5, 0.0, 1.0)[..., None]
    strength = np.clip((share - 0.5) / 0.1 + 0.5, 0.0, 1.0)[..., None]
    picture = strength * shown.to_rgba(mean)[..., :3] + (1 - strength) * np.array(to_rgb(_ground))
    axes.imshow(within * picture + (1 - within), extent=grid.extent, interpolation="bilinear", zorder=0)
    if "matrix/obstacle" in fields:
        corners = 0.54 * spacing * np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        places = fields["matrix/reference"][:, :2][values_of(fields, "obstacle", k) == 1]
        axes.add_collection(PolyCollection(places[:, None, :] + corners, facecolor=_obstacle, linewidth=0, zorder=1))
    return shown


def cell(axes: Axes, outline: Array, front: Array, number: int, cells: int) -> None:
    """The area of a cell: its rear, and its front over it."""
    from matplotlib.patches import Polygon

    rear_colour, front_colour = colours_of(number, cells)
    body = axes.add_patch(Polygon(outline, closed=True, facecolor=rear_colour, edgecolor="none", zorder=3, gid=f"cell {number}"))
    for arc in arcs(front > 0.5):
        area = axes.add_patch(Polygon(outline[arc], closed=True, facecolor=front_colour, edgecolor="none", zorder=3.1))
        area.set_clip_path(body)
    axes.add_patch(Polygon(outline, closed=True, facecolor="none", edgecolor="white", linewidth=0.8, zorder=3.2))


def nucleus(axes: Axes, outline: Array, number: int) -> None:
    from matplotlib.patches import Polygon

    axes.add_patch(Polygon(outline, closed=True, facecolor=_nucleus, edgecolor="none", zorder=3.4, gid=f"nucleus {number}"))


def arcs(has: Array) -> list[Array]:
    """Stretches of a ring that fulfil a condition, each as indices in order."""
    n = len(has)
    if has.all():
        return [np.arange(n)]
    start = int(np.argmin(has))
    turned = np.roll(has, -start).astype(int)  # begins with one that does not
    edges = np.diff(np.concatenate([turned, [0]]))
    return [(np.arange(a + 1, b + 1) + start) % n for a, b in zip(np.flatnonzero(edges > 0), np.flatnonzero(edges < 0), strict=True)]


def protrusions(axes: Axes, outline: Array, owner: Array, phase: Array) -> None:
    """The arcs of the cortex that protrusions hold, in the colours of their phases."""
    for one in np.unique(owner[owner != 255]):
        for arc in arcs(owner == one):
            kind = int(phase[arc[0]])
            axes.plot(*outline[arc].T, color=_phases[kind][1], linewidth=2.2, linestyle=(0, (2, 1.4)) if kind == 3 else "-",
                      dash_capstyle="butt", path_effects=_edged(3.6), zorder=4)


def adhesions(axes: Axes, outlines: dict[int, Array], alive: Any, hidden: set[str]) -> float:
    """Adhesions as dots, larger when mature, and their pull as arrows; returns the length of an arrow of 1 nN [um]."""
    adhered = alive[np.isfinite(alive["anchor_x"])]
    span = np.ptp(axes.get_xlim())
    strongest = float(adhered["force"].max()) if len(adhered) else 0.0
    unit = 0.1 * span / strongest if strongest > 0 else 0.0
    for row in adhered.to_dict("records"):
        tip = outlines[int(row.get("cell", 1))][int(row["centre"])]
        anchor, colour = np.array([row["anchor_x"], row["anchor_y"]]), _phases[int(row["phase"])][1]
        way = tip - anchor
        length = float(np.hypot(*way))
        if "adhesions" not in hidden:
            axes.plot(*np.transpose([tip, anchor]), color=colour, linewidth=1.2, path_effects=_edged(2.6), zorder=4.5)
            axes.plot(*anchor, "o", color=colour, markeredgecolor="white", markeredgewidth=0.9, gid="adhesion",
                      markersize=3.5 + 4.0 * row["f_mat"], zorder=4.6)
        if "traction" not in hidden and length > 0 and row["force"] > 0:
            end = anchor + way * (unit * row["force"] / length)
            _arrow(axes, anchor, end, 5)
    return unit


def path(axes: Axes, x: Array, y: Array, number: int, cells: int) -> None:
    """The way of a cell so far, from its ring."""
    colour = _ink if cells < 2 else colours_of(number, cells)[0]
    axes.plot(x, y, color=colour, linewidth=1.2, path_effects=_edged(2.6), zorder=5.5)
    axes.plot(x[:1], y[:1], "o", color=colour, markerfacecolor="white", markersize=5, zorder=5.6)


def path_in_time(axes: Axes, x: Array, y: Array, t: Array) -> Any:
    """A path in the colours of time; returns what a colour bar is made of."""
    from matplotlib.collections import LineCollection

    points = np.column_stack([x, y])
    lines = LineCollection(list(np.stack([points[:-1], points[1:]], axis=1)), array=0.5 * (t[1:] + t[:-1]), cmap="viridis",
                           linewidth=2.4, capstyle="round", zorder=3)
    lines.set_clim(float(t[0]), float(t[-1]))
    axes.add_collection(lines)
    return lines


def number_of(axes: Axes, outline: Array, number: int) -> None:
    axes.annotate(str(number), outline.mean(axis=0), ha="center", va="center", fontsize=9, fontweight="bold", color=_ink,
                  zorder=6, bbox={"boxstyle": "circle,pad=0.25", "facecolor": "white", "alpha": 0.85, "linewidth": 0})


def scale_bar(axes: Axes, unit: float, outlines: list[Array]) -> None:
    """In a corner that no cell is in a length, in another one an arrow of a round force.

    :param unit: length of an arrow of 1 nN [um]; 0 for none
    :param outlines: of the cells [um]
    """
    from matplotlib.font_manager import FontProperties
    from mpl_toolkits.axes_grid1.anchored_artists import AnchoredSizeBar

    left, right = axes.get_xlim()
    bottom, top = axes.get_ylim()
    width, height = right - left, top - bottom
    first, second = free_corners(((left, right), (bottom, top)), outlines)
    length = _round(0.25 * width)
    bar = AnchoredSizeBar(axes.transData, length, f"{length:g} µm", first, pad=0.35, borderpad=0.6, sep=4, color=_ink,
                          size_vertical=0.009 * height, label_top=True, fontproperties=FontProperties(size=9, weight="bold"))
    bar.patch.set(facecolor="white", alpha=0.85, linewidth=0)
    bar.set(zorder=7, gid="scale bar")
    axes.add_artist(bar)
    if unit > 0:
        force = _round(0.12 * width / unit)
        y = bottom + 0.05 * height if second.startswith("lower") else top - 0.05 * height
        end = right - 0.04 * width if second.endswith("right") else left + 0.2 * width + unit * force
        _arrow(axes, (end - unit * force, y), (end, y), 7.2)
        axes.annotate(f"{force:g} nN", (end - unit * force, y), (-5, 0), textcoords="offset points", ha="right", va="center",
                      fontsize=9, color=_ink, zorder=7.1,
                      bbox={"boxstyle": "round,pad=0.3", "facecolor": "white", "alpha": 0.85, "linewidth": 0})


def free_corners(seen: tuple[tuple[float, float], tuple[float, float]], outlines: list[Array]) -> list[str]:
    """The two corners of a view with the least of the cells in them; of equal ones the lower ones first."""
    corners = {"lower left": (0, 0), "lower right": (1, 0), "upper left": (0, 1), "upper right": (1, 1)}
    points = np.concatenate([np.asarray(outline, float) for outline in outlines]) if outlines else np.zeros((0, 2))
    shares = np.column_stack([(points[:, k] - low) / (high - low) for k, (low, high) in enumerate(seen)])
    inside = {name: int(np.sum((np.abs(shares[:, 0] - x) < 0.36) & (np.abs(shares[:, 1] - y) < 0.14))) for name, (x, y) in corners.items()}
    return sorted(corners, key=lambda name: inside[name])[:2]


def legend(axes: Axes, fields: Fields, hidden: set[str], cells: int, has_path: bool) -> None:
    """The signs of the figure, below it."""
    from matplotlib.lines import Line2D
    from matplotlib.patches import Patch

    entries: list[tuple[Any, str]] = []
    if "cell" not in hidden and cells < 2:
        entries += [(Patch(color=_single[1]), "front"), (Patch(color=_single[0]), "rear")]
    elif "cell" not in hidden:
        entries += [((Patch(color=rear), Patch(color=front)), f"cell {number}" + (": rear, front" if number == 1 else ""))
                    for number in range(1, min(cells, 4) + 1) for rear, front in [colours_of(number, cells)]]
    if "nucleus" not in hidden and "nucleus/position" in fields:
        entries.append((Patch(color=_nucleus), "nucleus"))
    if "protrusions" not in hidden:
        entries += [(Line2D([], [], color=colour, linewidth=2.2, linestyle="--" if name == "finishing" else "-"), name)
                    for name, colour in _phases]
    if "adhesions" not in hidden:
        entries.append((Line2D([], [], color=_phases[2][1], linewidth=1.2, marker="o", markersize=6), "adhesion"))
    if "path" not in hidden and has_path:
        entries.append((Line2D([], [], color=_ink, linewidth=1.2, marker="o", markerfacecolor="white", markersize=4.5), "path"))
    if not entries:
        return
    from matplotlib.legend_handler import HandlerTuple

    axes.legend(*zip(*entries, strict=True), loc="upper left", bbox_to_anchor=(0.0, -0.01), ncol=4, frameon=False, fontsize=8.5,
                borderaxespad=0.3, columnspacing=1.3, handlelength=1.8, handler_map={tuple: HandlerTuple(ndivide=None, pad=0)})


def track_paths(axes: Axes, tracks: Tracks, together: bool) -> None:
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


def track_quality(axes: Any, tracks: Tracks) -> None:
    """Three panels: steps with those that are too long; distance of each pair of tracks that are there together over how alike they walk;
    drift."""
    suspects = tracks.suspects()
    steps, pairs, drift = axes
    lengths = np.concatenate([np.hypot(*(track[1:] - track[:-1]).T) for track in tracks.values()])
    lengths = lengths[np.isfinite(lengths)]
    steps.hist(lengths, bins=40, color=words.grey)
    leaps = suspects[suspects["kind"] == "leap"]
    for _, row in leaps.iterrows():
        steps.axvline(row["value"], color=words.red, linewidth=1)
    steps.set(xlabel="step between positions (µm)", ylabel="steps", title=f"leaps: {len(leaps)}")
    of_pairs = tracks.pairs()
    double = set(zip(suspects.loc[suspects["kind"] == "double", "track"], suspects.loc[suspects["kind"] == "double", "other"]))
    colours = [words.red if (row.track, row.other) in double else words.grey for row in of_pairs.itertuples()]
    pairs.scatter(of_pairs["distance_um"], of_pairs["correlation"], s=9, c=colours)
    pairs.set(xlabel="mean distance of two tracks (µm)", ylabel="correlation of their steps", ylim=(-1.05, 1.05), title=f"doubles: {len(double)}")
    way = tracks.drift()
    drift.plot(way[:, 0], way[:, 1], color=words.blue)
    drift.plot(0, 0, "o", color=words.blue, markerfacecolor="white")
    drift.set(xlabel="x (µm)", ylabel="y (µm)", title="drift: sum of mean steps", aspect="equal", adjustable="datalim")


def _arrow(axes: Axes, start: Any, end: Any, zorder: float) -> None:
    from matplotlib.patches import FancyArrowPatch

    axes.add_patch(FancyArrowPatch(start, end, arrowstyle="-|>,head_length=0.5,head_width=0.22", mutation_scale=10, shrinkA=0,
                                   shrinkB=0, color=_traction, linewidth=1.6, path_effects=_edged(3.0), zorder=zorder))


def _edged(width: float) -> list[Any]:
    from matplotlib import patheffects

    return [patheffects.Stroke(linewidth=width, foreground="white"), patheffects.Normal()]


def _round(most: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is not above."""
    power: float = 10.0 ** np.floor(np.log10(most))
    return float(max(step * power for step in (1.0, 2.0, 5.0) if step * power <= most * (1 + 1e-9)))
