"""Units to read, and numbers in them."""

import math
import sys

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from kugelpendel import spelling


@pytest.mark.parametrize(
    ("value", "si", "text"),
    [
        (67.0, "m", "67.00 m"),
        (0.01, "m", "1.000 cm"),
        (0.0038265, "m/s", "3.826 mm/s"),
        (1e-7, "m", "100.0 nm"),
        (2e-20, "m", "2.000e−20 m"),
        (0.0, "m", "0 m"),
        (-0.25, "m", "−25.00 cm"),
        (12345.0, "m", "12.35 km"),
        (16.4, "s", "16.40 s"),
        (119.0, "s", "119.0 s"),
        (150.0, "s", "2.500 min"),
        (114720.0, "s", "31.87 h"),
        (6.55e6, "s", "75.81 d"),
        (1e9, "s", "31.69 years"),
        (1e-6, "s", "1.000 µs"),
        (0.7853981633974483, "rad", "45.00°"),
        (0.001, "rad", "3.438 arcmin"),
        (1e-9, "rad", "1.000 nrad"),
        (28.0, "kg", "28.00 kg"),
        (275.2, "N", "275.2 N"),
        (2.5e5, "N", "250.0 kN"),
    ],
)
def test_spell(value: float, si: str, text: str) -> None:
    assert spelling.spell(value, si) == text


@pytest.mark.parametrize(
    ("rate", "text"),
    [
        (9.59e-7, "+0.1978 °/h"),
        (-0.0237, "−1.358 °/s"),
        (0.0, "0 °/h"),
        (-1e-20, "−2.063e−15 °/h"),
    ],
)
def test_rate(rate: float, text: str) -> None:
    assert spelling.spell_rate(rate) == text


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (9.9996, 4, "10.00"),
        (123456.0, 4, "123456"),
        (1234567.0, 4, "1.235e+06"),
        (1.2e-5, 3, "0.0000120"),
        (1.2e-6, 3, "1.20e−06"),
        (1e-300, 4, "1.000e−300"),
        (-5e-324, 2, "−4.9e−324"),
        (float("inf"), 4, "inf"),
        (float("-inf"), 4, "−inf"),
    ],
)
def test_significant(value: float, digits: int, text: str) -> None:
    assert spelling.significant(value, digits) == text


@pytest.mark.parametrize(
    ("fraction", "text"),
    [
        (0.0, "the same"),
        (4.9e-15, "the same"),
        (-5.1e-15, "−5.1e−13 %"),
        (0.011, "+1.1 %"),
        (-1.0, "−100 %"),
    ],
)
def test_percent(fraction: float, text: str) -> None:
    assert spelling.spell_percent(fraction) == text


@pytest.mark.parametrize(
    ("value", "si", "text"),
    [
        (67.0, "m", "67 m"),
        (0.0, "m", "0 m"),
        (-1.0, "m", "−1 m"),
        (1e-300, "m", "1e−300 m"),
        (0.0038, "m/s", "3.8 mm/s"),
        (0.1 + 0.2, "kg", "300 g"),
    ],
)
def test_as_given(value: float, si: str, text: str) -> None:
    assert spelling.as_given(value, si) == text


@pytest.mark.parametrize(
    ("size", "text"),
    [
        (0.0, "0 B"),
        (999.0, "999 B"),
        (6.4e9, "6.4 GB"),
        (64e12, "64 TB"),
        (math.inf, "inf B"),
        (1e300, "1e+270 QB"),
    ],
)
def test_bytes(size: float, text: str) -> None:
    assert spelling.spell_bytes(size) == text


def test_german_has_a_comma_and_its_own_names_of_units() -> None:
    assert spelling.spell(0.0038265, "m/s", language="de") == "3,826 mm/s"
    assert spelling.spell(1e9, "s", language="de") == "31,69 Jahre"
    assert spelling.spell(0.001, "rad", language="de") == "3,438 Bogenminuten"
    assert spelling.spell_rate(-0.0237, language="de") == "−1,358 °/s"
    assert spelling.spell_percent(0.011, language="de") == "+1,1 %"
    assert spelling.spell_percent(0.0, language="de") == "gleich"
    assert spelling.as_given(0.125, "m", language="de") == "12,5 cm"
    assert spelling.degrees(0.1, language="de") == "5,72958°"
    assert spelling.significant(1.5, 3, language="de") == "1,50"
    assert spelling.spell_bytes(1.25e9, language="de") == "1,25 GB"


def test_counts_are_grouped() -> None:
    assert [spelling.grouped(count) for count in (7, 1000, 36001)] == ["7", "1 000", "36 001"]


# An angle is said in degrees or smaller units, so its number is up to 206 265 times as large.
NUMBERS = st.floats(-1e302, 1e302)
UNITS = st.sampled_from(["m", "m/s", "s", "rad", "kg", "N"])


@given(NUMBERS, UNITS, st.integers(1, 12))
def test_what_is_said_is_the_number_to_its_digits(value: float, si: str, digits: int) -> None:
    unit = spelling.unit_for(value, si)
    said = spelling.spell(value, si, digits).removesuffix(unit.symbol).strip()
    assert "-" not in said
    assert float(said.replace("−", "-")) * unit.size == pytest.approx(
        value, rel=0.51 * 10.0 ** (1 - digits), abs=5e-324
    )


@given(NUMBERS)
@example(sys.float_info.max)
def test_no_number_has_a_hyphen(value: float) -> None:
    for said in (
        spelling.spell_rate(value), spelling.spell_percent(value), spelling.general(value),
        spelling.degrees(value), spelling.as_given(value, "m"), spelling.minus(str(value)),
        spelling.significant(value, 3),
    ):  # fmt: skip
        assert "-" not in said
