"""Outcomes: measured numbers, and how simulations under several conditions give them."""
from __future__ import annotations

import difflib
import os
import tomllib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _arguments
from ._files import _pandas, read_text
from ._measurement import lost
from ._study_file import key_of
from .errors import ConfigurationError
from .studies import Study

if TYPE_CHECKING:
    import pandas


largest = 1e100  # its square is a number


@dataclass(frozen=True)
class Outcome:
    """A measured number: a read-out under a condition, or its difference between two.

    >>> Outcome("l_prot_um", (-3, 0), at="400 Pa", minus="50 Pa", error=0.5).label
    'l_prot_um at 400 Pa less 50 Pa'
    """

    readout: str
    value: float | tuple[float, float]
    """Measured; or a range, whose ends may be infinite: ``(0, math.inf)`` says that it is positive."""
    error: float = 0.0  #: standard error of the measured value
    at: str = ""  #: condition; empty if the design has none
    minus: str = ""  #: condition whose read-out is subtracted
    row: str = ""  #: outcomes of the same row are judged together; empty: a row of its own
    runs: float = 0.0
    """If the measured value is a mean of so many cells whose scatter is not known: that of simulated ones is taken."""
    discrepancy: float = 0.0  #: standard error of the model itself
    relative: float | None = None  #: the same, as a share of the value; None: that of ``match``
    held_back: bool = False  #: predicted, not fitted
    name: str = ""

    @property
    def label(self) -> str:
        return self.name or self.readout + (f" at {self.at}" if self.at else "") + (f" less {self.minus}" if self.minus else "")

    @property
    def of(self) -> str:
        """The row that it belongs to."""
        return self.row or self.label

    @property
    def ends(self) -> tuple[float, float]:
        low, high = self.value if isinstance(self.value, tuple) else (self.value, self.value)
        return float(low), float(high)

    def variance(self, relative: float) -> float:
        """Of the measured value and of the model.  :param relative: discrepancy, where the outcome has none of its own"""
        share = relative if self.relative is None else self.relative
        size = max((abs(end) for end in self.ends if np.isfinite(end)), default=0.0)
        return self.error**2 + self.discrepancy**2 + (share * size)**2

    def faults(self, relative: float) -> list[str]:
        faults = []
        try:
            low, high = self.ends
        except (TypeError, ValueError):
            return [f"{self.label}: {self.value!r} is no number and no range (low, high)"]
        if isinstance(self.value, (bool, np.bool_)) or any(abs(end) > largest for end in (low, high) if np.isfinite(end)) or not low <= high or np.isinf(low) and np.isinf(high) or low == np.inf or high == -np.inf:
            faults.append(f"{self.label}: {self.value!r} is no number and no range (low, high)")
        for name in ("error", "runs", "discrepancy", "relative"):
            size = getattr(self, name)
            if size is not None and (isinstance(size, bool) or not (isinstance(size, (int, float, np.number)) and 0 <= size <= largest)):
                faults.append(f"{self.label}: {name}: {size!r} is no number from 0 to {largest:g}")
        if not faults and not self.runs and not self.variance(relative) > 0:
            faults.append(f"{self.label}: has neither error, runs nor discrepancy")
        return faults


_keys = {one.name for one in fields(Outcome)} | {"low", "high"}


def read_outcomes(file: str | os.PathLike[str]) -> list[Outcome]:
    """The ``[[outcomes]]`` of a TOML file: the fields of an ``Outcome`` by their names; in place of ``value`` a range by ``low``, ``high`` or both.

    :raises ConfigurationError: with all that is wrong
    """
    path = _arguments.path("file", file)
    try:
        tables = tomllib.loads(read_text(path)).get("outcomes", [])
    except tomllib.TOMLDecodeError as error:
        raise ConfigurationError(f"{path}: {error}") from None
    if not isinstance(tables, list) or not tables or not all(isinstance(one, dict) for one in tables):
        raise ConfigurationError(f"{path}: has no [[outcomes]]")
    faults, found = list[str](), list[Outcome]()
    for k, table in enumerate(tables, 1):
        wrong = _faults_of_table(table)
        faults += [f"{path}: outcome {k}: {fault}" for fault in wrong]
        if not wrong:
            ends = (table.pop("low", -np.inf), table.pop("high", np.inf))
            found.append(Outcome(**{"value": ends} | table))
    if faults:
        raise ConfigurationError("\n".join(faults))
    return found


def _faults_of_table(table: Mapping[str, Any]) -> list[str]:
    faults = []
    for name in table:
        if name not in _keys:
            near = difflib.get_close_matches(name, sorted(_keys), 1)
            faults.append(f"{name}: there is no such key; " + (f"did you mean {near[0]}?" if near else f"there are {', '.join(sorted(_keys))}"))
    if "readout" not in table:
        faults.append("readout is missing")
    if ("value" in table) == ("low" in table or "high" in table):
        faults.append("either value, or low, high or both are needed")
    return faults


