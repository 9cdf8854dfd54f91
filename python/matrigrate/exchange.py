"""Runs in formats of other programs: OME-TIFF for Fiji and napari, Simularium for the viewer at simularium.allencell.org. ``matrigrate export`` calls it.

    matrigrate.exchange.ome_tiff(run, "fields.ome.tif", pixel=0.5)
    matrigrate.exchange.simularium(run, "run.simularium")
"""
from __future__ import annotations

import argparse
import hashlib
import json
import sys
import uuid
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ._version import __version__
from .base import arguments as _arguments
from .errors import MatrigrateError
from .results import raster, results
from .results.fields import Fields, evenly

if TYPE_CHECKING:
    import pandas

__all__ = ["ome_tiff", "simularium"]

Array = np.ndarray[Any, Any]

most_pixels = 8192  #: along an edge of a stack
_block = 1 << 20  # pixels that are looked at together


def ome_tiff(run: results.Run, file: str | Path, pixel: float | None = None) -> None:
    """Writes all frames as a stack of times and channels: a scalar of the matrix, a component of a vector, or the number of the cell that is
    there. A pixel has the value of the nearest particle, and is not a number beyond the disc; the upper row is at the largest y. 32-bit
    floating point, compressed by zlib, with the size of pixels [um], the times [s], and their interval where they are evenly spaced.

    :param pixel: width of a pixel [um]; the spacing of the particles if left out
    :raises ValueError: if the run has no frames, or there would be more than ``most_pixels`` along an edge
    """
    fields = _arguments.one_of("run", run, results.Run).fields
    _ome_tiff(fields, Path(file), pixel, run.folder.name, __version__)


def simularium(run: results.Run, file: str | Path) -> None:
    """Writes cortex and nucleus of each cell, adhesions, and the particles of the matrix over time, with distance and path as plots. A last
    frame that comes sooner than the others is left out.

    :raises ValueError: if the run has no frames, or frames that are not of one interval, which the viewer supposes
    """
    fields = _arguments.one_of("run", run, results.Run).fields
    _simularium(fields, run.tracks, Path(file), run.folder.name, __version__)


def _require_frames(fields: Fields) -> None:
    if not len(fields.times):
        raise ValueError(f"{fields.file}: holds no frames")


# -- OME-TIFF

def _ome_tiff(fields: Fields, file: Path, pixel: float | None, title: str, version: str) -> None:
    import tifffile

    _require_frames(fields)
    radius, spacing = (float(fields[f"matrix/{name}"][0]) for name in ("radius", "spacing"))
    pixel = spacing if pixel is None else float(pixel)
    if not 2 * radius / most_pixels <= pixel <= radius:
        raise ValueError(f"pixel: {pixel:g} um; allowed are {2 * radius / most_pixels:.3g} to {radius:g} um, for {most_pixels} to 2 pixels along an edge")
    side = int(np.ceil(2 * radius / pixel - 1e-9))
    middles = (np.arange(side) + 0.5) * pixel - 0.5 * side * pixel
    names = _channels(fields)
    count = len(fields.times) * len(names)
    even, interval = evenly(fields.times)
    content = hashlib.sha256(fields.file.read_bytes()).hexdigest()  # of which the name follows, so that the same run makes the same bytes
    about: dict[str, Any] = {
        "axes": "TCYX", "Name": title, "Creator": f"Matrigrate {version}", "UUID": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_OID, f'{content} {pixel}')}",
        "PhysicalSizeX": pixel, "PhysicalSizeXUnit": "µm", "PhysicalSizeY": pixel, "PhysicalSizeYUnit": "µm",
        "Channel": {"Name": [name for name, *_ in names]},
        "Plane": {"DeltaT": [float(t) for t in np.repeat(fields.times, len(names))], "DeltaTUnit": ["s"] * count}}
    if even == len(fields.times) > 1:
        about |= {"TimeIncrement": interval, "TimeIncrementUnit": "s"}
    with tifffile.TiffWriter(file, ome=True, bigtiff=4 * side * side * count > 3_500_000_000) as writer:
        writer.write(_pages(fields, names, middles, radius, spacing), shape=(len(fields.times), len(names), side, side), dtype=np.float32,
                     photometric="minisblack", compression="zlib", resolution=(1e4 / pixel, 1e4 / pixel), resolutionunit="CENTIMETER", metadata=about)


def _channels(fields: Fields) -> list[tuple[str, str, int | None]]:
    """Name with unit, field, component of each channel; the cells last."""
    particles = len(fields["matrix/reference"])
    found: list[tuple[str, str, int | None]] = []
    first = [f"matrix/{name}" for name in ("displacement", "velocity", "f_degr", "pressure", "von_mises", "fibre_von_mises", "attractant")]
    for name in [*(name for name in first if name in fields), *(name for name in fields if name not in first)]:
        body, _, own = name.partition("/")
        if body != "matrix" or own in ("position", "reference", "solid"):
            continue
        field = fields[name]
        unit = "" if field.units in ("1", "") else f" [{field.units}]"
        if fields.has_frames(name):
            found += [(f"{own}_{axis}{unit}", name, k) for k, axis in enumerate("xy")] if len(field.shape) == 3 else [(own + unit, name, None)]
        elif field.shape == (particles,):
            found.append((own + unit, name, None))
    return [*found, ("cell", "", None)]


