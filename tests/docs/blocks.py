"""The code blocks of a page of Markdown, and how a test runs them in a scratch folder.

```sh       runs in bash, which stops at the first command that fails; the folder and exported variables are kept
```python   runs in this process, after the blocks before it
```r        runs with all R blocks before it, where Rscript is installed
```toml title="FILE"    is written to FILE
```text     is output: each line must have been printed on this page, whatever the numbers

<!-- not run: REASON --> before a block leaves it out; <!-- needs PROGRAM, PROGRAM --> where one of these is not installed.
<!-- exit code N --> or <!-- exit code N or M --> is the code that its last command ends with.
"""
import contextlib
import dataclasses
import io
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import traceback

reasons = {"builds the program", "needs Slurm", "needs root", "takes hours"}


@dataclasses.dataclass
class Block:
    language: str
    title: str
    text: str
    line: int
    not_run: str
    needs: list[str]
    codes: tuple[int, ...]


def blocks(page: pathlib.Path) -> list[Block]:
    found = []
    text = page.read_text(encoding="utf-8")
    pattern = r"(?:^<!-- (?:not run: (?P<why>[^>]*?)|needs (?P<needs>[^>]*?)|exit code (?P<codes>[^>]*?)) -->\n)?^```(?P<info>[^\n]*)\n(?P<body>.*?)^```$"
    for match in re.finditer(pattern, text, re.MULTILINE | re.DOTALL):
        title = re.search(r'title="([^"]*)"', match["info"])
        codes = tuple(int(code) for code in (match["codes"] or "0").split(" or "))
        found.append(Block((match["info"].split() or [""])[0], title[1] if title else "", match["body"],
                           text[:match.start("body")].count("\n") + 1, match["why"] or "", re.findall(r"[^, ]+", match["needs"] or ""), codes))
    return found


class Runner:
    """Runs the blocks of one page in the present folder."""

    def __init__(self, page: pathlib.Path) -> None:
        self.page = page
        self.printed = ""
        self.faults: list[str] = []
        self.skipped: list[str] = []
        self._names: dict[str, object] = {}
        self._r = ""

    def run(self) -> None:
        for block in blocks(self.page):
            at = f"{self.page.name}:{block.line}"
            if block.not_run:
                if block.not_run not in reasons:
                    self.faults.append(f"{at}: not a reason to leave a block out: {block.not_run}")
                self.skipped.append(f"{at} ({block.not_run})")
                continue
            if absent := [program for program in block.needs if not shutil.which(program)]:
                self.skipped.append(f"{at} (without {', '.join(absent)})")
                continue
            run = {"sh": self._shell, "python": self._python, "r": self._run_r, "toml": self._write,
                   "text": self._compare}.get(block.language)
            if run is None:
                self.faults.append(f"{at}: no test runs a block of '{block.language}'")
            elif fault := run(block):
                self.faults.append(f"{at}: {fault}")
                if block.language != "text":
                    return  # what follows would fail as well

    def _shell(self, block: Block) -> str:
        with tempfile.TemporaryDirectory() as folder:
            state = pathlib.Path(folder) / "state"
            script = f"set -eu -o pipefail\ntrap '{{ pwd; env -0; }} >{state}' EXIT\n{block.text}"
            done = subprocess.run(["bash", "-c", script], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            there, _, exported = state.read_text().partition("\n")
        self.printed += done.stdout
        os.chdir(there)
        os.environ.update(line.split("=", 1) for line in exported.split("\0") if "=" in line)
        if done.returncode not in block.codes:
            return f"ended with {done.returncode}, not {block.codes}:\n{done.stdout}"
        return ""

    def _python(self, block: Block) -> str:
        printed = io.StringIO()
        try:
            with contextlib.redirect_stdout(printed):
                exec(compile("\n" * block.line + block.text, self.page.name, "exec"), self._names)
        except BaseException:
            return traceback.format_exc()
        finally:
            self.printed += printed.getvalue()
        return ""

    def _run_r(self, block: Block) -> str:
        self._r += block.text
        if not shutil.which("Rscript"):
            self.skipped.append(f"{self.page.name}:{block.line} (no R)")
            return ""
        done = subprocess.run(["Rscript", "--vanilla", "-e", f"grDevices::pdf(NULL)\n{self._r}"], text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.printed += done.stdout
        return done.stdout if done.returncode else ""

    def _write(self, block: Block) -> str:
        if not block.title:
            return 'the block names no file: ```toml title="FILE"'
        pathlib.Path(block.title).write_text(block.text)
        return ""

    def _compare(self, block: Block) -> str:
        said = {plain(line) for line in re.split(r"[\n\r]", self.printed)}
        missing = [line for line in block.text.splitlines() if line.strip() and plain(line) not in said]
        return "not printed on this page: " + " | ".join(missing) if missing else ""


def plain(line: str) -> str:
    """A line without its numbers, and with single spaces."""
    return " ".join(re.sub(r"-?\d[\d.,]*(?:e[-+]?\d+)?", "0", line).split())
