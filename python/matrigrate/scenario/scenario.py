"""Scenarios: all parameters of a simulation, with their units and ranges."""
from __future__ import annotations

import os
import re
import tempfile
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import AbstractContextManager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..base import arguments, program
from ..base.files import require_regular
from ..base.load_core import core
from ..errors import ConfigurationError, Fault, InputOutputError
from . import constants, schema
from .schema import Parameter, Value
from .sections import Sections, classes, help_text, of, unknown

_usual_adaptive_step = 5.0  # s; the reference has the schema's default


def _file_of(text: str) -> tuple[str, str] | None:
    """The name of a file and what follows it, of the text of a field; None of a formula.

    >>> _file_of("my map.csv column=E")
    ('my map.csv', ' column=E')
    >>> _file_of("'a x=1.PNG' pixel=1")
    ('a x=1.PNG', ' pixel=1')
    >>> _file_of("200 + x")
    """
    text = text.strip()
    if quoted := re.match(r"""(["'])((?:\\.|(?!\1).)*)\1""", text, re.DOTALL):
        return re.sub(r"\\(.)", r"\1", quoted[2]), text[quoted.end():]
    head = re.split(r"\s[A-Za-z_]+=(?!=)", text, maxsplit=1)[0]
    ends = list(re.finditer(r"\S\.(csv|png|tiff?)(?=\s|$)", head, re.IGNORECASE))
    return (text[:ends[-1].end()], text[ends[-1].end():]) if ends else None


