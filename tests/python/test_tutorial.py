"""Every block of Python in docs/python.md runs, in order; what it says is printed is printed."""
import contextlib
import io
import os
import re
import unittest

import common

os.environ["MPLBACKEND"] = "agg"
common.skip_without("matplotlib")


def has_core():
    import matrigrate
    try:
        matrigrate.simulation.core()
    except matrigrate.CoreNotFound:
        return False
    return True


page = (common.source / "docs" / "python.md").read_text(encoding="utf-8")


class Tutorial(common.InTemporaryFolder):
    def test_all_blocks(self):
        blocks = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
        if not has_core():
            blocks = [block for block in blocks if "Simulation(" not in block]
        self.assertGreater(len(blocks), 8)
        names, printed = {}, io.StringIO()
        for block in blocks:
            line = page[:page.index(block)].count("\n")
            with contextlib.redirect_stdout(printed):
                exec(compile("\n" * line + block, "docs/python.md", "exec"), names)
        text = printed.getvalue()
        for words in re.findall(r"^ *print\(error\) +# (.*)$", page, re.MULTILINE):
            self.assertIn(words, text)
        self.assertIn("60 min, 100%", text)
        self.assertIn("done, 1 h, seed 7", text)
        self.assertIn("\n100.0\n", text)
        for picture in ("path", "frame", "msd", "boxes"):
            self.assertGreater((self.folder / f"{picture}.png").stat().st_size, 5000)
        self.assertEqual(names["study"].points["done"].tolist(), [3, 3], "all runs of the study are done")
        self.assertEqual(names["mine"].folder.name, "mine-seed1")


if __name__ == "__main__":
    unittest.main()
