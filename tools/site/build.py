#!/usr/bin/python3
"""Builds the documentation site: build.py FOLDER [--program PATH] [--live PAGE]

Gathers the pages in a temporary folder (docs/, the pages at the root of the project, and reference pages made from the
sources), and calls mkdocs. With --program, the gallery holds report pages that the program makes from short runs.
"""
import argparse
import importlib.util
import json
import logging
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
sys.path.insert(0, str(here))

import formulas  # noqa: E402
import gather  # noqa: E402
import reference  # noqa: E402

katex = pathlib.Path("/usr/share/javascript/katex")  # Debian's libjs-katex

short = ["--set", "protrusion.initiation_rate=2e-3 1/s", "--set", "output.field_interval=60 s"]
reports = [  # name, what it shows, commands of the program; {0} is the folder
    ("baseline", "A run: half an hour of the baseline, 200 Pa",
     [["new", "baseline.toml"], ["run", "baseline.toml", "-o", "baseline", "--hours", "0.5", *short]]),
    ("fibres", "A run: among fibres along x, two protrusions at a time",
     [["new", "fibres.toml", "--preset", "two-protrusions-fibres"],
      ["run", "fibres.toml", "-o", "fibres", "--hours", "0.3", *short]]),
    ("study", "A study: two stiffnesses, three seeds each", [["study", "run", "stiffness.toml", "-o", "study"]]),
    ("stretch", "A verification case: a stretched specimen", [["validate", "stretch", "-o", "stretch"]]),
]
study = """title = "Soft and stiff matrix"
preset = "baseline"
replicates = 3

[set]
run.duration = "20 min"
ecm.radius = "80 um"
protrusion.initiation_rate = "2e-3 1/s"

[sweep]
ecm.youngs_modulus = ["50 Pa", "400 Pa"]
"""


def make_reports(program: pathlib.Path, folder: pathlib.Path) -> None:
    """Lets the program make the report pages of the gallery."""
    folder.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as work:
        (pathlib.Path(work) / "stiffness.toml").write_text(study)
        for name, _, commands in reports:
            for command in commands:
                done = subprocess.run([program, *command], cwd=work, capture_output=True, text=True)
                if done.returncode:
                    sys.exit(f"matrigrate {' '.join(command)}\n{done.stdout}{done.stderr}")
            shutil.copy(pathlib.Path(work) / name / "report.html", folder / f"{name}.html")


def gallery_text(program: pathlib.Path | None, live: pathlib.Path | None) -> str:
    """What the site adds to docs/gallery.md."""
    parts = ['## The live page\n\n<p><a href="live/index.html">Simulate a cell in this browser</a></p>\n'] if live else []
    if program is None:
        return "\n".join([*parts, "This site was built without the program, so it holds no report pages."])
    for name, title, commands in reports:
        lines = "\n".join("matrigrate " + " ".join(f'"{word}"' if " " in word else word for word in command)
                          for command in commands)
        parts.append(f'## {title}\n\n<p><a href="reports/{name}.html">Open the page alone</a></p>\n\n'
                     f'<iframe class="report" src="reports/{name}.html" title="{title}" loading="lazy"></iframe>\n\n'
                     f"```sh\n{lines}\n```\n")
    return "\n".join(parts)


def with_figures(texts: dict[str, str], docs: pathlib.Path) -> None:
    """The figures of the kept results, drawn here, below the table of their study."""
    import figures
    name = "validation/results.md"
    for study, files in figures.draw_all(docs / "validation").items():
        mark = f"<!-- figures: {study} -->"
        assert mark in texts[name], study
        texts[name] = texts[name].replace(mark, "\n\n".join(f"![{file.removesuffix('.svg')}]({file})" for file in files))


