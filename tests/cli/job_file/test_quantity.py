"""Numbers with units."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from kugelpendel import InvalidInput
from kugelpendel.cli.job_file import units
from kugelpendel.cli.job_file.kinds import (
    ACCELERATION,
    ANGLE,
    DECAY,
    DENSITY,
    LATITUDE,
    LENGTH,
    MASS,
    RATE,
    SPEED,
    TIME,
    Kind,
)
from kugelpendel.cli.job_file.quantity import read_quantity

DEGREE = math.pi / 180


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
        # A comma is a decimal mark, where it cannot be taken for one of thousands.
        ("0,2 m", LENGTH, 0.2),
        ("0,125 m", LENGTH, 0.125),
        ("67,5 m", LENGTH, 67.5),
        ("-2,25 mm", LENGTH, -0.00225),
        ("48,846 deg", LATITUDE, 48.846 * DEGREE),
        ("1,5e-3 1/s", DECAY, 1.5e-3),
        # Several parts.
        ("12 ft 6 in", LENGTH, 3.81),
        ("12ft 6in", LENGTH, 3.81),
        ("12' 6\"", LENGTH, 3.81),
        ("-1 m 20 cm", LENGTH, -1.2),
        ("1 h 30 min", TIME, 5400.0),
        ("2 d 3 h 0,5 min", TIME, 183630.0),
        ("5 lb 3 oz", MASS, 2.353010419375),
        ("29 deg 43.281 min", ANGLE, 29.72135 * DEGREE),
        ("-29 deg 43.281 min", ANGLE, -29.72135 * DEGREE),
        ("48° 51′ 12″", ANGLE, (48 + 51 / 60 + 12 / 3600) * DEGREE),
        ("30′", ANGLE, 0.5 * DEGREE),
        # Latitudes.
        ("48°51′N", LATITUDE, 48.85 * DEGREE),
        ("48°51'12\"N", LATITUDE, (48 + 51 / 60 + 12 / 3600) * DEGREE),
        ("48º51’ N", LATITUDE, 48.85 * DEGREE),
        ("48.85 N", LATITUDE, 48.85 * DEGREE),
        ("48,85° N", LATITUDE, 48.85 * DEGREE),
        ("N 48.85", LATITUDE, 48.85 * DEGREE),
        ("33 S", LATITUDE, -33 * DEGREE),
        ("33S", LATITUDE, -33 * DEGREE),
        ("33 deg 52 min S", LATITUDE, -(33 + 52 / 60) * DEGREE),
        ("−33°", LATITUDE, -33 * DEGREE),
        # What angles and other kinds of units may have.
        ("50 gon", ANGLE, math.pi / 4),
        ("3 mrad", ANGLE, 0.003),
        ("360 deg", ANGLE, 2 * math.pi),
        ("-1 turn", ANGLE, -2 * math.pi),
        ("9.81 m·s⁻²", ACCELERATION, 9.81),
        ("7.86 g/cm**3", DENSITY, 7860.0),
        ("8500 kg/(m^3)", DENSITY, 8500.0),
        ("3\u00a0m", LENGTH, 3.0),
    ],
)
def test_value(text: str | float, kind, value: float) -> None:
    # Decimal units are rounded once; π has 28 digits, so one more rounding is all there is.
    assert read_quantity(text, kind, "[x] y") == pytest.approx(value, rel=2.3e-16, abs=0)


def test_decimal_units_give_the_number_as_written() -> None:
    for count in range(1, 2000):
        assert read_quantity(f"{count} mm", LENGTH, "") == count / 1000
        assert read_quantity(f"{count} cm", LENGTH, "") == count / 100


@pytest.mark.parametrize(
    ("value", "kind", "said"),
    [
        (45, ANGLE, r'= 45 is in rad, which is more than a full turn; .* write "45 deg"'),
        (-6.3, ANGLE, r"= -6.3 is in rad"),
        ("45 rad", ANGLE, r'more than a full turn; write an angle from "-360 deg" to "360 deg"'),
        ("45 Grad", ANGLE, r'the unit "Grad" means degrees to some and gon to others; write "deg"'),
        ("45 grad", ANGLE, r'the unit "grad" means degrees'),
        ("48.8 grad", LATITUDE, r'the unit "grad" means degrees'),
        ("3 grad/s", RATE, r'the unit "grad/s" means degrees'),
        ("500 gr", MASS, r'the unit "gr" means gram to some, but is the grain'),
        ("45 kdeg", ANGLE, r'the unit "kdeg" would be a kilodegree'),
        ("45 mdeg", ANGLE, r"millidegree"),
        ("1 krad", ANGLE, r"kiloradian"),
        ("5 kdeg/s", RATE, r"kilodegree"),
        ("3 Min", LENGTH, r'the unit "Min" would be a megainch'),
        ("3 dd", TIME, r"deciday"),
        ("4{ deg", ANGLE, r'the unit "\{ deg" is not known'),
        ("4 (deg", ANGLE, r"is not known"),
        ("4 m^9**9**9", LENGTH, r"is not known"),
        ("4 m^99", LENGTH, r"is not known"),
        ("1,234 m", LENGTH, r'may mean 1.234 or 1234; write "1.234 m" or "1234 m"'),
        ("1,234.5 m", LENGTH, r"more than one point or comma"),
        ("1.234,5 m", LENGTH, r"more than one point or comma"),
        ("1 000 m", LENGTH, r"is not known"),
        ("12 ft 13 in", LENGTH, r"in ever smaller units"),
        ("6 in 12 ft", LENGTH, r"in ever smaller units"),
        ("1.5 h 30 min", TIME, r"in ever smaller units"),
        ("1 m 2 kg", LENGTH, r"is not a length"),
        ("29 deg 75 min", ANGLE, r"in ever smaller units"),
        ("-33 S", LATITUDE, r"both a sign and S"),
        ("2.35 E", LATITUDE, r"is not a latitude"),
        ("N 48 S", LATITUDE, r"is not a latitude"),
        ("48.85 N", ANGLE, r"is not an angle"),
        ("N", LATITUDE, r"does not start with a number"),
        ("5 m", TIME, r"is not a time"),
        ("5 Hz", RATE, r"Hz does not say whether turns or radians"),
    ],
)
def test_refused(value: str | float, kind: Kind, said: str) -> None:
    with pytest.raises(InvalidInput, match=said):
        read_quantity(value, kind, "[x] y")


KINDS = st.sampled_from([LENGTH, TIME, MASS, ANGLE, LATITUDE, RATE, SPEED, DENSITY])
PIECES = st.sampled_from(
    [*"0123456789.,+-*/^ '\"°′″()[]{}²⁻µμNSE%", "deg", "m", "ft", "min", "kg", "1e9", "**"]
)


@given(st.lists(PIECES, max_size=12).map("".join) | st.text(max_size=20), KINDS)
def test_any_text_is_a_number_or_a_sentence(text: str, kind: Kind) -> None:
    try:
        value = read_quantity(text, kind, "[x] y")
    except InvalidInput as error:
        said = str(error)
    else:
        assert math.isfinite(value)
        assert abs(value) <= kind.most
        return
    assert said.startswith("[x] y = ")
    assert said.endswith(".")


@given(st.decimals(0, 359, places=6), st.booleans())
def test_parts_of_an_angle_add_up(angle, comma: bool) -> None:
    whole, minutes = divmod(angle * 60, 60)
    text = f"{whole} deg {minutes} min"
    value = read_quantity(text.replace(".", ",") if comma else text, ANGLE, "")
    assert value == pytest.approx(math.radians(angle), rel=4e-16, abs=1e-300)


def test_everyday_units_are_those_of_pint() -> None:
    assert units._EVERYDAY
    for (unit, si), size in units._EVERYDAY.items():
        scale, root, _ = units._parsed(unit)
        of_si, expected, _ = units._parsed(si)
        assert root == expected
        assert size == scale / of_si
