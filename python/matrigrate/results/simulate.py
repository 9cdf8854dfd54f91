"""Runs and studies by the program, as a process of its own."""
from __future__ import annotations

import json
import os
import re
import tomllib
from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any

from ..base import arguments, program
from ..base.files import read_text
from ..errors import KeyboardStop
from ..scenario.scenario import Scenario
from ..scenario.schema import toml_text
from .results import Run, load
from .studies import Study, load_study

Progress = Callable[[float, float], None]  #: called with simulated time [s] and the share that is done [0 to 1]


def run(scenario: Scenario | str | os.PathLike[str], out: str | os.PathLike[str] | None = None, *,
        seed: int | None = None, hours: float | None = None, overrides: Mapping[str, Any] | None = None,
        threads: int | None = None, wall_time: str | None = None, force: bool = False,
        progress: Progress | None = None) -> Run:
    """Simulates one cell, and loads what was written. The results have the bits of ``matrigrate run``, which does it.

    A folder that holds the same scenario and seed is resumed; one that is done is loaded as it is. Ctrl-C ends the run
    with a checkpoint and raises KeyboardInterrupt; the same call goes on.

    :param scenario: a Scenario or the path of a scenario file
    :param out: folder for the results; ``<scenario>-seed<N>`` if left out, and what the overrides change
    :param seed: of the random numbers
    :param hours: simulated time [h]
    :param overrides: further parameters, ``{"ecm.youngs_modulus": "50 Pa"}``
    :param threads: to compute with; never changes a result
    :param wall_time: stop with a checkpoint after this time of the clock, "2 h", and raise Stopped
    :param force: start again in a folder that holds another run, whose files are removed
    :param progress: called several times a second with simulated time [s] and the share done [0 to 1]
    :raises ConfigurationError: with all that is wrong with the scenario; nothing was written
    :raises NumericalError: if the run fails; its ``folder`` can be loaded
    :raises InputOutputError: if the folder holds another run, or cannot be written
    :raises Stopped: if a signal or ``wall_time`` stopped it, with a checkpoint
    :raises UsageError: if the program refuses an option
    :raises TypeError: if scenario, out, overrides or progress is of a wrong type
    :raises ProgramNotFound: without the program
    """
    overrides = arguments.mapping("overrides", overrides)
    arguments.function("progress", progress)
    folder = None if out is None else arguments.path("out", out)
    with _file_of(scenario) as file:
        words = ["run", str(file), "--json", "--quiet"]
        words += ["--temporary-file"] if isinstance(scenario, Scenario) else []
        for option, value in (("--seed", seed), ("--hours", hours), ("--threads", threads), ("--wall-time", wall_time)):
            words += [] if value is None else [option, str(value)]
        for key, value in overrides.items():
            words += ["--set", f"{key}={_override(value)}"]
        words += ["--force"] if force else []
        folder = folder or _default_folder(file, seed, overrides)
        watch = _Watch(folder, progress) if progress is not None else None
        _call(words, folder, watch, file if isinstance(scenario, Scenario) else None)
    done = load(folder)
    if watch is not None:
        watch.tell(float(done.record["t_s"]), 1.0)
    return done


def run_study(file: str | os.PathLike[str], out: str | os.PathLike[str] | None = None, *,
              jobs: int | None = None) -> Study:
    """Computes the runs of a study file that are missing, as ``matrigrate study run``, and loads the study.

    :param out: folder of the study; ``<file>-study`` if left out
    :param jobs: runs at a time; as many as there are cores if left out
    :raises NumericalError: if a run failed; the others are done, and ``load_study`` reads them
    :raises ConfigurationError: with all that is wrong with the study
    :raises InputOutputError: if the file cannot be read, or the folder holds another study
    :raises TypeError: if file or out is no path
    :raises ProgramNotFound: without the program
    """
    file = arguments.path("file", file, "the path of a study file")
    folder = arguments.path("out", out) if out is not None else Path(f"{file.stem}-study")
    _call(["study", "run", str(file), "--quiet"] + ([] if jobs is None else ["--jobs", str(jobs)]), folder)
    return load_study(folder)


def _call(words: list[str], folder: Path, watch: _Watch | None = None, hidden: Path | None = None) -> None:
    """:param hidden: a file that the user does not know of"""
    try:
        outcome = program.call([*words, "-o", str(folder)], watch)
    except KeyboardInterrupt:
        raise KeyboardStop(folder) from None
    program.raise_for(outcome, folder, hidden)


def _file_of(scenario: Scenario | str | os.PathLike[str]) -> AbstractContextManager[Path]:
    if isinstance(scenario, Scenario):
        return scenario._as_file()
    return nullcontext(arguments.path("scenario", scenario, "a Scenario or the path of a file"))


def _override(value: Any) -> str:
    return value if isinstance(value, str) else toml_text(value)


def _default_folder(file: Path, seed: int | None, overrides: Mapping[str, Any]) -> Path:
    """The folder that the program would choose. Unreadable values are left to the program, which reports them."""
    seed = overrides.get("run.seed") if seed is None else seed
    if seed is None:
        try:
            seed = tomllib.loads(read_text(file).removeprefix("\ufeff")).get("run", {}).get("seed", 1)
        except (OSError, ValueError, AttributeError):
            seed = 1
    name = f"{file.stem}-seed{seed}"
    for key, value in overrides.items():
        if key not in ("run.seed", "run.threads"):
            name += f"-{key.rsplit('.', 1)[-1]}-" + re.sub(r"[^A-Za-z0-9._-]", "", _override(value))
    return Path(name[:120])


class _Watch:
    """Tells how far a run is, by the last row of tracks.csv; says each time once."""

    def __init__(self, folder: Path, progress: Progress) -> None:
        self._folder, self._progress, self._told = folder, progress, -1.0

    def __call__(self) -> None:
        try:
            record = json.loads((self._folder / "run.json").read_text())
            if record["status"] != "running":
                return
            with open(self._folder / "tracks.csv", "rb") as tracks:
                header = tracks.readline().decode().strip().split(",")
                tracks.seek(max(tracks.tell(), tracks.seek(0, os.SEEK_END) - 4096))
                row = tracks.read().decode().rsplit("\n", 2)[-2].split(",")
            t, whole = float(row[header.index("t_s")]), float(record["duration_s"])
        except (OSError, ValueError, KeyError, IndexError):
            return  # its first files are being written
        self.tell(t, min(1.0, t / whole))

    def tell(self, t: float, share: float) -> None:
        if t > self._told:
            self._told = t
            self._progress(t, share)
