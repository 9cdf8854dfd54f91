#!/usr/bin/env python3
"""Writes the generated parts of docs/validation.md, docs/validation/results.md and docs/performance.md from the tables in docs/validation.

    tools/validation_page.py [--check]    # with --check: writes nothing; exit code 1 and a diff if a page is stale

A generated part stands between the lines `<!-- generated: NAME -->` and `<!-- end -->`. The tables of runs
(<study>-results.csv) and of verdicts (claims.csv, experiments.csv; in before/ those of the set of closures before the default, where they are kept) are
copied there by tools/keep_results.sh.
"""
import argparse
import csv
import dataclasses
import difflib
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEPT = ROOT / "docs/validation"
BEFORE = KEPT / "before"
PAGES = ["docs/validation.md", "docs/validation/results.md", "docs/performance.md"]
LENGTH = 15_000  # characters of docs/validation.md, at most

READOUTS = [  # column, name, digits
    ("v_migr_abs_um_per_h", "speed from start to end, um/h", 1),
    ("v_migr_path_60s_um_per_h", "speed along the path, every 60 s, um/h", 1),
    ("v_migr_path_600s_um_per_h", "speed along the path, every 600 s, um/h", 1),
    ("n_protrusions", "protrusions in six hours", 1),
    ("n_unadhered", "never adhered", 1),
    ("tau_prot_min", "lifetime of a protrusion, min", 0),
    ("l_prot_um", "length of a protrusion, um", 1),
    ("f_mat", "maturation, 0 to 1", 2),
    ("f_adh_rel", "force of an adhesion over its largest, at its end", 2),
    ("n_simultaneous_mean", "protrusions at a time", 1),
    ("msd_slope", "slope of the mean square displacement", 2),
]
STUDIES = [  # name, what varies
    ("stiffness", "A1 to A7: Young's modulus"),
    ("contraction", "A8: actomyosin force of a strand"),
    ("initiation-rate", "B1, B2: rate of initiation"),
    ("disassembly-rate", "B3: rate of disassembly"),
    ("growth-time", "B4: time of growth"),
    ("sensitive-adhesions", "C: zeta_diss = 80 /nN, by Young's modulus"),
    ("insensitive-adhesions", "C: one rate of disassembly, by Young's modulus"),
    ("kept-protrusions", "D: protrusions kept up"),
    ("kept-protrusions-fibres", "E: protrusions kept up, among uniaxial fibres"),
]
NEW_SEEDS = [("50 Pa: all", "50 Pa"), ("200 Pa: all", "200 Pa"), ("400 Pa: all", "400 Pa"), ("one: all", "n_prot 1"),
             ("three: all", "3"), ("four: all", "4"), ("fibres one: all", "fibres, n_prot 1"), ("fibres two: all", "2")]


def rows_of(path: pathlib.Path) -> list[dict[str, str]]:
    """The rows of a table; none if it is not kept."""
    if not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def table(head: list[str], rows: list[list[str]]) -> str:
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def numbers(rows: list[dict[str, str]], label: str, column: str) -> list[float]:
    return [float(row[column]) for row in rows if row["label"] == label and row.get(column)]


def mean_and_sd(values: list[float]) -> tuple[float, float]:
    mean = sum(values) / len(values)
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))


def cell(values: list[float], digits: int) -> str:
    if len(values) < 2:
        return ""
    mean, sd = mean_and_sd(values)
    return f"{mean:.{digits}f} +- {sd:.{digits}f}"


def means(rows: list[dict[str, str]], points: list[tuple[str, str]], without: tuple[str, ...] = ()) -> str:
    """Means and standard deviations of runs, by point."""
    made = []
    for column, name, digits in READOUTS:
        if column in without:
            continue
        cells = [cell(numbers(rows, label, column), digits) for label, _ in points]
        if any(cells):
            made.append([name, *cells])
    return table(["read-out", *(name for _, name in points)], made)


# The verdicts.


def count(rows: list[dict[str, str]], verdict: str) -> int:
    return sum(row["verdict"] == verdict for row in rows)


def bottom_line(_page: str) -> str:
    rows = rows_of(KEPT / "claims.csv")
    predicted = [row for row in rows if row["kind"] == "predicted"]
    open_rows = [row["id"] for row in rows if row["verdict"] == "undecided"]
    lines = [f"**Of the {len(rows)} claims {count(rows, 'holds')} hold, {count(rows, 'in direction')} come out in direction, and "
             f"{count(rows, 'does not hold')} do not hold**"
             + (f"; {len(open_rows)} are still to be judged ({', '.join(open_rows)}), since their runs are not made yet." if open_rows else "."),
             f"Of the {len(predicted)} predicted rows {count(predicted, 'holds')} hold, {count(predicted, 'in direction')} are in direction, "
             f"{count(predicted, 'does not hold')} do not hold"
             + (f", and {count(predicted, 'undecided')} are to be judged." if open_rows else "."),
             f"Against the paper's direction, by a whole interval of 95 %: {', '.join(row['id'] for row in rows if row['against']) or 'none'}."]
    return "\n".join(lines)


