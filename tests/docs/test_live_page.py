"""The live page that a clone has: whole, of no release before the last one, one file that asks no network: test_live_page.py"""
import base64
import pathlib
import re
import unittest
import zlib

source = pathlib.Path(__file__).resolve().parents[2]
page = source / "live" / "index.html"
text = page.read_text(encoding="utf-8")
made_of = dict(line.split() for line in (source / "live" / "SOURCES").read_text(encoding="utf-8").splitlines())


def number(version: str) -> tuple[int, ...]:
    return tuple(int(part) for part in version.split("."))


class LivePage(unittest.TestCase):
    def test_is_not_older_than_the_last_release(self):
        released = re.findall(r"^## \[(\d+\.\d+\.\d+)", (source / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
        self.assertGreaterEqual(number(made_of["version"]), number(released[0]), "renew it: web/build.sh --keep")

    def test_names_the_sources_that_it_is_made_of(self):
        self.assertEqual(set(made_of), {"version", "src", "viewer", "web"})
        for folder in ("src", "viewer", "web"):
            self.assertRegex(made_of[folder], r"^[0-9a-f]{40}$")

    def test_is_one_file_that_asks_no_network_and_holds_its_licences(self):
        self.assertLess(page.stat().st_size, 3.0e6)
        policy = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', text)[1]
        self.assertIn("default-src 'none'", policy)
        self.assertEqual(re.findall(r'<(?:script|link|img|iframe)[^>]+(?:src|href)="(?!data:)[^"]+', text), [])
        version, terms = re.search(r'<script type="text/plain" id="matrigrate-notices">(.*?)</script>', text, re.DOTALL)[1].split("\n")
        self.assertRegex(version, r"^Matrigrate [\d.]+, commit [0-9a-f]{40}$")
        notices = zlib.decompress(base64.b64decode(terms)).decode()
        for name in ("emscripten", "libeigen3-dev", "librandom123-dev"):
            self.assertIn(f"==== {name} ====", notices)

    def test_answers_the_lesson(self):
        for words in ("from the start", "A lesson: five questions"):
            self.assertIn(words, text)


if __name__ == "__main__":
    unittest.main()
