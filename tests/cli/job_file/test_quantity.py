"""Numbers with units."""

import math

import pytest

from kugelpendel.cli.job_file.quantity import (
    ACCELERATION,
    ANGLE,
    LENGTH,
    MASS,
    RATE,
    SPEED,
    TIME,
    read_quantity,
)


@pytest.mark.parametrize(
    ("text", "kind", "value"),
    [
        ("67 m", LENGTH, 67.0),
        ("67m", LENGTH, 67.0),
        (" 1 cm ", LENGTH, 0.01),
        ("7 cm", LENGTH, 0.07),
        ("29 cm", LENGTH, 0.29),
        ("83 mm", LENGTH, 0.083),
        ("12 ft", LENGTH, 3.6576),
        ("3e-9 m", LENGTH, 3e-9),
        (".5 km", LENGTH, 500.0),
        ("-2 µm", LENGTH, -2e-6),
        (0, LENGTH, 0.0),
        (3, LENGTH, 3.0),
        (0.25, LENGTH, 0.25),
        ("10 min", TIME, 600.0),
        ("1 h", TIME, 3600.0),
        ("2 d", TIME, 172800.0),
        ("28 kg", MASS, 28.0),
        ("500 g", MASS, 0.5),
        ("9.81 m/s^2", ACCELERATION, 9.81),
        ("9.81 m/s²", ACCELERATION, 9.81),
        ("9.81 m s^-2", ACCELERATION, 9.81),
        ("18 km/h", SPEED, 5.0),
        ("30 deg", ANGLE, math.pi / 6),
        ("30°", ANGLE, math.pi / 6),
        ("1 turn", ANGLE, 2 * math.pi),
        ("2 rad", ANGLE, 2.0),
        ("180 deg/s", RATE, math.pi),
        ("11.3 °/h", RATE, 11.3 * math.pi / 180 / 3600),
        ("60 rpm", RATE, 2 * math.pi),
    ],
)
def test_value(text: str | float, kind, value: float) -> None:
    # Decimal units are rounded once; π has 28 digits, so one more rounding is all there is.
    assert read_quantity(text, kind, "[x] y") == pytest.approx(value, rel=2.3e-16, abs=0)


def test_decimal_units_give_the_number_as_written() -> None:
    for count in range(1, 2000):
        assert read_quantity(f"{count} mm", LENGTH, "") == count / 1000
        assert read_quantity(f"{count} cm", LENGTH, "") == count / 100