def shortened(text: str, parts: int = 2) -> str:
    """The first parts of a list that semicolons separate, and how many more there are."""
    found = [part for part in text.split("; ") if part]
    more = len(found) - parts
    return "; ".join(found[:parts]) + (f"; and {more} more ([conditions](conditions.csv))" if more > 0 else "")


def plain(text: str) -> str:
    """Points without the name of their study, where the claim leaves no doubt of it."""
    text = re.sub(r"\b(stiffness|contraction|kept-protrusions|(initiation|disassembly)-rate|growth-time|durotaxis|microtracks|contact-guidance|channel-width"
                  r"|two-cells): ", "", text.replace("kept-protrusions-fibres: ", "fibres, "))
    return text.replace("|", "\\|")


def verdict(row: dict[str, str]) -> str:
    """A row's verdict, and that with the cells that ended at the rim made again in a larger disc."""
    again = row["verdict_in_larger_disc"]
    return f"**{row['verdict']}**" + (f"; with cells at the rim made again: {again}" if again else "")


def by_verdict(name: str) -> str:
    """The rows of each verdict; * marks those that served no choice."""
    rows, lines = rows_of(KEPT / name), []
    for word in ("holds", "in direction", "does not hold", "undecided"):
        found = [row["id"] + ("*" if row["kind"] == "predicted" else "") for row in rows if row["verdict"] == word]
        if found:
            lines.append(f"- *{word}*: {', '.join(found)}")
    return "\n".join(lines)


def claims(_page: str) -> str:
    return by_verdict("claims.csv")


def with_reasons(name: str) -> str:
    """Claims, our values and what is not met, and in a column of its own the verdict of the set of closures before the default, where it is kept."""
    before = {row["id"]: [row["verdict"]] for row in rows_of(BEFORE / name)}
    return table(["row", "claim", "published", "ours: mean [95 % interval]", "verdict", *(["set before"] if before else []), "not met"],
                 [[row["id"], row["claim"], row.get("published", ""), plain(shortened(row["ours"], 5)), verdict(row),
                   *before.get(row["id"], [""] if before else []), plain(shortened(row["why_not"].removeprefix("not met: ")))]
                  for row in rows_of(KEPT / name)])


def verdicts(_page: str) -> str:
    return with_reasons("claims.csv")


def experiments(_page: str) -> str:
    return by_verdict("experiments.csv")


def experiment_verdicts(_page: str) -> str:
    return with_reasons("experiments.csv")


def constrictions(_page: str) -> str:
    """Row X4 by width and kind: speed and number of the runs that finished; after a slash the same with those that ended at the rim made again."""
    rows, again = (rows_of(KEPT / f"channel-width{disc}-results.csv") for disc in ("", "-larger-disc"))
    if not rows:
        return "The runs of the second set are still to be made."
    column, kinds = "v_migr_abs_um_per_h", [", no degradation", ", nucleus, no degradation", "", ", nucleus"]
    made = []
    for width in dict.fromkeys(row["label"].split(",")[0] for row in rows):
        cells = []
        for label in (width + kind for kind in kinds):
            values = numbers(rows, label, column)
            cells.append(f"{cell(values, 1)} ({len(values)})")
            if new := numbers(again, label, column):
                cells[-1] += f" / {cell(values + new, 1)} ({len(values + new)})"
        made.append([width, *cells])
    return table(["constriction", *(kind.removeprefix(", ") or "with degradation" for kind in kinds[:3]), "nucleus, with degradation"], made)


def study_means(_page: str) -> str:
    parts = []
    for name, varies in STUDIES:
        rows = rows_of(KEPT / f"{name}-results.csv")
        if not rows:
            parts.append(f"**{varies}**: the runs of the second set are still to be made.")
            continue
        labels = list(dict.fromkeys(row["label"] for row in rows))
        runs = sum(row["label"] == labels[0] for row in rows)
        ended = [row for row in rows if row["status"] != "done"]
        causes = sorted({row.get("cause") or row["status"] for row in ended})
        by_cause = ", ".join(f"{sum((row.get('cause') or row['status']) == cause for row in ended)} by {cause}" for cause in causes)
        again = ", made again in a larger disc for the claims" if (KEPT / f"{name}-larger-disc-results.csv").exists() else ""
        parts.append(f"**{varies}**, {runs} runs a point; of {len(rows)} runs {len(ended)} ended early"
                     + (f": {by_cause}{again}" if ended else "") + ".\n\n"
                     + means(rows, [(label, re.sub(r"^(youngs_modulus|force|rate|r_prot|r_off_min|growth_time) ", "", label)) for label in labels]))
        figures = [(f"{name}{kind}.svg", what) for kind, what in
                   (("", "box plots"), ("-paths", "paths"), ("-shapes", "shapes"), ("-msd", "mean square displacements"),
                    ("-adhesions", "forces at which adhesions ended")) if (KEPT / f"{name}{kind}.svg").exists()]
        if figures:
            parts.append("Drawn from the tables beside them: " + ", ".join(f"[{what}]({file})" for file, what in figures) + ".")
    return "\n\n".join(parts)


