"""Units to read, and numbers in them."""

import pytest

from kugelpendel import plot


@pytest.mark.parametrize(
    ("value", "si", "text"),
    [
        (67.0, "m", "67.00 m"),
        (0.01, "m", "1.000 cm"),
        (0.0038265, "m/s", "3.826 mm/s"),
        (1e-7, "m", "100.0 nm"),
        (2e-20, "m", "2.000e-20 m"),
        (0.0, "m", "0 m"),
        (-0.25, "m", "-25.00 cm"),
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
    assert plot.spell(value, si) == text


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
    assert plot.spell_rate(rate) == text


@pytest.mark.parametrize(
    ("value", "digits", "text"),
    [
        (9.9996, 4, "10.00"),
        (123456.0, 4, "123456"),
        (1234567.0, 4, "1.235e+06"),
        (1.2e-5, 3, "0.0000120"),
        (1.2e-6, 3, "1.20e-06"),
        (float("inf"), 4, "inf"),
    ],
)
def test_significant(value: float, digits: int, text: str) -> None:
    assert plot.significant(value, digits) == text
