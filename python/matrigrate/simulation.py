"""A simulation that is stepped from Python, with forces of one's own."""
from __future__ import annotations

import math
import os
import weakref
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .base import arguments
from .base.files import read_text
from .base.load_core import core
from .scenario.scenario import Scenario
from .scenario.schema import toml_text

if TYPE_CHECKING:
    from . import _core

Floats = NDArray[np.float64]


class Matrix:
    """The particles of the matrix now. Arrays are read-only views of the simulation's own numbers: they change with it,
    and cost no copy."""

    def __init__(self, core: _core.Simulation) -> None:
        self._core = core

    def __len__(self) -> int:
        return len(self.X)

    @property
    def X(self) -> Floats:
        """Reference positions [um], shape (n, 2)."""
        return self._core.matrix_X()

    @property
    def x(self) -> Floats:
        """Positions [um], shape (n, 2)."""
        return self._core.matrix_x()

    @property
    def v(self) -> Floats:
        """Velocities of the last step [um/s], shape (n, 2)."""
        return self._core.matrix_v()

    @property
    def f_degr(self) -> Floats:
        """1 where the matrix is intact solid, 0 where it is fluid, shape (n,)."""
        return self._core.matrix_f()

    @property
    def density(self) -> Floats:
        """Density over the density at the start, shape (n,)."""
        return self._core.matrix_rho()

    @property
    def deviatoric_stress(self) -> Floats:
        """In-plane part of the deviatoric Cauchy stress [kPa], shape (n, 2, 2); S_zz = -(S_xx + S_yy)."""
        return self._core.matrix_S()


class Cell:
    """A cell now. Arrays are read-only views, as in Matrix."""

    def __init__(self, core: _core.Simulation, index: int) -> None:
        self._core, self._index = core, index

    @property
    def index(self) -> int:
        """Index of the cell in the simulation, from 0."""
        return self._index

    @property
    def x(self) -> Floats:
        """Positions of the particles of the cortex, counter-clockwise [um], shape (n, 2)."""
        return self._core.cell_x(self._index)

    @property
    def v(self) -> Floats:
        """Their velocities in the last step [um/s], shape (n, 2)."""
        return self._core.cell_v(self._index)

    @property
    def normals(self) -> Floats:
        """Outward unit normals at the particles of the cortex, shape (n, 2); computed when asked for, so no view."""
        return self._core.cell_normals(self._index)

    @property
    def rest_lengths(self) -> Floats:
        """Rest lengths of the segments of the cortex [um], shape (n,); segment i joins particle i to the next."""
        return self._core.cell_l0(self._index)

    @property
    def polarization(self) -> float | None:
        """Angle of the direction of polarization from the x axis [rad]; None before the first protrusion."""
        return self._core.cell_polarization(self._index)

    @property
    def protrusions(self) -> list[dict[str, Any]]:
        """Living protrusions: id, centre (index of the central particle), phase, since_s [s], and anchor_um [um] while
        adhered.

        :raises RuntimeError: while the simulation computes in another thread
        """
        return self._core.cell_protrusions(self._index)


