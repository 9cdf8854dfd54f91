"""Groups of measured cells, control and treated ones, as ``compare`` takes them: what is refused, and what is left out
to predict it."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from .. import tracks as _tracks
from ..base import arguments
from ..errors import ConfigurationError, refuse
from .conditions import by_condition
from .emulator import Array
from .measurement import Measurement, asked_for, means_of_tracks, measurement
from .posterior import each

_spare = 2  # cells above the number of read-outs


@dataclass(frozen=True)
class Group:
    """What was measured of one group of cells."""

    name: str
    source: str  #: how many tracks, and their file; empty of numbers
    interval: float | None  #: of tracks [s]
    wanted: Measurement
    cells: Array  #: read-outs of each cell, a row a cell; NaN of numbers that no cell has
    others: Array  #: read-outs of the group without this cell

    def only(self, names: Sequence[str]) -> Group:
        """Of some of the read-outs."""
        at = [list(self.wanted.table.index).index(name) for name in names]
        return replace(self, wanted=self.wanted.only(names), cells=self.cells[:, at], others=self.others[:, at])


@dataclass(frozen=True)
class LeftOut:
    """Cases in each of which a part of the numbers of a pair of groups is left out, and predicted from the others."""

    kept: Array  #: which numbers
    values: Array  #: of these, a row a case
    covariance: Array
    cells: int  #: that it was estimated from; or 0
    seen: Array  #: which numbers are predicted
    left: Array  #: what was measured of these, a row a case
    scatter: Array  #: its covariance


class Pair:
    """Control and one treated group: their numbers side by side."""

    def __init__(self, control: Group, treated: Group) -> None:
        self.name, self.groups, self.many = treated.name, (control, treated), len(control.wanted.table)
        self.value: Array = np.concatenate([group.wanted.table["value"].to_numpy(float) for group in self.groups])
        self.covariance: Array = np.zeros((2 * self.many, 2 * self.many))
        for k, group in enumerate(self.groups):
            own = slice(k * self.many, (k + 1) * self.many)
            self.covariance[own, own] = group.wanted.covariance
        free = sum(max(0, group.wanted.cells - 1) for group in self.groups)
        self.cells = free + 1 if free else 0  #: of one group with as many degrees of freedom

    def parts(self) -> list[LeftOut]:
        """Each cell once, and each number that no cell has."""
        found = []
        for k, group in enumerate(self.groups):
            names = list(group.wanted.table.index)
            of_cells = [i for i in range(self.many) if np.isfinite(group.cells[:, i]).any()]
            seen = [i for i in of_cells if names[i] in means_of_tracks]
            if seen:
                found.append(self._cells(group, k * self.many, np.array(of_cells), np.array(seen)))
            for i in (k * self.many + i for i in range(self.many) if i not in of_cells):
                kept = np.delete(np.arange(2 * self.many), i)
                found.append(LeftOut(kept, self.value[None, kept], self.covariance[np.ix_(kept, kept)], self.cells,
                                     np.array([i]), self.value[None, [i]], self.covariance[[[i]], [i]]))
        return found

    def _cells(self, group: Group, begin: int, of_cells: Array, seen: Array) -> LeftOut:
        """The cells of a group that have all read-outs."""
        n = len(group.cells)
        whole = np.isfinite(group.cells[:, seen]).all(axis=1) & np.isfinite(group.others[:, of_cells]).all(axis=1)
        values, covariance = np.tile(self.value, (int(whole.sum()), 1)), self.covariance.copy()
        values[:, begin + of_cells] = group.others[whole][:, of_cells]
        covariance[np.ix_(begin + of_cells, begin + of_cells)] *= n / (n - 1)
        at = begin + seen
        return LeftOut(np.arange(2 * self.many), values, covariance, self.cells - 1, at, group.cells[whole][:, seen],
                       n * self.covariance[np.ix_(at, at)])


def groups_of(control: Any, treated: Any, readouts: Sequence[str] | None,
              besides: Any) -> tuple[list[Group], list[str]]:
    """Control and the treated groups with the read-outs that all have, and notes.

    :raises ConfigurationError: with all that is wrong
    """
    if by_condition(control):
        raise ConfigurationError("control: is one group; give tracks, or numbers with errors: "
                                 "{\"l_prot_um\": (13.1, 0.4)}")
    given = dict(treated) if by_condition(treated) else {"treated": treated}
    if "control" in given:
        raise ConfigurationError("treated: control: is the name of the first group; give this one another name")
    given = {"control": control, **given}
    for name, one in given.items():
        arguments.one_of(name, one, Mapping)
    more = dict.fromkeys(given) | dict(arguments.mapping("besides", besides, "a dictionary of numbers by group"))
    faults = [f"besides: {name}: there is no such group; there are {', '.join(given)}"
              for name in more if name not in given]
    refuse(faults + _alike(given))
    names = {name: asked_for(one, readouts, more[name]) for name, one in given.items()}
    shared = [name for name in names["control"] if all(name in own for own in names.values())]
    if not shared and any(names.values()):
        raise ConfigurationError("no read-out was measured in all groups: "
                                 + "; ".join(f"{name} has {', '.join(own) or 'none'}" for name, own in names.items()))
    notes = [f"{name}: was not measured in all groups, and is left out"
             for name in dict.fromkeys(sum(names.values(), [])) if name not in shared]
    return list(each(given, lambda name: _group(name, given[name], shared, more[name])).values()), notes


def _group(name: str, measured: Any, shared: Sequence[str], besides: Any) -> Group:
    numbers = {key: value for key, value in arguments.mapping("besides", besides).items() if key in shared}
    is_tracks = isinstance(measured, _tracks.Tracks)
    own = [key for key in shared if is_tracks and key in _tracks.meanings() and key not in numbers]
    if is_tracks and len(measured) < len(own) + _spare:
        many = "one cell" if len(measured) == 1 else f"{len(measured)} cells"
        raise ConfigurationError(f"has {many}; {len(own)} read-outs of tracks need {len(own) + _spare}: their scatter "
                                 "is taken from the cells")
    known = measured if is_tracks else {key: value for key, value in measured.items() if key in shared}
    wanted = measurement(known, shared, numbers)
    refuse([f"{key}: is a range; groups are compared by numbers with errors"
            for key, row in wanted.table.iterrows() if row["low"] < row["high"]])
    at = [list(shared).index(key) for key in own]
    cells, others = (np.full((len(measured) if own else 0, len(shared)), np.nan) for _ in range(2))
    for k, cell in enumerate(measured if own else ()):
        for found, chosen in ((cells, [cell]), (others, [one for one in measured if one != cell])):
            part = _tracks.Tracks({one: measured[one] for one in chosen}, measured.interval, [])
            found[k, at] = part.readouts(resamples=0).loc[own, "value"]
    if not is_tracks:
        return Group(name, "", None, wanted, cells, others)
    return Group(name, f"{len(measured)} tracks {measured.source}", measured.interval, wanted, cells, others)


def _alike(given: Mapping[str, Any]) -> list[str]:
    """Faults of groups that are the same, or were not measured in the same way."""
    faults = []
    of_tracks = {name: one for name, one in given.items() if isinstance(one, _tracks.Tracks)}
    paths = {name: {np.round(np.diff(track, axis=0), 6).tobytes() for track in one.values()}
             for name, one in of_tracks.items()}
    for k, (name, one) in enumerate(given.items()):
        first = next(iter(of_tracks), name)
        if name in of_tracks and abs(one.interval / of_tracks[first].interval - 1) > 1e-6:
            longer = max(one.interval, of_tracks[first].interval)
            faults.append(f"{name}: has a position every {one.interval:g} s, {first} every "
                          f"{of_tracks[first].interval:g} s: speeds and angles depend on it; thin the denser tracks: "
                          f"every({longer:g}), or `matrigrate tracks FILE --every {longer:g} -o OTHER.csv`")
        for other in list(given)[:k]:
            if name in paths and other in paths and (twice := len(paths[name] & paths[other])):
                faults.append(f"{name}: {twice} of {len(one)} tracks are tracks of {other}: give each group its own")
            if {name, other}.isdisjoint(paths) and {*map(repr, one.items())} == {*map(repr, given[other].items())}:
                faults.append(f"{name}: has the numbers of {other}: give each group its own")
    return faults
