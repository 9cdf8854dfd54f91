"""Takes the schema and the types made from it into the package, and the compiled module of matrigrate.Simulation where a build has made it; pyproject.toml has all else."""
import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

_root = Path(__file__).parent
_named = os.environ.get("MATRIGRATE_CORE", "")
_built = [Path(_named)] if _named else sorted(_root.glob("build/*/python/_core*.so"), key=os.path.getmtime)[-1:]


class WithCore(build_py):
    def run(self):
        super().run()
        for table in ("scenario.schema.json", "readouts.json"):
            shutil.copy2(_root / "docs" / table, Path(self.build_lib) / "matrigrate")
        subprocess.run([sys.executable, "-B", _root / "tools" / "stubs.py", Path(self.build_lib) / "matrigrate" / "_sections.pyi"], check=True)
        for module in _built:
            shutil.copy2(module, Path(self.build_lib) / "matrigrate" / module.name)


class Binary(Distribution):
    def has_ext_modules(self):
        return bool(_built)


setup(cmdclass={"build_py": WithCore}, distclass=Binary)
