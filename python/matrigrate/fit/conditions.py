"""The runs of studies under each condition, and what was measured there."""
from __future__ import annotations

import os
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from .. import tracks
from ..base import arguments
from ..base.files import require_pandas, read_text
from ..draw import words
from ..errors import ConfigurationError, refuse
from ..results.studies import Study, load_study

if TYPE_CHECKING:
    import pandas

Source = Any  # a study, its folder, a data frame with a row per run, or a list of these, one for each wave


@dataclass(frozen=True)
class Runs:
    """The runs under one condition."""

    table: pandas.DataFrame  #: a row per run: ``status``, ``point``, parameters and read-outs
    parameters: list[str]
    design: pandas.DataFrame  #: parameters of all points of the first wave, whatever became of their runs
    studies: dict[str, Study]  #: by the names of runs; empty of a data frame

    @property
    def readouts(self) -> list[str]:
        columns = list(self.table.columns)
        first = columns.index("trajectory_hash") + 1 if "trajectory_hash" in columns else 0
        return [name for name in columns[first:] if name not in (*self.parameters, "point", "status", "condition")]


def by_condition(measured: Any) -> bool:
    """Whether what was measured stands by conditions: ``{"50 Pa": {"l_prot_um": (13.1, 0.4)}}``."""
    return isinstance(measured, Mapping) and not isinstance(measured, tracks.Tracks) and any(isinstance(one, Mapping) for one in measured.values())


def require_study(study: Any) -> None:
    """:raises TypeError: if it is none"""
    if isinstance(study, (str, os.PathLike)):
        raise TypeError(f"study is the text {str(study)!r}; a study is expected, as matrigrate.load_study({str(study)!r}) gives it")
    arguments.one_of("study", study, Study, list, tuple, dict, require_pandas().DataFrame)


def runs_of(study: Source | Mapping[str, Source], conditions: Sequence[str], given: Sequence[str]) -> dict[str, Runs]:
    """The runs under each condition.

    :param conditions: wanted; none: all runs, under the condition ""
    :param given: parameters of data frames
    :raises ConfigurationError: with all that is wrong
    """
    if not isinstance(study, Mapping):
        return _of_waves(study, conditions, given)
    refuse([f"{name}: there is no study of this condition; there are {', '.join(map(str, study))}" for name in conditions if name not in study])
    if not conditions:
        raise ConfigurationError("measured: studies by condition need what was measured by condition: "
                                 f"{{\"{next(iter(study), '50 Pa')}\": {{\"l_prot_um\": (13.1, 0.4)}}}}")
    found = {name: _of_waves(study[name], [], given)[""] for name in conditions}
    named = {name: set(runs.parameters) for name, runs in found.items()}
    shared = set.intersection(*named.values())
    refuse([f"{name}: varies {', '.join(sorted(own - shared))}, which other conditions do not" for name, own in named.items() if own != shared])
    order = list(next(iter(found.values())).parameters)  # studies may name them in another one
    design = require_pandas().concat([runs.design for runs in found.values()], ignore_index=True)[order]
    return {name: replace(runs, parameters=order, design=design) for name, runs in found.items()}


def _of_waves(source: Source, conditions: Sequence[str], given: Sequence[str]) -> dict[str, Runs]:
    waves = [_of_one(one, conditions, given) for one in (source if isinstance(source, (list, tuple)) else [source])]
    if not waves:
        raise ConfigurationError("one study is needed")
    return {name: _together([wave[name] for wave in waves]) for name in waves[0]}


def _together(waves: list[Runs]) -> Runs:
    """Runs of several waves; those of two count once."""
    if len(waves) == 1:
        return waves[0]
    first = waves[0]
    refuse([f"{name}: wave {k} has no such parameter" for k, wave in enumerate(waves, 1) for name in first.parameters if name not in wave.table])
    table = require_pandas().concat([wave.table.assign(point=[f"{k}: {point}" for point in wave.table["point"]]) for k, wave in enumerate(waves, 1)],
                             ignore_index=True)
    table = table.drop_duplicates(["run"] if all(wave.studies for wave in waves) else [name for name in table if name != "point"], ignore_index=True)
    return replace(first, table=table, studies={run: study for wave in waves for run, study in wave.studies.items()})


