"""laws.constants of a scenario: numbers of the user's own, each of which is a parameter."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any

from ..base.load_core import core
from ..errors import ConfigurationError, Fault, UnknownParameter
from .schema import Parameter, toml_text

if TYPE_CHECKING:
    from .scenario import Scenario

path = "laws.constants"


def name_in(parameter: str) -> str:
    """The name of a constant in the path of a parameter; "" of any other path.

    >>> name_in("laws.constants.F_s"), name_in("laws.constants")
    ('F_s', '')
    """
    return parameter.removeprefix(f"{path}.") if str(parameter).startswith(f"{path}.") else ""


def read(value: Any, *alone: str) -> tuple[str, dict[str, tuple[float, Parameter]]]:
    """All constants in one text, and the number and row of each.

    :param value: of laws.constants, as it stands in a file
    :param alone: constants that are set after that, "laws.constants.F_s=0.4"
    :raises ConfigurationError: with all that is wrong
    """
    if not value and not alone:
        return "", {}
    try:
        text, each = core().constants(toml_text(value), list(alone))
    except ConfigurationError as error:
        raise ConfigurationError([Fault(fault.key, fault.message) for fault in error.faults]) from None
    found = {}
    for name, number, unit, allowed, written in each:
        kind, value = ("ratio", number) if unit == "1" else ("quantity", written.strip('"'))
        found[name] = number, Parameter(f"{path}.{name}", kind, "Constant of the laws", name, allowed, unit, value,
                                        "this scenario", ())
    return text, found


class Constants:
    """The constants of the laws of a scenario, as attributes and items: numbers in the unit of their row. One that is
    not there is defined by setting it.

    >>> from matrigrate import Scenario
    >>> laws = Scenario().laws
    >>> laws.constants = {"F_s": {"value": "400 pN", "range": ["0.1 nN", "1 nN"]}, "n": 2}
    >>> laws.constants.F_s, str(laws.constants)
    (0.4, 'F_s = 0.4 nN, n = 2')
    >>> laws.constants.F_s = "2 nN"
    Traceback (most recent call last):
      ...
    matrigrate.errors.ConfigurationError: laws.constants.F_s: "2 nN" is out of range; allowed is >= 0.1 and <= 1 nN
    """

    __slots__ = ("_scenario",)
    _scenario: Scenario

    def __init__(self, scenario: Scenario) -> None:
        object.__setattr__(self, "_scenario", scenario)

    def _read(self) -> tuple[str, dict[str, tuple[float, Parameter]]]:
        return read(self._scenario.given().get(path, ""))

    def keys(self) -> list[str]:
        return list(self._read()[1])

    __dir__ = keys

    def row(self, name: str) -> Parameter:
        known = self._read()[1]
        if name not in known:
            raise UnknownParameter(Fault(f"{path}.{name}", "there is no such constant; there are "
                                                           f"{', '.join(known) or 'none'}; set it to define it"))
        return known[name][1]

    def __getitem__(self, name: str) -> float:
        self.row(name)
        return self._read()[1][name][0]

    def _given(self) -> dict[str, Any]:
        """Each as typed."""
        given = self._scenario.given().get(path, {})
        if isinstance(given, Mapping):
            return dict(given)
        return {name: row.default for name, (_, row) in self._read()[1].items()}

    def __setitem__(self, name: str, value: Any) -> None:
        given = self._given()
        old = given.get(name)
        if old is None or isinstance(value, Mapping):
            self._scenario[path] = {**given, name: value}
            return
        value = read(given, f"{path}.{name}={toml_text(value)}")[1][name][1].default  # a bare number is in its unit
        self._scenario[path] = {**given, name: {**old, "value": value} if isinstance(old, Mapping) else value}

    def __delitem__(self, name: str) -> None:
        self.row(name)
        self._scenario[path] = {each: value for each, value in self._given().items() if each != name}

    def __getattr__(self, name: str) -> float:
        if name.startswith("__") or name == "_scenario":
            raise AttributeError(name)
        return self[name]

    __setattr__, __delattr__ = __setitem__, __delitem__

    def __iter__(self) -> Iterator[str]:
        return iter(self.keys())

    def __len__(self) -> int:
        return len(self.keys())

    def __eq__(self, other: object) -> bool:
        return isinstance(other, (str, Constants)) and str(self) == str(other)

    __hash__ = None  # type: ignore[assignment] # it can change

    def __str__(self) -> str:
        return self._read()[0]

    def __repr__(self) -> str:
        return f"Constants({self})"
