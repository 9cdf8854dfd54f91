"""The lesson sheet: its links hold the presets that it names, and its numbers are those of docs/validation/results.md: test_lesson.py"""
import base64
import json
import pathlib
import re
import unittest

source = pathlib.Path(__file__).resolve().parents[2]
page = (source / "docs/lesson.md").read_text(encoding="utf-8")
validation = (source / "docs/validation/results.md").read_text(encoding="utf-8")
questions = re.split(r"^## (?=\d\. )", page, flags=re.MULTILINE)[1:]

# The words of the sheet, and what stands in the tables of results.
read_outs = {name: name for name in ["speed from start to end, um/h", "speed along the path, every 60 s, um/h", "lifetime of a protrusion, min",
                                     "protrusions in six hours", "slope of the mean square displacement"]}
read_outs["how mature protrusions become, 0 to 1"] = "maturation, 0 to 1"
tables = {"1": "A1 to A7", "2": "D: protrusions", "3": "A8:"}


def settings_of(link: str) -> dict[str, str]:
    return json.loads(base64.urlsafe_b64decode(link + "=" * (-len(link) % 4)))["set"]


def rows_of(text: str) -> dict[str, list[str]]:
    cells = [[cell.strip() for cell in line.strip("|").split("|")] for line in text.splitlines() if line.startswith("| ")]
    return {row[0]: row[1:] for row in reversed(cells)}  # of rows with one name, the first


def results(start: str) -> dict[str, list[str]]:
    """The table of results whose title begins so."""
    found = re.search(rf"^\*\*{re.escape(start)}.*?\n\n(.*?)\n\n", validation, re.MULTILINE | re.DOTALL)
    return rows_of(found[1])


class Lesson(unittest.TestCase):
    def test_links_hold_the_presets_that_are_named(self):
        cpp = (source / "src/parameters/presets.cpp").read_text(encoding="utf-8")
        fibres = re.findall(r'"([^"]+)"', re.search(r"uniaxial\{(.*?)\};", cpp, re.DOTALL)[1])
        self.assertEqual(len(questions), 5)
        for question in questions:
            name = re.search(r"\(`([\w-]+)`\)", question)[1]
            entry = re.search(rf'{{"{name}",\s*"[^"]*",\s*(\{{.*?\}}|kept\([^)]*\))\}}', cpp, re.DOTALL)[1]
            wanted = dict(one.split("=", 1) for one in re.findall(r'"([^"]+)"', entry) + (fibres if "uniaxial" in entry else []))
            if kept := re.match(r"kept\((\d)", entry):
                wanted |= {"protrusion.number": kept[1], "adhesion.rupture": "true"}
            link, = re.findall(r"^#scenario=([\w-]+)$", question, re.MULTILINE)
            self.assertEqual(settings_of(link), wanted | {"run.integrator": "adaptive", "run.seed": "1"}, name)

    def test_the_page_itself_has_the_same_questions(self):
        text = (source / "viewer/src/live/lesson.ts").read_text(encoding="utf-8")
        own = re.findall(r'ask: "([^"]+)", preset: "([^"]+)", then: "([^"]+)"', text)
        self.assertEqual([ask for ask, _, _ in own], re.findall(r"^## \d\. (.*)$", page, re.MULTILINE))
        for question, (_, preset, then) in zip(questions, own, strict=True):
            self.assertIn(f"(`{preset}`)", question)
            for slider in re.findall(r'\*\*Change\*\* "([^"]+)"', question):
                self.assertIn(slider, then)

    def test_other_languages_have_the_same_numbers_presets_and_sliders(self):
        def numbers(text: str, sign: str) -> list[str]:
            """Means and deviations of the tables, with a decimal point."""
            return [found.replace(sign, ".") for found in re.findall(rf"\| (\d[\d{sign}]* \+- [\d{sign}]+)", text)]

        for language in ("de", "fr"):
            text = (source / f"docs/lesson.{language}.md").read_text(encoding="utf-8")
            self.assertNotRegex(text, re.compile(r"^\|.*\d\.\d", re.MULTILINE), language)  # tables have decimal commas
            other = re.split(r"^## (?=\d\. )", text, flags=re.MULTILINE)[1:]
            self.assertEqual(len(other), 5)
            for own, translated in zip(questions, other, strict=True):
                self.assertEqual(numbers(translated, ","), numbers(own, "."), language)
                self.assertIn(f"(`{re.search(r'[(]`([a-z-]+)`[)]', own)[1]}`)", translated, language)
                for slider in re.findall(r'\*\*Change\*\* "([^"]+)"', own):
                    self.assertRegex(translated, f"[„«] ?{re.escape(slider)}[\"“ ]", language)
            self.assertIn(f"{results('A1 to A7')['speed from start to end, um/h'][2].replace('.', ',')} µm/h", other[4])

    def test_presets_and_sliders_have_these_names(self):
        cpp = (source / "src/parameters/presets.cpp").read_text(encoding="utf-8")
        for name in re.findall(r"`([a-z]+-[a-z-]+|soft|baseline)`", page):
            self.assertIn(f'"{name}"', cpp)
        controls = (source / "viewer/src/live/controls.ts").read_text(encoding="utf-8")
        for name in re.findall(r'\*\*Change\*\* "([^"]+)"', page):
            self.assertIn(f'name: "{name}"', controls)

    def test_numbers_of_the_tables_are_those_of_the_results(self):
        compared = 0
        for question in questions:
            if question[0] in tables:
                known = results(tables[question[0]])
                for row, cells in rows_of(question).items():
                    if row:
                        self.assertEqual(cells, known[read_outs[row]], row)
                        compared += len(cells)
        self.assertEqual(compared, 42)

    def test_other_numbers_are_those_of_the_results(self):
        with_fibres, without = results("E: protrusions")["speed from start to end, um/h"], results("D: protrusions")["speed from start to end, um/h"]
        self.assertEqual(rows_of(questions[3])["speed from start to end, um/h"], [without[1], with_fibres[1]])
        self.assertIn(f"gave**: {results('A1 to A7')['speed from start to end, um/h'][2]} um/h", questions[4])
        claims = {row: " ".join(cells) for row, cells in rows_of(validation).items() if re.fullmatch(r"[A-F]\d", row)}
        shares = [float(re.search(rf"{which} uniaxial fibres that ended by rupture: ([\d.]+)", claims["E5"])[1]) for which in ("along", "across")]
        self.assertIn("{:.0f} % of the protrusions along them tear off, and {:.0f} % of the protrusions across".format(*(100 * share for share in shares)), questions[3])
        maturation = [re.search(rf"maturation of protrusions {way} uniaxial fibres, mean: ([\d.]+)", claims["E5"])[1] for way in ("along", "across")]
        self.assertIn("maturation is {} along the fibres and {} across them".format(*maturation), questions[3])
        ratio = re.search(r"^\| 2 \| \d+ \|.*\| ([\d.]+) \[([\d.]+), ([\d.]+)\] \|", (source / "docs" / "validation.md").read_text(), re.MULTILINE).groups()
        self.assertIn("is {} times that across (95 % interval {} to {})".format(*ratio), questions[3])
        ends = {stiffness: (low, high) for low, high, stiffness in re.findall(r"\[([\d.]+), ([\d.]+)\] \((\d+) Pa\)", claims["A2"])}
        for stiffness in ("50", "200", "400"):
            self.assertIn("{} to {}".format(*ends[stiffness]), questions[4])


if __name__ == "__main__":
    unittest.main()
