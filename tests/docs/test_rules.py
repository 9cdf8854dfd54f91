"""The rules of the tests of the documentation themselves, on text that breaks them and text that does not."""
import os
import pathlib
import tempfile
import unittest

import blocks
import links


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
                        "```sh\ncat x.toml; echo \"$A  um\"\n```\n```text\nk = 27\n3.1 um\n```\n"
                        '```python\nn = open("x.toml").read()\n```\n```python\nassert n == "k = 1\\n"\n```\n')
        self.assertEqual(done.faults, [])

    def test_faults_are_found(self):
        for text, fault in (("```sh\nfalse\n```\n", "page.md:2: ended with 1"), ("```python\n1 / 0\n```\n", "ZeroDivisionError"),
                            ("```text\nhello\n```\n", "not printed on this page: hello"), ("```ruby\n```\n", "no test runs"),
                            ("```toml\n```\n", "names no file"), ("<!-- not run: dull -->\n```sh\nfalse\n```\n", "not a reason"),
                            ("<!-- exit code 4 -->\n```sh\ntrue\n```\n", "ended with 0, not (4,)")):
            self.assertIn(fault, "\n".join(self.ran(text).faults))

    def test_marks(self):
        done = self.ran("<!-- not run: needs Slurm -->\n```sh\nfalse\n```\n<!-- exit code 0 or 4 -->\n```sh\nexit 4\n```\n")
        self.assertEqual((done.faults, done.skipped), ([], ["page.md:3 (needs Slurm)"]))


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


if __name__ == "__main__":
    unittest.main()
