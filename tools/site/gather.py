"""The pages of the site: the Markdown files of the project, as mkdocs wants them."""
import os
import pathlib
import re

import formulas
import reference

at_the_root = {"MODEL.md": "model.md", "CHANGELOG.md": "changelog.md", "CONTRIBUTING.md": "contributing.md",
               "README.md": "readme.md", "examples/README.md": "examples.md", "viewer/README.md": "viewer.md",
               "web/README.md": "web.md", "SECURITY.md": "security.md"}
_commands = ("matrigrate", "cmake", "ctest", "apt-get", "export", "npm", "program=", "GLIBC", "./", "python3", "tools/",
             "build/")
_shown = {".cpp": "cpp", ".hpp": "cpp", ".toml": "toml", ".py": "python", ".sh": "sh", ".ts": "ts", ".cmake": "cmake",
          ".R": "r", ".cff": "yaml", ".json": "json"}


def pages(root: pathlib.Path) -> dict[str, str]:
    """The text of each page of the site, by its name there. Links are still those of the source."""
    names = {f"docs/{path.relative_to(root / 'docs').as_posix()}": path.relative_to(root / "docs").as_posix()
             for path in (root / "docs").rglob("*.md")} | at_the_root
    texts = {}
    for source, name in names.items():
        text = (root / source).read_text(encoding="utf-8")
        if source == "MODEL.md":
            text = _model(text)
        if source == "examples/README.md":
            text = re.sub(r"^\| `(\w+\.cpp)`", r"| [`\1`](\1)", text, flags=re.MULTILINE)
        text = _with_links_by_source(text, source)
        texts[name] = _for_mkdocs(text)
    return texts


def outside_code(text: str, change, spans: bool = True) -> str:
    """Applies a change to what is neither a fenced block nor, with spans, a code span."""
    parts = re.split(r"(^```.*?^```[^\n]*$)", text, flags=re.MULTILINE | re.DOTALL)
    for k in range(0, len(parts), 2):
        pieces = re.split(r"(`[^`]+`)", parts[k]) if spans else [parts[k]]
        pieces[::2] = map(change, pieces[::2])
        parts[k] = "".join(pieces)
    return "".join(parts)


def _for_mkdocs(text: str) -> str:
    """GitHub's Markdown as Python-Markdown reads it."""
    text = outside_code(text, lambda part: re.sub(r"<!--(?! (?:reports|live|figures:) ).*?-->\n?", "", part, flags=re.DOTALL), spans=False)
    text = outside_code(text, _lists, spans=False)
    return re.sub(r"^```([^\n]*)\n(.*?)^```$", lambda match: _fence(match[1], match[2]), text, flags=re.MULTILINE | re.DOTALL)


def _fence(language: str, body: str) -> str:
    """A block without a language shows commands, or plain text."""
    return f"```{language or ('sh' if body.startswith(_commands) else 'text')}\n{body}```"


def _lists(text: str) -> str:
    """Python-Markdown wants a blank line before a list, and four spaces before what belongs to an item."""
    lines, made, inside = text.split("\n"), [], False
    for line in lines:
        item = re.match(r"(?:[-*]|\d+\.) ", line)
        if item and not inside and made and made[-1].strip():
            made.append("")
        if item:
            inside = True
        elif line and not line.startswith(" ") and made and not made[-1].strip():
            inside = False
        made.append(re.sub(r"^ {2,3}(?=\S)", "    ", line) if inside else line)
    return "\n".join(made)


# Links: first all become "source:PATH#anchor", then, once all pages are known, links of the site.


def _with_links_by_source(text: str, source: str) -> str:
    folder = os.path.dirname(source)

    def change(match: re.Match[str]) -> str:
        target, _, anchor = match[2].partition("#")
        if re.match(r"\w+:", match[2]):
            return match[0]
        path = os.path.normpath(os.path.join(folder, target)) if target else source
        return f"{match[1]}(source:{path}{'#' + anchor if anchor else ''})"

    return outside_code(text, lambda part: re.sub(r"(\])\(([^)\s]+)\)", change, part), spans=False)


