"""Files of tracks: columns, units and faults. ``matrigrate.tracks.read`` is their user."""
from __future__ import annotations

import csv
import io
import math
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field
from pathlib import Path

from ._files import read_text
from .errors import ConfigurationError, Fault

_ids = ("track_id", "track id", "track", "id", "particle", "cell")
_axes = {"x": ("position_x", "x_um", "x"), "y": ("position_y", "y_um", "y"), "z": ("position_z", "z_um", "z"),
         "t": ("t_s", "t_min", "t_h", "position_t", "t", "time")}
_frames = ("frame", "frames")
_lengths = {"um": 1.0, "µm": 1.0, "μm": 1.0, "micron": 1.0, "microns": 1.0, "micrometer": 1.0, "nm": 1e-3, "mm": 1e3}
_times = {"s": 1.0, "sec": 1.0, "second": 1.0, "seconds": 1.0, "min": 60.0, "minute": 60.0, "minutes": 60.0,
          "h": 3600.0, "hour": 3600.0, "hours": 3600.0, "ms": 1e-3}
_most_faults = 20


@dataclass(frozen=True)
class Position:
    """A row of a file, in um and s."""

    track: str
    t: float
    x: float
    y: float
    line: int  #: 0 where the file has none


@dataclass
class Content:
    """The content of a file of tracks."""

    positions: list[Position] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)


class Faults:
    """The faults of one file, raised all at once."""

    def __init__(self, file: Path) -> None:
        self.file, self.found = file, list[Fault]()

    def add(self, message: str, line: int = 0) -> None:
        self.found.append(Fault("", message, str(self.file), line, 1 if line else 0))

    def raise_if_any(self) -> None:
        if len(self.found) > _most_faults:
            more = len(self.found) - _most_faults
            self.found[_most_faults:] = [Fault("", f"{more} more faults", str(self.file))]
        if self.found:
            raise ConfigurationError(self.found)


def content(file: Path, pixel: float | None, interval: float | None, faults: Faults) -> Content:
    """The positions of a file; what is wrong with it goes to ``faults``."""
    text = read_text(file)
    if text.lstrip("\ufeff \t\r\n").startswith("<"):
        return _of_xml(text, pixel, interval, faults)
    return _of_csv(text.removeprefix("\ufeff"), pixel, interval, faults)


def _scale(unit: str, known: dict[str, float], given: float | None, what: str, faults: Faults) -> float:
    """um or s per unit of the file. What the caller gives replaces an unknown unit; it may not contradict a known one."""
    own = known.get(unit.strip().strip("()").lower())
    if own is None and given is None:
        of = f"its {what} is in {unit.strip()!r}" if unit.strip() else f"it does not state the unit of {what}"
        faults.add(f"{of}; give " + ("pixel = um per unit (1 if um)" if what == "length"
                                     else "interval = s per frame or unit of time (1 if s)"))
    elif own is not None and given is not None and not math.isclose(own, given, rel_tol=1e-9):
        faults.add(f"its {what} is in {unit.strip()}; {'pixel' if what == 'length' else 'interval'} = {given:g} "
                   "contradicts this; leave it out")
    return own if own is not None else given or 1.0


def _find(names: list[str], wanted: tuple[str, ...]) -> int | None:
    return next((names.index(name) for name in wanted if name in names), None)


