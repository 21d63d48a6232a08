"""Where a plane hurries, lags and stalls, and by what."""

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.motion import CAUSES, PrecessionBudget

EARTH = -5e-5  # rad/s


def shares(**causes: list[float]) -> PrecessionBudget:
    """Shares of the rate, in units of the Earth's; nothing for what is not named."""
    count = len(next(iter(causes.values())))
    values = {name: EARTH * np.array(share) for name, share in causes.items()}
    times = 10.0 * np.arange(count, dtype=np.float64)
    each = {name: values.get(name, np.zeros(count)) for name in CAUSES}
    return PrecessionBudget(times, times, **each, outer=times, inner=times)


def test_paces() -> None:
    ones = [1.0] * 6
    found = shares(earth=ones, intrinsic=[0.0, 0.009, 0.02, -0.02, -0.95, -1.5])
    assert list(found.pace) == [
        "as it should", "as it should", "hurries", "lags", "stalls", "stalls",
    ]  # fmt: skip


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_paces_are_the_same_on_both_hemispheres(sign: float) -> None:
    found = shares(earth=[sign] * 3, damping=[0.1 * sign, -0.1 * sign, -2 * sign])
    assert list(found.pace) == ["hurries", "lags", "stalls"]


def test_there_is_no_pace_without_the_earth() -> None:
    found = shares(earth=[0.0, 0.0], intrinsic=[1.0, 2.0])
    assert list(found.pace) == ["", ""]
    assert found.stretches() == []


def test_stretches_meet_half_way_between_the_times_and_cover_all() -> None:
    found = shares(earth=[1.0] * 6, intrinsic=[0.0, 0.1, 0.1, -0.1, -0.1, 0.0]).stretches()
    assert [(s.pace, s.start, s.stop) for s in found] == [
        ("as it should", 0.0, 5.0),
        ("hurries", 5.0, 25.0),
        ("lags", 25.0, 45.0),
        ("as it should", 45.0, 50.0),
    ]
    assert [s.cause for s in found] == ["", "intrinsic", "intrinsic", ""]


def test_cause_is_the_one_that_drives_and_the_one_that_holds_against_it() -> None:
    (one,) = shares(
        earth=[1.0] * 2, intrinsic=[0.8] * 2, drive=[-0.6] * 2, damping=[0.1] * 2
    ).stretches()
    assert (one.pace, one.cause, one.against) == ("hurries", "intrinsic", "drive")
    (well,) = shares(
        earth=[1.0] * 2, intrinsic=[9.0] * 2, drive=[-8.9] * 2, anisotropy=[0.5] * 2
    ).stretches()
    assert (well.pace, well.cause, well.against) == ("hurries", "anisotropy", "")
    (two,) = shares(earth=[1.0] * 2, intrinsic=[0.2] * 2, damping=[-0.8] * 2).stretches()
    assert (two.pace, two.cause, two.against) == ("lags", "damping", "")


def test_shares_add_up() -> None:
    found = shares(earth=[1.0], intrinsic=[0.5], anisotropy=[0.25], damping=[-1.0], drive=[2.0])
    assert found.beyond_earth[0] == pytest.approx(1.75 * EARTH)
    assert found.total[0] == pytest.approx(2.75 * EARTH)


def test_an_ensemble_has_no_stretches_but_paces() -> None:
    motion = kp.EnvelopeMotion(
        kp.Pendulum([1.0, 2.0], 9.8), kp.Launch.ellipse(0.1, 0.001), site=kp.Site(0.8)
    )
    rates = motion.rates([0.0, 5.0, 9.0])
    assert rates.pace.shape == rates.total.shape == (2, 3)
    # On the shorter one the ellipse turns by itself all but as fast as the Earth.
    assert rates.pace.tolist() == [["stalls"] * 3, ["lags"] * 3]
    with pytest.raises(
        kp.InvalidInput, match=r"times have the shape \(3,\) and the rates \(2, 3\)"
    ):
        rates.stretches()
    single = kp.EnvelopeMotion(
        kp.Pendulum(1.0, 9.8), kp.Launch.ellipse(0.1, 0.0), site=kp.Site(0.8)
    )
    with pytest.raises(kp.InvalidInput, match="need times that ascend"):
        single.rates([5.0, 0.0]).stretches()
    assert single.rates(5.0).total.shape == ()
