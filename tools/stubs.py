#!/usr/bin/env python3
"""Types of the sections and parameters of a scenario for editors and type checkers, made from the schema.

stubs.py [FILE]     writes FILE (default: python/matrigrate/scenario/sections.pyi, for editors that work on this tree)

A wheel and a Debian package contain the file, made by setup.py and cmake/install.cmake; the repository does not.
"""
import ast
import pathlib
import sys
import types

root = pathlib.Path(__file__).resolve().parents[1]
package = types.ModuleType("matrigrate")  # without its __init__.py, which needs numpy
package.__path__ = [str(root / "python" / "matrigrate")]
sys.modules["matrigrate"] = package

from matrigrate.scenario import schema  # noqa: E402
from matrigrate.scenario import sections  # noqa: E402

stub = root / "python" / "matrigrate" / "scenario" / "sections.pyi"
head = '''"""Made from scenario.schema.json by tools/stubs.py; do not edit.

Reading a parameter gives a number in the unit that its docstring names; writing takes such a number or a text with a unit.
A wrong name, unit or range raises matrigrate.ConfigurationError.
"""
from collections.abc import Mapping
from typing import Any, Literal

from ._schema import Parameter
from .constants import Constants
from .errors import UnknownParameter
from .scenario import Scenario

class _Quantity:
    def __get__(self, section: Section, owner: Any = None) -> float: ...
    def __set__(self, section: Section, value: float | str) -> None: ...

class _Constants:
    def __get__(self, section: Section, owner: Any = None) -> Constants: ...
    def __set__(self, section: Section, value: str | Mapping[str, Any]) -> None: ...

'''


def doc(text: str, indent: str) -> str:
    quoted = text.replace("\\", "\\\\")
    return f'{indent}"""{quoted}{" " if quoted.endswith(chr(34)) else ""}"""\n'


def type_of(p: schema.Parameter) -> str:
    if p.kind == "choice":
        return f"Literal[{', '.join(f'{choice!r}'.replace(chr(39), chr(34)) for choice in p.choices)}]"
    return {"quantity": "_Quantity", "angle": "_Quantity", "ratio": "float", "integer": "int", "boolean": "bool",
            "field": "str", "law": "str", "constants": "_Constants"}[p.kind]


def section(name: str, title: str) -> str:
    text = f"class {sections.class_name(name)}(Section):\n" + doc(title + ".", "    ")
    for within in sections.inner(name):
        text += reads(within, within.rsplit(".", 1)[1])
    for p in sections.of(name):
        text += f"    {p.key}: {type_of(p)}\n" + doc(sections.help_text(p), "    ")
    return text + "\n"


def reads(name: str, attribute: str) -> str:
    return (f"    @property\n    def {attribute}(self) -> {sections.class_name(name)}:\n"
            + doc(schema.sections()[name] + ".", "        "))


def signatures() -> str:
    """The functions of the module as they stand in its source."""
    source = (root / "python" / "matrigrate" / "scenario" / "sections.py").read_text(encoding="utf-8")
    text = ""
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            text += f"def {node.name}({ast.unparse(node.args)}) -> {ast.unparse(node.returns)}: ...\n"
    return text


def made() -> str:
    text = head + "class Section:\n" + doc(sections.Section.__doc__.strip(), "    ")
    text += "    def __init__(self, scenario: Scenario) -> None: ...\n\n"
    for name, title in schema.sections().items():
        text += section(name, title)
    text += "class Sections:\n" + doc(sections.Sections.__doc__, "    ")
    text += "".join(reads(name, name) for name in schema.sections() if "." not in name)
    return text + "\nclasses: dict[str, type[Section]]\n\n" + signatures()


if __name__ == "__main__":
    if len(sys.argv) > 2 or sys.argv[-1].startswith("-"):
        sys.exit(__doc__)
    pathlib.Path(sys.argv[1] if sys.argv[1:] else stub).write_text(made(), encoding="utf-8")