def with_live_page(texts: dict[str, str]) -> None:
    """Links to the live page, which this site holds: on the first page, on its own page, and one for each question of the lesson."""
    link = '<p><a class="live" href="{}">Simulate a cell in this browser</a>: nothing is installed or asked of a network.</p>'
    for name, mark, address in (("index.md", "<!-- live -->", "live/index.html"), ("how-to/live.md", "<!-- live -->", "../live/index.html")):
        assert mark in texts[name], name
        texts[name] = texts[name].replace(mark, link.format(address))
    texts["lesson.md"], n = re.subn(r"^```text\n(#scenario=[\w-]+)\n```$", r'<p><a class="live" href="live/index.html\1">Begin this question</a></p>',
                                    texts["lesson.md"], flags=re.MULTILINE)
    assert n == 5, n


def main() -> None:
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    options.add_argument("folder", type=pathlib.Path, help="where the site goes; an older site there is replaced")
    options.add_argument("--program", type=pathlib.Path, help="matrigrate, for the report pages of the gallery")
    options.add_argument("--live", type=pathlib.Path, help="the live page that web/build.sh has made, which the site then holds")
    given = options.parse_args()
    if any(importlib.util.find_spec(name) is None for name in ("mkdocs", "matplotlib", "pandas")) or not katex.is_dir():
        print("not here: mkdocs, mkdocs-material, katex, matplotlib or pandas; tools/site.sh installs them")
        sys.exit(77)
    folder = given.folder.resolve()
    if folder.exists() and any(folder.iterdir()) and not (folder / "sitemap.xml").exists():
        sys.exit(f"{folder} holds something other than a site; nothing was written")

    from mkdocs.commands.build import build
    from mkdocs.config import load_config
    logging.basicConfig(level=logging.WARNING, format="%(levelname)s: %(message)s")
    with tempfile.TemporaryDirectory() as temporary:
        docs = pathlib.Path(temporary) / "docs"
        texts = gather.pages(root)
        texts |= reference.python_pages(root) | reference.cpp_page(root)
        texts["gallery.md"] = texts["gallery.md"].replace("<!-- reports -->", gallery_text(given.program, given.live))
        if given.live:
            with_live_page(texts)
        files = gather.with_links_of_the_site(texts, root)
        with_figures(texts, docs)
        if given.program:
            make_reports(given.program.resolve(), docs / "reports")
        if given.live:
            (docs / "live").mkdir(parents=True, exist_ok=True)
            shutil.copy(given.live, docs / "live" / "index.html")
        for name, content in texts.items():
            (docs / name).parent.mkdir(parents=True, exist_ok=True)
            (docs / name).write_text(content, encoding="utf-8")
        for name, origin in files.items():
            (docs / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(origin, docs / name)
        shutil.copy(here / "site.css", docs)
        (docs / "katex").mkdir()
        style = re.sub(r",url\([^)]*\.(?:woff|ttf)\) format\([^)]*\)", "", (katex / "katex.min.css").read_text())
        (docs / "katex" / "katex.min.css").write_text(style)  # woff2 alone: all browsers read it
        shutil.copytree(katex / "fonts", docs / "katex" / "fonts", ignore=shutil.ignore_patterns("*.ttf", "*.woff"))
        (docs / "licences").mkdir()
        for package in ("libjs-katex", "mkdocs-material"):  # the site holds parts of both
            shutil.copy(f"/usr/share/doc/{package}/copyright", docs / "licences" / f"{package}.txt")
        shutil.rmtree(folder, ignore_errors=True)
        config = load_config(str(here / "mkdocs.yml"), docs_dir=str(docs), site_dir=str(folder), strict=True)
        config["mdx_configs"]["toc"]["slugify"] = gather.slug
        build(config)
    formulas.render(folder)
    write_search(folder)
    print(f"{folder / 'index.html'}")


def write_search(folder: pathlib.Path) -> None:
    """The search index as a script: a page that was opened as a file may not fetch it."""
    index = folder / "search" / "search_index.json"
    content = json.loads(index.read_text(encoding="utf-8"))
    content["docs"] = [entry for entry in content["docs"] if not entry["location"].startswith(("files/", "lab/"))]
    (folder / "search" / "search_index.js").write_text(f"setSearchIndex({json.dumps(content)});\n", encoding="utf-8")
    index.unlink()


if __name__ == "__main__":
    main()