class Scenario(Sections, Mapping[str, Value]):
    """All parameters of a simulation. A parameter that is not set has its default.

    >>> scenario = Scenario()
    >>> scenario.ecm.youngs_modulus                       # Pa
    200.0
    >>> scenario.ecm.youngs_modulus = "0.05 kPa"
    >>> scenario.ecm.youngs_modulus
    50.0
    >>> scenario["run.duration"] = 2                      # a bare number is in the documented unit, here hours
    >>> scenario.given()
    {'ecm.youngs_modulus': '0.05 kPa', 'run.duration': 2}
    >>> scenario.ecm.youngs_modulus = "50 s"
    Traceback (most recent call last):
      ...
    matrigrate.errors.ConfigurationError: ecm.youngs_modulus: "50 s" is a time, but a stress is expected; write it like "200 Pa"
    >>> scenario.ecm.youngs_modulu = 3
    Traceback (most recent call last):
      ...
    matrigrate.errors.UnknownParameter: ecm.youngs_modulu: there is no such parameter; did you mean ecm.youngs_modulus?
    """

    def __init__(self, values: Mapping[str, Any] | None = None, *, name: str = "scenario") -> None:
        """:param values: as in a file, ``{"ecm": {"radius": "60 um"}}``, or flat, ``{"ecm.radius": "60 um"}``; with the key
            ``version``, which files of the program have, a parameter that is left out has the value of what was done
            before there was such a parameter
        :param name: of the folder of a run, where none is given
        """
        self.name = arguments.text("name", name)
        self._given: dict[str, Value] = {}
        self._cells: list[dict[str, Value]] = []
        self._changes: list[dict[str, Value]] = []
        faults: list[Fault] = []
        given = dict(arguments.mapping("values", values))
        written = given.pop("version", None) is not None  # by a program
        flat = list(_flat(given))
        gone = schema.gone()
        for path, value, nested in flat:
            if path in gone:  # earlier versions had it; one value is left
                if not gone[path]["any"] and schema.plain(value) != gone[path]["left"]:
                    faults.append(Fault(path, gone[path]["fate"].replace("{}", schema.toml_text(schema.plain(value)))))
                continue
            try:
                if nested:
                    raise unknown(path, is_section=True)
                self[path] = value
            except ConfigurationError as error:
                faults += error.faults
        if faults:
            raise ConfigurationError(faults)
        if written:
            for p in schema.parameters().values():
                if p.before is not None and p.path not in self._given:
                    self._given[p.path] = self[p.before] if p.before in schema.parameters() else p.before

    @classmethod
    def preset(cls, name: str) -> Scenario:
        """One of the presets of ``matrigrate list``, such as "soft". Asks the program for it.

        :raises ConfigurationError: if there is none of that name
        :raises ProgramNotFound: without the program
        """
        arguments.text("name", name, "the name of a preset")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "preset.toml"
            outcome = program.call(["new", str(file), "--preset", name, "--schema", "none"])
            if outcome.code != 0:
                raise ConfigurationError(outcome.words.split("\nmatrigrate new")[0])
            return cls(_read(file), name=name)

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> Scenario:
        """A scenario file.

        :raises ConfigurationError: with all that is wrong with it
        :raises InputOutputError: if it cannot be read
        """
        path = arguments.path("file", file)
        scenario = cls(_read(path), name=path.stem)
        for p in schema.parameters().values():
            text = str(scenario._given.get(p.path, ""))
            if p.kind == "field" and (named := _file_of(text)):  # relative names count from the file
                name, options = named
                whole = str(path.resolve().parent / name)
                if re.search(r"\s", whole):
                    whole = '"' + re.sub(r'(["\\])', r"\\\1", whole) + '"'
                scenario._given[p.path] = whole + options
        return scenario

    def __getitem__(self, path: str) -> Value:
        if path == constants.path:
            return str(self.laws.constants)
        if name := constants.name_in(path):
            return self.laws.constants[name]
        p = _row(path)
        if path == "run.time_step" and path not in self._given and self["run.integrator"] == "adaptive":
            return _usual_adaptive_step
        return p.number(self._given.get(path, p.default))

    @property
    def cells(self) -> list[tuple[float, float]]:
        """Centres of several cells at the start [um]; empty: one cell, at cell.start_x, cell.start_y.

        >>> scenario = Scenario()
        >>> scenario.cells = [(-20, 0), {"x": "20 um", "y": 0}]
        >>> scenario.cells
        [(-20.0, 0.0), (20.0, 0.0)]
        """
        rows = schema.cell_parameters()
        return [(float(rows["x"].number(cell["x"])), float(rows["y"].number(cell["y"]))) for cell in self._cells]

    def _set_cells(self, cells: Any) -> None:
        rows = schema.cell_parameters()
        found: list[dict[str, Value]] = []
        faults: list[Fault] = []
        for k, cell in enumerate(cells, start=1):
            one = dict(cell) if isinstance(cell, Mapping) else dict(zip(rows, cell, strict=True))
            one = {key: schema.plain(value) for key, value in one.items()}
            faults += [Fault(f"cells[{k}].{key}", "there is no such key; a cell has x and y") for key in one if key not in rows]
            faults += [Fault(f"cells[{k}]", f'has no {key}; write it like {key} = "40 um"') for key in rows if key not in one]
            wrong = {key: rows[key].fault(value) for key, value in one.items() if key in rows}
            faults += [Fault(f"cells[{k}].{key}", fault) for key, fault in wrong.items() if fault]
            found.append(one)
        if faults:
            raise ConfigurationError(faults)
        self._cells = found

    @property
    def changes(self) -> list[dict[str, Value]]:
        """Parameters that change in the middle of a run: for each time ``at`` the values from then on, as typed.

        >>> scenario = Scenario()
        >>> scenario.changes = [{"at": "2 h", "actomyosin.force": "0.3 nN"}, {"at": 4, "actomyosin": {"force": 0.6}}]
        >>> scenario.changes
        [{'at': '2 h', 'actomyosin.force': '0.3 nN'}, {'at': 4, 'actomyosin.force': 0.6}]
        """
        return [dict(change) for change in self._changes]

    def _set_changes(self, changes: Any) -> None:
        found: list[dict[str, Value]] = []
        faults: list[Fault] = []
        for k, change in enumerate(arguments.one_of("changes", changes, list, tuple), start=1):
            one: dict[str, Value] = {}
            for path, value, _ in _flat(arguments.mapping(f"changes[{k}]", change)):
                alone = path == constants.path and isinstance(value, Mapping)  # of which a change sets each alone
                values = {f"{path}.{name}": value[name] for name in value} if alone else {path: value}
                one |= {key: schema.plain(single) for key, single in values.items()}
            if "at" not in one:
                faults.append(Fault(f"changes[{k}]", 'has no time; write it like at = "3 h"'))
            elif len(one) == 1:
                faults.append(Fault(f"changes[{k}].at", "nothing changes then; write below it a parameter with its "
                                                        'new value, such as ecm.youngs_modulus = "100 Pa"'))
            wrong = {path: schema.judge(f"changes.{path}", value)[0] for path, value in one.items()
                     if not constants.name_in(path)}  # which the program judges
            faults += [Fault(f"changes[{k}].{path}", fault) for path, fault in wrong.items() if fault]
            found.append(one)
        if faults:
            raise ConfigurationError(faults)
        self._changes = found

    def _numbers_of_changes(self) -> list[dict[str, Value]]:
        """The changes as numbers in the documented units, in the order of their times."""
        def number(path: str, value: Value) -> Value:
            if path == "at":
                return schema.judge("changes.at", value)[1]
            return value if constants.name_in(path) else _row(path).number(value)
        numbers = [{path: number(path, value) for path, value in change.items()} for change in self._changes]
        return sorted(numbers, key=lambda change: float(change["at"]))

    def __setitem__(self, path: str, value: Any) -> None:
        if path in ("cells", "changes"):
            setattr(self, path, value)
            return
        if name := constants.name_in(path):
            self.laws.constants[name] = value
            return
        p = _row(path)
        value = schema.plain(value)
        if isinstance(value, Mapping) and path == constants.path:
            constants.read(value)
        elif fault := p.fault(value):
            raise ConfigurationError(Fault(path, fault))
        self._given[path] = value

    def __delitem__(self, path: str) -> None:
        """Gives a parameter its default again."""
        if name := constants.name_in(path):
            del self.laws.constants[name]
            return
        self[path]
        self._given.pop(path, None)

    def __iter__(self) -> Iterator[str]:
        return iter(schema.parameters())

    def __len__(self) -> int:
        return len(schema.parameters())

    if not TYPE_CHECKING:  # else no checker would find a section that does not exist

        def __getattr__(self, name):
            if name.startswith("_"):
                raise AttributeError(name)
            raise unknown(name, is_section=True)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in classes:
            raise ConfigurationError(Fault(name, "is a section; set one of its parameters, such as "
                                                 f"{of(name)[0].path}"))
        if name in ("cells", "changes"):
            take = self._set_cells if name == "cells" else self._set_changes
            take(value)
            return
        if name not in ("name", "_given", "_cells", "_changes"):
            raise unknown(name, is_section=True)
        object.__setattr__(self, name, value)

    def __dir__(self) -> list[str]:
        return [*classes, *(n for n in super().__dir__() if n not in classes)]

    def __eq__(self, other: object) -> bool:
        return (isinstance(other, Scenario) and dict(self) == dict(other) and self.cells == other.cells
                and self._numbers_of_changes() == other._numbers_of_changes())

    __hash__ = None  # type: ignore[assignment] # it can change

    def __repr__(self) -> str:
        changed = ", ".join(f"{path}={schema.toml_text(value)}" for path, value in self.changed().items())
        cells = f"{len(self._cells)} cells" if self._cells else ""
        changes = f"{len(self._changes)} changes" if self._changes else ""
        return f"Scenario({self.name}: {', '.join(filter(None, (cells, changed, changes))) or 'all defaults'})"

    def __copy__(self) -> Scenario:
        return self.copy()

    def given(self) -> dict[str, Value]:
        """The values that were set, as typed; all other parameters have their defaults."""
        return dict(self._given)

    def changed(self) -> dict[str, Value]:
        """The values that differ from the defaults, as typed."""
        rows = schema.parameters()
        return {path: value for path, value in self._given.items()
                if self[path] != rows[path].number(rows[path].default)}

    def copy(self, name: str | None = None) -> Scenario:
        """A scenario of the same values, to be changed apart from this one."""
        made = Scenario(self._given, name=name or self.name)
        made._cells = [dict(cell) for cell in self._cells]
        made._changes = self.changes
        return made

    def help(self, path: str) -> str:
        """Meaning, unit, range and default of a parameter.

        >>> print(Scenario().help("ecm.viscosity"))
        Viscosity of the matrix, intact or degraded (mu); > 0 and <= 1e9 Pa s. A bare number is in Pa s. Default: "1000 Pa s" (Heck et al. 2020, Table 1).
        """
        return help_text(self._row(path))

    def unit(self, path: str) -> str:
        """The unit of a bare number, and of what reading gives: "Pa"; "1" of ratios and counts, empty of words."""
        return self._row(path).unit

    def _row(self, path: str) -> Parameter:
        name = constants.name_in(path)
        return self.laws.constants.row(name) if name else _row(path)

    def toml(self) -> str:
        """The text of a scenario file: what was set, each with its meaning and range."""
        text = "# A scenario of Matrigrate. What is left out has its default.\n"
        for section, title in schema.sections().items():
            rows = [p for p in of(section) if p.path in self._given]
            text += f"\n# {title}\n[{section}]\n" if rows else ""
            for p in rows:
                value = self._given[p.path]
                lines = f"[{p.path}]\n{_lines(value)}" if isinstance(value, Mapping) else _lines({p.key: value})
                text += f"# {p.meaning}; {p.allowed}\n{lines}"
        for cell in self._cells:
            text += f"\n[[cells]]\n{_lines(cell)}"
        for change in self._changes:
            text += f"\n[[changes]]\n{_lines(change)}"
        return text

    def save(self, file: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes a scenario file that the program accepts, after asking the program, where it is installed.

        An existing file is kept, unless ``overwrite``.

        :raises ConfigurationError: with all that the program finds wrong; nothing was written
        :raises InputOutputError: if the file exists or cannot be written
        """
        path = arguments.path("file", file)
        if program.find() is not None:
            self.check()
        try:
            with open(path, "w" if overwrite else "x", encoding="utf-8") as out:
                out.write(self.toml())
        except FileExistsError:
            raise InputOutputError(f"{path}: exists and is not overwritten; choose another name, or overwrite=True",
                                   path.parent) from None
        except OSError as error:
            raise InputOutputError(f"{path}: cannot be written: {error.strerror}", path.parent) from None
        return path

    def check(self) -> None:
        """Asks the program, which also judges parameters together; raises ConfigurationError with all faults."""
        with self._as_file() as file:
            program.check(file)

    @property
    def closures(self) -> str:
        """The set of closures that the values belong to, "third set"; "mixed: ..." with the parameters of each set.

        :raises CoreNotFound: if the package was installed without its compiled module
        """
        return core().closures(self.toml(), self.name)

    def _as_file(self) -> AbstractContextManager[Path]:
        return program.temporary_scenario(self.name, self.toml())


def _lines(table: Mapping[str, Any]) -> str:
    return "".join(f"{key} = {schema.toml_text(value)}\n" for key, value in table.items())


def _row(path: str) -> Parameter:
    p = schema.parameters().get(arguments.text("path", path, 'a name such as "ecm.youngs_modulus"'))
    if p is None:
        raise unknown(path)
    return p


def _flat(values: Mapping[str, Any]) -> Iterator[tuple[str, Any, bool]]:
    """Path, value, and whether it is a table that is no section."""
    for name, value in values.items():
        if name in classes and isinstance(value, Mapping):
            for key, inner in value.items():
                path = f"{name}.{key}"
                if path in classes:
                    yield from _flat({path: inner})
                else:
                    yield path, inner, False
        elif name in classes:
            raise ConfigurationError(Fault(name, f"is a section; write [{name}] and its keys below, each on a line"))
        else:
            yield name, value, isinstance(value, Mapping) and name != constants.path


def _read(path: Path) -> dict[str, Any]:
    require_regular(path)
    try:
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except tomllib.TOMLDecodeError as error:
        raise ConfigurationError(Fault("", f"cannot be read as TOML: {error}", str(path))) from None
    except UnicodeDecodeError:
        raise ConfigurationError(Fault("", "is no text", str(path))) from None
    except OSError as error:
        raise InputOutputError(f"{path}: cannot be read: {error.strerror}", path.parent) from None
