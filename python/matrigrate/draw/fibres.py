"""The fibres of the matrix as lines: bonds of the lattice, coloured by their strain."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from ..results.fields import Fields

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Array = np.ndarray[Any, Any]

_most_lines = 9000  # in a figure


def bonds_of(fields: Fields, scenario: dict[str, Any]) -> Array:
    """Vectors of the fibres at rest [um], each once, without those that lie along a shorter one. None where a field gives
    their direction: then each particle has its own."""
    fibres = scenario["fibres"]
    if fibres["arrangement"] == "none" or fibres.get("field", {}).get("direction_deg"):
        return np.zeros((0, 2))
    reference = fields["matrix/reference"][:, :2].astype(float)
    inner = reference[np.argmin(np.hypot(*reference.T))]
    bonds = reference - inner
    length = np.hypot(*bonds.T)
    reach = 2.0 * float(scenario["ecm"]["smoothing_length"].split()[0])
    up = (bonds[:, 1] > 1e-3) | ((np.abs(bonds[:, 1]) <= 1e-3) & (bonds[:, 0] > 0))
    kept = (length > 0) & (length < reach) & up
    if fibres["arrangement"] == "uniaxial":
        off = np.degrees(np.arctan2(bonds[:, 1], bonds[:, 0])) - float(fibres["direction_deg"])
        off = np.abs((off + 90.0) % 180.0 - 90.0)
        kept &= off <= float(fibres["half_angle_deg"]) + 1e-3
    bonds = bonds[kept][np.argsort(length[kept], kind="stable")]
    distinct: list[Array] = []
    for bond in bonds:
        if all(abs(bond[0] * b[1] - bond[1] * b[0]) > 1e-3 * np.hypot(*bond) * np.hypot(*b) for b in distinct):
            distinct.append(bond)
    return np.array(distinct).reshape(-1, 2)


def pairs_of(reference: Array, bonds: Array) -> Array:
    """The particles at both ends of each fibre, shape (fibres, 2)."""
    if not len(bonds):
        return np.zeros((0, 2), dtype=int)
    side = 0.5 * float(np.hypot(*bonds.T).min())  # of cells of a grid that hold one particle at most
    column, row = (np.floor((reference - reference.min(axis=0)) / side).astype(int) + 1).T
    grid = np.full((row.max() + 2, column.max() + 2), -1)
    grid[row, column] = np.arange(len(reference))
    found = []
    for bond in bonds:
        place = np.floor((reference + bond - reference.min(axis=0)) / side).astype(int) + 1
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                c, r = place[:, 0] + i, place[:, 1] + j
                there = (c >= 0) & (c < grid.shape[1]) & (r >= 0) & (r < grid.shape[0])
                other = np.where(there, grid[r.clip(0, grid.shape[0] - 1), c.clip(0, grid.shape[1] - 1)], -1)
                near = (other >= 0) & (np.hypot(*(reference[other] - reference - bond).T) < 0.2 * side)
                found.append(np.column_stack([np.flatnonzero(near), other[near]]))
    return np.concatenate(found)


def paint(axes: Axes, fields: Fields, scenario: dict[str, Any], k: int) -> Any:
    """Draws the fibres; returns what a colour bar of their strain is made of, or None without fibres."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.collections import LineCollection
    from matplotlib.colors import Normalize

    from .drawing import colour_map, some_frames

    reference = fields["matrix/reference"][:, :2].astype(float)
    pairs = pairs_of(reference, bonds_of(fields, scenario))
    if not len(pairs):
        return None
    rest = np.hypot(*(reference[pairs[:, 0]] - reference[pairs[:, 1]]).T)

    def strain(frame: int) -> Array:
        place, solid = fields["matrix/position"][frame][:, :2].astype(float), fields["matrix/solid"][frame] == 1
        length = np.hypot(*(place[pairs[:, 0]] - place[pairs[:, 1]]).T)
        return np.where(solid[pairs].all(axis=1), length / rest - 1.0, np.nan)

    sizes = np.concatenate([np.abs(strain(frame)) for frame in some_frames(fields)])
    most = float(f"{np.nanquantile(sizes, 0.995):.2g}") if np.isfinite(sizes).any() else 0.0
    shown = ScalarMappable(Normalize(-(most or 0.1), most or 0.1), colour_map("pressure"))
    lines = fields["matrix/position"][k][:, :2].astype(float)[pairs]
    (left, right), (bottom, top) = axes.get_xlim(), axes.get_ylim()
    x, y = lines.mean(axis=1).T
    strains = strain(k)
    seen = (x > left) & (x < right) & (y > bottom) & (y < top) & np.isfinite(strains)
    spacing = float(fields["matrix/spacing"][0])
    rows = max(1, int(np.ceil(max((right - left) / 24, 1.0) / spacing)), int(np.ceil(np.sqrt(seen.sum() / _most_lines))))
    if rows > 1:  # lines of every second row and so on
        steps = np.diff(np.unique(np.round(reference[:, 1], 2)))
        row = np.rint((reference[:, 1] - reference[:, 1].min()) / steps[steps > 0.1].min()).astype(int)
        seen &= (row[pairs] % rows == 0).any(axis=1)
    lines, strains = lines[seen], strains[seen]
    colours = shown.to_rgba(strains)
    strength = np.clip(np.abs(strains) / shown.norm.vmax, 0.0, 1.0)
    colours[:, 3] = 0.35 + 0.65 * strength
    order = np.argsort(strength, kind="stable")  # what is strained is drawn last
    axes.add_collection(LineCollection(list(lines[order]), colors=colours[order], linewidths=0.8 + 0.8 * strength[order],
                                       zorder=2), autolim=False)
    return shown
