"""Scenarios: all parameters of a simulation, with their units and ranges."""
from __future__ import annotations

import os
import re
import tempfile
import tomllib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from . import _program, _schema
from ._schema import Parameter, Value
from .errors import ConfigurationError, Fault, InputOutputError, UnknownParameter

_usual_adaptive_step = 5.0  # s; that of the reference is the schema's default


class Section:
    """The parameters of one section of a scenario, as attributes.

    Reading gives a number in the documented unit; writing takes such a number, or a text with a unit.
    """

    _name = ""
    _scenario: Scenario

    def __init__(self, scenario: Scenario) -> None:
        object.__setattr__(self, "_scenario", scenario)

    def __getattr__(self, key: str) -> Value:
        if key.startswith("_"):
            raise AttributeError(key)
        if f"{self._name}.{key}" in _classes:
            return _classes[f"{self._name}.{key}"](self._scenario)
        raise _unknown(f"{self._name}.{key}")

    def __setattr__(self, key: str, value: Any) -> None:
        self._scenario[f"{self._name}.{key}"] = value

    def __dir__(self) -> list[str]:
        return [p.key for p in _of(self._name)]

    def __repr__(self) -> str:
        lines = [f"[{self._name}] {_schema.sections()[self._name]}; * differs from its default"]
        changed = self._scenario.changed()
        for p in _of(self._name):
            mark = "*" if p.path in changed else " "
            value, unit = self._scenario[p.path], "" if p.unit == "1" else f" {p.unit}".rstrip()
            shown = f"{value:g}{unit}" if isinstance(value, float) else f"{_schema.toml_text(value)}{unit}"
            lines.append(f"{mark} {p.key:<20} {shown:<18} {p.meaning}; {p.allowed}")
        return "\n".join(lines)


def help_text(p: Parameter) -> str:
    """What a parameter means, its unit and range, and where its default is from."""
    unit = f" A bare number is in {p.unit}." if p.kind in ("quantity", "angle") else ""
    return f"{p.meaning}; {p.allowed}.{unit} Default: {_schema.toml_text(p.default)} ({p.source})."


def _of(section: str) -> list[Parameter]:
    return [p for p in _schema.parameters().values() if p.path.rsplit(".", 1)[0] == section]


def _attribute(p: Parameter) -> property:
    def read(self: Section) -> Value:
        return self._scenario[p.path]

    def write(self: Section, value: Value) -> None:
        self._scenario[p.path] = value

    return property(read, write, doc=help_text(p))


def _section_class(name: str, title: str) -> type[Section]:
    attributes: dict[str, Any] = {p.key: _attribute(p) for p in _of(name)}
    return type(name.title().replace(".", ""), (Section,), attributes | {"_name": name, "__doc__": title + "."})


_classes = {name: _section_class(name, title) for name, title in _schema.sections().items()}


def _unknown(path: str, is_section: bool = False) -> UnknownParameter:
    return UnknownParameter(Fault(path, _schema.unknown_words(path, is_section)))


def _plain(value: Any) -> Any:
    """Numbers of numpy as those of Python."""
    return value.item() if type(value).__module__ == "numpy" and getattr(value, "ndim", 1) == 0 else value


