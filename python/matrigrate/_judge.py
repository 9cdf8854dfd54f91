"""Judges values and names, by the compiled module or, without the module, by the program."""
from __future__ import annotations

import json
import tempfile
from dataclasses import dataclass
from pathlib import Path

from . import _program
from ._load_core import core

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
