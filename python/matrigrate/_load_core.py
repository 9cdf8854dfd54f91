"""Finds and loads the compiled module."""
from __future__ import annotations

import importlib.machinery
import importlib.util
import os
import sys
from pathlib import Path
from types import ModuleType

from .errors import CoreNotFound


def core() -> ModuleType:
    """The compiled module: beside this file, or where the environment variable MATRIGRATE_CORE says."""
    name = "matrigrate._core"
    if name in sys.modules:
        return sys.modules[name]
    places = [os.environ.get("MATRIGRATE_CORE", ""), *map(str, Path(__file__).parent.glob("_core*.so"))]
    found = next((place for place in places if place and Path(place).is_file()), None)
    if found is None:
        raise CoreNotFound("this package was installed without its compiled module, so it can neither step a simulation "
                           "(matrigrate.run runs one) nor compute read-outs of tracks (matrigrate tracks does); on Debian 12, in a clone of Matrigrate, python/install.sh builds the "
                           "module and installs the package with it into a virtual environment")
    spec = importlib.util.spec_from_file_location(name, found,
                                                  loader=importlib.machinery.ExtensionFileLoader(name, found))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[name] = module
    return module
