"""The sections of a scenario as classes, with an attribute for each parameter of the schema.

Their types are in sections.pyi, which tools/stubs.py makes from the same schema.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ..base.load_core import core
from ..errors import Fault, UnknownParameter
from . import schema
from .constants import Constants
from .schema import Parameter, Value

if TYPE_CHECKING:
    from .scenario import Scenario


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
        raise unknown(f"{self._name}.{key}")

    def __setattr__(self, key: str, value: Any) -> None:
        self._scenario[f"{self._name}.{key}"] = value

    def __dir__(self) -> list[str]:
        return [p.key for p in of(self._name)] + [name.rsplit(".", 1)[1] for name in inner(self._name)]

    def __repr__(self) -> str:
        lines = [f"[{self._name}] {schema.sections()[self._name]}; * differs from its default"]
        changed = self._scenario.changed()
        for p in of(self._name):
            mark = "*" if p.path in changed else " "
            value, unit = self._scenario[p.path], "" if p.unit == "1" else f" {p.unit}".rstrip()
            shown = f"{value:g}{unit}" if isinstance(value, float) else f"{schema.toml_text(value)}{unit}"
            lines.append(f"{mark} {p.key:<20} {shown:<18} {p.meaning}; {p.allowed}")
        return "\n".join(lines)


def help_text(p: Parameter) -> str:
    """Meaning, unit and range of a parameter, and the source of its default."""
    unit = f" A bare number is in {p.unit}." if p.kind in ("quantity", "angle") else ""
    return f"{p.meaning}; {p.allowed}.{unit} Default: {schema.toml_text(p.default)} ({p.source})."


def of(section: str) -> list[Parameter]:
    """The parameters of a section, without sections inside it."""
    return [p for p in schema.parameters().values() if p.path.rsplit(".", 1)[0] == section]


def inner(section: str) -> list[str]:
    """The sections inside of one: "ecm.fields" of "ecm"."""
    return [name for name in schema.sections() if name.startswith(section + ".")]


def _attribute(p: Parameter) -> property:
    def read(self: Section) -> Value | Constants:
        return Constants(self._scenario) if p.kind == "constants" else self._scenario[p.path]

    def write(self: Section, value: Value) -> None:
        self._scenario[p.path] = value

    return property(read, write, doc=help_text(p))


def _section_class(name: str, title: str) -> type[Section]:
    attributes: dict[str, Any] = {p.key: _attribute(p) for p in of(name)}
    for within in inner(name):
        attributes[within.rsplit(".", 1)[1]] = property(lambda self, within=within: classes[within](self._scenario),
                                                        doc=schema.sections()[within] + ".")
    attributes |= {"_name": name, "__doc__": title + ".", "__module__": __name__}
    return type(class_name(name), (Section,), attributes)


def class_name(section: str) -> str:
    """The name of the class of a section.

    >>> class_name("ecm.fields")
    'EcmFields'
    """
    return section.title().replace(".", "")


def _section(name: str) -> property:
    return property(lambda scenario: classes[name](scenario), doc=schema.sections()[name] + ".")


classes = {name: _section_class(name, title) for name, title in schema.sections().items()}
globals().update({one.__name__: one for one in classes.values()})
Sections = type("Sections", (), {name: _section(name) for name in classes if "." not in name} | {
    "__doc__": "The sections of a scenario, as attributes.", "__module__": __name__, "__slots__": ()})


def unknown(path: str, is_section: bool = False) -> UnknownParameter:
    """The exception for a name that nothing has, with the nearest that something has."""
    return UnknownParameter(Fault(path, core().unknown_name(path, is_section)))