def _of_csv(text: str, pixel: float | None, interval: float | None, faults: Faults) -> Content:
    found = Content()
    delimiter = max(",;\t", key=text.partition("\n")[0].count)
    reader = csv.reader(io.StringIO(text), delimiter=delimiter)
    rows = [(reader.line_num, row) for row in reader if any(cell.strip() for cell in row)]
    if not rows:
        faults.add("is empty")
        return found
    header = rows[0][1]
    names = [name.strip().lower() for name in header]
    columns = {axis: _find(names, wanted) for axis, wanted in _axes.items()}
    track, frame, run = _find(names, _ids), _find(names, _frames), _find(names, ("run",))
    if names[:1] == ["id"] and "track_id" not in names and _find(names, _ids[:3]) is not None:
        track = _find(names, _ids[:3])
    lacking = [what for what, column in (("a track (TRACK_ID, track, id)", track), ("x (POSITION_X, x_um, x)", columns["x"]),
                                         ("y (POSITION_Y, y_um, y)", columns["y"])) if column is None]
    if columns["t"] is None and frame is None:
        lacking.append("time (FRAME, POSITION_T, t_s, t)")
    if lacking:
        faults.add(f"has no column for {', nor for '.join(lacking)}; its columns are {', '.join(header)}", rows[0][0])
        return found
    assert track is not None and columns["x"] is not None and columns["y"] is not None
    first, units = 1, [""] * len(header)
    while first < min(len(rows), 4) and "position_x" in names and not _is_number(_cell(rows[first][1], columns["x"])):
        units = [_cell(rows[first][1], k) for k in range(len(header))]  # TrackMate: two rows of titles, one of units
        first += 1
    unit = {axis: _unit_of(names[k], units[k]) for axis, k in columns.items() if k is not None}
    if unit["x"] != unit["y"]:
        faults.add(f"x is in {unit['x'] or 'no unit'}, y in {unit['y'] or 'no unit'}", rows[0][0])
    length = _scale(unit["x"], _lengths, pixel, "length", faults)
    # Frames times the given interval where there are frames: the time in a file of an uncalibrated movie is in frames.
    by_frame = frame is not None and (columns["t"] is None or (interval is not None and unit.get("t", "").strip(
        "()").lower() not in _times))
    time_column = frame if by_frame else columns["t"]
    assert time_column is not None
    time = _scale("" if by_frame else unit["t"], _times, interval, "time", faults)
    loose, flat = 0, set[str]()
    for line, row in rows[first:]:
        if len(row) != len(header):
            faults.add(f"has {len(row)} fields, the header {len(header)}", line)
            continue
        name = row[track].strip()
        if name.lower() in ("", "none", "nan"):
            loose += 1
            continue
        values = [_number(row[k], header[k], line, faults) for k in (time_column, columns["x"], columns["y"])]
        if columns["z"] is not None:
            flat.add(row[columns["z"]].strip())
        if None not in values:
            t, x, y = (value or 0.0 for value in values)
            whole = f"{row[run].strip()}/{name}" if run is not None else name
            found.positions.append(Position(whole, t * time, x * length, y * length, line))
    if loose:
        found.notes.append(f"{loose} positions in no track are left out")
    if len(flat) > 1:
        found.notes.append("z is left out: read-outs are those of the projection on the plane")
    return found


def _of_xml(text: str, pixel: float | None, interval: float | None, faults: Faults) -> Content:
    """TrackMate's "Export tracks to XML file". A detection has no time but the number of its frame."""
    found = Content()
    try:
        root = xml.fromstring(text)
    except xml.ParseError as error:
        faults.add(f"is no XML: {error}", error.position[0])
        return found
    if root.tag != "Tracks":
        faults.add(f"its root is <{root.tag}>; TrackMate's \"Export tracks to XML file\" writes <Tracks>")
        return found
    length = _scale(root.get("spaceUnits", ""), _lengths, pixel, "length", faults)
    unit, step = root.get("timeUnits", ""), root.get("frameInterval", "")
    time = interval or 1.0
    if unit.lower() in _times and _is_number(step) and float(step) > 0:
        time = float(step) * _times[unit.lower()]
        if interval is not None and not math.isclose(interval, time, rel_tol=1e-9):
            faults.add(f"its frameInterval is {time:g} s; interval = {interval:g} contradicts this; leave it out")
    else:
        _scale(unit if unit.lower() not in _times else "", _times, interval, "time", faults)
    heights = set[str]()
    for number, particle in enumerate(root.iter("particle"), 1):
        for k, spot in enumerate(particle.iter("detection"), 1):
            where = f"particle {number}, detection {k}: "
            values = [_number(spot.get(name, ""), name, 0, faults, where) for name in ("t", "x", "y")]
            heights.add(spot.get("z", "0"))
            if None not in values:
                t, x, y = (value or 0.0 for value in values)
                found.positions.append(Position(str(number), t * time, x * length, y * length, 0))
    if len(heights) > 1:
        found.notes.append("z is left out: read-outs are those of the projection on the plane")
    return found


def _unit_of(name: str, written: str) -> str:
    return written or next((unit for unit in ("um", "s", "min", "h") if name.endswith("_" + unit)), "")


def _cell(row: list[str], k: int) -> str:
    return row[k] if k < len(row) else ""


def _is_number(text: str) -> bool:
    try:
        return math.isfinite(float(text))
    except ValueError:
        return text.strip().lower() in ("nan", "inf", "-inf")


def _number(text: str, name: str, line: int, faults: Faults, where: str = "") -> float | None:
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if math.isfinite(value):
        return value
    faults.add(f"{where}{name}: {text.strip() or 'nothing'!r} is no finite number", line)
    return None
