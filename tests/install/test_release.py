"""The steps of tools/release.sh that need no new build, made twice: the same bytes, all files in the checksums: test_release.py BUILD"""
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest

source = pathlib.Path(__file__).resolve().parents[2]
build = pathlib.Path(sys.argv.pop()).resolve()
if not (source / ".git").exists():
    print("not here: a release is made of a commit, and this is no clone")
    sys.exit(77)
temporary = tempfile.TemporaryDirectory()
folders = [pathlib.Path(temporary.name) / name for name in ("first", "second")]
for folder in folders:
    subprocess.run([source / "tools/release.sh", "--build", build, "--to", folder, "source", "r", "containers", "sbom", "checksums"], check=True)
first, second = folders
version = re.search(r'__version__ = "(.*)"', (source / "python/matrigrate/_version.py").read_text())[1]
commit = subprocess.run(["git", "rev-parse", "HEAD"], cwd=source, capture_output=True, text=True, check=True).stdout.strip()


def live_page_is_of(commit: str) -> bool:
    named = source / "build/web/live/COMMIT"
    return named.exists() and named.read_text().strip() == commit


class Release(unittest.TestCase):
    def test_same_bytes(self):
        names = sorted(path.name for path in first.iterdir())
        self.assertEqual(names, sorted(path.name for path in second.iterdir()))
        for name in names:
            self.assertEqual((first / name).read_bytes(), (second / name).read_bytes(), name)

    def test_archive_holds_the_commit_the_pages_and_every_tracked_file(self):
        with tarfile.open(first / f"matrigrate-{version}.tar.gz") as archive:
            top = f"matrigrate-{version}"
            self.assertEqual(archive.extractfile(f"{top}/COMMIT").read().decode().strip(), commit)
            for page in ("run", "study", "verdicts"):
                self.assertEqual(archive.extractfile(f"{top}/pages/{page}.html").read(), (build / f"viewer/dist/{page}.html").read_bytes())
            files = {member.name.removeprefix(f"{top}/") for member in archive if member.isfile()}
            tracked = subprocess.run(["git", "ls-tree", "-r", "--name-only", "-z", "HEAD"], cwd=source, capture_output=True, text=True,
                                     check=True).stdout.strip("\0").split("\0")
            live = {"pages/live.html"} if live_page_is_of(commit) else set()
            self.assertEqual(files - set(tracked), {"COMMIT", "pages/run.html", "pages/study.html", "pages/verdicts.html"} | live)
            self.assertLessEqual(set(tracked), files)
            self.assertEqual({(member.uid, member.uname) for member in archive}, {(0, "")})

    @unittest.skipUnless(shutil.which("R"), "R is not installed")
    def test_r_package_installs_and_has_this_version(self):
        archive = first / f"matrigrate_{version}.tar.gz"
        library = pathlib.Path(temporary.name) / "library"
        library.mkdir()
        done = subprocess.run(["R", "CMD", "INSTALL", "-l", library, archive], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        said = subprocess.run(["Rscript", "--vanilla", "-e", 'cat(as.character(packageVersion("matrigrate")))'], capture_output=True, text=True,
                              env=os.environ | {"R_LIBS": str(library)})
        self.assertEqual(said.stdout, version, said.stderr)
        with tarfile.open(archive) as files:
            self.assertNotIn("matrigrate/matrigrate.R", files.getnames())  # for source() in a clone only

    def test_every_file_has_its_checksum_and_size(self):
        sums = dict(reversed(line.split("  ")) for line in (first / "SHA256SUMS").read_text().splitlines())
        sizes = dict(reversed(match) for match in re.findall(r"^ *(\d+)  (\S+)$", (first / "CONTENTS").read_text(), re.MULTILINE))
        files = {path.name for path in first.iterdir()}
        self.assertEqual(files, sums.keys() | {"SHA256SUMS"})
        self.assertEqual(files, sizes.keys() | {"SHA256SUMS", "CONTENTS"})
        for name, digest in sums.items():
            self.assertEqual(hashlib.sha256((first / name).read_bytes()).hexdigest(), digest, name)
        for name, size in sizes.items():
            self.assertEqual((first / name).stat().st_size, int(size), name)

    def test_parts_are_those_that_the_program_names(self):
        parts = json.loads((first / f"matrigrate-{version}.spdx.json").read_text())
        known = {package["SPDXID"]: package for package in parts["packages"]}
        linked = {known[one["relatedSpdxElement"]]["name"] for one in parts["relationships"] if one["relationshipType"] == "DYNAMIC_LINK"}
        needed = subprocess.run(["objdump", "-p", build / "bin/matrigrate"], capture_output=True, text=True, check=True).stdout
        for word in ("hdf5", "fmt", "tbb", "muparser", "png", "tiff"):
            self.assertEqual(any(word in name for name in linked), bool(re.search(rf"NEEDED.*{word}", needed)), word)
        self.assertGreater(len(linked), 8)
        for one in parts["relationships"]:
            self.assertLessEqual({one["spdxElementId"], one["relatedSpdxElement"]}, known.keys() | {"SPDXRef-DOCUMENT"})
        plotly = json.loads((source / "viewer/package.json").read_text())["devDependencies"]["plotly.js-cartesian-dist-min"]
        contained = [known[one["relatedSpdxElement"]]["versionInfo"] for one in parts["relationships"] if one["relationshipType"] == "CONTAINS"]
        self.assertEqual(contained, [plotly])

    def test_the_live_page_is_taken_where_it_is_of_this_commit_and_its_absence_is_told_as_is_that_of_r(self):
        """In a clone of its own, without Emscripten and R: tools/release.sh looks for the page in build/web/live/."""
        clone = pathlib.Path(temporary.name) / "clone"
        subprocess.run(["git", "clone", "--quiet", "--depth", "1", source.as_uri(), clone], check=True)
        (clone / "bin").mkdir()
        for tool in ("bash", "cat", "cp", "dirname", "git", "grep", "ls", "mkdir", "mktemp", "rm", "sed", "sudo", "basename", "id", "dpkg-query", "nproc"):
            if found := shutil.which(tool):
                (clone / "bin" / tool).symlink_to(found)
        (clone / "live/SOURCES").write_text("version 0.1.0\n")  # of other sources than these
        page = clone / "build/web/live/index.html"
        page.parent.mkdir(parents=True)
        page.write_text("<p>a cell")
        for named, there in ((f"{commit}, with changes", False), (commit, True)):
            (page.parent / "COMMIT").write_text(f"{named}\n")
            to = clone / "release" / str(there)
            done = subprocess.run([clone / "tools/release.sh", "--to", to, "live", "r"], capture_output=True, text=True, env={"PATH": str(clone / "bin")})
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual("Emscripten is not installed" in done.stdout, not there, done.stdout)
            self.assertIn("R is not installed", done.stdout)
            self.assertEqual([file.read_text() for file in to.iterdir()], ["<p>a cell"] if there else [])

        page.unlink()
        trees = [f"{folder} " + subprocess.run(["git", "rev-parse", f"HEAD:{folder}"], cwd=clone, capture_output=True, text=True, check=True).stdout
                 for folder in ("src", "viewer", "web")]
        (clone / "live/SOURCES").write_text("version 0.1.0\n" + "".join(trees))
        (clone / "live/index.html").write_text("<p>the kept one")
        (page.parent / "COMMIT").unlink()
        subprocess.run([clone / "tools/release.sh", "--to", clone / "release/kept", "live"], check=True, env={"PATH": str(clone / "bin")})
        self.assertEqual([file.read_text() for file in (clone / "release/kept").iterdir()], ["<p>the kept one"])

    def test_unknown_steps_are_refused(self):
        done = subprocess.run([source / "tools/release.sh", "--to", first / "no", "sbmo"], capture_output=True, text=True)
        self.assertEqual((done.returncode, (first / "no").exists()), (1, False))
        self.assertIn("no such step: sbmo", done.stderr)


if __name__ == "__main__":
    unittest.main()
