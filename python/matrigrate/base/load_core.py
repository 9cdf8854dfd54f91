"""Loads what may be missing: the compiled module, and libraries that only a part of the package needs."""
from __future__ import annotations

import importlib
import importlib.machinery
import importlib.util
import os
import sys
from pathlib import Path
from types import ModuleType
from typing import Any

from ..errors import CoreNotFound


def library(name: str, use: str) -> Any:
    """A library. :raises ImportError: naming its packages   :param use: what needs it: "tables need pandas" """
    try:
        return importlib.import_module(name)
    except ImportError:
        package = name.partition(".")[0]
        raise ImportError(f"{use}: apt install python3-{package}, or pip install {package}") from None


def core() -> ModuleType:
    """The compiled module: where the environment variable MATRIGRATE_CORE says; else in the folder of the package, or in a clone where ./demo builds it.

    :raises CoreNotFound: if it is in none of these places
    """
    name = "matrigrate._core"
    if name in sys.modules:
        return sys.modules[name]
    here = Path(__file__).resolve().parents[1]
    named = os.environ.get("MATRIGRATE_CORE")
    built = here.parents[1] / "build" / "release" / "python"
    places = [named] if named else [str(folder / f"_core{end}") for folder in (here, built) for end in importlib.machinery.EXTENSION_SUFFIXES]
    found = next((place for place in places if Path(place).is_file()), None)
    if found is None:
        raise CoreNotFound("this package has no compiled module, so it reads results, and neither checks scenarios, steps simulations nor reads "
                           "tracks; in a clone of Matrigrate on Debian 12 ./demo builds the module for the package in the clone, and "
                           "python/install.sh installs both into a virtual environment")
    spec = importlib.util.spec_from_file_location(name, found, loader=importlib.machinery.ExtensionFileLoader(name, found))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    sys.modules[name] = module
    return module
