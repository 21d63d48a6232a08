"""What a builder asks: every answer against its check, and against figures found elsewhere."""

import math

import pytest

import kugelpendel as kp

SITE = kp.Site(math.radians(50.0))
BOB = kp.Bob(0.12, 7860.0, 0.28)
PENDULUM = kp.Pendulum(20.0, SITE.gravity, BOB.mass)
MUSEUM = kp.design(
    PENDULUM, 1.0, 0.005, azimuth=0.4, site=SITE, drag=kp.Drag(1e-4, 1e-6),
    suspension=kp.Suspension(2e-6, 0.5, 1e-5, -0.3), bob=BOB, drive=kp.Drive(5e-4, radius=0.25),
    wire=kp.Wire(1.5e-3), radius=0.2, time=0.5,
)  # fmt: skip

GOOD: dict[str, float] = {
    # Relative differences, or over the scale of the check; each some times what is seen.
    "period": 2e-6,
    "foucault_rate": 1e-7,
    "intrinsic_exact": 1e-8,
    "largest_b": 1e-3,
    "release_b": 1e-3,
    "release_rate": 2e-6,
    "rate_at_start": 2e-3,
    "amplitude_after": 1e-3,
    "stalling_damping": 2e-3,
    "turning_by_anisotropy": 1e-4,
    "slowest_by_anisotropy": 2e-3,
    "fastest_by_anisotropy": 2e-3,
    "widest_by_anisotropy": 3e-3,
    "slowest_by_damping": 1e-3,
    "fastest_by_damping": 1e-3,
    "turning_best_push": 5e-3,
    "growth_best_push": 2e-3,
    "turning_best_pull": 5e-3,
    "growth_best_pull": 2e-2,
    "turning_early": 5e-2,
    "growth_early": 5e-3,
    "turning_late": 2e-2,
    "growth_late": 5e-3,
    "turning_weak": 3e-2,
    "growth_weak": 1e-2,
    "turning_strong": 0.1,
    "growth_strong": 3e-2,
    "turning_given": 2e-2,
    "growth_given": 1e-2,
    "passage_time": 1e-12,
    "radius_at": 1e-12,
    "tension_least": 1e-3,
    "tension_largest": 1e-3,
}


@pytest.mark.parametrize("name", GOOD)
def test_formula_is_what_the_full_equations_give(name: str) -> None:
    check = MUSEUM[name].check
    assert check is not None
    assert check.relative is not None
    assert abs(check.relative) < GOOD[name]


def test_every_check_is_tested() -> None:
    assert {answer.key for answer in MUSEUM.answers if answer.check is not None} == set(GOOD)


def test_every_answer_says_where_it_comes_from() -> None:
    names = [answer.name for answer in MUSEUM.answers]
    assert len(set(names)) == len(names)
    for answer in MUSEUM.answers:
        assert math.isfinite(answer.value)
        assert answer.formula
        assert any(word in answer.source for word in ("(19", "(18", "docs/design.md", "§", "law",
                                                      "TR8350"))  # fmt: skip


def test_corrections_add_up_to_the_period() -> None:
    names = ("amplitude_exact", "ellipse_width", "bob_radius", "thread_mass",
             "buoyancy", "added_air", "drag_period", "earth_period",
             "suspension_period")  # fmt: skip
    total = 1 + sum(MUSEUM[name].value for name in names)
    small = MUSEUM["period_small"].value
    assert MUSEUM["period"].value / small == pytest.approx(total, abs=1e-6)


def test_pantheon() -> None:
    # 67 m, 28 kg, 3 m: 16.5 s, 11.3°/h, a turn in 31.8 h (J. B. L. Foucault's of 1851).
    site = kp.Site(math.radians(48 + 52 / 60))
    found = kp.design(kp.Pendulum(67.0, site.gravity, 28.0), 3.0, site=site, checked=False)
    assert found["period"].value == pytest.approx(16.4, abs=0.1)
    assert math.degrees(found["foucault_rate"].value) * 3600 == pytest.approx(-11.3, abs=0.05)
    assert found["foucault_turn"].value / 3600 == pytest.approx(31.8, abs=0.05)


def test_shares_are_the_rate() -> None:
    shares = [a.value for a in MUSEUM.answers if a.key.startswith("share_")]
    assert sum(shares) == pytest.approx(MUSEUM["rate_at_start"].value)
    assert sum(MUSEUM.budget.values()) == pytest.approx(MUSEUM["rate_at_start"].value)