def new_seeds(_page: str) -> str:
    return means(rows_of(KEPT / "second-set-results.csv"), NEW_SEEDS, ("v_migr_path_600s_um_per_h", "n_unadhered", "n_simultaneous_mean"))


@dataclasses.dataclass
class Row:
    """A row that does not hold: what it asks for, and the read-out at a point (less that at another one)."""
    claim: str
    wanted: str
    column: str
    digits: int
    point: str  # of the studies of sensitivity
    kept: tuple[str, str]  # study and label of the same point with the second set
    less: str = ""
    kept_less: tuple[str, str] = ("", "")


FAILING = [
    Row("A1", "speed at 50 Pa: 3.7 um/h", "v_migr_abs_um_per_h", 1, "50 Pa", ("stiffness", "youngs_modulus 50 Pa")),
    Row("A4", "length of protrusions at 400 Pa less that at 50 Pa: below 0 um", "l_prot_um", 1, "400 Pa", ("stiffness", "youngs_modulus 400 Pa"),
        "50 Pa", ("stiffness", "youngs_modulus 50 Pa")),
    Row("A8", "protrusions at 0.6 nN less that at 0.2 nN a strand: above 0", "n_protrusions", 1, "200 Pa", ("contraction", "force 0.6 nN"),
        "F_am 0.2 nN a strand", ("contraction", "force 0.2 nN")),
    Row("C2", "share of adhesions that end at a low relative force at 50 Pa, zeta_diss 80 /nN less 20 /nN: above 0", "share_f_adh_rel_low", 2, "zeta_diss 80 /nN, 50 Pa",
        ("sensitive-adhesions", "youngs_modulus 50 Pa"), "50 Pa", ("stiffness", "youngs_modulus 50 Pa")),
    Row("C2", "protrusions at 200 Pa, zeta_diss 80 /nN less 20 /nN: below 0", "n_protrusions", 1, "zeta_diss 80 /nN, 200 Pa",
        ("sensitive-adhesions", "youngs_modulus 200 Pa"), "200 Pa", ("stiffness", "youngs_modulus 200 Pa")),
    Row("C4", "protrusions at 300 Pa, zeta_diss 20 /nN less one rate: above 0", "n_protrusions", 1, "300 Pa", ("stiffness", "youngs_modulus 300 Pa"),
        "one rate, 300 Pa", ("insensitive-adhesions", "youngs_modulus 300 Pa")),
    Row("D2", "path at n_prot 3: 26.6 um/h", "v_migr_path_60s_um_per_h", 1, "n_prot 3", ("kept-protrusions", "n_prot 3")),
    Row("E1", "speed among fibres at n_prot 2: 10.7 um/h", "v_migr_abs_um_per_h", 1, "fibres, n_prot 2",
        ("kept-protrusions-fibres", "n_prot 2")),
    Row("E2", "path among fibres at n_prot 2: 21.2 um/h", "v_migr_path_60s_um_per_h", 1, "fibres, n_prot 2", ("kept-protrusions-fibres", "n_prot 2")),
    Row("E4", "angle of the path off the fibres at n_prot 1: below 45 degrees", "path_angle_deg", 0, "fibres, n_prot 1",
        ("kept-protrusions-fibres", "n_prot 1")),
]
CONDITIONS = ["share 0.10", "share 0.20", "larger pressure", "no wait for rest"]


def with_error(values: list[float], less: list[float], digits: int) -> str:
    """Mean and standard error, of a difference where there is something to take off."""
    if len(values) < 2 or len(less) == 1:
        return ""
    squares = [mean_and_sd(v)[1] ** 2 / len(v) for v in (values, less) if v]
    mean = mean_and_sd(values)[0] - (mean_and_sd(less)[0] if less else 0.0)
    return f"{mean:.{digits}f} +- {math.sqrt(sum(squares)):.{digits}f}"


