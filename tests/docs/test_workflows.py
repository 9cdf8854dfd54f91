"""The files in .github/ and the conda recipe can be read, and what they name is there: test_workflows.py"""
import pathlib
import re
import subprocess
import sys
import unittest

try:
    import yaml
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

source = pathlib.Path(__file__).resolve().parents[2]
workflows = {path.name: yaml.safe_load(path.read_text(encoding="utf-8")) for path in sorted((source / ".github/workflows").glob("*.yml"))}
forms = {path.name: yaml.safe_load(path.read_text(encoding="utf-8")) for path in sorted((source / ".github/ISSUE_TEMPLATE").glob("*.yml"))}


def missing_scripts(command: str) -> list[str]:
    """Programs of this project that a step calls, and that are not there or cannot be run."""
    named = [match[1] for line in command.splitlines() if (match := re.match(r"\s*((?:\./|tools/|web/|python/|tests/)[\w./-]+)", line))]
    return [name for name in named if not (source / name).is_file() or not (source / name).stat().st_mode & 0o100]


def steps(workflow: dict) -> list[dict]:
    return [step for job in workflow["jobs"].values() for step in job.get("steps", [])]


class Workflows(unittest.TestCase):
    def test_scripts_are_there(self):
        called = [step["run"] for workflow in workflows.values() for step in steps(workflow) if "run" in step]
        self.assertGreater(len(called), 5)
        for command in called:
            self.assertEqual(missing_scripts(command), [], command)

    def test_rule_finds_what_is_not_there(self):
        self.assertEqual(missing_scripts("./no-such\n  tools/nothing.sh --to x\n./test"), ["./no-such", "tools/nothing.sh"])

    def test_each_job_runs_on_the_system_that_is_tested(self):
        for name in ("test", "make"):
            job = next(workflow["jobs"][name] for workflow in workflows.values() if name in workflow["jobs"])
            self.assertEqual(job["container"], "debian:12")

    def test_jobs_are_waited_for_and_called_by_names_that_exist(self):
        for name, workflow in workflows.items():
            for job in workflow["jobs"].values():
                needed = job.get("needs", [])
                self.assertLessEqual({needed} if isinstance(needed, str) else set(needed), workflow["jobs"].keys(), name)
                if "uses" in job:
                    called = pathlib.Path(job["uses"]).name
                    self.assertIn("workflow_call", workflows[called][True], called)  # YAML 1.1 reads `on` as true

    def test_version_is_found_by_the_pattern_of_the_release(self):
        command, = [step["run"] for step in steps(workflows["release.yml"]) if "GITHUB_REF_NAME#v" in step.get("run", "")]
        version = re.search(r'__version__ = "(.*)"', (source / "python/matrigrate/_version.py").read_text())[1]
        for tag, code in ((f"v{version}", 0), ("v0.0.0", 1)):
            done = subprocess.run(["bash", "-c", command], cwd=source, env={"GITHUB_REF_NAME": tag, "PATH": "/usr/bin:/bin"})
            self.assertEqual(done.returncode, code, tag)

    def test_release_script_knows_its_options(self):
        command, = [step["run"] for step in steps(workflows["release.yml"]) if step.get("run", "").startswith("tools/release.sh")]
        help_text = subprocess.run([source / "tools/release.sh", "--help"], capture_output=True, text=True, check=True).stdout
        for option in re.findall(r"--\w+", command):
            self.assertIn(option, help_text)


class Forms(unittest.TestCase):
    def test_fields_have_labels_and_names_of_their_own(self):
        self.assertEqual(set(forms), {"config.yml", "fault.yml", "question.yml", "wish.yml"})
        for name, form in forms.items():
            if name == "config.yml":
                continue
            fields = [field for field in form["body"] if field["type"] != "markdown"]
            ids = [field["id"] for field in fields]
            self.assertEqual(len(ids), len(set(ids)), name)
            self.assertTrue(all(field["attributes"]["label"] for field in fields), name)
            self.assertTrue(any(field.get("validations", {}).get("required") for field in fields), name)

    def test_commands_that_they_name_exist(self):
        verbs = re.findall(r'add_subcommand\("(\w+)"', "".join(path.read_text() for path in (source / "apps").rglob("*.cpp")))
        for path in (source / ".github").rglob("*"):
            if path.is_file():
                for verb in re.findall(r"`matrigrate (\w+)", path.read_text(encoding="utf-8")):
                    self.assertIn(verb, verbs, path.name)


class Recipe(unittest.TestCase):
    recipe = yaml.safe_load((source / "packaging/conda/recipe.yaml").read_text(encoding="utf-8"))

    def test_version_is_that_of_the_build(self):
        build = re.search(r"project\(matrigrate VERSION (\S+)", (source / "CMakeLists.txt").read_text())[1]
        self.assertEqual(self.recipe["context"]["version"], build)

    def test_files_of_the_package_are_those_of_the_source(self):
        for name in self.recipe["about"]["license_file"]:
            self.assertTrue((source / name).is_file(), name)
        for test in self.recipe["tests"]:
            for name in test.get("package_contents", {}).get("files", []):
                place = name.removeprefix("share/").replace("man/man1", "man").removeprefix("matrigrate/")
                self.assertTrue((source / place).is_file(), name)

    def test_python_packages_are_those_of_pyproject(self):
        import tomllib
        wanted = tomllib.loads((source / "pyproject.toml").read_text(encoding="utf-8"))["project"]
        run = {line.replace(" ", "").replace("python-xxhash", "xxhash") for line in self.recipe["requirements"]["run"]}  # the library has that name there
        self.assertEqual(run, {*wanted["dependencies"], f"python{wanted['requires-python']}"})


if __name__ == "__main__":
    unittest.main()