def test_largest_b_has_its_share() -> None:
    found = kp.design(PENDULUM, 1.0, site=SITE, share=0.05, checked=False)
    b = found["largest_b"].value
    again = kp.design(PENDULUM, 1.0, b, site=SITE, checked=False)
    assert again["intrinsic_ratio"].value == pytest.approx(0.05, rel=1e-3)
    # Pushed with the one speed or the other, and seen from a frame that does not turn.
    omega, earth = float(PENDULUM.angular_frequency), float(SITE.vertical_rotation)
    for name, sign in (("least", -1), ("most", 1)):
        speed = found[f"speed_{name}"].value
        assert (speed + earth * 1.0) / omega == pytest.approx(sign * b)


@pytest.mark.parametrize("azimuth", [0.0, 0.7, math.pi / 2, math.pi, -math.pi / 2])
def test_release_from_rest_depends_on_the_direction(azimuth: float) -> None:
    # The bob's fall and rise make the Coriolis force push it across a swing that is not east-west.
    found = kp.design(PENDULUM, 2.0, azimuth=azimuth, site=SITE)
    earth, level = float(SITE.vertical_rotation), float(SITE.horizontal_rotation)
    known = -earth * (1 - 3 / 8 * 0.01) - level * 0.1**3 / 4 * math.sin(azimuth)
    rate = found["release_rate"]
    assert rate.value == pytest.approx(known, rel=1e-12)
    assert rate.check is not None
    assert rate.check.measured == pytest.approx(known, rel=1e-5)
    straight = found["foucault_rate"].check
    assert straight is not None
    assert straight.measured == pytest.approx(-earth, rel=1e-6)


def test_south_turns_the_other_way() -> None:
    south = kp.design(PENDULUM, 1.0, site=kp.Site(math.radians(-50.0)),
                      suspension=kp.Suspension(2e-6, 0.5, 1e-5, -0.3))  # fmt: skip
    for name in ("foucault_rate", "slowest_by_anisotropy",
                 "fastest_by_damping"):  # fmt: skip
        assert south[name].value > 0
        check = south[name].check
        assert check is not None
        assert check.measured == pytest.approx(south[name].value, rel=3e-3)
    assert south["release_b"].value < 0


def test_equator_never_turns() -> None:
    found = kp.design(PENDULUM, 1.0, site=kp.Site(0.0))
    assert found["foucault_turn"].value == math.inf
    assert found["foucault_rate"].value == 0
    with pytest.raises(
        kp.InvalidInput, match="no answer 'critical_amplitude'; it has period_small"
    ):
        found["critical_amplitude"]


def test_a_swing_turns_back_above_the_critical_amplitude_only() -> None:
    # The closed form with a start where the suspension does its worst.
    # Large enough for b ≪ a.
    stiff = kp.Suspension(1.2e-6, 0.0)
    pendulum = kp.Pendulum(20.0, SITE.gravity)
    wanted = kp.design(pendulum, 0.5, site=SITE, suspension=stiff, checked=False)
    critical = wanted["critical_amplitude"].value
    for share, turns_back in ((0.95, False), (1.05, True)):
        found = kp.design(
            pendulum, share * critical, azimuth=math.pi / 2, site=SITE, suspension=stiff
        )
        slowest = found["slowest_by_anisotropy"]
        assert slowest.check is not None
        assert (slowest.value > 0) is turns_back
        scale = abs(found["fastest_by_anisotropy"].value)
        assert slowest.check.measured == pytest.approx(slowest.value, abs=0.02 * scale)


def test_damping_stalls_at_twice_the_rotation() -> None:
    critical = MUSEUM["stalling_damping"].value
    for share, stalls in ((0.9, False), (1.1, True)):
        uneven = kp.Suspension(0.0, 0.0, share * critical, 0.0)
        found = kp.design(PENDULUM, 1.0, site=SITE, suspension=uneven)
        slowest = found["slowest_by_damping"]
        assert slowest.check is not None
        assert (slowest.value == 0) is stalls
        earth = float(SITE.vertical_rotation)
        assert (abs(slowest.check.measured) < 0.1 * earth) is stalls


@pytest.mark.parametrize(
    ("linear", "quadratic"), [(1e-4, 0.0), (0.0, 1e-3), (1e-4, 1e-3), (1e-12, 1e-3)]
)
def test_decay_is_its_own_inverse(linear: float, quadratic: float) -> None:
    found = kp.design(PENDULUM, 1.0, drag=kp.Drag(linear, quadratic), checked=False)
    for key, share in (("half_time", 0.5), ("e_time", 1 / math.e)):
        time = found[key].value
        assert found.amplitude(time) == pytest.approx(share, rel=1e-12)
    # a' = −γa − ka², by a difference quotient.
    omega = float(PENDULUM.angular_frequency)
    rate = (found.amplitude(1.0) - found.amplitude(-1.0)) / 2
    assert rate == pytest.approx(-linear - 4 / (3 * math.pi) * quadratic * omega, rel=1e-5)


