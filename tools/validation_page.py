#!/usr/bin/env python3
"""Writes the generated parts of docs/validation.md and docs/validation/results.md from the tables in docs/validation.

    tools/validation_page.py [--check]    # with --check: writes nothing; exit code 1 and a diff if a page is stale

A generated part stands between the lines `<!-- generated: NAME -->` and `<!-- end -->`. The tables of runs
(<study>-results.csv) and of verdicts (claims.csv, experiments.csv; in before/ those of the set of closures before the default, where they are kept) are
copied there by tools/keep_results.sh.
"""
import argparse
import csv
import difflib
import math
import pathlib
import random
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEPT = ROOT / "docs/validation"
BEFORE = KEPT / "before"
PAGES = ["docs/validation.md", "docs/validation/results.md"]
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
        return f"{values[0]:.{digits}f}" if values else ""
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


def ids(rows: list[dict[str, str]], column: str) -> str:
    return ", ".join(row["id"] for row in rows if row[column]) or "none"


def second_edition(rows: list[dict[str, str]]) -> str:
    """The same by the second edition of the rules, which differs in some rows."""
    before = [{**row, "verdict": row["verdict_second_edition"] or row["verdict"],
               "against": row["against_second_edition"] if row["verdict_second_edition"] else row["against"]} for row in rows]
    numbers = " / ".join(str(count(before, word)) for word in ("holds", "in direction", "does not hold"))
    same = " as well" if [row["verdict"] for row in before] == [row["verdict"] for row in rows] else ""
    return f"By the second edition of the [rules](#the-rules) it is {numbers}{same}, with {ids(before, 'against')} significantly against the paper."


def bottom_line(_page: str) -> str:
    rows = rows_of(KEPT / "claims.csv")
    predicted = [row for row in rows if row["kind"] == "predicted"]
    open_rows = [row["id"] for row in rows if row["verdict"] == "undecided"]
    near, fail = count(predicted, "in direction"), count(predicted, "does not hold")
    lines = [f"**Of the {len(rows)} claims {count(rows, 'holds')} hold, {count(rows, 'in direction')} come out in direction, and "
             f"{count(rows, 'does not hold')} do not hold**"
             + (f"; {len(open_rows)} are still to be judged ({', '.join(open_rows)}), since their runs are not made yet." if open_rows else "."),
             f"Of the {len(predicted)} predicted rows {count(predicted, 'holds')} hold, {near} {'is' if near == 1 else 'are'} in direction, "
             f"{fail} {'does' if fail == 1 else 'do'} not hold"
             + (f", and {count(predicted, 'undecided')} are to be judged." if open_rows else "."),
             f"Significantly against the paper's direction: {ids(rows, 'against')}.",
             second_edition(rows)]
    return "\n".join(lines)


def shortened(text: str, parts: int = 2) -> str:
    """The first parts of a list that semicolons separate, and how many more there are."""
    found = [part for part in text.split("; ") if part]
    more = len(found) - parts
    return "; ".join(found[:parts]) + (f"; and {more} more ([conditions](conditions.csv))" if more > 0 else "")


def plain(text: str) -> str:
    """Points without the name of their study, where the claim leaves no doubt of it."""
    text = text.replace("kept-protrusions-fibres: ", "fibres, ")
    if "fibres, " in text:
        text = text.replace("kept-protrusions: ", "no fibres, ")
    if "sensitive-adhesions: " in text:
        for study, words in (("insensitive-adhesions: ", "one rate, "), ("sensitive-adhesions: ", "zeta_diss 80 /nN, "), ("stiffness: ", "zeta_diss 20 /nN, ")):
            text = text.replace(study, words)
    text = re.sub(r"\b(stiffness|contraction|kept-protrusions|(initiation|disassembly)-rate|growth-time|durotaxis|microtracks|contact-guidance|channel-width"
                  r"|two-cells): ", "", text)
    return text.replace("|", "\\|")


def verdict(row: dict[str, str]) -> str:
    """A row's verdict, and that with the cells that ended at the rim made again in a larger disc."""
    again = row["verdict_in_larger_disc"]
    before = row.get("verdict_second_edition")
    return (f"**{row['verdict']}**" + (f"; with cells at the rim made again: {again}" if again else "")
            + (f"; by the second edition of the rules: {before}{', significantly against' if row['against_second_edition'] else ''}" if before else ""))


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
        return "The runs are still to be made."
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


def paths_of(study: str) -> dict[str, list[list[tuple[float, float]]]]:
    """Kept paths, each 10 minutes, by point."""
    paths: dict[str, dict[str, list[tuple[float, float]]]] = {}
    for row in rows_of(KEPT / f"{study}-paths.csv"):
        paths.setdefault(row["point"], {}).setdefault(row["replicate"], []).append((float(row["x_um"]), float(row["y_um"])))
    return {point: list(runs.values()) for point, runs in paths.items()}


def squares(path: list[tuple[float, float]], lag: int) -> tuple[float, float]:
    """Sums of the squared displacement along x and along y over all windows of so many intervals."""
    steps = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(path, path[lag:])]
    return sum(x * x for x, _ in steps), sum(y * y for _, y in steps)


def ratio(runs: list[tuple[float, float]]) -> float:
    return sum(x for x, _ in runs) / sum(y for _, y in runs)


def guidance(_page: str) -> str:
    """What fibres along x do to paths: squared displacements along over across, summed over runs, with a bootstrap over runs; the net angle."""
    made, lot = [], random.Random(1)
    for point, paths in paths_of("kept-protrusions-fibres").items():
        cells = []
        for hours in (1, 3, 6):
            runs = [squares(path, 6 * hours) for path in paths]
            drawn = sorted(ratio(lot.choices(runs, k=len(runs))) for _ in range(4000))
            cells.append(f"{ratio(runs):.1f} [{drawn[100]:.1f}, {drawn[3899]:.1f}]")
        angles = [math.degrees(math.atan2(abs(path[-1][1]), abs(path[-1][0]))) for path in paths]
        mean, sd = mean_and_sd(angles)
        made.append([point.removeprefix("n_prot "), str(len(paths)), *cells, f"{mean:.0f} +- {sd / math.sqrt(len(angles)):.0f}"])
    return table(["protrusions", "cells", "in 1 h", "in 3 h", "in 6 h", "net angle, degrees"], made)


def study_means(_page: str) -> str:
    parts = []
    for name, varies in STUDIES:
        rows = rows_of(KEPT / f"{name}-results.csv")
        if not rows:
            parts.append(f"**{varies}**: the runs are still to be made.")
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
        if any((KEPT / f"{name}-{kind}.csv").exists() for kind in ("paths", "adhesions")):
            parts.append(f"<!-- figures: {name} -->")
    return "\n\n".join(parts)


PARTS = {"bottom line": bottom_line, "claims": claims, "verdicts": verdicts, "experiments": experiments,
         "experiment verdicts": experiment_verdicts, "constrictions": constrictions, "guidance": guidance, "means": study_means}
PART = re.compile(r"(<!-- generated: ([\w ]+) -->\n).*?(<!-- end -->)", re.DOTALL)


def written(page: str) -> str:
    text = (ROOT / page).read_text(encoding="utf-8")
    unknown = [name for _, name, _ in PART.findall(text) if name not in PARTS]
    if unknown:
        sys.exit(f"{page}: unknown generated part '{unknown[0]}'; there are {', '.join(PARTS)}")
    return PART.sub(lambda part: f"{part[1]}{PARTS[part[2]](page)}\n{part[3]}", text)


def main() -> int:
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
