"""What `kp.design` refuses, each with a sentence."""

import math
from typing import Any

import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(20.0, 9.81)

REFUSED: list[tuple[dict[str, Any], str]] = [
    ({"a": 0.0}, "amplitude a must lie between 0 and the length 20 m, but it is 0 m; count it ho"),
    ({"a": -1.0}, "amplitude a must lie between .* -1 m"),
    ({"a": 20.0}, "amplitude a must lie between .* 20 m; "),
    ({"a": math.nan}, "amplitude a must lie between .* nan m"),
    ({"a": [1.0, 2.0]}, r"amplitude a must be one number in m, but it is \[1.0, 2.0\]"),
    ({"a": "1 m"}, "amplitude a must be a number .* in m"),
    ({"b": 0.6}, "b = 0.6 m must not exceed half the amplitude, a = 1 m: .* use kp.RealMotion"),
    ({"b": math.nan}, "b = nan m must not exceed"),
    ({"azimuth": math.inf}, "azimuth must be finite, but it is inf rad"),
    ({"share": 0.0}, "share of the Foucault rate must lie between 0 and 1, but it is 0; 1 % is"),
    ({"share": 5.0}, "share of the Foucault rate must lie between 0 and 1, but it is 5"),
    ({"after": 0.0}, "time after which the amplitude is asked must be positive .* 0 s"),
    ({"after": math.inf}, "time after which .* inf s"),
    ({"radius": 1.5}, r"radius to pass must lie between \|b\| = 0 m and a = 1 m, but it is 1.5 m"),
    ({"b": 0.1, "radius": 0.05}, r"radius to pass must lie between \|b\| = 0.1 m and a = 1 m"),
    ({"time": -1.0}, "time after the closest approach must be finite and not negative, .* -1 s"),
    ({"time": math.nan}, "time after the closest approach .* nan s"),
    ({"site": kp.Site(0.8, 9.82)}, "site's gravity is 9.82 m/s², the pendulum's is 9.81 m/s²; giv"),
    ({"site": kp.Site([0.8, 0.9])}, r"for one pendulum, but the site has the shape \(2,\); ask fo"),
    ({"drag": kp.Drag([0.0, 1e-4])}, "but the drag has the shape"),
    ({"wire": kp.Wire([1e-3, 2e-3])}, "but the wire has the shape"),
    ({"drag": kp.Drag(1.0)}, "drag takes 1 1/s, more than 0.05 of the swing's 0.7004 rad/s: avera"),
    ({"drag": kp.Drag(0.0, 1.0)}, "drag takes 0.297.* 1/s, more than 0.05"),
    ({"suspension": kp.Suspension(-0.1)}, "anisotropy is 0.1 rad/s, more than .* kp.RealMotion"),
    ({"suspension": kp.Suspension(0, 0, 0.1)}, "damping anisotropy is 0.1 1/s, more than 0.05"),
    ({"bob": kp.Bob(25.0, 8e3)}, "radius must be less than the length"),
]


@pytest.mark.parametrize(("changes", "said"), REFUSED, ids=[said for _, said in REFUSED])
def test_refused(changes: dict[str, Any], said: str) -> None:
    arguments: dict[str, Any] = {"a": 1.0, **changes}
    with pytest.raises(kp.InvalidInput, match=said):
        kp.design(PENDULUM, **arguments)


def test_ensemble_of_pendulums() -> None:
    with pytest.raises(kp.InvalidInput, match=r"but the pendulum has the shape \(2,\)"):
        kp.design(kp.Pendulum([1.0, 2.0]), 0.1)
