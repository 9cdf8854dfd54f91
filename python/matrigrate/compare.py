"""Which parameter must differ between control and treated cells: ``calibrate.compare`` of files, for a shell and for R.

    python3 -m matrigrate.compare design-study control.csv treated.csv --readouts speed_um_per_h -o comparison
"""
from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from . import calibrate, load_study, tracks
from .base.files import require_pandas
from .errors import ConfigurationError, InputOutputError, MatrigrateError

_of_numbers = ["group", "readout", "mean", "error"]  # columns


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser("python3 -m matrigrate.compare", allow_abbrev=False, description=(
        "Says which parameter must differ between control and treated cells. If a file of tracks needs more options "
        "than --pixel and --frame-interval, `matrigrate tracks FILE ... -o PLAIN.csv` makes one that needs none."))
    add = parser.add_argument
    add("design", metavar="DESIGN", help="folder of a Latin hypercube; or a table, *.csv, a row a run, and --prior")
    add("control", metavar="CONTROL", help="file of tracks")
    add("treated", metavar="[LABEL=]TREATED", nargs="+", help="file of tracks; of several each with its label")
    add("--readouts", metavar="A,B", type=_list, required=True, help="of tracks, such as speed_um_per_h,straightness")
    add("--prior", metavar="NAME=LOW:HIGH[:log]", action="append", help="range of a parameter, of a table of each")
    add("--pixel", type=float, metavar="UM", help="um per unit of length of the files")
    add("--frame-interval", type=float, metavar="S", help="s per frame of the files")
    add("--error", type=float, default=0.0, metavar="UM", help="localisation error, added to the simulated tracks")
    add("--besides", metavar="FILE", help=f"numbers beside the tracks: a table of {','.join(_of_numbers)}")
    add("--known", metavar="NAME=CONTROL:TREATED", action="append", help="values of a parameter in the groups")
    add("--parameters", metavar="A,B", type=_list, help="that may differ; all, if left out")
    add("--no-pairs", action="store_true", help="try no two parameters that differ")
    add("--no-scores", action="store_true", help="no cross-validation, which takes more than half of the time")
    add("-o", "--output", type=Path, metavar="FOLDER", help="for report.html and the tables: a new one")
    add("--force", action="store_true", help="replace them in a folder that is there already")
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Prints the sentences, and notes to stderr; or all that is wrong. :return: the exit code, as of the program"""
    options = _parser().parse_args(arguments)
    try:
        found = _found(options)
        if options.output:
            found.write(options.output, overwrite=options.force)
    except (MatrigrateError, ImportError) as error:
        print(error, file=sys.stderr)
        return 3 if isinstance(error, ConfigurationError) else 5
    print(*found.words, sep="\n")
    for note in found.notes:
        print(note, file=sys.stderr)
    return 0


def _found(options: argparse.Namespace) -> calibrate.Comparison:
    faults: list[MatrigrateError] = []
    if options.output and options.output.exists() and not options.force:
        faults.append(InputOutputError(f"{options.output}: exists already; give a new folder, or force"))

    def tried(read: Callable[..., Any], *given: Any, **more: Any) -> Any:
        try:
            return read(*given, **more)
        except MatrigrateError as error:
            faults.append(error)

    groups: dict[str, Any] = {}
    for name, file in [("control", options.control), *map(_labelled, options.treated)]:
        if name in groups:
            faults.append(ConfigurationError(f"{name}: two groups have this name; give LABEL=FILE"))
        groups[name] = tried(tracks.read, file, pixel=options.pixel, frame_interval=options.frame_interval)
    design = tried(_table if options.design.endswith(".csv") else load_study, options.design)
    besides = tried(_numbers, options.besides) if options.besides else None
    if faults:
        kind = ConfigurationError if any(isinstance(one, ConfigurationError) for one in faults) else InputOutputError
        raise kind("\n".join(dict.fromkeys(map(str, faults))))
    return calibrate.compare(design, groups.pop("control"), groups, options.readouts, besides=besides,
                             known=_values(options.known), parameters=options.parameters, pairs=not options.no_pairs,
                             scores=not options.no_scores, error=options.error, prior=_values(options.prior))


def _labelled(text: str) -> tuple[str, str]:
    """Label and file; a file may have = in its name."""
    label, mark, file = text.partition("=")
    return (label, file) if label and mark and not Path(text).is_file() else ("treated", text)


def _table(file: str) -> Any:
    try:
        return require_pandas().read_csv(file)
    except OSError as error:
        raise InputOutputError(f"{file}: cannot be read: {error.strerror}") from None
    except ValueError as error:  # those of pandas, too
        raise ConfigurationError(f"{file}: is no table: {error}") from None


def _numbers(file: str) -> dict[str, dict[str, tuple[Any, Any]]]:
    """By group and read-out a mean and its standard error."""
    table, found = _table(file), dict[str, dict[str, tuple[Any, Any]]]()
    if lacking := [name for name in _of_numbers if name not in table]:
        raise ConfigurationError(f"{file}: has no column {', '.join(lacking)}, but {', '.join(map(str, table))}")
    for group, readout, *number in table[_of_numbers].itertuples(index=False):
        if readout in found.setdefault(str(group), {}):
            raise ConfigurationError(f"{file}: has two rows of {group}, {readout}")
        found[str(group)][str(readout)] = tuple(number)
    return found


def _list(text: str) -> list[str]:
    return [word.strip() for word in text.split(",") if word.strip()]


def _values(given: Sequence[str] | None) -> dict[str, tuple[Any, ...]]:
    """{"a": (1.0, 2.0, "log")} of "a=1:2:log"; what is no number stays a text, which is refused later, by name."""
    return {one.partition("=")[0]: tuple(map(_number, one.partition("=")[2].split(":"))) for one in given or ()}


def _number(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


if __name__ == "__main__":
    sys.exit(main())
