"""The package as pip installs it: its version, and that it is whole."""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import unittest
import unittest.mock
import zipfile

import common
import matrigrate

common.skip_without("setuptools", "wheel", "pip")


class Package(common.InTemporaryFolder):
    def test_version_is_that_of_the_program(self):
        cmake = (common.source / "CMakeLists.txt").read_text()
        self.assertEqual(matrigrate.__version__, re.search(r"project\(matrigrate VERSION (\S+)", cmake).group(1))

    def wheel(self, **inside):
        """The wheel that pip makes. @param inside  variables of the environment that name what goes into it"""
        clone = self.folder / "clone"  # pip writes into the folder that it installs from
        shutil.copytree(common.source / "python", clone / "python", ignore=shutil.ignore_patterns("*.egg-info", "__pycache__"))
        (clone / "pages").mkdir()
        (clone / "pages/live.html").write_text("<p>a cell")
        for file in ("pyproject.toml", "setup.py", "LICENSE", "NOTICES", "tools/stubs.py", "docs/python.md", "docs/scenario.schema.json",
                     "docs/readouts.json", "viewer/src/colours.json"):
            (clone / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(common.source / file, clone / file)
        subprocess.run([sys.executable, "-m", "pip", "wheel", "--quiet", "--no-index", "--no-deps", "--no-build-isolation",
                        "--wheel-dir", self.folder, clone], check=True, env=os.environ | inside)
        wheel, = self.folder.glob("*.whl")
        return wheel

    def test_pip_installs_it_without_a_network(self):
        wheel = self.wheel()
        with zipfile.ZipFile(wheel) as archive:
            names = set(archive.namelist())
            archive.extractall("installed")
        package = common.source / "python" / "matrigrate"
        for file in package.rglob("*.py*"):
            if "__pycache__" not in file.parts:
                self.assertIn(f"matrigrate/{file.relative_to(package)}", names)
        self.assertTrue({"matrigrate/scenario.schema.json", "matrigrate/readouts.json", "matrigrate/colours.json", "matrigrate/scenario/sections.pyi"} <= names)
        script = ("import json, matrigrate as m; print(json.dumps([m.__file__, m.__version__, "
                  "m.Scenario().ecm.youngs_modulus, m.load(%r).status, m.live(show=False).read_text()]))" % str(common.runs / "run"))
        done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, cwd=self.folder,
                              env=os.environ | {"PYTHONPATH": str(self.folder / "installed")})
        where, version, modulus, status, page = json.loads(done.stdout)
        self.assertTrue(where.startswith(str(self.folder)), where)
        self.assertEqual((version, modulus, status, page), (matrigrate.__version__, 200.0, "done", "<p>a cell"))

    def test_a_package_without_the_live_page_asks_the_program_and_says_where_to_get_it(self):
        for program, words in (("/no/such/program", "no program that has it"), (str(self.program_without_page()), "A clone has it in live/")):
            with unittest.mock.patch.dict(os.environ, {"MATRIGRATE": program}), self.assertRaisesRegex(matrigrate.InputOutputError, words):
                matrigrate.live(show=False)

    def program_without_page(self):
        """The program alone in a folder: nothing is installed beside it."""
        (self.folder / "bin").mkdir()
        return shutil.copy(os.environ["MATRIGRATE"], self.folder / "bin")

    @unittest.skipUnless(shutil.which("patchelf") and "MATRIGRATE_CORE" in os.environ, "needs patchelf and the compiled module")
    def test_a_wheel_with_the_program_needs_no_library_of_the_system(self):
        plain = self.wheel(MATRIGRATE_INSIDE=os.environ["MATRIGRATE"])
        for folder in ("once", "twice"):
            subprocess.run([common.source / "tools" / "wheel_libraries.py", plain, folder], check=True)
        wheel, = pathlib.Path("once").glob("*-manylinux_2_*.whl")
        self.assertEqual(wheel.read_bytes(), (pathlib.Path("twice") / wheel.name).read_bytes())
        subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", "venv"], check=True)
        python = self.folder / "venv/bin/python"
        subprocess.run([sys.executable, "-m", "pip", "--python", python, "install", "--quiet", "--no-index", "--no-deps", wheel], check=True)
        package, = self.folder.glob("venv/lib/python3*/site-packages/matrigrate")
        elsewhere = {"HOME": "/", "PATH": "/usr/bin:/bin"}  # not the program and module of this build
        for file in (package / "bin/matrigrate", *package.glob("_core*.so")):
            loaded = subprocess.run(["ldd", file], capture_output=True, text=True, check=True, env=elsewhere).stdout
            others = [line for line in loaded.splitlines() if "matrigrate.libs" not in line and
                      not re.search(r"(linux-vdso|ld-linux\S*|lib(c|m|stdc\+\+|gcc_s|resolv|dl|rt|pthread))\.so", line)]
            self.assertEqual(others, [], file)
            self.assertIn("libhdf5" if file.name == "matrigrate" else "libfmt", loaded)
        self.assertIn(f"matrigrate {matrigrate.__version__}", subprocess.run([self.folder / "venv/bin/matrigrate", "info"], capture_output=True,
                                                                            text=True, check=True, env=elsewhere).stdout)
        script = "import matrigrate as m; from matrigrate.base import program as _program; s = m.Simulation(); s.step(); print(_program.find())"
        done = subprocess.run([python, "-c", script], capture_output=True, text=True, check=True, cwd="/", env=elsewhere)
        self.assertEqual(done.stdout.strip(), str(package / "bin/matrigrate"))

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
