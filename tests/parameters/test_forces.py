"""Everything that acts, as one object."""

import copy
import inspect
import math
import pickle
from dataclasses import FrozenInstanceError, fields
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp
from kugelpendel.cli.job_file import schema
from kugelpendel.parameters import FORCE_PARTS, ActedOn, ForceParts

PARTS: dict[str, Any] = {
    "site": kp.Site(0.85),
    "drag": kp.Drag(1e-5, 1e-3),
    "suspension": kp.Suspension(1e-6, 0.2),
    "bob": kp.Bob(0.1, 7860.0),
    "drive": kp.Drive(1e-3, radius=0.2),
}
ALL: Any = kp.Forces(**PARTS)
SEVERAL = [
    kp.Forces(),
    *(kp.Forces(**{name: part}) for name, part in PARTS.items()),
    ALL,
    kp.Forces(drag=kp.Drag([1e-5, 2e-5])),
]
PENDULUM: Any = kp.Pendulum(20.0, 9.81)
LAUNCH: Any = kp.Launch.ellipse(1.0, 0.0)
NO: Any = kp  # so that a checker of types lets what is wrong pass


def test_equality_hash_and_pickle() -> None:
    for i, one in enumerate(SEVERAL):
        for again in (copy.copy(one), copy.deepcopy(one), pickle.loads(pickle.dumps(one))):
            assert again == one
            assert hash(again) == hash(one)
            assert repr(again) == repr(one)
        assert [other == one for other in SEVERAL] == [i == k for k in range(len(SEVERAL))]
    assert len({*SEVERAL, *SEVERAL}) == len(SEVERAL)


def test_representation_has_units_and_is_short() -> None:
    drag = kp.Forces(drag=kp.Drag(1e-5), site=kp.Site(0.5))
    assert repr(drag) == "Forces(site=Site(latitude=0.5 rad, height=0 m), drag=Drag(linear=1e-05 " \
                         "1/s, quadratic=0 1/m))"  # fmt: skip
    assert all(len(repr(one)) <= 200 for one in SEVERAL)
    many = np.linspace(1e-5, 2e-5, 10_000)
    said = repr(kp.Suspension(many, many, many[:, np.newaxis], many))
    assert said.startswith("Suspension(anisotropy=[1e-05 … 2e-05: 10000] rad/s, axis=[")
    assert len(said) <= 200


def test_frozen() -> None:
    with pytest.raises(FrozenInstanceError):
        ALL.drag = None  # pyright: ignore[reportAttributeAccessIssue]


def test_parts_are_those_that_are_there() -> None:
    assert kp.Forces().parts == {}
    assert list(ALL.parts) == ["site", "drag", "suspension", "bob", "drive"]
    assert ALL.drag == PARTS["drag"]


def test_shapes_broadcast() -> None:
    forces = kp.Forces(drag=kp.Drag([1e-5, 2e-5]), site=kp.Site([[0.1], [0.2], [0.3]]))
    assert forces.shape == (3, 2)
    with pytest.raises(kp.InvalidInput, match=r"what was given .*: Site \(2,\), Drag \(3,\); give"):
        kp.Forces(drag=kp.Drag([1e-5, 2e-5, 0.0]), site=kp.Site([0.1, 0.2]))
    with pytest.raises(kp.InvalidInput, match=r"Pendulum \(\), Launch \(3,\), Drag \(2,\); give"):
        kp.RealMotion(
            PENDULUM, kp.Launch.ellipse([1.0, 2.0, 3.0], 0), kp.Forces(drag=kp.Drag([0, 0]))
        )


def test_whether_anything_acts() -> None:
    assert not kp.Forces().acts
    assert not kp.Forces(drag=kp.Drag(), suspension=kp.Suspension(axis=0.3)).acts
    assert not kp.Forces(bob=PARTS["bob"], drive=kp.Drive(0.0, phase=0.0)).acts
    for name in ("site", "drag", "suspension", "drive"):
        assert kp.Forces(**{name: PARTS[name]}).acts
    assert kp.Forces(site=kp.Site(0.0)).acts  # the ground tilts under a pendulum on the equator
    assert kp.Forces(drag=kp.Drag([0.0, 1e-5])).acts


def test_effective_pendulum() -> None:
    assert kp.Forces().effective_pendulum(PENDULUM) is PENDULUM
    factor = float(PARTS["bob"].gravity_factor(20.0))
    effective = ALL.effective_pendulum(PENDULUM)
    assert effective.length == 20.0
    assert effective.gravity == pytest.approx(9.81 * factor, rel=1e-15)
    # The weight stays.
    assert float(effective.gravity) * float(effective.mass) == pytest.approx(9.81, rel=1e-15)
    with pytest.raises(kp.InvalidInput, match="bob's radius must be less than the length"):
        ALL.effective_pendulum(kp.Pendulum(0.05))
    several = ALL.effective_pendulum(kp.Pendulum([0.05, 20.0], 9.81))
    assert np.isnan(np.asarray(several.gravity)).tolist() == [True, False]


