"""Exceptions with the messages of the program. Each exit code of the program has its exception."""
from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


class MatrigrateError(Exception):
    """Any failure of this package or of the program that it calls."""


@dataclass(frozen=True)
class Fault:
    """One fault of a scenario.

    >>> print(Fault("ecm.radius", "-1 um is out of range; allowed is >= 10 and <= 2000 um"))
    ecm.radius: -1 um is out of range; allowed is >= 10 and <= 2000 um
    """

    key: str  #: the parameter, such as ``"ecm.radius"``; empty if none is meant
    message: str
    file: str = ""
    line: int = 0  #: 0 where there is none
    column: int = 0

    def __str__(self) -> str:
        place = self.file + (f":{self.line}:{self.column}" if self.line else "")
        return ": ".join(part for part in (place, self.key, self.message) if part)


class ConfigurationError(MatrigrateError, ValueError):
    """The scenario or study is wrong (exit code 3). ``faults`` lists all that is wrong with it."""

    def __init__(self, faults: list[Fault] | Fault | str) -> None:
        if isinstance(faults, str):
            faults = Fault("", faults)
        self.faults: list[Fault] = [faults] if isinstance(faults, Fault) else list(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))


def refuse(faults: list[str]) -> None:
    """:raises ConfigurationError: with all of these, if there are any"""
    if faults:
        raise ConfigurationError("\n".join(faults))


class UnknownParameter(ConfigurationError, AttributeError):
    """There is no parameter or section of that name."""


class _OfFolder(MatrigrateError):
    """A failure of a run; ``folder`` holds its partial results, if any were written."""

    def __init__(self, words: str, folder: Path | None = None) -> None:
        super().__init__(words)
        self.folder = folder


class NumericalError(_OfFolder):
    """The run failed numerically, or a run of a study did; or memory ran out, or the program crashed (exit code 4)."""


class InputOutputError(_OfFolder, OSError):
    """A file could not be read or written, is damaged, or would be overwritten (exit code 5)."""


class Stopped(_OfFolder):
    """The program was stopped by a signal or a limit of time, with a checkpoint (exit codes 75 and 130).

    The same call with the same folder goes on.
    """


class UsageError(MatrigrateError):
    """The program does not know a verb or an option (exit code 2): most often another version of it."""


class InternalError(MatrigrateError):
    """A fault of the program (exit code 1), or the program was killed."""


class ProgramNotFound(MatrigrateError):
    """The program ``matrigrate`` is neither on PATH nor named by the environment variable MATRIGRATE."""


class KeyboardStop(KeyboardInterrupt):
    """Ctrl-C, after the program has written its checkpoint: a KeyboardInterrupt that names the folder to go on with."""

    def __init__(self, folder: Path) -> None:
        super().__init__(f"stopped; partial results and a checkpoint are in {folder}; the same call continues")
        self.folder = folder


class CoreNotFound(MatrigrateError, ImportError):
    """The compiled module of this package is not there."""
