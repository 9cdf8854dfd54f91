"""What the tests of the Python package share: the small runs, and skipping where a library is missing."""
import os
import pathlib
import sys
import tempfile
import unittest

try:
    import tomllib  # noqa: F401 # Python 3.11
    import h5py  # noqa: F401
    import numpy  # noqa: F401
    import pandas  # noqa: F401
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

source = pathlib.Path(__file__).resolve().parents[2]
program = os.environ["MATRIGRATE"]
runs = pathlib.Path(os.environ["MATRIGRATE_SMALL_RUNS"])  # made by small_runs.sh
unittest.TestCase.maxDiff = None


class InTemporaryFolder(unittest.TestCase):
    """Each test works in an empty folder, with MATRIGRATE as it was."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.addCleanup(os.chdir, os.getcwd())
        self.addCleanup(os.environ.update, {"MATRIGRATE": os.environ["MATRIGRATE"]})
        os.chdir(self.folder)


def points_of(parameters, values, positions=0, seen=(), design=None):
    """Simulations for emulators: a run a point. @param seen  their tracks, of so many positions"""
    from matrigrate.fit.measurement import Points

    counts = pandas.DataFrame(1.0, values.index, values.columns)
    return Points(parameters, values, counts, 1, positions, [], list(seen), parameters if design is None else design)


def skip_without(*modules):
    for name in modules:
        try:
            __import__(name)
        except ImportError as missing:
            print(f"not here: {missing}")
            sys.exit(77)


if __name__ == "__main__":
    sys.exit("run one of the tests")
