"""The code blocks of a page of Markdown, and how a test runs them in a scratch folder.

```sh       runs in bash, which stops at the first command that fails; the folder and exported variables are kept
```python   runs in this process, after the blocks before it
```r        runs with all R blocks before it, where Rscript is installed
```toml title="FILE"    is written to FILE
```text     is output: its lines must have been printed on this page, to the last digit and in this order; of output that was
            printed several times, the last one counts

<!-- not run: REASON --> before a block leaves it out; <!-- needs PROGRAM, PROGRAM --> where one of these is not installed.
<!-- exit code N --> or <!-- exit code N or M --> is the code that its last command ends with.
<!-- varies: WHAT --> before output whose numbers depend on the machine or the clock: they are not compared.
<!-- within N % --> before output whose numbers may differ by so much: test_page.py --update leaves those that agree.
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

reasons = {"builds the program", "needs Slurm", "needs root", "needs napari", "takes hours"}


@dataclasses.dataclass
class Block:
    language: str
    title: str
    text: str
    line: int
    not_run: str
    needs: list[str]
    codes: tuple[int, ...]
    varies: str  #: on what the numbers of an output depend; empty: on nothing
    within: float  #: by which share of its value a number of an output may differ
    start: int  #: of the text in the page
    end: int


def blocks(page: pathlib.Path) -> list[Block]:
    found = []
    text = page.read_text(encoding="utf-8")
    marks = (r"not run: (?P<why>[^>]*?)|needs (?P<needs>[^>]*?)|exit code (?P<codes>[^>]*?)|varies: (?P<varies>[^>]*?)"
             r"|within (?P<within>[\d.]+) %")
    pattern = rf"(?:^<!-- (?:{marks}) -->\n)?^```(?P<info>[^\n]*)\n(?P<body>.*?)^```$"
    for match in re.finditer(pattern, text, re.MULTILINE | re.DOTALL):
        title = re.search(r'title="([^"]*)"', match["info"])
        codes = tuple(int(code) for code in (match["codes"] or "0").split(" or "))
        found.append(Block((match["info"].split() or [""])[0], title[1] if title else "", match["body"],
                           text[:match.start("body")].count("\n") + 1, match["why"] or "", re.findall(r"[^, ]+", match["needs"] or ""), codes,
                           match["varies"] or "", float(match["within"] or 0) / 100, *match.span("body")))
    return found


class Runner:
    """Runs the blocks of one page in the present folder."""

    def __init__(self, page: pathlib.Path) -> None:
        self.page = page
        self.printed = ""
        self.faults: list[str] = []
        self.skipped: list[str] = []
        self.compared = 0  #: blocks of output
        self._outputs: list[tuple[Block, str]] = []  # each, as it was printed
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
        """What differs from the last output of the same words; keeps that output for updated()."""
        self.compared += 1
        wanted = [line for line in block.text.splitlines() if line.strip()]
        printed = [line.rstrip() for line in re.split(r"[\n\r]", self.printed) if line.strip()]
        starts = [k for k, line in enumerate(printed) if wanted and plain(line) == plain(wanted[0])]
        found = next(filter(None, (follow(wanted, printed[k:]) for k in reversed(starts))), None)
        if found is None:
            return "not printed on this page, or not in this order: " + " | ".join(wanted)
        shown, different = [], ""
        for line in block.text.splitlines():
            real = found.pop(0) if line.strip() else line
            same = agrees(line, real, block)
            shown.append(line if same else real)
            different += "" if same else f"\n  shown:   {line}\n  printed: {real}"
        self._outputs.append((block, "".join(line + "\n" for line in shown)))
        return f"{other_numbers} (tests/docs/test_page.py --update takes the printed ones):{different}" if different else ""

    def updated(self) -> str:
        """The page with each output as it was printed."""
        text = self.page.read_text(encoding="utf-8")
        for block, output in reversed(self._outputs):
            text = text[:block.start] + output + text[block.end:]
        return text


other_numbers = "other numbers than were printed"
number = re.compile(r"(?<![\w.])-?\d[\d.,]*(?:e[-+]?\d+)?")


def plain(line: str) -> str:
    """A line without its numbers, and with single spaces. A number in the first column of a table belongs to its words."""
    columns = re.split(r" {2,}", line.strip())
    if len(columns) > 1:
        return " ".join([columns[0], number.sub("0", " ".join(columns[1:]))])
    return number.sub("0", line.strip())


def follow(wanted: list[str], printed: list[str]) -> list[str] | None:
    """For each line the next one printed of the same words; None unless all are there."""
    rest = iter(printed)
    found = [next((line for line in rest if plain(line) == plain(want)), None) for want in wanted]
    return None if None in found else found


def agrees(shown: str, printed: str, block: Block) -> bool:
    """Of two lines with the same words: are their numbers the same, as far as the marks of the block ask for it?"""
    if block.varies or shown.rstrip() == printed:
        return True
    if block.within == 0.0:
        return False
    pairs = zip(number.findall(shown), number.findall(printed), strict=True)
    return all(a == b or abs(_value(a) - _value(b)) <= block.within * abs(_value(b)) for a, b in pairs)


def _value(text: str) -> float:
    """Of what looks like a number; "1.2.3" is none."""
    try:
        return float(text.rstrip(".,").replace(",", ""))
    except ValueError:
        return float("nan")
