"""Means that pages print are those of the results that are kept: python3 numbers_agree.py ROOT

Reads the tables of docs/validation.md and docs/performance.md whose cells are "mean +- standard deviation", computes both
from the results.csv behind each table, and asks that the printed digits be theirs. Also: phrases that several pages say.
"""
import csv
import math
import re
import sys
from pathlib import Path

READOUTS = {
    "v_migr_abs, um/h": "v_migr_abs_um_per_h",
    "v_migr_path, 60 s, um/h": "v_migr_path_60s_um_per_h",
    "v_migr_path, 600 s, um/h": "v_migr_path_600s_um_per_h",
    "n_protrusions": "n_protrusions",
    "of them unadhered": "n_unadhered",
    "tau_prot, min": "tau_prot_min",
    "l_prot, um": "l_prot_um",
    "f_mat": "f_mat",
    "f_adh_rel": "f_adh_rel",
    "protrusions at a time": "n_simultaneous_mean",
    "slope of the MSD": "msd_slope",
}
STIFFNESS = [f"youngs_modulus {E} Pa" for E in (50, 100, 200, 300, 400)]
NUMBERS = [f"n_prot {n}" for n in (1, 2, 3, 4)]
CLOSURES = ["50 Pa: all", "200 Pa: all", "400 Pa: all", "one: all", "three: all", "four: all"]
TABLES = [  # page, first cell and column after it of the header, results, label of the point of each column
    ("docs/validation.md", "12 runs | 50 Pa |", "stiffness-results.csv", STIFFNESS),
    ("docs/validation.md", "12 runs | 0.4 nN |", "contraction-results.csv",
     [f"force {F} nN" for F in (0.4, 0.8, 1.2, 1.6, 2)]),
    ("docs/validation.md", "12 runs | 1e-5 /s |", "initiation-rate-results.csv",
     [f"initiation_rate {r} 1/s" for r in ("1e-05", "3e-05", "6e-05", "8e-05", "0.0001")]),
    ("docs/validation.md", "12 runs, 1/r_off_min |", "disassembly-rate-results.csv",
     [f"r_off_min {r} 1/s" for r in ("0.0001852", "0.000278", "0.0004167", "0.0008333", "0.001667")]),
    ("docs/validation.md", "12 runs | 200 s |", "growth-time-results.csv",
     [f"growth_time {t} s" for t in (200, 300, 400, 500, 600)]),
    ("docs/validation.md", "12 runs, zeta_diss 80 /nN |", "sensitive-adhesions-results.csv", STIFFNESS),
    ("docs/validation.md", "12 runs, one rate |", "insensitive-adhesions-results.csv", STIFFNESS),
    ("docs/validation.md", "17 runs | 1 |", "kept-protrusions-results.csv", NUMBERS),
    ("docs/validation.md", "18 runs | 1 |", "kept-protrusions-fibres-results.csv", NUMBERS),
    ("docs/validation.md", "8 seeds, mean +- standard deviation | 50 Pa |", "closures-results.csv", CLOSURES),
    ("docs/validation.md", "16 new seeds, mean +- standard deviation | 50 Pa |", "second-set-results.csv",
     CLOSURES + ["fibres one: all", "fibres two: all"]),
    ("docs/performance.md", "| read-out | adaptive, up to 5 s | reference |", "integrators-results.csv",
     ["adaptive", "reference"]),
]
PHRASES = {
    "7 to 9 times slower": ["README.md", "docs/performance.md", "apps/reproduce/reproduce.cpp"],
}


def moments(rows, label, column):
    values = [float(row[column]) for row in rows if row["label"] == label and row[column] != ""]
    mean = sum(values) / len(values)
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / (len(values) - 1))


def printed_as(text, value):
    """Whether a printed number is this value, rounded to its digits."""
    digits = len(text.split(".")[1]) if "." in text else 0
    return abs(float(text) - value) <= 0.5 * 10**-digits * (1 + 1e-6)


def rows_of(page, header):
    """The cells of each line of the table whose header holds a text."""
    lines = page.splitlines()
    start = next((k for k, line in enumerate(lines) if line.startswith("|") and header in line), None)
    if start is None:
        return []
    rows = []
    for line in lines[start + 2:]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def faults_of_table(root, page, header, results, labels):
    rows = list(csv.DictReader((root / "docs/validation" / results).open(newline="")))
    table = rows_of((root / page).read_text(), header)
    if not table:
        yield f"{page}: has no table with the header '{header}'"
    for name, *cells in table:
        if name not in READOUTS:
            yield f"{page}: '{name}' is no read-out"
            continue
        for label, cell in zip(labels, cells):
            mean, deviation = moments(rows, label, READOUTS[name])
            numbers = re.findall(r"-?\d+(?:\.\d+)?", cell.replace("+-", " "))
            wanted = (mean, deviation)[: len(numbers)]
            if not numbers or not all(map(printed_as, numbers, wanted)):
                yield f"{page}: {name} at {label}: says {cell}, {results} gives {mean:.4g} +- {deviation:.3g}"


def main():
    root = Path(sys.argv[1])
    faults = [fault for table in TABLES for fault in faults_of_table(root, *table)]
    for phrase, pages in PHRASES.items():
        faults += [f"{page}: does not say '{phrase}'" for page in pages if phrase not in (root / page).read_text()]
    assert not printed_as("1.3", 1.36) and printed_as("1.4", 1.36) and printed_as("12", 12.49)
    print("\n".join(faults) or "all numbers agree")
    return 1 if faults else 0


sys.exit(main())