@pytest.mark.parametrize("motion", [kp.RealMotion, kp.EnvelopeMotion])
def test_one_object_is_as_good_as_its_parts(motion: Any) -> None:
    one, other = motion(PENDULUM, LAUNCH, ALL), motion(PENDULUM, LAUNCH, **PARTS)
    assert one.forces == other.forces == ALL
    assert (one.site, one.drag, one.drive) == (ALL.site, ALL.drag, ALL.drive)
    np.testing.assert_array_equal(one.position(3.0), other.position(3.0))
    assert motion(PENDULUM, LAUNCH, drag=None).forces == kp.Forces()
    again = pickle.loads(pickle.dumps(one))
    assert again.forces == ALL
    np.testing.assert_array_equal(again.position(3.0), one.position(3.0))


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: NO.Forces(drag=1e-5), r"drag must be a kugelpendel.Drag, but it is 1e-05 of type "
                                       r"float; write drag=kp.Drag\(…\)"),
        (lambda: NO.Forces(drag=kp.Site(0.5)), "drag must be a kugelpendel.Drag, but it is Site"),
        (lambda: NO.RealMotion(PENDULUM, LAUNCH, kp.Drag(1e-5)), "forces must be a kugelpendel.F"),
        (lambda: NO.RealMotion(PENDULUM, LAUNCH, ALL, drag=kp.Drag()), r"given twice, .*\(drag\)"),
        (lambda: NO.RealMotion(PENDULUM, LAUNCH, wind=kp.Drag()), "RealMotion takes no wind; what "
                                                               "can act on a pendulum is site, dr"),
        (lambda: NO.RealMotion(LAUNCH, PENDULUM), "pendulum of RealMotion must be a kugelpendel.P"),
        (lambda: NO.ExactMotion(LAUNCH, PENDULUM), r"The pendulum of ExactMotion must be a "
                                                   r"kugelpendel.Pendulum, but it is Launch.*; the "
                                                   r"pendulum comes first: kp.ExactMotion\(kp.Pen"),
        (lambda: NO.ExactMotion(0.3, 0.1), "The pendulum of ExactMotion must be .*, but it is 0.3 "
                                           r"of type float; write kp.ExactMotion\(kp.Pendulum"),
        (lambda: NO.ExactMotion(PENDULUM, 0.1), "The launch of ExactMotion must be .* it is 0.1"),
        (lambda: NO.EnvelopeMotion(PENDULUM, None), "launch of EnvelopeMotion must be a"),
        (lambda: NO.LinearMotion(LAUNCH, PENDULUM), "pendulum comes first"),
        (lambda: NO.design(1.0, 0.1), r"^The pendulum must be .* 1.0 of type float; write kp.Pen"),
        (lambda: NO.Drag.from_quality(800, 1.0), "^The pendulum must be a kugelpendel.Pendulum, b"),
        (lambda: NO.Drag.from_bob(PENDULUM, PENDULUM), "^The bob must be a kugelpendel.Bob, but"),
        (lambda: NO.RealMotion(PENDULUM, LAUNCH, thread=["rod"]), r"thread must be .* \['rod'\]"),
        (lambda: NO.RealMotion(PENDULUM, LAUNCH).events(np.array(["outer"]), 0, 1), "event must b"),
        (lambda: NO.series.radius(0.1, np.array(["radii"])), "variables of the series must be"),
    ],
)  # fmt: skip
def test_what_is_of_another_type(call: Any, said: str) -> None:
    with pytest.raises(kp.InvalidInput, match=said):
        call()


def test_a_bad_case_of_a_part_is_kept() -> None:
    drag = kp.Drag([1e-5, -1.0, math.nan])
    np.testing.assert_array_equal(drag.linear, [1e-5, -1.0, math.nan])
    assert drag == kp.Drag([1e-5, -1.0, math.nan])
    assert np.isnan(np.asarray(kp.Drag.from_half_life([60.0, -1.0]).linear)).tolist() == [0, 1]
    assert np.isnan(np.asarray(kp.Site([0.5, 48.0]).gravity)).tolist() == [0, 1]
    assert np.isnan(np.asarray(kp.Bob([0.1, -0.1], 8e3).mass)).tolist() == [0, 1]
    assert np.isnan(np.asarray(kp.Bob(1.0, 8e3).gravity_factor([2.0, 0.5]))).tolist() == [0, 1]
    assert np.isnan(np.asarray(kp.Suspension.from_periods([8.0, 0.0], 8.0).anisotropy))[1]


def test_parts_are_listed_once_and_known_everywhere() -> None:
    names = list(FORCE_PARTS)
    assert names == [field.name for field in fields(kp.Forces)]
    assert names == list(ForceParts.__annotations__)
    assert names == [name for name, it in vars(ActedOn).items() if name in names and it is not None]
    assert names == [section.name for section in schema.FORCES]
    for name, part in FORCE_PARTS.items():
        assert part.part == name
        assert getattr(kp, part.__name__) is part
        assert set(part.strengths) <= {*part.units, "rotation"}
        for key in schema.JOB.section(name).keys:
            argument = inspect.signature(part).parameters.get(key.name)
            if argument is not None and key.default is not None:
                assert argument.default == key.default, (name, key.name)
