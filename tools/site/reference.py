"""Reference pages made from the sources: the Python package by its docstrings, the C++ libraries by their headers."""
import importlib
import inspect
import pathlib
import re
import sys
import textwrap

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
    named = {name for _, names in _groups for name in names} | {"__version__", "plot", "tracks", "truth", "calibrate"}
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
    for title, module in (("Tracks", package.tracks), ("Ground truth", package.truth), ("Calibration", package.calibrate)):
        text.append(f"## {title}\n\n" + _markdown(inspect.getdoc(module) or "") + "\n")
        for name in module.__all__:
            text.append(_python_entry(f"{module.__name__}.{name}", name, getattr(module, name)))
    return {"reference/python.md": "\n".join(text)}


def _python_entry(full: str, name: str, thing: object) -> str:
    parts = [f"### {name}\n", f"```python\n{_signature(full, thing)}\n```\n", _markdown(_own_doc(thing)) + "\n"]
    if inspect.isclass(thing):
        for member, value in vars(thing).items():
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
    """The folder of each library, by its name: those below src/ whose CMakeLists.txt declares one."""
    return {path.parent.name: path.parent for path in (root / "src").rglob("CMakeLists.txt")
            if re.search(r"^matrigrate_folder\(", path.read_text(encoding="utf-8"), re.MULTILINE)}


def target_and_include(root: pathlib.Path, header: pathlib.Path) -> tuple[str, str]:
    """The library that holds a header, and the path of the header within its folder."""
    name, folder = next((folder.name, folder) for folder in header.parents if libraries(root).get(folder.name) == folder)
    return name, header.relative_to(folder).as_posix()


def cpp_pages(root: pathlib.Path) -> dict[str, str]:
    """A page for each library, a folder of src/ or of one of its wings: its headers with their comments and declarations."""
    what = dict(re.findall(r"^\| `src/(?:\w+/)?(\w+)/` \| (.*?) \|", (root / "CONTRIBUTING.md").read_text(encoding="utf-8"), re.MULTILINE))
    pages, rows = {}, []
    all_of_them = libraries(root)
    for folder, place in sorted(all_of_them.items()):
        headers = sorted(path for path in place.rglob("*.hpp")
                         if not any(other in path.parents for other in all_of_them.values() if place in other.parents))
        text = [f"# {folder}\n", _sentence(what.get(folder, "")) + "\n",
                f"CMake target `Matrigrate::{folder}`; an include reads as `#include \"{headers[0].relative_to(place.parent)}\"`. "
                "The functions and types are in the namespace `matrigrate` unless stated otherwise.\n"]
        for header in headers:
            text.append(f"## {header.relative_to(place).as_posix()}\n")
            text.append(_cpp_header(header.read_text(encoding="utf-8")))
        pages[f"reference/cpp/{folder}.md"] = "\n".join(text)
        names = ", ".join(f"`{header.stem}`" for header in headers)
        rows.append(f"| [{folder}]({folder}.md) | {what.get(folder, '')} | {names} |")
    pages["reference/cpp/index.md"] = (
        "# The C++ libraries\n\nEach folder of `src/`, or of its wings `model`, `run` and `study`, is a library and a CMake target, `Matrigrate::FOLDER`. These pages are made from "
        "the comments of the headers. [Examples](../../examples.md) show how the parts work together; "
        "[the model](../../model.md) leads from each equation to its function.\n\n"
        "| library | holds | headers |\n|---|---|---|\n" + "\n".join(rows) + "\n")
    return pages


def _sentence(text: str) -> str:
    return text[:1].upper() + text[1:] + ("" if text.endswith(".") else ".") if text else ""


