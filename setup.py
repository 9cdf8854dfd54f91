"""Takes the schema and the types made from it into the package, and what a build has made: the compiled module of matrigrate.Simulation, the
live page; the program, if MATRIGRATE_INSIDE names it. pyproject.toml has all else."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

_root = Path(__file__).parent
_named = os.environ.get("MATRIGRATE_CORE", "")
_live = [page for page in (_root / "pages/live.html", _root / "build/web/live/index.html", _root / "live/index.html") if page.is_file()][:1]
_built = [Path(_named)] if _named else sorted(_root.glob("build/*/python/_core*.so"), key=os.path.getmtime)[-1:]
_program = os.environ.get("MATRIGRATE_INSIDE", "")


class WithCore(build_py):
    def run(self):
        super().run()
        package = Path(self.build_lib) / "matrigrate"
        for table in ("docs/scenario.schema.json", "docs/readouts.json", "viewer/src/colours.json"):
            shutil.copy2(_root / table, package)
        subprocess.run([sys.executable, "-B", _root / "tools" / "stubs.py", package / "scenario" / "sections.pyi"], check=True)
        for page in _live:
            shutil.copy2(page, package / "live.html")
        for module in _built:
            shutil.copy2(module, package / module.name)
        if _program:
            (package / "bin").mkdir(exist_ok=True)
            shutil.copy2(_program, package / "bin" / "matrigrate")


class Binary(Distribution):
    def has_ext_modules(self):
        return bool(_built or _program)


setup(cmdclass={"build_py": WithCore}, distclass=Binary, scripts=["python/command/matrigrate"] if _program else [])
