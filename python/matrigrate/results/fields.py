"""The frames of fields.h5."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from ..base import arguments
from ..base.files import require_pandas
from ..base.load_core import library
from ..errors import InputOutputError

if TYPE_CHECKING:
    import pandas
    import xarray

_bodies = ("matrix", "outline", "nucleus")
_sparse = ("protrusions", "anchors")
_aliases = {"matrix/degradation": "matrix/f_degr"}  # the layers of the command line that the file calls otherwise


def evenly(times: np.ndarray[Any, Any]) -> tuple[int, float]:
    """How many times from the first are multiples of the first interval [s], and that; times agree within 1 ms."""
    if len(times) < 2:
        return len(times), 0.0
    interval = float(times[1] - times[0])
    off = np.abs(times - times[0] - interval * np.arange(len(times))) > 1e-3
    return int(np.argmax(off)) if off.any() else len(times), interval


class Field:
    """One array of fields.h5. Indexing reads it: ``field[-1]`` is the last frame."""

    def __init__(self, file: Path, data: Any) -> None:
        """:param data: of h5py, as long as the file is open"""
        units = data.attrs.get("units", "1")
        self._file, self.name, self.shape, self.dtype = file, data.name.lstrip("/"), data.shape, data.dtype
        self.units = units.decode() if isinstance(units, bytes) else str(units)

    def __getitem__(self, index: Any) -> Any:
        with _opened(self._file) as file:
            try:
                return file[self.name][index]
            except (IndexError, ValueError, TypeError) as error:
                raise IndexError(f"{self.name}, of shape {self.shape}: {error}") from None

    def __array__(self, dtype: Any = None, copy: Any = None) -> np.ndarray[Any, Any]:
        return np.asarray(self[...], dtype=dtype)

    def __len__(self) -> int:
        return self.shape[0]

    def __repr__(self) -> str:
        return f"Field({self.name}: {self.shape} {self.dtype}, {self.units})"


class Fields(Mapping[str, Field]):
    """The frames of cell and matrix: ``fields["matrix/pressure"][k]`` is the pressure [Pa] of all particles in frame k.

    Arrays are (frames, particles) or (frames, particles, 3). Several cells follow one another: ``outline/cell`` is the number
    of the cell, from 1, of each particle of ``outline``. "matrix/degradation", as the command line calls it, is
    "matrix/f_degr".
    """

    def __init__(self, file: str | Path) -> None:
        self.file = arguments.path("file", file)
        with _opened(self.file) as opened:
            try:
                self.times: np.ndarray[Any, Any] = opened["time"][:]
                """Simulated time of each frame [s]."""
                self._fields = {f"{group}/{name}": Field(self.file, opened[group][name])
                                for group in (*_bodies, *_sparse) if group in opened for name in opened[group]}
            except (KeyError, AttributeError, TypeError, ValueError):
                raise InputOutputError(f"{self.file}: is no file of frames of this program", self.file.parent) from None

    def __getitem__(self, name: str) -> Field:
        name = _aliases.get(name, name)
        if name not in self._fields:
            raise KeyError(f"{name}; there are {', '.join(self._fields)}")
        return self._fields[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._fields)

    def __len__(self) -> int:
        return len(self._fields)

    def __repr__(self) -> str:
        rows = "\n".join(f"  {f.name:<26} {str(f.shape):<18} {f.units}" for f in self._fields.values())
        span = f", {self.times[0]:g} to {self.times[-1]:g} s" if len(self.times) else ""
        return f"Fields({str(self.file)!r}: {len(self.times)} frames{span})\n{rows}"

    def nearest(self, t: float) -> int:
        """The number of the frame nearest to a time. :param t: simulated time [s]

        :raises TypeError: if that is no number
        """
        if isinstance(t, bool) or not isinstance(t, (int, float, np.integer, np.floating)):
            raise arguments.wrong("t", t, "a number [s]")
        if not len(self.times):
            raise InputOutputError(f"{self.file}: holds no frames", self.file.parent)
        return int(np.abs(self.times - t).argmin())

    def frame(self, k: int) -> dict[str, np.ndarray[Any, Any]]:
        """All arrays of matrix, outline and nucleus in frame k, by their names."""
        try:
            number = range(len(self.times))[k]
        except IndexError:
            raise IndexError(f"frame {k}: there are {len(self.times)} frames") from None
        return {name: field[number] for name, field in self._fields.items() if self.has_frames(name)}

    def outlines(self, k: int = -1) -> dict[int, np.ndarray[Any, Any]]:
        """The cortex of each cell [um] in frame k, by the number of the cell: x, y of its particles in their order."""
        places = self["outline/position"][k][:, :2]
        cell = self["outline/cell"][k] if "outline/cell" in self else np.ones(len(places))
        return {int(number): places[cell == number] for number in np.unique(cell)}

    def nuclei(self, k: int = -1) -> dict[int, np.ndarray[Any, Any]]:
        """The nucleus of each cell [um] in frame k, by the number of the cell; none of cells without a nucleus."""
        if "nucleus/position" not in self:
            return {}
        numbers = list(self.outlines(k))
        return dict(zip(numbers, np.split(self["nucleus/position"][k][:, :2], len(numbers)), strict=True))

    @cached_property
    def protrusions(self) -> pandas.DataFrame:
        """A row for each protrusion alive in a frame: ``frame``, ``t_s`` [s], ``id``, phase, maturation, force [nN]."""
        return self._sparse("protrusions")

    @cached_property
    def anchors(self) -> pandas.DataFrame:
        """A row for each adhesion in a frame: ``frame``, ``t_s`` [s], ``id``, place [um], maturation, force [nN]."""
        return self._sparse("anchors")

    def xarray(self) -> xarray.Dataset:
        """All frames as one data set with the coordinate ``time`` [s], units in the attributes. Needs xarray."""
        xarray = library("xarray", "Fields.xarray needs xarray")
        arrays = {}
        for name, field in self._fields.items():
            body = name.split("/")[0]
            if body in _bodies and len(field.shape) > 1:
                first = ("time",) if self.has_frames(name) else ()
                dims = (*first, body, "axis")[:len(field.shape)]
                arrays[name.replace("/", "_")] = xarray.DataArray(field[...], dims=dims, attrs={"units": field.units})
        data = xarray.Dataset(arrays, coords={"time": ("time", self.times, {"units": "s"})})
        return data.assign_coords(axis=["x", "y", "z"]) if "axis" in data.dims else data

    def has_frames(self, name: str) -> bool:
        """True if a field has a value of each particle in each frame."""
        field = self[name]
        return (field.name.split("/")[0] in _bodies and field.name != "matrix/reference" and len(field.shape) > 1
                and len(field) == len(self.times))

    def _sparse(self, group: str) -> pandas.DataFrame:
        columns: dict[str, Any] = {}
        units: dict[str, str] = {}
        for name, field in self._fields.items():
            if not name.startswith(group + "/"):
                continue
            key, values = name.split("/")[1], field[...]
            parts = {f"{key}_{axis}": values[:, i] for i, axis in enumerate("xy")} if values.ndim == 2 else {key: values}
            columns |= parts
            units |= dict.fromkeys(parts, field.units)
        frames = columns.pop("frame", np.zeros(0, dtype="u4"))
        if len(frames) and frames.max() >= len(self.times) or len({len(values) for values in columns.values()}) > 1:
            raise InputOutputError(f"{self.file}: is damaged: {group} do not fit its frames", self.file.parent)
        table = require_pandas().DataFrame({"frame": frames, "t_s": self.times[frames], **columns})
        table.attrs["units"] = units | {"frame": "1", "t_s": "s"}
        return table


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """The file in h5py, whose errors become ours."""
    h5py = library("h5py", "fields need h5py")
    if not path.is_file():
        raise InputOutputError(f"{path}: there is no such file", path.parent)
    try:
        with h5py.File(path, "r") as file:
            yield file
    except InputOutputError:
        raise
    except (OSError, RuntimeError) as error:
        raise InputOutputError(f"{path}: is damaged: {error}", path.parent) from None