class Simulation:
    """A simulation in memory: nothing is written. The same scenario has the bits of ``matrigrate run``.

    >>> simulation = Simulation(seed=3, overrides={"ecm.radius": "60 um", "run.integrator": "adaptive"})
    >>> simulation.advance(hours=0.01)
    >>> simulation.cell.x.shape, simulation.t > 35
    ((235, 2), True)

    A force of one's own is a function of the simulation that returns an array [nN], or None:

    >>> def pull(simulation):
    ...     return np.tile([1e-3, 0.0], (len(simulation.cell.x), 1))
    >>> pulled = Simulation(overrides={"ecm.radius": "60 um"}, cell_force=pull)
    >>> pulled.step()

    A cue of one's own is a function of the simulation and a cell that returns a factor on the rate at which each particle
    of that cell's cortex initiates protrusions:

    >>> def towards_x(simulation, cell):
    ...     return np.exp(cell.normals[:, 0])
    >>> cued = Simulation(overrides={"ecm.radius": "60 um"}, cue=towards_x)
    >>> cued.step()
    """

    def __init__(self, scenario: Scenario | str | os.PathLike[str] | None = None, *, seed: int | None = None,
                 overrides: Mapping[str, Any] | None = None,
                 force: Callable[[Simulation], Floats | None] | None = None,
                 cell_force: Callable[[Simulation], Floats | None] | None = None,
                 cue: Callable[[Simulation, Cell], Floats | None] | None = None, cue_every: int = 1) -> None:
        """:param scenario: a Scenario or the path of a scenario file; the defaults if left out
        :param seed: of the random numbers
        :param overrides: further parameters, ``{"ecm.youngs_modulus": "50 Pa"}``
        :param force: called in each step; returns forces on the particles of the matrix [nN], shape (n, 2), or None
        :param cell_force: the same for the particles of the cortex (of all cells, one after the other)
        :param cue: called for each cell before a step; returns factors on the rate of initiation of its particles [-],
            finite and >= 0, shape (n,), or None for 1; with protrusion.number > 0, weights in the draw of the particle
        :param cue_every: steps between two calls of the cue, which the factors of the first hold for; 1 to 10^9
        :raises ConfigurationError: with all that is wrong with the scenario
        :raises InputOutputError: if the file of the scenario cannot be read
        :raises CoreNotFound: if the package was installed without its compiled module
        """
        for what, function in (("force", force), ("cell_force", cell_force), ("cue", cue)):
            arguments.function(what, function)
        if isinstance(cue_every, bool) or not isinstance(cue_every, (int, np.integer)) or not 1 <= cue_every <= 10**9:
            raise ValueError(f"cue_every is {cue_every!r}; a whole number of steps from 1 to 10^9 is expected")
        name, text = _text_of(scenario)
        words = [f"{key}={value if isinstance(value, str) else toml_text(value)}"
                 for key, value in arguments.mapping("overrides", overrides).items()]
        words += [] if seed is None else [f"run.seed={seed}"]
        self._core: _core.Simulation = core().Simulation(text, name, words)
        me = weakref.ref(self)  # a cycle through the compiled object would never be freed

        def with_me(what: str, function: Callable[[Simulation], Floats | None] | None
                    ) -> Callable[[], Floats | None] | None:
            return None if function is None else lambda: _unmasked(what, function(_alive(me)))

        self._core.set_force(with_me("force", force), with_me("cell_force", cell_force))
        self._core.set_cue(None if cue is None else
                           lambda k: _unmasked("cue", cue(_alive(me), _alive(me).cells[k])), int(cue_every))
        self._name = name
        self.matrix = Matrix(self._core)  #: the particles of the matrix
        self.cells: list[Cell] = [Cell(self._core, k) for k in range(self._core.cell_count)]  #: the cells, in the order of the scenario

    def __repr__(self) -> str:
        cells = "1 cell" if len(self.cells) == 1 else f"{len(self.cells)} cells"
        return (f"Simulation({self._name!r}: {cells}, {len(self.matrix)} particles of matrix, {self.t / 3600:.3g} of "
                f"{self.duration / 3600:.3g} h, {self.step_count} steps{'' if self.failure is None else ', ' + self.failure})")

    @property
    def cell(self) -> Cell:
        """The first cell."""
        return self.cells[0]

    @property
    def t(self) -> float:
        """Simulated time [s]."""
        return self._core.t

    @property
    def step_count(self) -> int:
        """Steps done."""
        return self._core.step_count

    @property
    def duration(self) -> float:
        """run.duration of the scenario [s]; a simulation may go on beyond it."""
        return self._core.duration

    @property
    def failure(self) -> str | None:
        """When and why a step failed, "failed at 130 s: ..."; None if none did. The arrays are then of a step that
        broke off, to be looked at, and no further step is made."""
        return self._core.failure

    @property
    def closures(self) -> str:
        """The set of closures that the parameters belong to, "third set"; "mixed: ..." with the parameters of each set."""
        return self._core.closures

    @property
    def trajectory_hash(self) -> str:
        """The hash that run.json would have if the run ended now, after a failure without the step that broke off. Equal
        hashes mean equal bits.

        :raises RuntimeError: while the simulation computes in another thread
        """
        return self._core.trajectory_hash()

    def step(self) -> None:
        """One step, of run.time_step or as long as the adaptive integrator takes it.

        :raises NumericalError: if the step fails, or one did before
        :raises RuntimeError: if this simulation is computing: from a function of one's own, or in another thread
        """
        self._core.step()

    def advance(self, *, hours: float | None = None, until: float | None = None,
                progress: Callable[[Simulation], None] | None = None) -> None:
        """Goes on for some hours, until a time, or to the end of the scenario. Other threads of Python run meanwhile.

        Ctrl-C, and an exception in a function of one's own, end it between two steps; the simulation can go on after.

        :param hours: simulated time to go on for [h]
        :param until: simulated time to go on to [s]
        :param progress: called with the simulation at most ten times a second
        :raises NumericalError: if a step fails, or one did before: the simulation does not go on, make a new one
        :raises ValueError: if hours or until is negative or no finite number
        :raises RuntimeError: if this simulation is computing: from a function of one's own, or in another thread
        """
        if hours is not None and until is not None:
            raise ValueError("give hours or until, not both")
        for name, value, unit in (("hours", hours, "h"), ("until", until, "s")):
            _require_time(name, value, unit)
        arguments.function("progress", progress)
        end = self.t + 3600.0 * hours if hours is not None else until if until is not None else self.duration
        self._core.march_to(float(end), None if progress is None else lambda: progress(self))


def _alive(me: weakref.ref[Simulation]) -> Simulation:
    simulation = me()
    assert simulation is not None  # it is computing
    return simulation


def _unmasked(what: str, returned: Floats | None) -> Floats | None:
    """The array that a user's function returned. :raises ValueError: if it is masked, since a mask would be ignored"""
    if isinstance(returned, np.ma.MaskedArray):
        raise ValueError(f"{what} returned a masked array, whose mask would be ignored; a plain one is expected, such as "
                         ".filled(0)")
    return returned


def _text_of(scenario: Scenario | str | os.PathLike[str] | None) -> tuple[str, str]:
    """Name and text. A file is read as the program reads it, with the faults of `Scenario.load`."""
    if scenario is None:
        return "scenario", ""
    if isinstance(scenario, Scenario):
        return scenario.name, scenario.toml()
    file = arguments.path("scenario", scenario, "a Scenario or the path of a file")
    return str(file), read_text(file).removeprefix("\ufeff")


def _require_time(name: str, value: float | None, unit: str) -> None:
    if value is None:
        return
    if isinstance(value, bool) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise arguments.wrong(name, value, f"a number [{unit}]")
    if not (math.isfinite(value) and value >= 0):
        raise ValueError(f"{name} is {value}; a finite number [{unit}] >= 0 is expected")
