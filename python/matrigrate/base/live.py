"""The live page: a cell computed in the browser while one watches."""
from __future__ import annotations

import webbrowser
from pathlib import Path

from ..errors import InputOutputError
from . import program


def live(*, show: bool = True) -> Path:
    """Opens the live page in the browser, and returns where it is: a cell is computed there while you watch. The page is
    one file that needs neither network nor program; a copy of it works as well.

    :param show: False only returns where it is
    :raises InputOutputError: if neither this package nor the program has the page, saying where to get it
    """
    page = Path(__file__).parents[1] / "live.html"
    if not page.is_file():
        if program.find() is None:
            raise InputOutputError(f"the live page is not here: there is no {page}, and no program that has it. The wheel, the Debian "
                                   "package and the folder of a release have the page; a clone has it in live/")
        outcome = program.call(["live", "--print"])
        program.raise_for(outcome, None)
        page = Path(outcome.out.strip())
    if show:
        webbrowser.open(page.as_uri())
    return page
