"""Which parameters must differ between control and treated cells. ``matrigrate.calibrate.compare`` is the user."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base import arguments
from ..base.files import require_pandas, write_report
from ..errors import ConfigurationError, refuse
from .conditions import Source, parameters_of, require_study, runs_of
from .fit import Emulators, discrepancies, of_points, varied
from .groups import Group, Pair, groups_of
from .hypotheses import Compared, Model
from .measurement import Points, differences, simulated, size_faults
from .posterior import said
from .process import scipy

if TYPE_CHECKING:
    import pandas


@dataclass(frozen=True)
class Comparison:
    """What may explain the difference between treated groups of cells and control."""

    table: pandas.DataFrame
    """A row for each treated ``group`` and hypothesis of what ``differs``: nothing, one parameter, two, everything.
    ``ratio_5`` to ``ratio_95``: of the treated value over that of control, if this parameter alone differs. ``times``:
    as likely as if nothing differs the data are (Bayes factor). ``probability`` of this parameter, if just one differs;
    ``candidate``: whether it is one of the fewest that have 95 % of it; none, if nothing differs. ``over_nothing``,
    ``over_everything``: cross-validated logarithmic score less that of these hypotheses, each with its standard error.
    ``p``: posterior predictive p of the distance of the data. ``effective_sample_size``: of the posterior."""
    ratios: pandas.DataFrame  #: treated over control: a row for each group, hypothesis and parameter that differs in it
    readouts: pandas.DataFrame  #: a row a number: measured value and error, and means over the posterior
    something: dict[str, float]  #: by group: as likely as if nothing differs the data are if something does
    words: list[str]  #: what the data say, a sentence each
    notes: list[str]
    source: dict[str, str]  #: study, groups, known parameters, seed

    def __repr__(self) -> str:
        table = self.table.to_string(index=False, float_format="%.3g", na_rep="")
        return "\n".join([table, "", *self.words, *self.notes])

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes comparison.csv, ratios.csv, readouts.csv and report.html, which needs no other file, into a new
        folder.

        :param overwrite: whether to replace these files in a folder that is there already
        :return: report.html
        """
        from .report import page_of_comparison

        return write_report(arguments.path("folder", folder), overwrite, page_of_comparison(self),
                            {"comparison": self.table, "ratios": self.ratios, "readouts": self.readouts})


