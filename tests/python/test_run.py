"""Runs from Python: the same bits as the program, its words as exceptions, stopping and going on."""
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import common
import matrigrate
from matrigrate import Scenario

cell = common.runs / "cell.toml"


class RunsFromPython(common.InTemporaryFolder):
    def test_same_bits_and_progress(self):
        told = []
        run = matrigrate.run(Scenario.load(cell), out="run", progress=lambda *now: told.append(now))
        self.assertEqual(run.trajectory_hash, matrigrate.load(common.runs / "run").trajectory_hash)
        self.assertEqual(run.status, "done")
        self.assertEqual(told[-1], (1800.0, 1.0))
        self.assertEqual(told, sorted(set(told)), "each time once, in order")
        again = matrigrate.run(cell, out="run")
        self.assertEqual(again.record["end"], run.record["end"], "a run that is done is left as it is")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "holds another run"):
            matrigrate.run(cell, out="run", seed=2)

    def test_seed_hours_overrides_and_default_folder(self):
        run = matrigrate.run(cell, seed=3, hours=0.05, threads=2,
                             overrides={"ecm.youngs_modulus": "300 Pa", "output.report": False, "cell.start_x": 2})
        self.assertEqual(run.folder, pathlib.Path("cell-seed3-youngs_modulus-300Pa-report-false-start_x-2"))
        self.assertEqual((run.seed, run.record["duration_s"], run.scenario["ecm"]["youngs_modulus"],
                          run.scenario["cell"]["start_x"]), (3, 180.0, "300 Pa", "2 um"))
        scenario = Scenario.load(cell).copy("mine")
        self.assertEqual(matrigrate.run(scenario, hours=0.01).folder, pathlib.Path("mine-seed1"))

    def test_names_the_command_that_makes_the_run_again(self):
        scenario = Scenario.load(cell).copy("mine")
        scenario.output.report = True
        run = matrigrate.run(scenario, hours=0.01, seed=5)
        command = run.record["command_line"]
        self.assertEqual(command[1:], ["run", "mine-seed5/scenario.resolved.toml", "-o", "mine-seed5-again"])
        self.assertEqual(run.record["commands"], [command])
        self.assertEqual(run.record["scenario"], "mine")
        self.assertIn("matrigrate run mine-seed5/scenario.resolved.toml -o mine-seed5-again",
                      (run.folder / "report.html").read_text(encoding="utf-8"))
        self.assertEqual(subprocess.run([*command, "--quiet"], capture_output=True, check=False).returncode, 0)
        self.assertEqual(matrigrate.load("mine-seed5-again").trajectory_hash, run.trajectory_hash)
        again = matrigrate.run(cell, out="by-file", hours=0.01)
        self.assertIn(str(cell), again.record["command_line"], "a file that stays is named")

    def test_configuration(self):
        scenario = Scenario.load(cell)
        scenario.ecm.radius = 20
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            matrigrate.run(scenario, out="run", overrides={"run.durations": 3})
        keys = [fault.key for fault in caught.exception.faults]
        self.assertEqual(sorted(keys), ["ecm.radius", "run.durations"])
        self.assertIn("did you mean run.duration?", str(caught.exception))
        self.assertNotIn("/tmp", str(caught.exception))
        self.assertFalse((self.folder / "run").exists())
        (self.folder / "None").write_text("[ecm]\nradius = \"6 um\"\n")
        with self.assertRaises(matrigrate.ConfigurationError) as caught:
            matrigrate.run("None", out="run")
        self.assertEqual([(fault.file, fault.line) for fault in caught.exception.faults], [("None", 2)])

    def test_other_failures(self):
        with self.assertRaisesRegex(matrigrate.NumericalError, "clamped rim") as caught:
            matrigrate.run(cell, out="x", overrides={"ecm.radius": "40 um", "ecm.youngs_modulus": "50 Pa"})
        self.assertEqual(matrigrate.load(caught.exception.folder).status, "failed")
        with self.assertRaisesRegex(matrigrate.InputOutputError, "cannot be read"):
            matrigrate.run("none.toml", out="y")
        with self.assertRaisesRegex(matrigrate.UsageError, "the program is"):
            matrigrate.base.program.raise_for(matrigrate.base.program.call(["run", "--no-such-option"]), None)

    def test_without_the_program(self):
        for named, words in (("/nowhere/matrigrate", "MATRIGRATE names /nowhere/matrigrate"), ("", "not on PATH")):
            os.environ["MATRIGRATE"] = named
            path = os.environ["PATH"]
            os.environ["PATH"] = "/nowhere"
            try:
                with self.assertRaisesRegex(matrigrate.ProgramNotFound, words):
                    matrigrate.run(cell, out="x")
                Scenario().save("unchecked.toml", overwrite=True)
                matrigrate.load(common.runs / "run")
            finally:
                os.environ["PATH"] = path

    def test_a_callback_that_fails_ends_the_run(self):
        def fail(t, share):
            raise RuntimeError("enough")

        with self.assertRaisesRegex(RuntimeError, "enough"):
            matrigrate.run(cell, out="x", hours=24, progress=fail)
        self.assertEqual(matrigrate.load("x").status, "interrupted")

    def test_wall_time_then_the_same_bits(self):
        with self.assertRaisesRegex(matrigrate.Stopped, "safe in checkpoint") as caught:
            matrigrate.run(cell, out="x", wall_time="0.2 s")
        self.assertEqual(matrigrate.load(caught.exception.folder).status, "interrupted")
        run = matrigrate.run(cell, out="x")
        self.assertEqual(run.trajectory_hash, matrigrate.load(common.runs / "run").trajectory_hash)

    def test_control_c(self):
        script = f"import matrigrate; matrigrate.run({str(cell)!r}, out='x', hours=24)"
        python = subprocess.Popen([sys.executable, "-c", script], stderr=subprocess.PIPE, text=True,
                                  start_new_session=True)
        tracks = self.folder / "x" / "tracks.csv"
        while not (tracks.exists() and tracks.read_text().count("\n") > 2) and python.poll() is None:
            time.sleep(0.05)
        os.killpg(python.pid, signal.SIGINT)  # as a terminal does: to Python and the program
        words = python.communicate(timeout=60)[1]
        self.assertNotEqual(python.returncode, 0)
        self.assertIn("and a checkpoint are in x; the same call continues", words)
        run = matrigrate.load("x")
        self.assertEqual((run.status, run.record["exit_code"]), ("interrupted", 130))

    def test_study(self):
        text = (common.runs / "study.toml").read_text().replace('"cell.toml"', f'"{cell}"')
        (self.folder / "small.toml").write_text(text.replace("replicates = 2", "replicates = 1"))
        study = matrigrate.run_study("small.toml", jobs=1)
        self.assertEqual(study.folder, pathlib.Path("small-study"))
        theirs = matrigrate.load_study(common.runs / "study").results
        self.assertEqual(list(study.results["trajectory_hash"]),
                         list(theirs[theirs["replicate"] == 1]["trajectory_hash"]))
        (self.folder / "bad.toml").write_text("replicates = 0\n")
        with self.assertRaises(matrigrate.ConfigurationError):
            matrigrate.run_study("bad.toml")


if __name__ == "__main__":
    unittest.main()
