"""The rules of the tests of the documentation themselves, on text that breaks them and text that does not."""
import os
import pathlib
import re
import sys
import tempfile
import unittest

import blocks
import links

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools" / "site"))
import formulas  # noqa: E402
import gather  # noqa: E402
import reference  # noqa: E402

source = pathlib.Path(__file__).resolve().parents[2]


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.addCleanup(os.chdir, os.getcwd())
        self.folder = pathlib.Path(folder.name)
        os.chdir(self.folder)


class Blocks(InFolder):
    def ran(self, text):
        (self.folder / "page.md").write_text(text)
        runner = blocks.Runner(self.folder / "page.md")
        runner.run()
        return runner

    def test_state_is_kept_and_output_compared(self):
        done = self.ran('```sh\nexport A=5\nmkdir b\ncd b\n```\n```toml title="x.toml"\nk = 1\n```\n'
                        "```sh\ncat x.toml; echo \"$A um\"\n```\n```text\nk = 1\n5 um\n```\n"
                        '```python\nimport pathlib\nn = pathlib.Path("x.toml").read_text()\n```\n```python\nassert n == "k = 1\\n"\n```\n')
        self.assertEqual(done.faults, [])

    def test_faults_are_found(self):
        for text, fault in (("```sh\nfalse\n```\n", "page.md:2: ended with 1"), ("```python\n1 / 0\n```\n", "ZeroDivisionError"),
                            ("```text\nhello\n```\n", "not printed on this page, or not in this order: hello"), ("```ruby\n```\n", "no test runs"),
                            ("```toml\n```\n", "names no file"), ("<!-- not run: dull -->\n```sh\nfalse\n```\n", "not a reason"),
                            ("<!-- exit code 4 -->\n```sh\ntrue\n```\n", "ended with 0, not (4,)")):
            self.assertIn(fault, "\n".join(self.ran(text).faults))

    two_runs = ('```sh\nfor run in "1.5 2" "2.5 3"; do set -- $run; echo "speed every 60 s  $1"; echo "speed every 600 s  $2"; echo; done\n'
                'echo "Done: 4 steps."\n```\n')

    def test_numbers_of_outputs_are_compared(self):
        for shown, fault in (("speed every 600 s  3\n\nDone: 4 steps.\n", ""), ("speed every 60 s  2.5\nDone: 4 steps.\n", ""),
                             ("speed every 60 s  1.5\n", "printed: speed every 60 s  2.5"),  # of the run before
                             ("speed every 600 s  3\nDone: 5 steps.\n", "printed: Done: 4 steps."),
                             ("speed every 300 s  3\n", "not printed"), ("Done: 4 steps.\nspeed every 60 s  2.5\n", "not in this order")):
            faults = "\n".join(self.ran(f"{self.two_runs}```text\n{shown}```\n").faults)
            self.assertIn(fault, faults)
            self.assertEqual(bool(fault), bool(faults), shown)

    def test_marks_of_outputs(self):
        for mark, good in (("varies: the machine", True), ("within 25 %", True), ("within 10 %", False)):
            done = self.ran(f"{self.two_runs}<!-- {mark} -->\n```text\nspeed every 60 s  2.1\n```\n")
            self.assertEqual(not done.faults, good, mark)

    def test_outputs_are_rewritten(self):
        page = self.two_runs + "```text\n{}\n\n{}\n```\nbetween\n<!-- within 30 % -->\n```text\n{}\n```\n"
        done = self.ran(page.format("speed every 600 s  2", "Done: 5 steps.", "speed every 60 s  2.1"))
        self.assertEqual(done.updated(), page.format("speed every 600 s  3", "Done: 4 steps.", "speed every 60 s  2.1"))
        self.assertEqual(self.ran(done.updated()).faults, [])

    def test_marks(self):
        done = self.ran("<!-- not run: needs Slurm -->\n```sh\nfalse\n```\n<!-- exit code 0 or 4 -->\n```sh\nexit 4\n```\n")
        self.assertEqual((done.faults, done.skipped), ([], ["page.md:3 (needs Slurm)"]))
        done = self.ran("<!-- needs sh, no-such-program -->\n```sh\nfalse\n```\n<!-- needs sh -->\n```sh\ntrue\n```\n")
        self.assertEqual((done.faults, done.skipped), ([], ["page.md:3 (without no-such-program)"]))


class Links(InFolder):
    def test_faults_are_found(self):
        (self.folder / "a.html").write_text('<h1 id="x">A</h1><a href="b.html#y">b</a><a href="#x">x</a><a href="https://a.example">a</a>')
        (self.folder / "b.html").write_text('<p id="y"></p>')
        (self.folder / "c.css").write_text("p { background: url(data:image/png;base64,AA) }")
        self.assertEqual(links.faults(self.folder), [])
        (self.folder / "d.html").write_text(
            '<a href="no.html"></a><a href="b.html#no"></a><a href="/b.html"></a><script src="https://a.example/s.js"></script>'
            '<style>@import "//a.example/t.css"</style>')
        (self.folder / "e.css").write_text("p { background: url(no.png) }")
        self.assertEqual(links.faults(self.folder), [
            "d.html: no such file: no.html", "d.html: no such place: b.html#no", "d.html: not relative: /b.html",
            "d.html: takes https://a.example/s.js from the network", "d.html: a style takes //a.example/t.css from the network",
            "e.css: no such file: no.png"])


class Pages(unittest.TestCase):
    def test_lists_and_fences_become_those_of_mkdocs(self):
        self.assertEqual(gather._for_mkdocs("a\n- b\n  c\n   - d\n\ne\n"), "a\n\n- b\n    c\n    - d\n\ne\n")
        self.assertEqual(gather._for_mkdocs("```\nmatrigrate list\n```\nb\n\n```\n12\n```\n<!-- c -->\n"),
                         "```sh\nmatrigrate list\n```\nb\n\n```text\n12\n```\n")
        self.assertEqual(gather._for_mkdocs("```text\n- a\n<!-- b -->\n```\n"), "```text\n- a\n<!-- b -->\n```\n")

    def test_anchors_are_those_of_github(self):
        self.assertEqual([gather.slug("The paper's claims"), gather.slug("A, b: c_d (e)")], ["the-papers-claims", "a-b-c_d-e"])

    def test_symbols_become_tex(self):
        for base, below, tex in (("F", "_am", "F_{\\text{am}}"), ("l", "_0,adh", "l_{0,\\text{adh}}"), ("kappa", "", "\\kappa"),
                                 ("x", "_ij", "x_{ij}")):
            self.assertEqual(formulas.tex_of_symbol(base, below), tex)

        def met(text):
            return [span[2] for span in formulas._span.findall(formulas.with_formulas(text, [("A v = F", "x")], set()))]

        self.assertEqual(met("In A v\n= F the k_s"), ["A v = F", "k&#95;s"])
        self.assertEqual(met("a file drag_cache.hpp, an eta/2 and a number"), [])

    def test_each_header_is_listed_once(self):
        listed = re.findall(r"\(source:(src/[^)]+)\)", reference.cpp_page(source)["reference/cpp.md"])
        self.assertEqual(sorted(listed), sorted(path.relative_to(source).as_posix() for path in (source / "src").rglob("*.hpp")))


if __name__ == "__main__":
    unittest.main()
