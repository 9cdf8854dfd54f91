"""Results, scenarios and runs of Matrigrate, a simulator of a cell that migrates through a degradable matrix.

    import matrigrate

    run = matrigrate.load("cell-seed1")               # the folder of a run
    run.tracks                                        # pandas: t_s, x_um, y_um, ...
    run.readouts.v_migr_abs_um_per_h                  # um/h
    run.fields["matrix/pressure"][-1]                 # numpy: Pa, of each particle in the last frame

    study = matrigrate.load_study("stiffness-study")  # many runs
    study.results

    scenario = matrigrate.Scenario.preset("soft")     # a scenario of one's own
    scenario.ecm.youngs_modulus = "100 Pa"
    run = matrigrate.run(scenario, out="mine", hours=1)

Units are um, s, nN, stress in Pa; they stand in the names of columns. The tutorial is docs/python.md.
"""
from . import calibrate, exchange, plot, tracks, truth
from ._version import __version__
from .base.program import live
from .errors import ConfigurationError, CoreNotFound, Fault, InputOutputError, InternalError, KeyboardStop, MatrigrateError, NumericalError, ProgramNotFound, Stopped, UnknownParameter, UsageError
from .results.fields import Field, Fields
from .results.results import CellOfRun, CellsOfRun, Readouts, ReadoutsOfCells, Run, load, meaning
from .results.simulate import run, run_study
from .results.studies import Runs, Study, load_study
from .scenario.scenario import Scenario
from .scenario.schema import Parameter
from .scenario.sections import Section
from .simulation import Cell, Matrix, Simulation

__all__ = [
    "Cell", "CellOfRun", "CellsOfRun", "ConfigurationError", "CoreNotFound", "Fault", "Field", "Fields",
    "InputOutputError", "InternalError", "KeyboardStop", "MatrigrateError", "Matrix", "NumericalError", "Parameter",
    "ProgramNotFound", "Readouts", "ReadoutsOfCells", "Run", "Runs", "Scenario", "Section", "Simulation", "Stopped",
    "Study", "UnknownParameter", "UsageError", "__version__", "calibrate", "exchange", "live", "load", "load_study", "meaning",
    "plot", "run", "run_study", "tracks", "truth",
]
