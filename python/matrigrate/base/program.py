"""The program `matrigrate`: where it is, calling it, and its exit codes as exceptions; and the live page."""
from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import webbrowser
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from ..errors import ConfigurationError, Fault, InputOutputError, InternalError, NumericalError, ProgramNotFound, Stopped, UsageError

_look_every = 0.2  # s


@dataclass(frozen=True)
class Outcome:
    """How a call ended: exit code, and what was printed."""

    code: int
    out: str
    err: str

    @property
    def words(self) -> str:
        return "\n".join(line.removeprefix("matrigrate: ") for line in self.err.strip().splitlines())


@contextmanager
def temporary_scenario(name: str, text: str) -> Iterator[Path]:
    """A scenario in a file of its name, as long as it is used."""
    stem = re.sub(r"[^\w.+-]", "_", name) or "scenario"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / f"{stem}.toml"
        file.write_text(text, encoding="utf-8")
        yield file


def find() -> str | None:
    """The program: what the environment variable MATRIGRATE names, else the one in the wheel, else the first on PATH; none if there is none."""
    named = os.environ.get("MATRIGRATE")
    inside = Path(__file__).parents[1] / "bin" / "matrigrate"
    return str(inside) if not named and inside.is_file() else shutil.which(named or "matrigrate")


def program() -> str:
    found = find()
    if found is None:
        named = os.environ.get("MATRIGRATE")
        where = f"the environment variable MATRIGRATE names {named}, which is no program" if named else \
            "the program matrigrate is not on PATH, and the environment variable MATRIGRATE does not name it"
        raise ProgramNotFound(f"{where}. Reading results needs no program; running does: build it (./demo in a clone "
                              "of Matrigrate), then set MATRIGRATE=/path/to/build/release/bin/matrigrate")
    return found


def call(words: Sequence[str], watch: Callable[[], None] | None = None) -> Outcome:
    """Calls the program, and `watch` several times a second meanwhile. If that or Ctrl-C ends the wait, the program is
    asked to stop, and waited for: it writes its checkpoint."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        try:
            process = subprocess.Popen([program(), *words], stdout=out, stderr=err, stdin=subprocess.DEVNULL,
                                       env=os.environ | {"NO_COLOR": "1"})
        except OSError as error:
            raise ProgramNotFound(f"{program()}: cannot be started: {error.strerror}") from None
        try:
            _wait(process, watch)
        except KeyboardInterrupt:
            _stop(process, signal.SIGINT)
            raise
        except BaseException:
            _stop(process, signal.SIGTERM)
            raise
        return Outcome(process.returncode, _text(out), _text(err))


def _wait(process: subprocess.Popen[bytes], watch: Callable[[], None] | None) -> None:
    while process.poll() is None:
        with suppress(subprocess.TimeoutExpired):
            process.wait(_look_every if watch else None)
        if watch:
            watch()


def _stop(process: subprocess.Popen[bytes], how: signal.Signals) -> None:
    """A terminal sends Ctrl-C to the program as well; it takes two within a second for one."""
    process.send_signal(how)
    try:
        process.wait()
    except KeyboardInterrupt:
        process.kill()
        process.wait()
        raise


def _text(file: IO[bytes]) -> str:
    file.seek(0)
    return file.read().decode("utf-8", "replace")


def check(file: Path) -> None:
    """Raises ConfigurationError with all faults of a scenario or study file."""
    outcome = call(["check", str(file), "--json"])
    try:
        findings = json.loads(outcome.out)["files"]
    except (ValueError, KeyError):
        raise_for(outcome, None)
        return
    faults = [Fault(f["key"], f["message"]) for finding in findings for f in finding["faults"]]
    if faults and outcome.code == 5:
        raise InputOutputError(faults[0].message)
    if faults:
        raise ConfigurationError(faults)


_fault_line = re.compile(r"(?:(?P<file>[^:\s][^:]*)(?::(?P<line>\d+)(?::(?P<column>\d+))?)?: )?"
                         r"(?:(?P<key>[a-z_]+(?:\.[a-z0-9_]+)*): )?(?P<message>.*)")


def faults_of(words: str, hidden: Path | None) -> list[Fault]:
    """Faults from lines "file:line:column: key: message". @param hidden  a file that the user does not know of"""
    faults = []
    for line in words.splitlines():
        match = _fault_line.fullmatch(line)
        assert match is not None  # the last group takes anything
        file = match["file"] or ""
        place = () if file == str(hidden or "") else (file, int(match["line"] or 0), int(match["column"] or 0))
        faults.append(Fault(match["key"] or "", match["message"], *place))
    return faults


def raise_for(outcome: Outcome, folder: Path | None, hidden: Path | None = None) -> None:
    """The exception of an exit code, with the program's words; none of 0."""
    code, words = outcome.code, outcome.words or _reason(outcome.out)
    if code == 0:
        return
    if code == 3:
        raise ConfigurationError(faults_of(words, hidden))
    if hidden is not None:
        words = words.replace(str(hidden), hidden.stem)
    if code == 2:
        raise UsageError(f"{words}\n(the program is {find()})")
    if code in (4, 5, 75, 130):
        kind: Any = {4: NumericalError, 5: InputOutputError}.get(code, Stopped)
        raise kind(words, folder if folder is not None and folder.exists() else None)
    if code < 0:
        words = f"was ended by {signal.Signals(-code).name}. {words}".strip()
    raise InternalError(f"matrigrate {words}" if code < 0 else words or f"exit code {code}")


def _reason(out: str) -> str:
    try:
        return str(json.loads(out)["reason"])
    except (ValueError, KeyError, TypeError):
        return out.strip()


def live(*, show: bool = True) -> Path:
    """Opens the live page in the browser, and returns where it is: a cell is computed there while you watch. The page is
    one file that needs neither network nor program; a copy of it works as well.

    :param show: False only returns where it is
    :raises InputOutputError: if neither this package nor the program has the page, saying where to get it
    """
    page = Path(__file__).parents[1] / "live.html"
    if not page.is_file():
        if find() is None:
            raise InputOutputError(f"the live page is not here: there is no {page}, and no program that has it. The wheel, the Debian "
                                   "package and the folder of a release have the page; a clone has it in live/")
        outcome = call(["live", "--print"])
        raise_for(outcome, None)
        page = Path(outcome.out.strip())
    if show:
        webbrowser.open(page.as_uri())
    return page