Source = Any  # a study, a data frame, or studies or frames by condition


def runs_of(source: Source) -> tuple[pandas.DataFrame, list[str], list[str]]:
    """The runs of a design under its conditions: parameters, ``condition`` and read-outs, a row per run.

    :param source: a study, with ``[[conditions]]`` or without; a data frame with a column ``condition``; or a dictionary of such by the
        name of the condition, over the same points
    :return: the frame, its parameters (none known of a data frame), notes
    """
    if isinstance(source, Study):
        return _of_study(source)
    if isinstance(source, _pandas().DataFrame):
        if again := sorted({str(name) for name in source.columns[source.columns.duplicated()]}):
            raise ConfigurationError("\n".join(f"{name}: two columns have this name" for name in again))
        frame = source.copy()
        frame["condition"] = frame["condition"].astype(str) if "condition" in frame else ""
        return frame, [], []
    if not isinstance(source, Mapping):
        said = f"design is {source!r}" if isinstance(source, (str, os.PathLike)) else f"design has the type {type(source).__name__}"
        raise TypeError(f"{said}; a study (matrigrate.load_study), a data frame, or a dictionary of them by condition is expected")
    frames, known, notes = [], [list[str]() for _ in source], list[str]()
    for k, (condition, one) in enumerate(source.items()):
        frame, known[k], said = runs_of(one)
        frame["condition"] = str(condition)
        frames.append(frame)
        notes += [f"{condition}: {note}" for note in said]
    shared = [name for name in known[0] if all(name in other for other in known)] if known else []
    if not frames:
        raise ConfigurationError("the design has no condition")
    return _pandas().concat(frames, ignore_index=True), shared, notes


def _of_study(study: Study) -> tuple[pandas.DataFrame, list[str], list[str]]:
    document = tomllib.loads(read_text(study.folder / "study.resolved.toml"))
    conditions = document.get("conditions", [])
    set_by_conditions = {key for one in conditions for key in one if key != "label"}
    results = study.results
    done = results[results["status"] == "done"].reset_index(drop=True)
    parameters = [name for name in study.parameters if key_of(name) not in set_by_conditions]
    if texts := [name for name in parameters if results[name].dtype == object]:
        raise ConfigurationError("\n".join(f"{name}: only numbers can be matched" for name in texts))
    labels = sorted((one["label"] for one in conditions), key=len, reverse=True)
    frame = done.drop(columns=["run", "seed", "replicate"])
    frame["condition"] = [next((label for label in labels if text.startswith(f"{label}: ")), "") for text in done["label"]]
    return frame, parameters, lost(results)


def values_of(frame: pandas.DataFrame, parameters: Sequence[str], outcome: Outcome) -> tuple[Any, Any, Any]:
    """At each point that has the outcome: parameters, its mean over runs, and how many runs have the same scatter as this mean."""
    def means(condition: str) -> pandas.DataFrame:
        runs = frame.loc[(frame["condition"] == condition) & np.isfinite(frame[outcome.readout].astype(float))]
        return runs.groupby(list(parameters), sort=False)[outcome.readout].agg(["mean", "size"])

    table = means(str(outcome.at))
    if outcome.minus:
        other = means(str(outcome.minus))
        table = table.join(other, rsuffix="_minus", how="inner")
        table["mean"] -= table["mean_minus"]
        table["size"] = 2.0 / (1.0 / table["size"] + 1.0 / table["size_minus"])
    at = np.array([key if isinstance(key, tuple) else (key,) for key in table.index], dtype=float).reshape(len(table), len(parameters))
    return at, table["mean"].to_numpy(float), table["size"].to_numpy(float)


def faults_of(outcomes: Sequence[Outcome], frame: pandas.DataFrame, relative: float) -> list[str]:
    """What is wrong with outcomes of these runs."""
    faults = [fault for outcome in outcomes for fault in outcome.faults(relative)]
    labels = [outcome.label for outcome in outcomes]
    faults += [f"{label}: is there twice; give one of them a name" for label in dict.fromkeys(labels) if labels.count(label) > 1]
    conditions = sorted(frame["condition"].unique())
    for outcome in outcomes:
        if outcome.readout not in frame:
            faults.append(f"{outcome.label}: the design has no read-out {outcome.readout}")
        elif frame[outcome.readout].dtype == object:
            faults.append(f"{outcome.label}: {outcome.readout} is no number")
        faults += [f"{outcome.label}: the design has no condition \"{name}\"; it has {', '.join(conditions)}"
                   for name in dict.fromkeys([str(outcome.at), *([str(outcome.minus)] if outcome.minus else [])]) if name not in conditions]
    return faults
