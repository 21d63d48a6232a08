"""What a motion keeps of its pendulum and launch, through copies and pickles."""

import copy
import pickle

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from kugelpendel import ExactMotion, Launch, Pendulum

SINGLE = ExactMotion(Pendulum(2.0), Launch.apsides(0.5, 0.2, 0.7))
ENSEMBLE = ExactMotion(Pendulum([2.0, -1.0]), Launch.apsides([[0.5], [0.4]], 0.2))


@pytest.mark.parametrize("motion", [SINGLE, ENSEMBLE], ids=["single", "ensemble"])
def test_copies_and_pickles_move_alike(motion: ExactMotion) -> None:
    times = np.linspace(-1, 1, 5)
    for again in (copy.copy(motion), copy.deepcopy(motion), pickle.loads(pickle.dumps(motion))):
        assert again.pendulum == motion.pendulum
        assert again.launch == motion.launch
        assert_array_equal(again.position(times), motion.position(times))
        assert_array_equal(again.reason, motion.reason)


def test_shape_and_span_cannot_be_set() -> None:
    for name in ("pendulum", "launch", "shape", "span", "goes_slack"):
        with pytest.raises(AttributeError):
            setattr(SINGLE, name, None)
