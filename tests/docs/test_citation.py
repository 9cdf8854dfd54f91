"""CITATION.cff and codemeta.json say the same of the program and of the paper, in the version of the build: test_citation.py"""
import json
import pathlib
import re
import sys
import unittest

try:
    import yaml
except ImportError as missing:
    print(f"not here: {missing}")
    sys.exit(77)

source = pathlib.Path(__file__).resolve().parents[2]
cff = yaml.safe_load((source / "CITATION.cff").read_text(encoding="utf-8"))
codemeta = json.loads((source / "codemeta.json").read_text(encoding="utf-8"))


class Citation(unittest.TestCase):
    def test_version_is_that_of_the_build_and_of_the_packages(self):
        build = re.search(r"project\(matrigrate VERSION (\S+)", (source / "CMakeLists.txt").read_text())[1]
        package = re.search(r'__version__ = "(.*)"', (source / "python" / "matrigrate" / "_version.py").read_text())[1]
        of_r = re.search(r"^Version: (.*)", (source / "R" / "DESCRIPTION").read_text(), re.MULTILINE)[1]
        self.assertEqual({str(cff["version"]), codemeta["version"], package, of_r}, {build})

    def test_program(self):
        self.assertEqual((cff["title"], cff["abstract"], str(cff["date-released"]), f"https://spdx.org/licenses/{cff['license']}"),
                         (codemeta["name"], codemeta["description"], codemeta["datePublished"], codemeta["license"]))
        self.assertEqual([author["name"] for author in cff["authors"]], [author["name"] for author in codemeta["author"]])
        self.assertTrue((source / codemeta["softwareHelp"]).is_file())

    def test_paper(self):
        ours, = cff["references"]
        theirs = codemeta["referencePublication"]
        self.assertEqual((ours["title"], f"https://doi.org/{ours['doi']}", str(ours["year"])),
                         (theirs["name"], theirs["identifier"], theirs["datePublished"]))
        self.assertEqual([(author["given-names"], author["family-names"]) for author in ours["authors"]],
                         [(author["givenName"], author["familyName"]) for author in theirs["author"]])


if __name__ == "__main__":
    unittest.main()