def _pages(fields: Fields, channels: list[tuple[str, str, int | None]], middles: Array, radius: float, spacing: float) -> Iterator[Array]:
    """The channels of each frame, one after the other.   :param middles: of the columns, rising [um]; rows are turned"""
    for k in range(len(fields.times)):
        near = _nearest(fields["matrix/position"][k][:, :2].astype(float), middles, radius, spacing)
        for _, name, component in channels:
            if not name:
                yield _cells(fields.outlines(k), middles)
                continue
            values = fields[name][k] if fields.has_frames(name) else fields[name][...]
            values = values if component is None else values[:, component]
            yield np.where(near >= 0, values[near], np.nan).astype(np.float32)


def _nearest(places: Array, middles: Array, radius: float, spacing: float) -> Array:
    """The number of the particle nearest to each pixel, of those in the square bins around it; -1 beyond the disc, and where there is none."""
    width = 2.0 * spacing
    low, side = -radius - width, int(np.ceil(2 * (radius + width) / width)) + 1
    bins = np.clip(((places - low) / width).astype(int), 0, side - 1)
    key = bins[:, 1] * side + bins[:, 0]
    order = np.argsort(key, kind="stable")
    counts = np.bincount(key, minlength=side * side)
    starts = np.cumsum(counts) - counts
    found = np.full((len(middles), len(middles)), -1)
    rows = max(1, _block // len(middles))
    columns = np.clip(((middles - low) / width).astype(int), 0, side - 1)
    for first in range(0, len(middles), rows):
        y = -middles[first:first + rows]  # the largest first
        lines = np.clip(((y - low) / width).astype(int), 0, side - 1)
        least = np.full((len(y), len(middles)), np.inf)
        part = found[first:first + rows]
        for down in (-1, 0, 1):
            for right in (-1, 0, 1):
                row, column = lines[:, None] + down, columns[None, :] + right
                bin_ = np.clip(row, 0, side - 1) * side + np.clip(column, 0, side - 1)
                for n in range(int(counts[bin_].max())):
                    there = counts[bin_] > n
                    particle = order[np.minimum(starts[bin_] + n, len(order) - 1)]
                    square = (places[particle, 0] - middles[None, :]) ** 2 + (places[particle, 1] - y[:, None]) ** 2
                    nearer = there & (square < least)
                    least[nearer], part[nearer] = square[nearer], particle[nearer]
        part[np.hypot(middles[None, :], y[:, None]) > radius] = -1
    return found


def _cells(outlines: dict[int, Array], middles: Array) -> Array:
    """The number of the cell in which the middle of each pixel lies; 0 outside."""
    half = float(middles[-1] + 0.5 * (middles[1] - middles[0]))
    return raster.labels(raster.Grid.over((-half, half, -half, half), 2 * half / len(middles)), outlines).astype(np.float32)


# -- Simularium

_first_cell = 5  # types of agents: matrix, degraded, adhesion, nucleus, obstacle, then the cells
_in_front = 2.0  # z of the cells [um]


def _simularium(fields: Fields, tracks: pandas.DataFrame, file: Path, title: str, version: str) -> None:
    _require_frames(fields)
    even, interval = evenly(fields.times)
    if even < len(fields.times) - 1:
        raise ValueError(f"{fields.file}: its frames are not of one interval, which Simularium's viewer supposes")
    cells = list(fields.outlines(0))
    adhesions = _adhesions(fields)
    with file.open("w", encoding="utf-8") as out:
        out.write('{"trajectoryInfo":' + json.dumps(_info(fields, even, interval, len(cells), title, version), ensure_ascii=False))
        out.write(f',\n"spatialData":{{"version":1,"msgType":1,"bundleStart":0,"bundleSize":{even},"bundleData":[')
        for k in range(even):
            agents = [*_rings(fields, k), *adhesions.get(k, []), *_particles(fields, k)]
            out.write(f'{"," if k else ""}\n{{"frameNumber":{k},"time":{float(fields.times[k])!r},"data":[{",".join(agents)}]}}')
        out.write(f']}},\n"plotData":{json.dumps(_plots(tracks, cells), ensure_ascii=False)}}}\n')


def _info(fields: Fields, even: int, interval: float, cells: int, title: str, version: str) -> dict[str, Any]:
    def kind(name: str, shape: str, colour: str) -> dict[str, Any]:
        return {"name": name, "geometry": {"displayType": shape, "url": "", "color": colour}}

    def point(x: float, y: float, z: float) -> dict[str, float]:
        return {"x": x, "y": y, "z": z}

    colours = ("#2066a8", "#d55e00", "#009e73", "#cc79a7")
    kinds = [kind("matrix#solid", "SPHERE", "#c8bfa9"), kind("matrix#degraded", "SPHERE", "#eee9dd"), kind("adhesion", "SPHERE", "#c1121f"),
             kind("nucleus", "FIBER", "#4b3f72"), kind("obstacle", "SPHERE", "#3c3c3c"),
             *(kind(f"cell {k + 1}", "FIBER", colours[k % len(colours)]) for k in range(cells))]
    radius = float(fields["matrix/radius"][0])
    return {"version": 3, "trajectoryTitle": title,
            "modelInfo": {"title": "Single-cell migration through a degradable viscoelastic matrix", "version": version,
                          "authors": "Heck et al. 2020; computed by Matrigrate",
                          "description": "The cortex of the cell as a ring, its adhesions, and the particles of the matrix.",
                          "doi": "10.1371/journal.pcbi.1007250"},
            "timeUnits": {"magnitude": 1.0, "name": "s"}, "timeStepSize": interval or 1.0, "totalSteps": even,
            "spatialUnits": {"magnitude": 1.0, "name": "µm"}, "size": point(2 * radius, 2 * radius, 20.0),
            "cameraDefault": {"position": point(0, 0, 1.4 * radius), "lookAtPosition": point(0, 0, 0), "upVector": point(0, 1, 0), "fovDegrees": 75.0},
            "typeMapping": {str(k): one for k, one in enumerate(kinds)}}


def _rings(fields: Fields, k: int) -> Iterator[str]:
    """Cells, and their nuclei, as closed fibres of 1 um."""
    for of, first_id, kind in ((fields.outlines(k), 0, _first_cell), (fields.nuclei(k), 1000, None)):
        for n, points in enumerate(of.values()):
            closed = [*points, points[0]]
            places = ",".join(f"{x:.3f},{y:.3f},{_in_front:g}" for x, y in closed)
            yield f"1001,{first_id + n},{3 if kind is None else kind + n},0,0,0,0,0,0,1,{3 * len(closed)},{places}"


def _adhesions(fields: Fields) -> dict[int, list[str]]:
    found: dict[int, list[str]] = {}
    for row in fields.protrusions.to_dict("records"):
        if np.isfinite(row["anchor_x"]):
            found.setdefault(int(row["frame"]), []).append(_sphere(10000 * int(row.get("cell", 1)) + int(row["id"]), 2, row["anchor_x"], row["anchor_y"], _in_front, 1.2))
    return found


def _particles(fields: Fields, k: int) -> Iterator[str]:
    places, intact = fields["matrix/position"][k], fields["matrix/f_degr"][k] > 0
    kinds = np.where(intact, 0, 1)
    if "matrix/obstacle" in fields:
        kinds[fields["matrix/obstacle"][...] == 1] = 4
    radius = 0.4 * float(fields["matrix/spacing"][0])
    for n, (kind, (x, y, *_)) in enumerate(zip(kinds, places, strict=True)):
        yield _sphere(10_000_000 + n, kind, x, y, 0.0, radius)


def _sphere(number: int, kind: int, x: float, y: float, z: float, radius: float) -> str:
    return f"1000,{number},{kind},{x:.2f},{y:.2f},{z:g},0,0,0,{radius:g},0"


def _plots(tracks: pandas.DataFrame, cells: list[int]) -> dict[str, Any]:
    distance, way = [], []
    for number in cells:
        own = tracks[tracks["track"] == number]
        x, y = own["x_um"].to_numpy(float), own["y_um"].to_numpy(float)
        kind = {"name": f"cell {number}", "type": "scatter", "mode": "lines"}
        distance.append(kind | {"x": own["t_s"].tolist(), "y": np.hypot(x - x[:1], y - y[:1]).tolist()})
        way.append(kind | {"x": x.tolist(), "y": y.tolist()})

    def plot(title: str, along: str, up: str, data: list[Any]) -> dict[str, Any]:
        return {"layout": {"title": title, "xaxis": {"title": along}, "yaxis": {"title": up}}, "data": data}

    return {"version": 1, "data": [plot("Distance from the start", "time (s)", "distance (µm)", distance),
                                   plot("Path of the centre of mass", "x (µm)", "y (µm)", way)]}


def main(arguments: list[str]) -> int:
    """What the program calls; its exit code."""
    parser = argparse.ArgumentParser(description="Writes a run in formats of other programs.")
    parser.add_argument("folder", help="of the run")
    parser.add_argument("--fields", required=True, help="its frames, fields.h5")
    parser.add_argument("--title", default="")
    parser.add_argument("--program", default=__version__, help="its version")
    parser.add_argument("--pixel", type=float)
    parser.add_argument("--ome-tiff", metavar="FILE")
    parser.add_argument("--simularium", metavar="FILE")
    options = parser.parse_args(arguments)
    try:
        fields = Fields(options.fields)
        if options.ome_tiff:
            _ome_tiff(fields, Path(options.ome_tiff), options.pixel, options.title, options.program)
        if options.simularium:
            _simularium(fields, results.load(options.folder).tracks, Path(options.simularium), options.title, options.program)
    except MemoryError:
        print("not enough memory; a larger --pixel makes a smaller stack", file=sys.stderr)
        return 1
    except (MatrigrateError, OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    return 0