def compare(study: Source | Emulators, control: Any, treated: Any, readouts: Sequence[str] | None = None, *,
            besides: Any = None, known: Mapping[str, Sequence[float]] | None = None,
            parameters: Sequence[str] | None = None, pairs: bool = True, scores: bool = True,
            interval: float | None = None, error: float = 0.0, prior: Mapping[str, Any] | None = None,
            discrepancy: Mapping[str, float] | None = None, seed: int = 1) -> Comparison:
    """Which parameter of a study must differ between treated cells and control.

    :param study: a Latin hypercube, or what else ``fit`` takes; or what ``emulate`` made of it, with its read-outs
    :param control: tracks; or means and standard errors by the names of read-outs: ``{"l_prot_um": (8.2, 0.5)}``
    :param treated: the same of treated cells; or a dictionary of such groups, each compared with control
    :param readouts: of tracks; those of numbers, if left out
    :param besides: numbers beside tracks, by group: ``{"control": {"l_prot_um": (13.1, 0.4)}, "treated": {...}}``
    :param known: values in control and in each treated group: ``{"ecm.youngs_modulus_Pa": (50, 200)}``
    :param parameters: that may differ; if left out, all that the study varies and that are not known
    :param pairs: whether two parameters that differ are tried as well
    :param scores: whether hypotheses are cross-validated, which takes more than half of the time
    :param interval: [s] between positions, where no tracks are given
    :param error: localisation error of a coordinate [um], added to the simulated tracks
    :param prior: as ``fit`` takes it
    :param discrepancy: standard error of the model itself, the same in all groups, by the names of read-outs
    :raises ConfigurationError: with all that is wrong
    """
    made = study if isinstance(study, Emulators) else None
    if made is None:
        require_study(study)
    elif readouts is not None or interval is not None or error or prior:
        raise ConfigurationError("readouts, interval, error, prior: are those of the emulators; leave them out")
    groups, notes = groups_of(control, treated, made.names if made else readouts, besides)
    if made is None:
        runs = runs_of(study, [], list(arguments.mapping("prior", prior, "a dictionary of ranges")))[""]
        interval = next((one.interval for one in groups if one.interval), interval)
        points = simulated(runs, list(groups[0].wanted.table.index), interval, error)
    else:
        points = made.points
    values, may, errors = _asked_for(points, groups, known, parameters, discrepancy)
    if made is None:
        scipy()
        folders = dict.fromkeys(str(one.folder) for one in runs.studies.values())
        made = replace(of_points(points, prior, seed), study=", ".join(folders))
    ends = dict(zip(made.prior.names, zip(made.prior.low, made.prior.high, strict=True), strict=True))
    refuse([f"known: {name}: {one:g} lies outside of {ends[name][0]:g} to {ends[name][1]:g}, the range of the study"
            for name, value in values.items() for one in value if not ends[name][0] <= one <= ends[name][1]])
    tells = [name for name, one in zip(made.names, made.processes, strict=True) if one.tells]
    if not tells:
        raise ConfigurationError("no read-out depends on a parameter, as far as the points can tell: nothing can be "
                                 "compared; run more points")
    kept, off = [group.only(tells) for group in groups], np.array([errors.get(name, 0.0) for name in tells])
    found = []
    for place, group in enumerate(kept[1:], 1):
        own = [{name: float(value[k]) for name, value in values.items()} for k in (0, place)]
        found.append(Compared(Model(made, Pair(kept[0], group), may, own, off), pairs, scores, seed))
    notes += made.notes
    for group in groups:
        notes += said(group.name, [*group.wanted.notes, *differences(points, group.wanted)])
    source = {"study": made.study, "seed": str(seed)} | {f"known {name}": ", ".join(f"{one:g}" for one in value)
                                                        for name, value in values.items()}
    source |= {group.name: group.source for group in groups}
    frame = require_pandas().DataFrame
    return Comparison(*(frame([row for one in found for row in getattr(one, part)], columns=columns)
                        for part, columns in Compared.columns.items()),
                      {one.pair.name: one.something for one in found}, [word for one in found for word in one.words],
                      list(dict.fromkeys([*notes, *(note for one in found for note in one.notes)])), source)


def _asked_for(points: Points, groups: Sequence[Group], known: Any, parameters: Any,
               discrepancy: Any) -> tuple[dict[str, Sequence[float]], list[str], dict[str, float]]:
    """Known values and parameters that may differ, by the columns of the study, and errors of the model; or all that is
    wrong."""
    varying, fixed = varied(points.parameters)
    given = arguments.mapping("known", known, "a dictionary of values")
    if isinstance(parameters, str):
        raise arguments.wrong("parameters", parameters, "a list of parameters")
    columns, faults = parameters_of("known", given, varying, fixed)
    wanted, more = parameters_of("parameters", varying if parameters is None else parameters, varying, fixed)
    values = {column: given[name] for name, column in columns.items()}
    may = [name for name in wanted.values() if name not in values]
    faults += [f"known: {name}: {value!r} are no {len(groups)} numbers: one for "
               f"{', one for '.join(group.name for group in groups)}"
               for name, value in values.items()
               if not (isinstance(value, Sequence) and len(value) == len(groups) and all(map(arguments.is_number, value)))]
    faults += more + ([] if may or faults or more else ["parameters: none is left that may differ"])
    for group in groups:
        faults += said(group.name, size_faults(group.wanted.table, points.values))
    off, errors = discrepancies(discrepancy, {"": list(points.values)})
    refuse(faults + off)
    return values, may, errors
