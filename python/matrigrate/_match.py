"""History matching under several conditions. ``matrigrate.calibrate.match`` is its user."""
from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from . import _arguments, _emulator, _space
from ._emulator import Array, Constant, Emulator, Prior
from ._files import _pandas, make_folder
from ._fit import beyond, prior_of, varied
from ._outcomes import Outcome, Source, faults_of, runs_of, values_of
from ._process import scipy
from .errors import ConfigurationError
from .studies import Study

if TYPE_CHECKING:
    import pandas

_least_points, _enough_points = 3, 10  # for each parameter: for an emulator at all, and without a note


@dataclass(frozen=True)
class Wave:
    """What the runs of a wave, and of those before, leave of the space of parameters."""

    points: int  #: with any outcome
    share: float  #: of the prior that is plausible; 0 if nothing was found
    ranges: pandas.DataFrame  #: a row per parameter: ``low`` and ``high`` of what is plausible, and its quantiles ``5``, ``50``, ``95``
    sample: pandas.DataFrame  #: uniform over what is plausible, a row per draw
    cube: Array = field(repr=False)  #: the same in the unit cube of the prior


@dataclass(frozen=True)
class Match:
    """Which parameters give outcomes like the measured ones, all conditions at once.

    The implausibility of an outcome is its distance from what was measured over the root of the summed variances: of the emulator, of the
    measured value, of the model, and of seeds. A point is plausible if at most ``allowed`` rows have one of ``cutoff`` or more.
    """

    waves: list[Wave]
    outcomes: pandas.DataFrame
    """A row an outcome: ``row``, measured ``low`` and ``high``, its ``error`` (with the discrepancy of the model), ``points`` that have it; of the
    emulator ``predicted`` share of the variance of points and ``coverage`` of its 90 % intervals, and whether it is ``told`` by it; over the plausible
    space ``mean`` and the quantiles ``5`` and ``95`` of the prediction; ``implausibility`` at the best point; and ``held_back``."""
    rows: pandas.DataFrame
    """A row for each row of outcomes that is fitted: ``plausible``, the share of the prior where it alone is; ``least`` implausibility within the prior;
    and that at the best ``point``."""
    best: pandas.Series
    """The point with the least mean square of the implausibilities of rows among those that are plausible; or, if none is, the nearest to it."""
    notes: list[str]
    prior: Prior
    allowed: int
    cutoff: float
    emulators: dict[str, Emulator] = field(repr=False)  #: by the label of outcomes, of the last wave
    _judge: _Judge = field(repr=False)
    _there: Array = field(repr=False)  # points of all waves in the unit cube
    _seed: int = 1
    source: dict[str, str] = field(default_factory=dict)  #: the folders of studies

    def __repr__(self) -> str:
        shares = ", ".join(f"{wave.share:.3g}" for wave in self.waves)
        return "\n".join([f"share of the prior that is plausible, wave by wave: {shares}", "", self.rows.to_string(float_format="%.3g"), "",
                          self.outcomes[["low", "high", "mean", "5", "95", "predicted", "implausibility", "held_back"]].to_string(
                              float_format="%.3g"), *self.notes])

    def predict(self, points: pandas.DataFrame) -> pandas.DataFrame:
        """At points, a row each: for each outcome its mean and, ending in ``_error``, the standard error of this mean."""
        if lacking := [name for name in self.prior.names if name not in points]:
            raise ConfigurationError("\n".join(f"{name}: the points have no such column" for name in lacking))
        cube = self.prior.to_cube(points[self.prior.names].to_numpy(float))
        found = {}
        for name, emulator in self.emulators.items():
            found[name], found[f"{name}_error"] = emulator(cube)
        return _pandas().DataFrame(found, index=points.index)

    def next_points(self, many: int) -> pandas.DataFrame:
        """Points for the next wave, a row each: they fill what is plausible, and stay away from points of earlier waves.

        :raises ConfigurationError: if nothing is plausible
        """
        cube = self.waves[-1].cube
        if not len(cube):
            raise ConfigurationError("nothing within the prior is plausible: allow more rows, or larger discrepancies")
        return _pandas().DataFrame(self.prior.from_cube(_space.filling(cube, many, self._there)), columns=self.prior.names)

    def write_study(self, file: str | os.PathLike[str], many: int, like: Study | str | os.PathLike[str], *,
                    keys: Mapping[str, str] | None = None) -> pandas.DataFrame:
        """Writes ``next_points(many)`` as a file for ``matrigrate study run``, and checks it by the program.

        :param like: the study of an earlier wave, or its file: scenario, conditions, replicates and read-outs are taken from it
        :param keys: of parameters that are not named as in tables of a study: ``{"zeta": "adhesion.force_sensitivity"}``
        :return: the points
        """
        from ._study_file import write_points

        points = self.next_points(many)
        write_points(_arguments.path("file", file), points, like, keys or {})
        return points

    @cached_property
    def exclusions(self) -> pandas.DataFrame:
        """A row for each pair of rows: ``least`` of the larger of their implausibilities within the prior, and ``both``, whether any point satisfies
        them; ``alone_a`` and ``alone_b``, the least of each. Those that exclude each other come first."""
        return self.excluding({row: [row] for row in self.rows.index})

    def excluding(self, groups: Mapping[str, Sequence[str]]) -> pandas.DataFrame:
        """As ``exclusions``, for groups of rows: a group is satisfied where all of its rows are.

        :param groups: names of rows by the name of a group
        """
        if unknown := [f"{name}: there is no such row" for rows in groups.values() for name in rows if name not in self.rows.index]:
            raise ConfigurationError("\n".join(unknown))
        at = {group: [list(self.rows.index).index(name) for name in rows] for group, rows in groups.items()}
        names, found = list(at), []
        alone = {name: self._least(at[name]) for name in names}
        for i, a in enumerate(names):
            for b in names[i + 1:]:
                together = self._least([*at[a], *at[b]], max(alone[a], alone[b]))
                found.append((a, b, together, together < self.cutoff, alone[a], alone[b]))
        table = _pandas().DataFrame(found, columns=["a", "b", "least", "both", "alone_a", "alone_b"])
        return table.sort_values("least", ascending=False, ignore_index=True, kind="stable")

    @cached_property
    def reach(self) -> pandas.DataFrame:
        """A row for each outcome that an emulator tells, held back or not: what meeting it would take, by the means of emulators within the prior.

        ``nearest`` mean to what was measured (any of them, if means lie within a measured range); ``met``, the share of the prior where the
        mean is within ``error`` of it; ``others``, the mean there of exp(-I^2/2), I^2 being the sum of the squared implausibilities of all
        other rows that are fitted, over the mean in the whole prior; NaN if the outcome is met nowhere or there is no other row;
        ``against``, the other row whose mean square of I is raised most there, empty if none is by more than 0.01. NaN come first, then the
        outcomes that cost the others most.
        """
        told = [one for one in self._judge.outcomes if self.emulators[one.label].tells]
        table = _pandas().DataFrame([self._judge.reach(one) for one in told], columns=["outcome", "row", "nearest", "met", "others", "against"])
        return table.set_index("outcome").sort_values("others", na_position="first", kind="stable")

    def _least(self, rows: list[int], floor: float = 0.0) -> float:
        """Least of the largest implausibility of rows, refined only where it decides."""
        known = self._judge.known[:, rows].max(axis=1)
        start = float(known.min())
        if start < self.cutoff or start <= floor:
            return start
        return _space.least(lambda cube: self._judge.rows(cube, rows).max(axis=1), self._judge.cube, known, self._seed)[1]

    def write(self, folder: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes outcomes.csv, reach.csv, rows.csv, exclusions.csv, ranges.csv (of all waves), plausible.csv (the sample of the last wave) and
        report.html, which needs no other file, into a new folder.

        :param overwrite: whether to replace these files in a folder that is there already
        :return: report.html
        """
        from ._match_report import page

        path = _arguments.path("folder", folder)
        text = page(self)
        make_folder(path, overwrite)
        self.outcomes.to_csv(path / "outcomes.csv", index_label="outcome")
        self.reach.to_csv(path / "reach.csv", float_format="%.4g")
        self.rows.to_csv(path / "rows.csv", index_label="row")
        self.exclusions.to_csv(path / "exclusions.csv", index=False)
        ranges = [wave.ranges.assign(wave=k, share=wave.share) for k, wave in enumerate(self.waves, 1)]
        _pandas().concat(ranges).to_csv(path / "ranges.csv", index_label="parameter")
        self.waves[-1].sample.to_csv(path / "plausible.csv", index=False)
        (path / "report.html").write_text(text, encoding="utf-8")
        return path / "report.html"


@dataclass(frozen=True)
class _How:
    """As of ``match``."""

    allowed: int
    discrepancy: float
    cutoff: float
    row: str
    seed: int

    def faults(self) -> list[str]:
        faults = []
        if not (isinstance(self.discrepancy, (int, float)) and 0 <= self.discrepancy < np.inf):
            faults.append(f"discrepancy: {self.discrepancy!r} is no share from 0 on")
        if not (isinstance(self.cutoff, (int, float)) and 0 < self.cutoff < np.inf):
            faults.append(f"cutoff: {self.cutoff!r} is no number above 0")
        if self.row not in ("worst", "mean"):
            faults.append(f"row: {self.row!r} is neither \"worst\" nor \"mean\"")
        if not isinstance(self.allowed, (int, np.integer)) or self.allowed < 0:
            faults.append(f"allowed: {self.allowed!r} is no number of rows")
        return faults


class _Judge:
    """Implausibilities at points of the unit cube."""

    def __init__(self, outcomes: Sequence[Outcome], emulators: Mapping[str, Emulator | Constant], how: _How, prior: Prior) -> None:
        self.how, self.prior = how, prior
        self.outcomes = [one for one in outcomes if one.label in emulators]
        self.emulators = emulators
        fitted = [one for one in self.outcomes if not one.held_back and (emulators[one.label].tells or self.missed(one))]
        self.names = list(dict.fromkeys(one.of for one in fitted))
        self._of_row = [[one for one in fitted if one.of == name] for name in self.names]
        self.cube = prior.snapped(_space.whole(len(prior.names), how.seed))
        self.known = self.rows(self.cube)

    def missed(self, outcome: Outcome) -> bool:
        """Whether an outcome that depends on no parameter, as far as the points can tell, is met nowhere."""
        return not self.emulators[outcome.label].tells and bool(self.one(outcome, np.zeros((1, len(self.prior.names))))[0] >= self.how.cutoff)

    def one(self, outcome: Outcome, cube: Array) -> Array:
        emulator, (low, high) = self.emulators[outcome.label], outcome.ends
        cube = self.prior.snapped(cube)
        if emulator.tells:
            mean, error = emulator(cube)
        else:  # the same everywhere, with the scatter of points
            mean, error = np.full(len(cube), emulator.values.mean()), np.full(len(cube), emulator.values.std())
        seeds = emulator.scatter(cube)**2 / outcome.runs if outcome.runs else 0.0
        off = np.maximum(0.0, np.maximum(low - mean, mean - high))
        return np.asarray(off / np.sqrt(error**2 + seeds + outcome.variance(self.how.discrepancy)))

    def reach(self, outcome: Outcome) -> tuple[str, str, float, float, float, str]:
        """As in ``Match.reach``."""
        low, high = outcome.ends
        mean, _ = self.emulators[outcome.label](self.cube)
        off = np.maximum(0.0, np.maximum(low - mean, mean - high))
        met = off <= outcome.variance(self.how.discrepancy)**0.5
        names = [name for name in self.names if name != outcome.of]
        squares = self.known[:, [self.names.index(name) for name in names]]**2
        others, against = float("nan"), ""
        if met.any() and names:
            total = squares.sum(axis=1)
            likely = np.exp(-0.5 * (total - total.min()))
            others = likely[met].mean() / likely.mean()
            raised = squares[met].mean(axis=0) - squares.mean(axis=0)
            against = names[int(raised.argmax())] if raised.max() > 0.01 else ""
        return outcome.label, outcome.of, float(mean[off.argmin()]), float(met.mean()), others, against

    def rows(self, cube: Array, which: Sequence[int] | None = None) -> Array:
        """A column a row: the worst of its outcomes, or the root of their mean square."""
        found = []
        for k in range(len(self.names)) if which is None else which:
            own = np.array([self.one(outcome, cube) for outcome in self._of_row[k]])
            found.append(own.max(axis=0) if self.how.row == "worst" else np.sqrt((own**2).mean(axis=0)))
        return np.array(found).T.reshape(len(cube), -1)

    def depth(self, cube: Array) -> Array:
        """Below the cutoff if at most as many rows as are allowed are implausible: the largest implausibility but for those."""
        return self.deep(self.rows(cube))

    def deep(self, rows: Array) -> Array:
        return np.asarray(np.sort(rows, axis=1)[:, -1 - min(self.how.allowed, rows.shape[1] - 1)])


def match(designs: Source | Sequence[Source], outcomes: Sequence[Outcome], *, prior: Mapping[str, Any] | None = None, allowed: int = 0,
          discrepancy: float = 0.1, cutoff: float = 3.0, row: Literal["worst", "mean"] = "worst", seed: int = 1) -> Match:
    """Gaussian processes of all outcomes over the parameters of a design, and what the measured values leave of its space.

    :param designs: the runs of a design, or a list of those of one wave after the other, each judged together with those before: a study with
        ``[[conditions]]``, a dictionary of studies by the name of a condition, or a data frame with a row per run, a column ``condition``,
        and columns of parameters and read-outs
    :param prior: ranges of parameters as of ``fit``; needed for data frames, since it names their parameters; else those of the design
    :param allowed: rows that may be implausible at a plausible point
    :param discrepancy: standard error of the model itself as a share of a measured value, for outcomes that have none of their own
    :param cutoff: the implausibility at which a row is implausible; three is that of a normal distribution with hardly any chance
    :param row: the implausibility of a row: that of its worst outcome, or the root of the mean square of all
    :raises ConfigurationError: with all that is wrong
    :raises ImportError: without SciPy
    """
    scipy()
    gathered, parameters, notes = _gathered(designs, prior)
    frame = _pandas().concat(gathered, ignore_index=True).drop_duplicates(ignore_index=True)
    outcomes = list(outcomes)
    faults = [f"{one!r} is no Outcome" for one in outcomes if not isinstance(one, Outcome)]
    how = _How(allowed, discrepancy, cutoff, row, seed)
    faults = how.faults() or faults or faults_of(outcomes, frame, discrepancy)
    if all(one.held_back for one in outcomes if isinstance(one, Outcome)):
        faults.append("one outcome is needed that is not held back")
    points = frame[parameters].drop_duplicates().astype(float)
    names, fixed = varied(points)
    ranges, prior_faults, prior_notes = prior_of(points[names], points[names], prior, fixed)
    if not names:
        faults.append("the design varies no parameter")
    if faults + prior_faults:
        raise ConfigurationError("\n".join(faults + prior_faults))
    notes += [f"{name}: is {value:.6g} at all points, so it is left out: nothing can be said of it" for name, value in fixed.items()]
    waves, judge, said = [], None, list[str]()
    for k in range(len(gathered)):
        so_far = _pandas().concat(gathered[:k + 1], ignore_index=True).drop_duplicates(ignore_index=True)  # a run of two waves counts once
        emulators, said = _emulators(outcomes, so_far, ranges, seed)
        judge = _judge_of(outcomes, emulators, how, ranges, said)
        waves.append(_wave(judge, ranges, so_far, seed))
        if judge is None:
            notes.append(f"wave {k + 1}: its {waves[-1].points} points tell no outcome, so it excludes nothing")
    if judge is None:
        raise ConfigurationError("\n".join(["no outcome is told by an emulator", *said]))
    made = _match(waves, judge, outcomes, frame, ranges, [*notes, *prior_notes, *said])
    return replace(made, source={"study": ", ".join(_folders(designs))})


def _folders(designs: Any) -> list[str]:
    """Of the studies among designs."""
    if isinstance(designs, Study):
        return [str(designs.folder)]
    parts = designs.values() if isinstance(designs, Mapping) else designs if isinstance(designs, (list, tuple)) else []
    return [folder for part in parts for folder in _folders(part)]


def _gathered(designs: Any, prior: Mapping[str, Any] | None) -> tuple[list[pandas.DataFrame], list[str], list[str]]:
    """The runs of each wave, the parameters that all have, notes."""
    listed = list(designs) if isinstance(designs, (list, tuple)) else [designs]
    if not listed:
        raise ConfigurationError("one design is needed")
    given = list(_arguments.mapping("prior", prior, "a dictionary of ranges"))
    frames, known, notes = [], [], list[str]()
    for one in listed:
        frame, parameters, said = runs_of(one)
        frames.append(frame)
        known.append(parameters)
        notes += said
    own = next((names for names in known if names), None)
    wanted = list(given) if own is None else own
    if not wanted:
        raise ConfigurationError("prior: is needed for a data frame: it names the parameters and their ranges")
    faults = [f"{name}: design {k} has no such column" for k, frame in enumerate(frames, 1) for name in wanted if name not in frame]
    faults += [f"{name}: is no number in design {k}" for k, frame in enumerate(frames, 1) for name in wanted
               if name in frame and (frame[name].dtype == object or not np.isfinite(frame[name].to_numpy(float)).all())]
    if faults:
        raise ConfigurationError("\n".join(faults))
    return frames, wanted, list(dict.fromkeys(notes))


def _emulators(outcomes: Sequence[Outcome], frame: pandas.DataFrame, prior: Prior,
               seed: int) -> tuple[dict[str, Emulator | Constant], list[str]]:
    """By the label of outcomes; none of an outcome that too few points have."""
    found, notes = dict[str, Emulator | Constant](), list[str]()
    there = len(frame[prior.names].drop_duplicates())
    needed, enough = (many * len(prior.names) for many in (_least_points, _enough_points))
    few = 0
    for outcome in outcomes:
        at, values, runs = values_of(frame, prior.names, outcome)
        if 0 < len(at) < there:
            notes.append(f"{outcome.label}: {there - len(at)} of {there} points have no run with a finite value of it")
            notes += [f"prior: {name}: {prior.low[j]:.4g} to {prior.high[j]:.4g} goes {side} the points that have {outcome.label}, "
                      f"{at[:, j].min():.4g} to {at[:, j].max():.4g}: nothing is known of it there, and its emulator extrapolates"
                      for j, name in enumerate(prior.names)
                      if (side := beyond(at[:, j], (float(prior.low[j]), float(prior.high[j])), prior.is_log[j]))]
        if len(at) < needed:
            notes.append(f"{outcome.label}: {len(at)} points have it; {needed} are needed, so it is left out")
        elif np.ptp(values) == 0:
            found[outcome.label] = Constant(float(values[0]), len(prior.names))
        else:
            few += len(at) < enough
            found[outcome.label] = Emulator(prior.to_cube(at), values, runs, seed, linear=True)
    if few:
        notes.append(f"{few} of {len(found)} outcomes have fewer than {enough} points, {_enough_points} for each parameter: emulators are rough")
    return found, notes


def _judge_of(outcomes: Sequence[Outcome], emulators: dict[str, Emulator | Constant], how: _How, prior: Prior, notes: list[str]) -> _Judge | None:
    """None if the emulators tell no outcome that is fitted, and none is met nowhere."""
    if not emulators:
        return None
    judge = _Judge(outcomes, emulators, how, prior)
    for one in judge.outcomes:
        emulator = judge.emulators[one.label]
        if emulator.tells:
            continue
        (low, high), values = one.ends, emulator.values
        measured = f"{low:.4g}" if low == high else f"{low:.4g} to {high:.4g}"
        notes.append(f"{one.label}: is {values.mean():.4g} ({values.min():.4g} to {values.max():.4g}) at all points, measured is {measured}: it is "
                     "met nowhere" if judge.missed(one) else
                     f"{one.label}: depends on no parameter, as far as the points can tell: it excludes nothing")
    return judge if judge.names else None


def _wave(judge: _Judge | None, prior: Prior, frame: pandas.DataFrame, seed: int) -> Wave:
    if judge is None:
        all_of_it = _space.whole(len(prior.names), seed)
        region = _space.Region(all_of_it, 1.0, all_of_it[0], 0.0)
    else:
        region = _space.below(judge.depth, judge.how.cutoff, judge.cube, judge.deep(judge.known), seed)
    pandas, names = _pandas(), prior.names
    cube = np.unique(prior.snapped(region.sample), axis=0) if any(prior.whole or []) else region.sample
    sample = pandas.DataFrame(prior.from_cube(region.sample), columns=names)
    nothing = np.full((5, len(names)), np.nan)
    ends = np.percentile(region.sample, [0, 100, 5, 50, 95], axis=0) if len(sample) else nothing
    ranges = pandas.DataFrame(prior.from_cube(ends).T if len(sample) else nothing.T, index=names, columns=["low", "high", "5", "50", "95"])
    return Wave(len(frame[names].drop_duplicates()), region.share, ranges, sample, cube if len(sample) else region.best[None][:0])


def _match(waves: list[Wave], judge: _Judge, outcomes: Sequence[Outcome], frame: pandas.DataFrame, prior: Prior, notes: list[str]) -> Match:
    how = judge.how
    cube = waves[-1].cube
    if len(cube):
        rows = judge.rows(cube)
        best = cube[np.argmin((rows**2).sum(axis=1))]
    else:
        best, depth = _space.least(judge.depth, judge.cube, judge.deep(judge.known), how.seed)
        notes = [*notes, f"no parameters within the prior are plausible: even at the best point {how.allowed + 1} or more rows are off, the "
                         f"least of them by {depth:.2g} standard errors"]
    at_best = judge.rows(best[None])[0]
    table = _pandas().DataFrame({"plausible": (judge.known < how.cutoff).mean(axis=0), "least": judge.known.min(axis=0), "point": at_best},
                                index=judge.names)
    shown = [_shown(outcome, judge, cube if len(cube) else best[None], best, frame, prior) for outcome in outcomes]
    there = frame[prior.names].drop_duplicates().to_numpy(float)
    return Match(waves, _pandas().DataFrame(shown).set_index("outcome"), table,
                 _pandas().Series(prior.from_cube(best[None])[0], index=prior.names), notes, prior, how.allowed, how.cutoff,
                 dict(judge.emulators), judge, prior.to_cube(there), how.seed)


def _shown(outcome: Outcome, judge: _Judge, cube: Array, best: Array, frame: pandas.DataFrame, prior: Prior) -> dict[str, Any]:
    low, high = outcome.ends
    relative = judge.how.discrepancy
    row: dict[str, Any] = {"outcome": outcome.label, "row": outcome.of, "low": low, "high": high, "error": outcome.variance(relative)**0.5,
                           "points": len(values_of(frame, prior.names, outcome)[1])}
    blank = dict.fromkeys(("predicted", "predicted_error", "coverage", "mean", "5", "95", "implausibility"), float("nan"))
    emulator = judge.emulators.get(outcome.label)
    if emulator is None:
        return row | {"told": False} | blank | {"held_back": outcome.held_back}
    cube = prior.snapped(cube)
    mean, error = emulator(cube[:1000])
    seeds = emulator.scatter(cube[:1000]) / outcome.runs**0.5 if outcome.runs else 0.0
    drawn = mean + np.hypot(error, seeds) * np.random.default_rng(1).standard_normal((20, len(mean)))
    return row | {"told": emulator.tells, "predicted": emulator.explained, "predicted_error": emulator.explained_error, "coverage": emulator.coverage,
                  "mean": mean.mean(), "5": np.percentile(drawn, 5), "95": np.percentile(drawn, 95),
                  "implausibility": float(judge.one(outcome, best[None])[0]), "held_back": outcome.held_back}


