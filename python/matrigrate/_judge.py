"""What the program says of values and names: the compiled module is asked, or without it the program."""
from __future__ import annotations

import importlib.machinery
import importlib.util
import json
import os
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType

from . import _program
from .errors import MatrigrateError

_most_kept = 100_000


@dataclass(frozen=True)
class Answer:
    fault: str  #: what is wrong; empty if nothing is
    number: float  #: of a good number, in the documented unit; of all else 0


_kept: dict[str, Answer] = {}


def ask(questions: list[str]) -> list[Answer]:
    """The answers to questions in JSON (src/parameters/judge.hpp). Questions asked before are not asked again.

    :raises ProgramNotFound: without the compiled module and without the program
    """
    if len(_kept) > _most_kept:
        _kept.clear()
    new = [question for question in dict.fromkeys(questions) if question not in _kept]
    if new:
        answers = json.loads(_answers(f"[{', '.join(new)}]"))
        _kept.update(zip(new, (Answer(a["fault"], float(a["number"])) for a in answers), strict=True))
    return [_kept[question] for question in questions]


def _answers(questions: str) -> str:
    try:
        return str(core().judged(questions))
    except (ImportError, AttributeError):  # no module, or one of an earlier version
        pass
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "values.json"
        file.write_text(questions, encoding="utf-8")
        outcome = _program.call(["check", "--values", str(file)])
    _program.raise_for(outcome, None)
    return outcome.out


class CoreNotFound(MatrigrateError, ImportError):
    """The compiled module of this package is not there."""


def core() -> ModuleType:
    """The compiled module: beside this file, or where the environment variable MATRIGRATE_CORE says."""
    name = "matrigrate._core"
    if name in sys.modules:
        return sys.modules[name]
    places = [os.environ.get("MATRIGRATE_CORE", ""), *map(str, Path(__file__).parent.glob("_core*.so"))]
    found = next((place for place in places if place and Path(place).is_file()), None)
    if found is None:
        raise CoreNotFound("this package was installed without its compiled module, so it cannot step a simulation "
                           "(matrigrate.run does); on Debian 12, in a clone of Matrigrate, python/install.sh builds the "
                           "module and installs the package with it into a virtual environment")
    spec = importlib.util.spec_from_file_location(name, found,
                                                  loader=importlib.machinery.ExtensionFileLoader(name, found))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[name] = module
    return module
