"""The figure of a design: its bars and its curve, and what it says where there is none."""

import math

import pytest

import kugelpendel as kp
from kugelpendel import plot

SITE = kp.Site(math.radians(50.0))
PENDULUM = kp.Pendulum(20.0, SITE.gravity)


def test_bars_are_the_rates() -> None:
    uneven = kp.Suspension(2e-6, 0.5, 1e-5, -0.3)
    found = kp.design(PENDULUM, 1.0, 0.005, site=SITE, suspension=uneven, checked=False)
    left, right = plot.design(found, "tower").axes
    widths = [bar.get_width() for bar in left.patches]  # pyright: ignore[reportAttributeAccessIssue]
    hourly = [math.degrees(rate) * 3600 for rate in found.budget.values()]
    assert abs(hourly[2]) < 0.01  # cannot be seen, and has no bar
    assert widths[:4] == pytest.approx([*hourly[:2], hourly[3], sum(hourly)])
    slow, fast = (found[f"{name}_by_damping"].value for name in ("slowest", "fastest"))
    assert widths[-1] == pytest.approx(math.degrees(slow - fast) * 3600)
    assert not right.axison
    assert "No drag is given" in right.texts[0].get_text()


def test_curve_is_the_decay() -> None:
    found = kp.design(PENDULUM, 1.0, drag=kp.Drag(1e-4, 1e-3), checked=False)
    _, right = plot.design(found).axes
    curve, half = right.lines
    assert curve.get_ydata()[0] == pytest.approx(1.0)  # pyright: ignore[reportIndexIssue]
    hours = found["half_time"].value / 3600
    assert half.get_xdata()[0] in (pytest.approx(hours), pytest.approx(60 * hours))  # pyright: ignore[reportIndexIssue]
    assert half.get_ydata()[0] == pytest.approx(0.5)  # pyright: ignore[reportIndexIssue]