def _of_one(source: Any, conditions: Sequence[str], given: Sequence[str]) -> dict[str, Runs]:
    if isinstance(source, require_pandas().DataFrame):
        return _of_frame(source, conditions, given)
    study = source if isinstance(source, Study) else load_study(source)
    results = study.results.assign(point=study.results["label"])
    if not conditions:
        return {"": _runs(results, study.parameters, study)}
    known_conditions = document_of(study).get("conditions", [])
    labels = [one["label"] for one in known_conditions]
    _require_known(conditions, labels, "study")
    fixed = {key for one in known_conditions for key in one if key != "label"}
    parameters = [name for name in study.parameters if (known := words.parameter_of(name)) is None or known.path not in fixed]
    at = {point: max((label for label in labels if point.startswith(f"{label}: ")), key=len, default="") for point in results["point"].unique()}
    return {name: _runs(results[results["point"].map(at) == name], parameters, study) for name in conditions}


def _of_frame(frame: pandas.DataFrame, conditions: Sequence[str], given: Sequence[str]) -> dict[str, Runs]:
    if not given:
        raise ConfigurationError("prior: is needed for a table: it names the parameters and their ranges")
    columns = list(frame.columns)
    faults = [f"{name}: two columns have this name" for name in dict.fromkeys(columns) if columns.count(name) > 1]
    faults += [f"{name}: the table has no such column" for name in given if name not in columns]
    faults += [f"{name}: only finite numbers can be fitted" for name in given if columns.count(name) == 1
               and not (require_pandas().api.types.is_numeric_dtype(frame[name]) and frame[name].abs().lt(float("inf")).all())]
    if conditions and "condition" not in columns:
        faults.append("condition: the table has no such column")
    refuse(faults)
    table = frame.assign(point=frame.groupby(list(given), sort=False).ngroup(), status=frame["status"] if "status" in columns else "done")
    if not conditions:
        return {"": _runs(table, list(given))}
    _require_known(conditions, sorted(table["condition"].astype(str).unique()), "data frame")
    return {name: _runs(table[table["condition"].astype(str) == name], list(given)) for name in conditions}


def _require_known(conditions: Sequence[str], labels: Sequence[str], owner: str) -> None:
    known = f"; it has {', '.join(labels)}" if labels else ": it has no conditions"
    refuse([f"{name}: the {owner} has no such condition{known}" for name in conditions if name not in labels])


def _runs(table: pandas.DataFrame, parameters: list[str], study: Study | None = None) -> Runs:
    table = table.reset_index(drop=True)
    return Runs(table, parameters, table.drop_duplicates("point")[parameters].reset_index(drop=True),
                {} if study is None else dict.fromkeys(table["run"], study))


def parameters_of(argument: str, given: Iterable[str], varying: Sequence[str],
                  fixed: Mapping[str, float]) -> tuple[dict[str, str], list[str]]:
    """By the names that were given the columns of a study, and faults. A path without its unit is a name, too.

    :param varying: columns of parameters   :param fixed: those that have one value
    """
    found, faults = {}, []
    for name in given:
        match = [column for column in varying
                 if name == column or ((one := words.parameter_of(column)) is not None and one.path == name)]
        if match:
            found[name] = match[0]
            continue
        is_one = name in fixed or words.parameter_of(str(name)) is not None
        why = "has no range in the study" if is_one else "is no parameter of the study"
        faults.append(f"{argument}: {name}: {why}, which varies {', '.join(varying)}")
    return found, faults


def document_of(study: Study) -> dict[str, Any]:
    return tomllib.loads(read_text(study.folder / "study.resolved.toml"))


def first_study(source: Any) -> Study | None:
    """The study, or that of the first wave; None of data frames and of studies by condition."""
    one = next(iter(source), None) if isinstance(source, (list, tuple)) else source
    return load_study(one) if isinstance(one, (str, os.PathLike)) else one if isinstance(one, Study) else None


def targets_of(study: Any) -> dict[str, Any]:
    """What ``[[targets]]`` of a study, or of its first wave, say, as ``fit`` takes it: by condition if it has any.

    :raises ConfigurationError: if there are none, or some of tracks
    """
    first = first_study(study)
    document = {} if first is None else document_of(first)
    labels, found = [one["label"] for one in document.get("conditions", [])], dict[str, dict[str, Any]]()
    for target in document.get("targets", []):
        if "tracks" in target:
            raise ConfigurationError(f"targets: {target['readout']}: is of tracks: give these, as matrigrate.tracks.read(\"{target['tracks']}\") "
                                     "reads them")
        value = target["value"] if "value" in target else (target["low"], target["high"])
        for label in target.get("at", labels) or [""]:
            found.setdefault(label, {})[target["readout"]] = (value, target["error"])
    if not found:
        raise ConfigurationError("measured: the study has no [[targets]]; give what was measured: {\"l_prot_um\": (13.1, 0.4)}")
    return found if labels else found[""]