def test_quality_and_half_life_are_the_ones_given() -> None:
    drag = kp.Drag.from_quality(800.0, PENDULUM)
    found = kp.design(PENDULUM, 1.0, drag=drag, checked=False)
    assert found["quality_linear"].value == pytest.approx(800)
    half = kp.design(PENDULUM, 1.0, drag=kp.Drag.from_half_life(5e3), checked=False)
    assert half["half_time"].value == pytest.approx(5e3)


def test_pushes_that_are_wrong_do_what_one_expects() -> None:
    def measured(name: str) -> float:
        check = MUSEUM[name].check
        assert check is not None
        return check.measured

    # b > 0: the ellipse turns by itself counter-clockwise, and the push turns it back.
    assert measured("turning_early") < 0 < measured("turning_late")
    assert measured("turning_strong") < 0
    assert measured("turning_weak") > 0
    assert measured("growth_weak") < 0 < measured("growth_strong")
    strong = MUSEUM["amplitude_strong"].value
    assert strong > 1 > MUSEUM["amplitude_weak"].value


def test_drive_that_takes_energy_away_and_one_that_never_ends() -> None:
    def amplitude(push: float) -> kp.DesignAnswer:
        found = kp.design(PENDULUM, 1.0, drag=kp.Drag(1e-4), drive=kp.Drive(push, phase=0.5),
                          checked=False)  # fmt: skip
        return found["amplitude_given"]

    assert amplitude(-1e-3).note == "the push takes energy away"
    assert amplitude(-1e-3).value == 0
    assert amplitude(1.0).note == "beyond the length: it pumps without end, and is not run"
    pumped = kp.design(PENDULUM, 1.0, drag=kp.Drag(1e-4), drive=kp.Drive(1.0, phase=0.5))
    assert pumped["growth_given"].check is None
    assert pumped["growth_best_push"].check is not None


def test_passage_of_a_plane_swing() -> None:
    # For small swings ρ = a sin ωt.
    found = kp.design(kp.Pendulum(20.0), 1e-3, radius=5e-4, time=0.3, checked=False)
    omega = math.sqrt(9.80665 / 20)
    assert found["passage_time"].value == pytest.approx(math.pi / 6 / omega)
    assert found["time_within"].value == pytest.approx(math.pi / 3 / omega)
    assert found["radius_at"].value == pytest.approx(1e-3 * math.sin(0.3 * omega))
    assert found["passage_speed"].value == pytest.approx(1e-3 * omega * math.sqrt(0.75), rel=1e-6)


def test_wire() -> None:
    pendulum = kp.Pendulum(10.0, 9.8, 50.0)
    found = kp.design(pendulum, 2.0, wire=kp.Wire(2e-3, 1.9e11, 1.1e-5), checked=False)
    cosine = math.sqrt(1 - 0.2**2)
    assert found["tension_least"].value == pytest.approx(490 * cosine)
    assert found["tension_largest"].value == pytest.approx(490 * (3 - 2 * cosine))
    area = math.pi * 1e-6
    assert found["stress"].value == pytest.approx(490 * (3 - 2 * cosine) / area)
    assert found["stretch_rest"].value == pytest.approx(490 * 10 / (1.9e11 * area))
    assert found["lengthening"].value == pytest.approx(1.1e-4)
    assert found["period_kelvin"].value == pytest.approx(5.5e-6)


def test_without_checks_nothing_is_run() -> None:
    found = kp.design(PENDULUM, 1.0, 0.005, site=SITE, drag=kp.Drag(1e-4), checked=False)
    assert all(answer.check is None for answer in found.answers)


def test_progress_counts_to_its_end() -> None:
    seen: list[tuple[int, int]] = []
    uneven = kp.Suspension(1e-6, 0.0, 1e-6, 0.0)
    kp.design(PENDULUM, 1.0, site=SITE, suspension=uneven,
              done=lambda k, n: seen.append((k, n)))  # fmt: skip
    assert [k for k, _ in seen] == list(range(1, len(seen) + 1))
    assert {n for _, n in seen} == {len(seen)}


def test_the_share_of_a_clamp_in_a_straight_swing_is_nothing() -> None:
    pendulum, site = kp.Pendulum(20.0, 9.81), kp.Site(math.radians(50.0))
    for axis in (0.3, 1.2, math.radians(30)):
        clamp = kp.Suspension(2e-6, axis, 0.0, axis)
        found = kp.design(pendulum, 1.0, site=site, suspension=clamp, checked=False)
        assert found["share_anisotropy"].value == 0.0
        wide = kp.design(pendulum, 1.0, 0.005, site=site, suspension=clamp, checked=False)
        assert abs(wide["share_anisotropy"].value) > 1e-10
