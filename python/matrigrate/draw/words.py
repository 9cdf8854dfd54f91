"""What stands on axes, in legends and in captions: words of the program's tables, the paper's symbol and the unit. The pages' ``words.ts`` says the
same. And the one table of colours and sizes of figures.

>>> title("tau_prot_min"), title("n_protrusions")
('lifetime of a mature adhesion, mean, tau_prot (min)', 'protrusions initiated')
>>> title("ecm.youngs_modulus_Pa"), setting("ecm.youngs_modulus_Pa", 50.0), plain("$5 to $10")
("Young's modulus of the intact matrix, E (Pa)", 'E = 50 Pa', '\\\\$5 to \\\\$10')
"""
from __future__ import annotations

import functools
import math
import re
import textwrap
from typing import Any

from ..base.files import unit_of, unit_suffix
from ..results import results
from ..scenario import constants, schema
from ..tracks import meanings

colours: list[str] = schema.table("colours.json")["palette"]  #: Okabe and Ito's, which all eyes can separate
blue, red, grey = colours[0], colours[1], "#8a8f98"
least_for_box = 5  #: runs that a box is drawn of; of fewer the runs alone
style = {"font.size": 9, "axes.titlesize": 9, "axes.labelsize": 9, "xtick.labelsize": 8, "ytick.labelsize": 8, "legend.fontsize": 8,
         "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8, "lines.linewidth": 1.4}  #: legible at a width of 85 mm

_greek = {"eta": "η", "gamma": "γ", "zeta": "ζ", "kappa": "κ", "mu": "μ", "nu": "ν", "tau": "τ", "eps": "ε"}
_symbol = re.compile(rf"(?<![\w.])(?!n_(?!prot\b))({'|'.join(_greek)}|[A-Za-z])_([A-Za-z0-9]+(?:[_,][A-Za-z0-9]+)*)(?![\w.])")
_no_noun = re.compile(r"(The|With|Two|A|Whether|How|Which|What) ")
_people = re.compile(r"Young|Poisson|Kelvin|[xy] ")


def typeset(text: str) -> str:
    """For matplotlib: symbols with their index below the line.

    >>> typeset("f_mat, tau_prot")
    '$f_{\\\\mathrm{mat}}$, $τ_{\\\\mathrm{prot}}$'
    """
    return _symbol.sub(lambda m: f"${_greek.get(m[1], m[1])}_{{\\mathrm{{{m[2].replace('_', ',')}}}}}$", text)


def plain(text: str) -> str:
    """Text of a user for matplotlib, as it stands: "$" begins no formula, and a name in a legend may begin with "_"."""
    return re.sub("^_", "\u200b_", text.replace("$", r"\$"))


def lettered(text: str) -> str:
    """The same for HTML; the text has no other marks."""
    return _symbol.sub(lambda m: f"{_greek.get(m[1], m[1])}<sub>{m[2].replace('_', ',')}</sub>", text)


def shown_unit(unit: str) -> str:
    """"µm²" of "um^2"; "" of a ratio."""
    if unit in ("1", "-", ""):
        return ""
    return re.sub(r"\bum\b", "µm", unit).replace("^2", "²")


@functools.cache
def parameter_of(column: str) -> schema.Parameter | None:
    """The parameter whose column this is in tables of a study, "ecm.youngs_modulus_Pa"; None if there is none.

    >>> title("laws.constants.F_s_nN")
    'F_s (nN)'
    """
    if name := constants.name_in(column):  # not that of a plain number that ends like a unit: tau_s
        suffix, unit = unit_suffix(column), unit_of(column)
        name = name.removesuffix(f"_{suffix}") if suffix else name
        kind = "quantity" if suffix else "ratio"
        return schema.Parameter(f"{constants.path}.{name}", kind, "", name, "", unit, 1.0, "", ())
    known = schema.parameters()
    return max((p for path, p in known.items() if column == path or column.startswith(f"{path}_")), key=lambda p: len(p.path), default=None)


def noun(parameter: schema.Parameter) -> str:
    """A noun for a parameter: the first clause of its meaning; of a rule or a law the words of its name."""
    if constants.name_in(parameter.path):  # its symbol says it
        return ""
    clause = "" if parameter.path.startswith("laws.") else re.split(r"[;:,(]", parameter.meaning)[0].strip()
    if clause and len(clause) <= 60 and not _no_noun.match(clause):
        return clause if _people.match(clause) else clause[0].lower() + clause[1:]
    section, key = parameter.path.rsplit(".", 1)
    return f"{section}: {key}".replace("_", " ").replace(".", " ")


def at(readout: str, condition: str) -> str:
    """The name of a read-out at a condition.

    >>> at("l_prot_um", "50 Pa"), title(at("l_prot_um", "50 Pa"))
    ('l_prot_um at 50 Pa', 'length of mature protrusions, mean, l_prot (µm) at 50 Pa')
    """
    return f"{readout} at {condition}" if condition else readout


def symbol(column: str) -> str:
    """The paper's symbol of a read-out or parameter as it is typed; "" if it has none."""
    if parameter := parameter_of(column):
        return _greek.get(parameter.symbol, parameter.symbol)
    label = results.readout_table().get(column, {}).get("label", "")
    return label if _symbol.fullmatch(label) else ""


def words(column: str) -> str:
    """A read-out or a parameter in words."""
    if parameter := parameter_of(column):
        return noun(parameter)
    known = meanings() | {name: row["meaning"] for name, row in results.readout_table().items()}
    return known.get(column, column.replace("_", " "))


def unit(column: str) -> str:
    return shown_unit(results.readout_table().get(column, {"unit": unit_of(column)})["unit"])


def title(column: str) -> str:
    """Words, symbol and unit of a read-out or parameter, and the condition of ``at``."""
    column, between, condition = column.partition(" at ")
    parts = [part for part in (words(column), symbol(column)) if part]
    return ", ".join(parts) + (f" ({unit(column)})" if unit(column) else "") + between + condition


def axis_title(column: str, letters: int = 44) -> str:
    """For an axis of matplotlib: broken into lines, symbols typeset."""
    return typeset(textwrap.fill(title(column), letters, break_long_words=False))


def setting(column: str, value: Any) -> str:
    """A value of a parameter as a legend of matplotlib names it: by symbol, or by words if it has none."""
    name = f"{symbol(column)} =" if symbol(column) else words(column)
    return f"{typeset(name)} {plain(number(value))} {unit(column)}".strip()


def number(value: Any) -> str:
    """As people read it: "50", "0.2", "soft.csv"."""
    if isinstance(value, (bool, str)):
        return str(value)
    return "" if not math.isfinite(value) else f"{value:.4g}"


def time_text(seconds: float) -> str:
    """As the pages say it.

    >>> time_text(10800), time_text(720), time_text(90)
    ('3 h 00 min', '12 min', '1 min 30 s')
    """
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    parts = [f"{hours} h {minutes:02} min"] if hours else [f"{minutes} min"] if minutes or not rest else []
    return " ".join(parts + [f"{rest:02} s" if parts else f"{rest} s"] * (rest > 0))


def plain_decades(axis: Any, low: float, high: float) -> None:
    """Ticks of a logarithmic axis: decades where there are two, else 1, 2, 5, as plain numbers."""
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

    axis.set_major_locator(LogLocator(subs=(1.0,) if high > 99 * low else (1.0, 2.0, 5.0)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(NullFormatter())
