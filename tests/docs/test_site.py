"""The site builds; its links lead somewhere, nothing comes from the network, and what readers look for is near: test_site.py"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import tomllib
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools/site"))
import links

source = pathlib.Path(__file__).resolve().parents[2]
temporary = tempfile.TemporaryDirectory()
site = pathlib.Path(temporary.name) / "site"
live = pathlib.Path(temporary.name) / "live.html"  # in place of the page that web/build.sh makes
live.write_text("<p>a cell")
built = subprocess.run([sys.executable, "-B", source / "tools" / "site" / "build.py", site, "--live", live], capture_output=True, text=True)
if built.returncode == 77:
    print(built.stdout)
    sys.exit(77)


class Site(unittest.TestCase):
    def test_builds_without_a_warning(self):
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
        self.assertNotIn("WARNING", built.stdout + built.stderr)

    def test_links_lead_somewhere(self):
        self.assertGreater(len(list(site.rglob("*.html"))), 40)
        self.assertEqual(links.faults(site), [])

    def test_all_pages_of_docs_are_in_it(self):
        for page in (source / "docs").rglob("*.md"):
            self.assertTrue((site / page.relative_to(source / "docs").with_suffix(".html")).is_file(), page)

    def test_all_headers_are_in_it(self):
        for header in (source / "src").rglob("*.hpp"):
            text = (site / "files" / f"{header.relative_to(source)}.html").read_text(encoding="utf-8")
            self.assertIn("pragma once", text)

    def test_figures_of_kept_results_are_drawn(self):
        text = (site / "validation" / "results.html").read_text(encoding="utf-8")
        shown = re.findall(r'<img[^>]* src="([^"]+\.svg)"', text)
        self.assertEqual(len(shown), 16)
        for name in shown:
            self.assertIn("</svg>", (site / "validation" / name).read_text(encoding="utf-8"), name)

    def test_equations_are_rendered(self):
        text = (site / "model.html").read_text(encoding="utf-8")
        equations = tomllib.loads((source / "tools" / "site" / "equations.toml").read_text(encoding="utf-8"))["equation"]
        self.assertGreater(text.count("<math "), len(equations))
        self.assertNotIn("data-tex", text)

    def test_stiffness_and_speed_are_two_clicks_away(self):
        page = site / "how-to" / "stiffness.html"
        for start in ("index.html", "quick-start.html", "how-to/index.html"):
            text = (site / start).read_text(encoding="utf-8")
            targets = {((site / start).parent / link).resolve() for link in re.findall(r'href="([^"#:]+\.html)', text)}
            self.assertIn(page.resolve(), targets, start)

    def test_the_live_page_is_in_it_and_linked(self):
        self.assertEqual((site / "live/index.html").read_text(), "<p>a cell")
        for page, links_to_it in (("index.html", 1), ("how-to/live.html", 1), ("gallery.html", 1), ("lesson.html", 5)):
            text = (site / page).read_text(encoding="utf-8")
            found = {((site / page).parent / address).resolve() for address in re.findall(r'href="([^"#]*live/index.html)', text)}
            self.assertEqual(found, {(site / "live/index.html").resolve()}, page)
            self.assertEqual(len(re.findall(r'href="[^"]*live/index.html', text)), links_to_it, page)

    def test_search_finds_the_stiffness(self):
        script = (site / "search" / "search_index.js").read_text(encoding="utf-8")
        entries = json.loads(script.removeprefix("setSearchIndex(").removesuffix(");\n"))["docs"]
        self.assertIn("how-to/stiffness.html", {entry["location"] for entry in entries if "youngs_modulus" in entry["text"]})


if __name__ == "__main__":
    unittest.main()