class Scenario(Mapping[str, Value]):
    """All parameters of a simulation. What is not set has its default.

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
        """:param values: as in a file, ``{"ecm": {"radius": "60 um"}}``, or flat, ``{"ecm.radius": "60 um"}``
        :param name: of the folder of a run, where none is given
        """
        self.name = name
        self._given: dict[str, Value] = {}
        self._cells: list[dict[str, Value]] = []
        faults: list[Fault] = []
        for path, value, nested in _flat(values or {}):
            try:
                if nested:
                    raise _unknown(path, is_section=True)
                self[path] = value
            except ConfigurationError as error:
                faults += error.faults
        if faults:
            raise ConfigurationError(faults)

    @classmethod
    def preset(cls, name: str) -> Scenario:
        """One of the presets of ``matrigrate list``, such as "soft". Asks the program for it."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "preset.toml"
            outcome = _program.call(["new", str(file), "--preset", name, "--schema", "none"])
            if outcome.code != 0:
                raise ConfigurationError(outcome.words.split("\nmatrigrate new")[0])
            return cls(_read(file), name=name)

    @classmethod
    def load(cls, file: str | os.PathLike[str]) -> Scenario:
        """A scenario file."""
        path = Path(file)
        scenario = cls(_read(path), name=path.stem)
        for p in _schema.parameters().values():
            text = str(scenario._given.get(p.path, ""))
            if p.kind == "field" and re.match(r"\S+\.(csv|png|tiff?)( |$)", text):  # relative names count from the file
                scenario._given[p.path] = str(path.resolve().parent / text)
        return scenario

    def __getitem__(self, path: str) -> Value:
        p = _schema.parameters().get(path)
        if p is None:
            raise _unknown(path)
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
        rows = _schema.cell_parameters()
        return [(float(rows["x"].number(cell["x"])), float(rows["y"].number(cell["y"]))) for cell in self._cells]

    def _set_cells(self, cells: Any) -> None:
        rows = _schema.cell_parameters()
        found: list[dict[str, Value]] = []
        faults: list[Fault] = []
        for k, cell in enumerate(cells, start=1):
            one = dict(cell) if isinstance(cell, Mapping) else dict(zip(rows, cell, strict=True))
            one = {key: _plain(value) for key, value in one.items()}
            faults += [Fault(f"cells[{k}].{key}", "there is no such key; a cell has x and y") for key in one if key not in rows]
            faults += [Fault(f"cells[{k}]", f'has no {key}; write it like {key} = "40 um"') for key in rows if key not in one]
            wrong = {key: rows[key].fault(value) for key, value in one.items() if key in rows}
            faults += [Fault(f"cells[{k}].{key}", fault) for key, fault in wrong.items() if fault]
            found.append(one)
        if faults:
            raise ConfigurationError(faults)
        self._cells = found

    def __setitem__(self, path: str, value: Any) -> None:
        if path == "cells":
            self._set_cells(value)
            return
        p = _schema.parameters().get(path)
        if p is None:
            raise _unknown(path)
        value = _plain(value)
        fault = p.fault(value)
        if fault:
            raise ConfigurationError(Fault(path, fault))
        self._given[path] = value

    def __delitem__(self, path: str) -> None:
        """Gives a parameter its default again."""
        self[path]
        self._given.pop(path, None)

    def __iter__(self) -> Iterator[str]:
        return iter(_schema.parameters())

    def __len__(self) -> int:
        return len(_schema.parameters())

    def __getattr__(self, name: str) -> Any:
        if name in _classes:
            return _classes[name](self)
        if name.startswith("_"):
            raise AttributeError(name)
        raise _unknown(name, is_section=True)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in _classes:
            raise ConfigurationError(Fault(name, "is a section; set one of its parameters, such as "
                                                 f"{_of(name)[0].path}"))
        if name == "cells":
            self._set_cells(value)
            return
        if name not in ("name", "_given", "_cells"):
            raise _unknown(name, is_section=True)
        object.__setattr__(self, name, value)

    def __dir__(self) -> list[str]:
        return [*_classes, *(n for n in super().__dir__() if n not in _classes)]

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Scenario) and dict(self) == dict(other) and self.cells == other.cells

    __hash__ = None  # type: ignore[assignment] # it can change

    def __repr__(self) -> str:
        changed = ", ".join(f"{path}={_schema.toml_text(value)}" for path, value in self.changed().items())
        cells = f"{len(self._cells)} cells" if self._cells else ""
        return f"Scenario({self.name}: {', '.join(filter(None, (cells, changed))) or 'all defaults'})"

    def __copy__(self) -> Scenario:
        return self.copy()

    def given(self) -> dict[str, Value]:
        """What was set, as it was typed; all else has its default."""
        return dict(self._given)

    def changed(self) -> dict[str, Value]:
        """What differs from the defaults, as it was typed."""
        rows = _schema.parameters()
        return {path: value for path, value in self._given.items()
                if self[path] != rows[path].number(rows[path].default)}

    def copy(self, name: str | None = None) -> Scenario:
        """A scenario of the same values, to be changed apart from this one."""
        made = Scenario(self._given, name=name or self.name)
        made._cells = [dict(cell) for cell in self._cells]
        return made

    def help(self, path: str) -> str:
        """What a parameter means, its unit, range and default.

        >>> print(Scenario().help("ecm.viscosity"))
        Viscosity of the matrix, intact or degraded (mu); > 0 and <= 1e9 Pa s. A bare number is in Pa s. Default: "1000 Pa s" (Heck et al. 2020, Table 1).
        """
        if path not in _schema.parameters():
            raise _unknown(path)
        return help_text(_schema.parameters()[path])

    def unit(self, path: str) -> str:
        """The unit of a bare number, and of what reading gives: "Pa"; "1" of ratios and counts, empty of words."""
        self[path]
        return _schema.parameters()[path].unit

    def toml(self) -> str:
        """The text of a scenario file: what was set, each with its meaning and range."""
        text = "# A scenario of Matrigrate. What is left out has its default.\n"
        for section, title in _schema.sections().items():
            rows = [p for p in _of(section) if p.path in self._given]
            text += f"\n# {title}\n[{section}]\n" if rows else ""
            for p in rows:
                text += f"# {p.meaning}; {p.allowed}\n{p.key} = {_schema.toml_text(self._given[p.path])}\n"
        for cell in self._cells:
            text += "\n[[cells]]\n" + "".join(f"{key} = {_schema.toml_text(value)}\n" for key, value in cell.items())
        return text

    def save(self, file: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Writes a scenario file that the program accepts, after asking the program, where it is installed.

        An existing file is kept, unless ``overwrite``.
        """
        if _program.find() is not None:
            self.check()
        path = Path(file)
        try:
            with open(path, "w" if overwrite else "x", encoding="utf-8") as out:
                out.write(self.toml())
        except FileExistsError:
            raise InputOutputError(f"{path}: exists, and is not overwritten; choose another name, or overwrite=True",
                                   path.parent) from None
        except OSError as error:
            raise InputOutputError(f"{path}: cannot be written: {error.strerror}", path.parent) from None
        return path

    def check(self) -> None:
        """Asks the program, which also judges parameters together; raises ConfigurationError with all faults."""
        with self._as_file() as file:
            _program.check(file)

    def _as_file(self) -> _program.TemporaryScenario:
        return _program.TemporaryScenario(self.name, self.toml())


def _flat(values: Mapping[str, Any]) -> Iterator[tuple[str, Any, bool]]:
    """Path, value, and whether it is a table that is no section."""
    for name, value in values.items():
        if name in _classes and isinstance(value, Mapping):
            for key, inner in value.items():
                path = f"{name}.{key}"
                if path in _classes:
                    yield from _flat({path: inner})
                else:
                    yield path, inner, False
        elif name in _classes:
            raise ConfigurationError(Fault(name, f"is a section; write [{name}] and its keys below, each on a line"))
        else:
            yield name, value, isinstance(value, Mapping)


def _read(path: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except tomllib.TOMLDecodeError as error:
        raise ConfigurationError(Fault("", f"cannot be read as TOML: {error}", str(path))) from None
    except UnicodeDecodeError:
        raise ConfigurationError(Fault("", "is no text", str(path))) from None
    except OSError as error:
        raise InputOutputError(f"{path}: cannot be read: {error.strerror}", path.parent) from None
