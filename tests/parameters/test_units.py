"""Quantities with a unit are converted or refused, and masked numbers are bad cases."""

from typing import Any, ClassVar

import numpy as np
import pytest

from kugelpendel import Drag, ExactMotion, InvalidInput, Launch, Pendulum, Site


class Astropy:
    """The protocol of astropy and unyt: `to_value` beside `unit`."""

    sizes: ClassVar = {"cm": 0.01, "m": 1.0}

    def __init__(self, value: Any, unit: str):
        self.value, self.unit = value, unit

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(self.value)  # as theirs does: without the unit

    def to_value(self, unit: str) -> Any:
        if self.unit not in self.sizes or unit not in self.sizes:
            raise TypeError(f"{self.unit} does not convert to {unit}")
        return np.asarray(self.value) * self.sizes[self.unit] / self.sizes[unit]


class Mute:
    """A quantity of a library that nobody here knows."""

    units = "cm"

    def __array__(self, dtype: Any = None, copy: Any = None) -> Any:
        return np.asarray(67.0)


def test_pint_is_converted() -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    assert Pendulum(67 * unit.cm).length == pytest.approx(0.67, rel=1e-15)
    pendulum = Pendulum([100, 200] * unit.cm, 981 * unit.cm / unit.s**2, 500 * unit.g)
    assert pendulum == Pendulum([1.0, 2.0], 9.81, 0.5)
    assert Site(45 * unit.deg) == Site(np.pi / 4)
    assert Drag(3.6 / unit.hour, 1 / unit.km) == Drag(1e-3, 1e-3)
    launch = Launch.ellipse([3 * unit.cm, 5 * unit.mm], 1 * unit.mm)
    assert launch.shape == (2,)
    assert launch == Launch.ellipse([0.03, 0.005], 0.001)
    motion = ExactMotion(Pendulum(1.0), Launch.ellipse(0.1, 0.0))
    assert motion.position(1 * unit.minute) == pytest.approx(motion.position(60.0))


def test_pint_of_another_kind_is_refused() -> None:
    pint = pytest.importorskip("pint")
    unit = pint.UnitRegistry()
    said = "^The pendulum's length must be a quantity in m, but it is .*; give a number in m, or"
    for wrong in (67 * unit.s, [1 * unit.m, 2 * unit.kg], 67 * unit.dimensionless):
        with pytest.raises(InvalidInput, match=said):
            Pendulum(wrong)


def test_the_protocol_of_astropy() -> None:
    assert Pendulum(Astropy(67.0, "cm")).length == pytest.approx(0.67, rel=1e-15)  # pyright: ignore[reportArgumentType]
    assert Pendulum(Astropy([67.0, 100.0], "cm")).shape == (2,)  # pyright: ignore[reportArgumentType]
    with pytest.raises(InvalidInput, match="must be a quantity in m, but it is"):
        Pendulum(Astropy(67.0, "s"))  # pyright: ignore[reportArgumentType]


def test_a_unit_that_nobody_knows_is_not_lost() -> None:
    with pytest.raises(InvalidInput, match=r"must be a quantity in m, but it is .*Mute"):
        Pendulum(Mute())


def test_masked_numbers_are_bad_cases() -> None:
    lengths = np.ma.masked_array([1.0, 2.0, 3.0], mask=[False, True, False])
    assert np.isnan(np.asarray(Pendulum(lengths).length)).tolist() == [False, True, False]
    motion = ExactMotion(Pendulum(lengths), Launch.ellipse(0.1, 0.0))
    assert list(motion.problems) == [1]
    assert np.isfinite(motion.position(1.0)[[0, 2]]).all()
    with pytest.raises(InvalidInput, match="length must be positive and finite, but it is NaN"):
        Pendulum(np.ma.masked)
    with pytest.raises(InvalidInput, match="Times must be finite, but 1 of 3 are not"):
        motion.position(lengths)
    # Whole numbers have no NaN of their own.
    whole: Any = np.ma.masked_array([1, 2], mask=[False, True])  # pyright: ignore[reportCallIssue, reportArgumentType]
    assert np.isnan(np.asarray(Pendulum(whole).length)[1])
