"""Formulas of plain-text pages as TeX, and TeX as HTML by KaTeX."""
import html
import json
import pathlib
import re
import subprocess
import tomllib

here = pathlib.Path(__file__).resolve().parent
_greek = {"eps": "\\varepsilon"} | {name: f"\\{name}" for name in
                                    ("alpha", "gamma", "eta", "theta", "kappa", "mu", "nu", "rho", "sigma", "zeta", "Gamma")}
_symbol = re.compile(r"(?<![\w/.`-])(?:([A-Za-z]+)((?:_[A-Za-z0-9]+)+(?:,(?:adh|init|min|[0ij])\b)?)(?!\w|\.\w)|"
                     rf"({'|'.join(name for name in _greek if name != 'Gamma')})(?![\w/(]|\.\w))")


def tex_of_symbol(base: str, below: str = "") -> str:
    """F, _am -> F_{\\text{am}}; l, _0,adh -> l_{0,\\text{adh}}."""
    parts = [part for part in re.split("[_,]", below) if part]
    below_tex = ",".join(part if len(part) == 1 or part == "ij" else f"\\text{{{part}}}" for part in parts)
    return _greek.get(base, base if len(base) == 1 else f"\\text{{{base}}}") + (f"_{{{below_tex}}}" if parts else "")


def marked(text: str, tex: str, display: bool = False) -> str:
    """A span that stands for a formula until rendered(): it keeps the plain text, for the search."""
    plain = "".join(f"&#{ord(c)};" if c in "*_^[]<>&|`\\-" else c for c in text)
    return f'<span class="tex" data-tex="{tex.encode().hex()}" data-display="{int(display)}">{plain}</span>'


def load() -> list[tuple[str, str]]:
    """The equations of equations.toml, longest first."""
    entries = tomllib.loads((here / "equations.toml").read_text(encoding="utf-8"))["equation"]
    return sorted(((entry["text"], entry["tex"]) for entry in entries), key=lambda pair: -len(pair[0]))


def with_formulas(text: str, equations: list[tuple[str, str]], met: set[str], display: bool = False) -> str:
    """A piece of Markdown (no code in it) with its known equations, and its symbols, as formulas."""
    pieces: list[tuple[str, bool]] = [(text, False)]
    for plain, tex in equations:
        pattern = re.compile(r"(?<!\w)" + re.sub(r"(\\ )+", r"\\s+", re.escape(plain)) + r"(?!\w)")
        made: list[tuple[str, bool]] = []
        for piece, done in pieces:
            if done:
                made.append((piece, True))
                continue
            at = 0
            for match in pattern.finditer(piece):
                met.add(plain)
                made += [(piece[at:match.start()], False), (marked(plain, tex, display), True)]
                at = match.end()
            made.append((piece[at:], False))
        pieces = made
    return "".join(piece if done else _symbol.sub(
        lambda match: marked(match[0], tex_of_symbol(match[1] or match[3], match[2] or "")), piece)
        for piece, done in pieces)


_span = re.compile(r'<span class="tex" data-tex="([0-9a-f]*)" data-display="([01])">(.*?)</span>', re.DOTALL)
_script = """const katex = require("katex");
const all = JSON.parse(require("fs").readFileSync(0, "utf8"));
console.log(JSON.stringify(all.map(([tex, display]) => katex.renderToString(
  (display ? "\\\\displaystyle " : "") + tex, {throwOnError: true, strict: "error"}))));"""


def render(site: pathlib.Path) -> int:
    """Puts KaTeX's HTML, with MathML for readers of the screen, in place of all marked formulas. Returns how many differ."""
    pages = {path: path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    wanted = sorted({match.groups()[:2] for text in pages.values() for match in _span.finditer(text)})
    if not wanted:
        return 0
    done = subprocess.run(["node", "-e", _script], text=True, capture_output=True, check=False,
                          env={"NODE_PATH": "/usr/share/nodejs", "PATH": "/usr/local/bin:/usr/bin:/bin"},
                          input=json.dumps([[bytes.fromhex(tex).decode(), display == "1"] for tex, display in wanted]))
    if done.returncode:
        raise SystemExit(f"KaTeX: {done.stderr}")
    made = dict(zip(wanted, json.loads(done.stdout)))
    for path, text in pages.items():
        new = _span.sub(lambda match: made[match.groups()[:2]], text)
        if new != text:
            path.write_text(new, encoding="utf-8")
    return len(wanted)


def plain(text: str) -> str:
    """Markdown or HTML with marked formulas as the plain text they stand for."""
    return html.unescape(_span.sub(lambda match: match[3], text))
