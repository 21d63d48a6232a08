"""What is derived from other numbers: its bad cases are told by what was given."""

import pickle

import numpy as np
import pytest

import kugelpendel as kp

PENDULUM = kp.Pendulum(1.0)
LAUNCH = kp.Launch.ellipse(0.1, 0.0)
BOBS = kp.Bob([0.03, 0.03, 0.03], [7860.0, 0.5, 7860.0])

BAD = [
    ({"drag": kp.Drag.from_half_life([60.0, 0.0, 60.0])}, "The half life must be positive"),
    ({"drag": kp.Drag.from_quality([9.0, -1.0, 9.0], PENDULUM)}, "The quality factor must be"),
    (
        {"suspension": kp.Suspension.from_periods([2.0, 2.0, 2.0], [2.000001, 0.0, 2.0])},
        "The period across the axis must be positive",
    ),
    ({"drag": kp.Drag.from_bob(BOBS, PENDULUM)}, "air"),
]


@pytest.mark.filterwarnings("ignore:On swings as wide:UserWarning")
@pytest.mark.parametrize(("forces", "said"), BAD, ids=[said for _, said in BAD])
@pytest.mark.parametrize("make", [kp.RealMotion, kp.EnvelopeMotion])
def test_a_bad_case_is_told_by_what_was_given(make, forces, said: str) -> None:
    motion = make(PENDULUM, LAUNCH, **forces)
    assert list(motion.problems) == [1]
    assert (motion.status != 0).tolist() == [False, True, False]
    assert np.isnan(motion.position(1.0)).any(axis=-1).tolist() == [False, True, False]
    assert said in motion.reason[1]
    assert "drag must" not in motion.reason[1]
    # Elsewhere in a larger ensemble, the case is the same.
    spread = make(kp.Pendulum([[1.0], [1.1]]), LAUNCH, **forces)
    assert (1, 1) in spread.problems
    assert said in spread.reason[1, 1]


def test_a_pickle_still_tells_what_was_given() -> None:
    drag = pickle.loads(pickle.dumps(kp.Drag.from_half_life([60.0, 0.0])))
    assert drag == kp.Drag.from_half_life([60.0, float("nan")])
    with pytest.raises(kp.InvalidInput):
        kp.Drag.from_half_life(0.0)


def test_a_bad_number_that_was_given_is_told_itself() -> None:
    motion = kp.RealMotion(PENDULUM, LAUNCH, drag=kp.Drag([1e-3, -1.0]))
    assert motion.reason[1].startswith("The linear drag must be finite and not negative")
