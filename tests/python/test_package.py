"""The package as pip installs it: its version, and that it is whole."""
import json
import os
import re
import shutil
import subprocess
import sys
import unittest
import zipfile

import common
import matrigrate

common.skip_without("setuptools", "wheel", "pip")


class Package(common.InTemporaryFolder):
    def test_version_is_that_of_the_program(self):
        cmake = (common.source / "CMakeLists.txt").read_text()
        self.assertEqual(matrigrate.__version__, re.search(r"project\(matrigrate VERSION (\S+)", cmake).group(1))

    def test_pip_installs_it_without_a_network(self):
        clone = self.folder / "clone"  # pip writes into the folder that it installs from
        shutil.copytree(common.source / "python", clone / "python", ignore=shutil.ignore_patterns("*.egg-info", "__pycache__"))
        (clone / "docs").mkdir()
        (clone / "tools").mkdir()
        for file in ("pyproject.toml", "setup.py", "tools/stubs.py", "docs/scenario.schema.json", "docs/readouts.json"):
            shutil.copy(common.source / file, clone / file)
        subprocess.run([sys.executable, "-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", "--no-build-isolation",
                        "--wheel-dir", self.folder, clone], check=True)
        wheel, = self.folder.glob("*.whl")
        with zipfile.ZipFile(wheel) as archive:
            names = set(archive.namelist())
            archive.extractall("installed")
        for file in (common.source / "python" / "matrigrate").iterdir():
            if file.name != "__pycache__":
                self.assertIn(f"matrigrate/{file.name}", names)
        self.assertTrue({"matrigrate/scenario.schema.json", "matrigrate/readouts.json", "matrigrate/_sections.pyi"} <= names)
        script = ("import json, matrigrate as m; print(json.dumps([m.__file__, m.__version__, "
                  "m.Scenario().ecm.youngs_modulus, m.load(%r).status]))" % str(common.runs / "run"))
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=self.folder,
                              env=os.environ | {"PYTHONPATH": str(self.folder / "installed")})
        where, version, modulus, status = json.loads(done.stdout)
        self.assertTrue(where.startswith(str(self.folder)), where)
        self.assertEqual((version, modulus, status), (matrigrate.__version__, 200.0, "done"))

    def test_reading_scenarios_needs_neither_pandas_nor_h5py(self):
        script = ("import sys; sys.modules.update(pandas=None, h5py=None, matplotlib=None)\nimport matrigrate\n"
                  "print(matrigrate.load(%r).readouts.n_protrusions)\n"
                  "for get in (lambda run: run.tracks, lambda run: run.fields, matrigrate.plot.path):\n"
                  "  try: get(matrigrate.load(%r))\n"
                  "  except ImportError as error: print(error)" % ((str(common.runs / "run"),) * 2))
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
        for words in ("tables need pandas", "fields need h5py", "figures need matplotlib"):
            self.assertIn(words, done.stdout, done.stderr)


if __name__ == "__main__":
    unittest.main()