def sensitivity(_page: str) -> str:
    rows = [row for name in ("sensitivity-second", "sensitivity-adhesions") for row in rows_of(KEPT / f"{name}-results.csv")]
    kept = {study: rows_of(KEPT / f"{study}-results.csv") for study, _ in STUDIES}
    made = []
    for row in FAILING:
        of_kept = [numbers(kept[study], label, row.column) if study else [] for study, label in (row.kept, row.kept_less)]
        cells = [with_error(*of_kept, row.digits)]
        for condition in CONDITIONS:
            values = numbers(rows, f"{condition}: {row.point}", row.column)
            less = numbers(rows, f"{condition}: {row.less}", row.column)
            cells.append(with_error(values, less, row.digits) if less or not row.less else "")
        made.append([row.claim, row.wanted, *cells])
    return table(["row", "wanted", "second set", *CONDITIONS], made)


# Both integrators: Welch's t-test.


def two_sided(t: float, df: float) -> float:
    """p of Student's t, by the continued fraction of the incomplete beta function."""
    x, a, b = df / (df + t * t), 0.5 * df, 0.5
    if x > (a + 1.0) / (a + b + 2.0):
        return 1.0 - beta_share(b, a, 1.0 - x)
    return beta_share(a, b, x)


def beta_share(a: float, b: float, x: float) -> float:
    if x <= 0.0:
        return 0.0
    front = math.exp(math.lgamma(a + b) - math.lgamma(a) - math.lgamma(b) + a * math.log(x) + b * math.log1p(-x)) / a
    c, d = 1.0, 1.0 / (1.0 - (a + b) * x / (a + 1.0))
    h = d
    for m in range(1, 300):
        for term in (m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m)), -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1))):
            d = 1.0 / (1.0 + term * d)
            c = 1.0 + term / c
            h *= d * c
    return front * h


def quantile(df: float) -> float:
    """t with two_sided(t, df) = 0.05."""
    low, high = 1.0, 20.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if two_sided(middle, df) > 0.05 else (low, middle)
    return low


def integrators(_page: str) -> str:
    rows = rows_of(KEPT / "integrators-results.csv")
    made = []
    for column, name, digits in READOUTS:
        a, b = (numbers(rows, label, column) for label in ("adaptive", "reference"))
        if column in ("f_adh_rel", "n_unadhered"):
            continue
        digits = {"n_simultaneous_mean": 2, "tau_prot_min": 1}.get(column, digits)
        (mean_a, sd_a), (mean_b, sd_b) = mean_and_sd(a), mean_and_sd(b)
        share_a, share_b = sd_a**2 / len(a), sd_b**2 / len(b)
        error = math.sqrt(share_a + share_b)
        df = error**4 / (share_a**2 / (len(a) - 1) + share_b**2 / (len(b) - 1))
        difference, half, p = mean_a - mean_b, quantile(df) * error, two_sided((mean_a - mean_b) / error, df)
        made.append([name, cell(a, digits), cell(b, digits),
                     f"{difference:.{digits}f} ({difference - half:.{digits}f} to {difference + half:.{digits}f})",
                     f"{p:.2f}" if p >= 0.01 else f"{p:.3f}"])
    return table(["read-out", "adaptive, up to 5 s", "reference", "difference, 95 % interval", "p"], made)


PARTS = {"bottom line": bottom_line, "claims": claims, "verdicts": verdicts, "experiments": experiments,
         "experiment verdicts": experiment_verdicts, "constrictions": constrictions, "means": study_means, "new seeds": new_seeds, "sensitivity": sensitivity, "integrators": integrators}
PART = re.compile(r"(<!-- generated: ([\w ]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def written(page: str) -> str:
    text = (ROOT / page).read_text(encoding="utf-8")
    unknown = [name for _, name, _ in PART.findall(text) if name not in PARTS]
    if unknown:
        sys.exit(f"{page}: unknown generated part '{unknown[0]}'; there are {', '.join(PARTS)}")
    return PART.sub(lambda part: f"{part[1]}{PARTS[part[2]](page)}\n{part[3]}", text)


def main() -> int:
    assert abs(two_sided(2.0, 10.0) - 0.07339) < 1e-4 and abs(quantile(46.0) - 2.0129) < 1e-3
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="write nothing; fail if a page is stale")
    check = parser.parse_args().check
    code = 0
    for page in PAGES:
        made = written(page)
        path = ROOT / page
        if not check:
            path.write_text(made, encoding="utf-8")
        else:
            diff = list(difflib.unified_diff(path.read_text(encoding="utf-8").splitlines(), made.splitlines(), page,
                                             f"{page}, written by tools/validation_page.py", lineterm="", n=0))
            print("\n".join(diff), end="\n" if diff else "")
            code = 1 if diff else code
    length = len((ROOT / PAGES[0]).read_text(encoding="utf-8"))
    if length > LENGTH:
        print(f"{PAGES[0]}: has {length} characters, {LENGTH} at most are wanted")
        code = 1
    return code


if __name__ == "__main__":
    sys.exit(main())
