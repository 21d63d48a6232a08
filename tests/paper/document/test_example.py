"""The worked numbers are those of the formulas and of the core, and every sentence gets its own."""

import math
import re

import pytest

import kugelpendel as kp
from kugelpendel import paper
from kugelpendel.olsson import precession
from kugelpendel.paper.document.example import (
    LATITUDE,
    PANTHEON,
    TO_BUILD,
    WIDE,
    Example,
    sky_rate,
    values,
)

LANGUAGES = ("de", "en")
SWINGS = {
    "to build": TO_BUILD,
    "Panthéon": PANTHEON,
    "wide": WIDE,
    "nearly round": Example(1, 9, 0.9, 0.89),
}


@pytest.mark.parametrize("name", SWINGS)
def test_the_exact_turning_is_that_of_the_core(name: str) -> None:
    swing = SWINGS[name]
    pendulum = kp.Pendulum(swing.length, swing.gravity)
    motion = kp.ExactMotion(pendulum, kp.Launch.apsides(swing.a, swing.b))
    # apsides close to 0 or to each other cost digits of what the core is given, not of its answer
    assert swing.exact_turning == pytest.approx(float(motion.precession), rel=1e-10)
    assert swing.exact_frequency == pytest.approx(float(motion.frequency), rel=1e-13)


@pytest.mark.parametrize("name", SWINGS)
def test_the_turning_by_25_is_that_of_olsson(name: str) -> None:
    swing = SWINGS[name]
    known = precession(swing.a, swing.b, swing.length, swing.gravity)
    assert swing.turning == pytest.approx(float(known), rel=1e-14)
    ratio = (swing.a**2 + swing.b**2) / swing.length**2
    expected = swing.natural_frequency * math.sqrt(1 - ratio / 8)
    assert swing.frequency == pytest.approx(expected, rel=1e-14)


def test_numbers_that_a_hand_can_check() -> None:
    spelled = values("en")
    frequency = math.sqrt(9.81 / 2)
    a_minute = math.degrees(0.375 * frequency * 0.2 * 0.05 / 4) * 60
    assert spelled["turning"] == f"{a_minute:.3f}" == "7.138"
    assert spelled["period"] == f"{2 * math.pi / frequency:.2f}"
    assert spelled["push"] == f"{5 * frequency:.0f}"
    assert float(spelled["exact-turning"]) > float(spelled["turning"])
    hour = math.degrees(sky_rate()) * 3600
    assert hour == pytest.approx(15.041 * math.sin(math.radians(LATITUDE)), rel=1e-4)
    assert spelled["paris-sky"] == "11.3 °/h"
    alike = float(spelled["paris-alike"]) / 100
    wide = Example(PANTHEON.length, PANTHEON.gravity, PANTHEON.a, alike)
    assert wide.turning == pytest.approx(sky_rate(), rel=0.01)


def test_german_has_decimal_commas() -> None:
    german, english = values("de"), values("en")
    assert german.keys() == english.keys()
    for name, text in english.items():
        assert german[name] == text.replace(".", ","), name


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_gap_of_the_wording_is_filled(language: str) -> None:
    tables = {key: value for key, value in paper.words(language).tables.items() if key != "ui"}
    wanted = set(re.findall(r"<([a-z0-9-]+)>", str(tables)))
    known = values(language)  # type: ignore[arg-type]
    assert wanted == set(known)
    for form in ("html", "md", "text"):
        # A page keeps numbers and units together by no-break blanks.
        written = paper.write(language, form).replace("\N{NO-BREAK SPACE}", " ")
        for name in wanted:
            assert f"<{name}>" not in written
            assert f"&lt;{name}&gt;" not in written
            assert form == "md" or known[name] in written or name.startswith("wide"), name


def test_both_languages_have_the_same_gaps() -> None:
    def gaps(table: object) -> list[str]:
        if isinstance(table, dict):
            return [gap for key in sorted(table) for gap in gaps(table[key])]
        if isinstance(table, list):
            return [gap for one in table for gap in gaps(one)]
        return sorted(re.findall(r"<([a-z0-9-]+)>", str(table)))

    german, english = (paper.words(language).tables for language in LANGUAGES)
    for name in german:
        assert gaps(german[name]) == gaps(english[name]), name
