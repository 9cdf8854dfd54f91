"""Reference pages made from the sources: the Python package by its docstrings, a list of the C++ libraries with their headers."""
import importlib
import inspect
import pathlib
import re
import sys

# The Python package.

_groups = [
    ("Runs", ["run", "load", "Run", "CellsOfRun", "CellOfRun", "Readouts", "ReadoutsOfCells", "meaning"]),
    ("Steps", ["Simulation", "Cell", "Matrix"]),
    ("Fields", ["Fields", "Field"]),
    ("Studies", ["run_study", "load_study", "Study", "Runs"]),
    ("Scenarios", ["Scenario", "Section", "Parameter"]),
    ("The live page", ["live"]),
    ("Errors", ["MatrigrateError", "ConfigurationError", "Fault", "UnknownParameter", "NumericalError", "InputOutputError",
                "InternalError", "Stopped", "KeyboardStop", "ProgramNotFound", "CoreNotFound", "UsageError"]),
]


def python_pages(root: pathlib.Path) -> dict[str, str]:
    sys.path.insert(0, str(root / "python"))
    package = importlib.import_module("matrigrate")
    named = {name for _, names in _groups for name in names} | {"__version__", "plot", "tracks", "truth", "calibrate", "exchange"}
    if named != set(package.__all__):
        raise SystemExit(f"tools/site/reference.py: groups and matrigrate.__all__ differ: {named ^ set(package.__all__)}")
    text = ["# The Python package\n", "A [tutorial](../python.md) shows how the parts work together. Names that begin with an "
            "underscore are no part of the interface.\n", _markdown(inspect.getdoc(package) or ""), ""]
    for title, names in _groups:
        text.append(f"## {title}\n")
        text += [_python_entry(f"matrigrate.{name}", name, getattr(package, name)) for name in names]
    text.append("## Figures\n\n" + _markdown(inspect.getdoc(package.plot) or "") + "\n")
    for name, function in vars(package.plot).items():
        if inspect.isfunction(function) and not name.startswith("_") and function.__module__ == package.plot.__name__:
            text.append(_python_entry(f"matrigrate.plot.{name}", name, function))
    for title, module in (("Tracks", package.tracks), ("Ground truth", package.truth), ("Calibration", package.calibrate), ("Formats of other programs", package.exchange)):
        text.append(f"## {title}\n\n" + _markdown(inspect.getdoc(module) or "") + "\n")
        for name in module.__all__:
            text.append(_python_entry(f"{module.__name__}.{name}", name, getattr(module, name)))
    return {"reference/python.md": "\n".join(text)}


def _python_entry(full: str, name: str, thing: object) -> str:
    parts = [f"### {name}\n", f"```python\n{_signature(full, thing)}\n```\n", _markdown(_own_doc(thing)) + "\n"]
    if inspect.isclass(thing):
        own = (one for one in reversed(thing.__mro__) if one is thing or one.__name__.startswith("_"))  # and of bases without a page
        for member, value in {name: value for one in own for name, value in vars(one).items()}.items():
            if member.startswith("_"):
                continue
            called = value.__func__ if isinstance(value, (classmethod, staticmethod)) else value
            function = getattr(called, "fget", None) or getattr(called, "func", None) or called
            doc = inspect.getdoc(function) if inspect.isfunction(function) else None
            if not doc:
                continue
            if called is function:
                owner = thing.__name__ if isinstance(value, (classmethod, staticmethod)) else thing.__name__.lower()
                line = _signature(f"{owner}.{member}", function, method=not isinstance(value, staticmethod))
            else:
                returned = inspect.signature(function).return_annotation
                line = f"{thing.__name__.lower()}.{member}" + (
                    "" if returned is inspect.Signature.empty else f": {_annotation(returned)}")
            parts.append(f'<div class="member" markdown>\n\n```python\n{line}\n```\n\n{_markdown(doc)}\n\n</div>\n')
    return "\n".join(parts)


def _own_doc(thing: object) -> str:
    doc = inspect.getdoc(thing) or ""
    return "" if inspect.isclass(thing) and not vars(thing).get("__doc__") else doc


def _annotation(value: object) -> str:
    return value if isinstance(value, str) else getattr(value, "__name__", str(value))