def _cpp_header(text: str) -> str:
    """The comments and declarations of a header. Bodies of functions are left out, those of structs and enums stay."""
    lines = text.split("\n")
    made: list[str] = []
    comment: list[str] = []
    namespace, k = "matrigrate", 0
    while k < len(lines):
        line = lines[k]
        opened = re.match(r"(?:inline )?namespace ([\w:]+) \{", line)
        if line.startswith("///"):
            comment.append(line[3:].removeprefix(" "))
        elif opened:
            made.append(_cpp_comment(comment))
            if opened[1] != namespace:
                made.append(f"Namespace `{opened[1]}`.\n")
            namespace, comment = opened[1], []
        elif line.startswith(("#", "//", "}")) or not line.strip():
            if comment and not line.strip():
                made.append(_cpp_comment(comment))
            comment = [] if not line.startswith("//") else comment
        else:
            declaration, k = _declaration(lines, k)
            if comment or re.match(r"(template|struct|class|enum|inline|using|constexpr|[\w:<>]+ )", declaration):
                if comment:
                    made.append(f'```cpp\n{declaration}\n```\n\n<div class="said" markdown>\n\n{_cpp_comment(comment)}\n</div>\n')
                else:
                    made.append(f"```cpp\n{declaration}\n```\n")
            comment = []
            continue
        k += 1
    return "\n".join(part for part in made if part)


def _declaration(lines: list[str], k: int) -> tuple[str, int]:
    """The declaration that begins in line k, and the line after it."""
    start, depth, text = k, 0, ""
    body_at = None
    while k < len(lines):
        code = re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'|//.*', "", lines[k])
        for c in code:
            if c == "{" and depth == 0 and body_at is None:
                body_at = k
            depth += (c in "{(") - (c in "})")
        k += 1
        ended = depth == 0 and (code.rstrip().endswith(";") or (body_at is not None and code.rstrip().endswith("}")))
        if ended:
            break
    text = "\n".join(lines[start:k])
    head = re.sub(r"\A(?:template <[^\n]*>\n)*", "", text)
    if re.match(r"(struct|class|enum|union)\b", head) or body_at is None or re.match(r"(inline )?(constexpr|const)\b[^(]*=", head):
        return re.sub(r"\n\s*private:.*?(?=\n\};)", "", text, flags=re.DOTALL), k
    signature = text[:_body(text)].rstrip()
    signature = re.sub(r"\)\s*:\s.*\Z", ")", signature, flags=re.DOTALL)
    *before, line = re.sub(r"\n\s+", " ", re.sub(r"\[\[gnu::always_inline\]\] |^inline ", "", signature, flags=re.MULTILINE)).split("\n")
    return "\n".join([*before, *textwrap.wrap(line + ";", 96, subsequent_indent="    ", break_long_words=False,
                                              break_on_hyphens=False)]), k


def _body(text: str) -> int:
    """Where the body of a function begins: the first brace outside of parentheses."""
    depth = 0
    for at, c in enumerate(text):
        depth += (c == "(") - (c == ")")
        if c == "{" and depth == 0:
            return at
    return len(text)


def _cpp_comment(lines: list[str]) -> str:
    """A comment as Markdown: @param and its like as a list, tables as they stand."""
    if not lines:
        return ""
    text: list[str] = []
    for line in re.sub(r" +(?=@(?:param|return|throws)\b)", "\n", "\n".join(lines)).split("\n"):
        tag = re.match(r"@(param|return|throws|note)\s+(.*)", line)
        if tag:
            if not any(item.startswith("- ") for item in text[-1:]) and not (text and text[-1].startswith("    ")):
                text.append("")
            name, _, rest = tag[2].partition(" ")
            text.append(f"- `{name}`: {_plain(rest.strip())}" if tag[1] == "param" else
                        f"- {'returns' if tag[1] == 'return' else 'throws' if tag[1] == 'throws' else 'note:'} {_plain(tag[2])}")
        elif re.match(r"\s{2,}\S", line) and not (text and text[-1].startswith(("- ", "    "))) or (text and text[-1] == "@code"):
            text.append("@code " + line)
        else:
            text.append("    " + _plain(line) if text and text[-1].startswith(("- ", "    ")) else _plain(line))
    made, code = [], False
    for line in text:
        if line.startswith("@code ") != code:
            made += ["", "```text"] if not code else ["```", ""]
            code = not code
        made.append(line.removeprefix("@code "))
    return "\n".join(made + (["```"] if code else [])) + "\n"


def _plain(text: str) -> str:
    """Text in which no character is Markdown, but for code spans."""
    parts = re.split(r"(`[^`]*`)", text)
    parts[::2] = [re.sub(r"([\\*_<>\[\]|#])", r"\\\1", part) for part in parts[::2]]
    return "".join(parts)
