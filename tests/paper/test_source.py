"""The formulas as printed are those of the paper's text: all, in its order, sign by sign."""

import re
from pathlib import Path

import pytest

from kugelpendel import paper

PRINTED = [formula for formula in paper.FORMULAS if not formula.is_ours]
NUMBER = r"\((?:5[abc]|13[ab]|[1-46890]|1[026789]|2[0356])\)\s*(?=\\quad|&|=|\\q)"
LAYOUT = r"\\(?:begin|end)\{aligned\}|\\left|\\right|\\quad|\\text\{[^}]*\}|\\wedge|\\\\(?!\})|&|\s"


def bare(latex: str) -> str:
    """Without layout: alignment, spaces, ends of lines, the equation's number, the full stop."""
    return re.sub(LAYOUT, "", re.sub(NUMBER, "", latex)).rstrip(".,")


@pytest.fixture
def displays(shared: Path) -> list[str]:
    (source,) = (shared / "seed").glob("*.txt")
    text = source.read_text(encoding="utf-8")
    return [bare(found) for found in re.findall(r"\$\$(.*?)\$\$", text, re.DOTALL)]


def test_every_displayed_formula_is_there_as_printed(displays: list[str]) -> None:
    ours: dict[str, str] = {}
    for formula in PRINTED:
        ours[formula.display] = ours.get(formula.display, "") + bare(formula.printed)
    # the paper sets some of these together and some apart; the row of signs is the same
    assert "".join(ours.values()) == "".join(displays)


def test_every_display_of_the_text_is_one_of_ours(displays: list[str]) -> None:
    assert len(displays) == len({formula.display for formula in PRINTED})


def test_numbers_are_those_of_the_text(shared: Path) -> None:
    (source,) = (shared / "seed").glob("*.txt")
    blocks = re.findall(r"\$\$(.*?)\$\$", source.read_text(encoding="utf-8"), re.DOTALL)
    found = [
        number
        for block in blocks
        for number in re.findall(
            r"\((\d+[abc]?)\)\s*\\quad|"
            r"\((6)\) ",
            block,
        )
        for number in number
        if number
    ]
    ours: dict[str, str] = {}
    for formula in PRINTED:
        if formula.number:
            ours.setdefault(formula.display, formula.number)
    assert list(ours.values()) == found