def with_links_of_the_site(texts: dict[str, str], root: pathlib.Path) -> dict[str, pathlib.Path]:
    """Points all links at pages of the site; files that are linked become pages, or are copied. Returns the copies."""
    by_source = at_the_root | {f"docs/{name}": name for name in texts if (root / "docs" / name).exists()}
    copies: dict[str, pathlib.Path] = {}
    more: dict[str, str] = {}

    def place(path: str, anchor: str) -> str:
        if (root / path / "README.md").is_file():
            path = f"{path}/README.md"
        if path in by_source:
            return by_source[path] + anchor
        origin = root / path
        if origin.is_dir():
            name = f"files/{path}/index.md"
            more[name] = f"# {path}\n\n" + "".join(
                f"- [{file.name}]({os.path.relpath(place(f'{path}/{file.name}', ''), os.path.dirname(name))})\n"
                for file in sorted(origin.iterdir()) if file.is_file())
            return name
        if not origin.is_file():
            raise SystemExit(f"a page links to {path}, which is not there")
        name = path.removeprefix("docs/")
        if origin.suffix in (".svg", ".png", ".gif", ".webp", ".csv") or path == "docs/scenario.schema.json":
            copies[name] = origin
            return name
        text = origin.read_text(encoding="utf-8")
        more[f"files/{path}.md"] = f"# {path}\n\n```{_shown.get(origin.suffix, 'text')}\n{text}\n```\n"
        return f"files/{path}.md"

    for name, text in texts.items():
        def change(match: re.Match[str]) -> str:
            there = place(match[1], match[2] or "")
            relative = os.path.relpath(there, os.path.dirname(name) or ".")
            return f"]({relative})"

        text = _with_links_to_headers(text, name, root)
        text = outside_code(text, lambda part: re.sub(r"\]\(source:([^)#]+)(#[^)]*)?\)", change, part), spans=False)
        texts[name] = _with_links_to_interpretations(text, name)
    texts |= more
    return copies


def _with_links_to_interpretations(text: str, name: str) -> str:
    """MODEL.md, I12 in the text becomes a link to that interpretation."""
    model = os.path.relpath("model.md", os.path.dirname(name) or ".")
    return outside_code(text, lambda part: re.sub(
        r"(?<!\[)\bMODEL\.md, I(\d+)\b", lambda match: f"[{match[0]}]({model}#i{match[1]})", part))


def _with_links_to_headers(text: str, name: str, root: pathlib.Path) -> str:
    """`cell/spring.hpp` in the text becomes a link to the page of that header."""
    if name.startswith(("reference/", "files/")):
        return text
    folders = reference.libraries(root)

    def change(match: re.Match[str]) -> str:
        library, header = match[1], match[2]
        if library not in folders or not (folders[library] / header).is_file():
            return match[0]
        return f"[{match[0]}](source:{(folders[library] / header).relative_to(root).as_posix()})"

    def line(text: str) -> str:
        return text if text.startswith("#") else re.sub(r"(?<!\[)`(?:src/(?:\w+/)?)?(\w+)/([\w/]+\.hpp)`(?!\])", change, text)

    return outside_code(text, lambda part: "\n".join(map(line, part.split("\n"))), spans=False)


def _symbols(text: str) -> str:
    """The first column of the table of symbols: its single letters, too, as formulas; elsewhere they may be words."""
    start, end = text.index("| symbol |"), text.index("\n\n", text.index("| symbol |"))
    rows = text[start:end].split("\n")
    for k, row in enumerate(rows[2:], 2):
        cells = row.split(" | ")
        cells[0] = re.sub(r"(?<![\w,])(?:[A-Za-z]|dp)(?!\w)", lambda match: formulas.marked(match[0], match[0].replace("dp", "d_p")),
                          cells[0])
        rows[k] = " | ".join(cells)
    return text[:start] + "\n".join(rows) + text[end:]


def slug(heading: str, separator: str = "-") -> str:
    """The anchor of a heading, as on GitHub."""
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", separator)


# MODEL.md.


def _model(text: str) -> str:
    """Rendered equations; the table of equations as blocks, which fit a narrow screen; anchors of the interpretations."""
    equations, met = formulas.load(), set()
    start, end = text.index("| equation |"), text.index("\n\n", text.index("| equation |"))
    rows = [[cell.strip() for cell in re.split(r" \| ", line.strip("| "))] for line in text[start:end].split("\n")[2:]]

    def rendered(piece: str, display: bool = False) -> str:
        return outside_code(piece, lambda part: formulas.with_formulas(part, equations, met, display))

    blocks = []
    for equation, statement, function, test in rows:
        blocks.append(f'<div class="equation" id="{slug(equation)}" markdown>\n\n**{rendered(equation)}**\n\n'
                      f"{rendered(statement, display=True)}\n\nFunction: {function}<br>Test: {test}\n\n</div>\n")
    before, after = rendered(text[:start]), rendered(_symbols(text[end:]))
    missing = [plain for plain, _ in equations if plain not in met]
    if missing:
        raise SystemExit("tools/site/equations.toml has equations that MODEL.md does not have:\n" + "\n".join(missing))
    text = before + "\n".join(blocks) + after
    text = outside_code(text, lambda part: re.sub(r"\b(u?m)\^([23])\b", r"\1<sup>\2</sup>", part))
    text = re.sub(r"^\*\*(I\d+)\. (.*?)\*\*",
                  lambda match: f"### {match[1]}. {match[2].rstrip('.')} {{: #{match[1].lower()} }}\n\n", text,
                  flags=re.MULTILINE | re.DOTALL)
    return outside_code(text, lambda part: re.sub(
        r"(?<![\w#/])I(\d+)\b(?!\. )", lambda match: f"[I{match[1]}](#i{match[1]})", part))