def _signature(name: str, thing: object, method: bool = False) -> str:
    try:
        signature = inspect.signature(thing)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        return name
    parameters = list(signature.parameters.values())[1 if method else 0:]
    if inspect.isclass(thing) and any(p.kind is p.VAR_POSITIONAL for p in parameters):
        return name
    words, star = [], False
    for p in parameters:
        if p.kind is p.KEYWORD_ONLY and not star:
            words.append("*")
            star = True
        word = {p.VAR_POSITIONAL: "*", p.VAR_KEYWORD: "**"}.get(p.kind, "") + p.name
        star = star or p.kind is p.VAR_POSITIONAL
        typed = p.annotation is not p.empty
        word += f": {_annotation(p.annotation)}" if typed else ""
        word += (f" = {p.default!r}" if typed else f"={p.default!r}") if p.default is not p.empty else ""
        words.append(word)
    returned = signature.return_annotation
    end = "" if returned in (signature.empty, "None") or inspect.isclass(thing) else f" -> {_annotation(returned)}"
    line = f"{name}({', '.join(words)}){end}"
    return line if len(line) <= 80 else f"{name}(\n" + "".join(f"    {word},\n" for word in words) + f"){end}"


def _markdown(doc: str) -> str:
    """A docstring: fields as a list, examples as code."""
    lines = re.sub(r"(?<=\S) (?=:(?:param|raises|returns?)\b)", "\n", doc).split("\n")
    made, code, fields = [], False, False
    for line in lines:
        example = line.startswith((">>> ", "... ")) or (code == ">" and line.strip() != "")
        indented = line.startswith("    ") and not fields and (code == " " or not made or not made[-1].strip())
        if code and not (example or indented) and (code == ">" or line.strip()):
            while made and not made[-1].strip():
                made.pop()
            made += ["```", ""]
            code = False
        if not code and (example or indented):
            made += ["", "```python"]
            code = ">" if example else " "
        if code:
            made.append(line[4:] if code == " " else line)
            continue
        field = re.match(r":(param|raises|returns?) ?(\w*): ?(.*)", line)
        if field:
            if not fields:
                made.append("")
            fields = True
            name = {"raises": f"raises `{field[2]}`", "return": "returns", "returns": "returns"}.get(field[1], f"`{field[2]}`")
            made.append(f"- {name}: {field[3]}")
        else:
            made.append(line)
    if code:
        made.append("```")
    return _code_spans("\n".join(made))


def _code_spans(text: str) -> str:
    return re.sub(r"(?<!`)``(?!`)([^`]+)``(?!`)", r"`\1`", text)


# The C++ libraries.


def libraries(root: pathlib.Path) -> dict[str, pathlib.Path]:
    """The folder of each library, by its name: those that the wings' CMakeLists.txt declare."""
    return {name: path.parent / name if (path.parent / name).is_dir() else path.parent
            for path in (root / "src").glob("*/CMakeLists.txt")
            for name in re.findall(r"^matrigrate_folder\((\w+)", path.read_text(encoding="utf-8"), re.MULTILINE)}


def cpp_page(root: pathlib.Path) -> dict[str, str]:
    """The libraries, folders of src/ or of one of its wings, with links to their headers, which become pages as they stand."""
    what = dict(re.findall(r"^\| `src/(?:\w+/)?(\w+)/` \| (.*?) \|", (root / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.MULTILINE))
    all_of_them = libraries(root)
    rows = []
    for library, place in sorted(all_of_them.items()):
        headers = (path for path in sorted(place.rglob("*.hpp"))
                   if not any(other in path.parents for other in all_of_them.values() if place in other.parents))
        links = ", ".join(f"[{header.stem}](source:{header.relative_to(root).as_posix()})" for header in headers)
        rows.append(f"| {library} | {what.get(library, '')} | {links} |\n")
    return {"reference/cpp.md": "# The C++ libraries\n\nEach folder of `src/`, or of its wings `model`, `run` and `study`, is a library and a CMake target, "
            "`Matrigrate::FOLDER`; an include reads as `#include \"FOLDER/HEADER.hpp\"`. [Examples](../examples.md) show how the parts work together; "
            "[the model](../model.md) leads from each equation to its function.\n\n| library | holds | headers |\n|---|---|---|\n" + "".join(rows)}
