"""The motion as a labelled data set."""

import numpy as np
import pytest

from kugelpendel import ExactMotion, InvalidInput, Launch, Pendulum

TIMES = np.linspace(0.0, 3.0, 5)


def test_single_motion() -> None:
    motion = ExactMotion(Pendulum(1.0, mass=2.0), Launch.apsides(0.2, 0.05))
    data = motion.to_xarray(TIMES)
    assert data["position"].dims == data["velocity"].dims == ("time", "component")
    assert data["tension"].dims == ("time",)
    np.testing.assert_array_equal(data["position"], motion.position(TIMES))
    np.testing.assert_array_equal(data["velocity"], motion.velocity(TIMES))
    np.testing.assert_array_equal(data["tension"], motion.tension(TIMES))
    np.testing.assert_array_equal(data["time"], TIMES)
    assert data["component"].values.tolist() == ["x", "y", "z"]
    units = {str(name): variable.attrs["units"] for name, variable in data.data_vars.items()}
    assert units == {"position": "m", "velocity": "m/s", "tension": "N"}
    assert data["time"].attrs["units"] == "s"
    assert "z down from the support" in data.attrs["axes"]


def test_ensemble() -> None:
    pendulum = Pendulum(np.array([[0.9], [1.7], [67.0]]))
    motion = ExactMotion(pendulum, Launch.apsides([0.1, 0.2], 0.05))
    data = motion.to_xarray(TIMES)
    assert data["position"].dims == ("case_0", "case_1", "time", "component")
    assert dict(data.sizes) == {"case_0": 3, "case_1": 2, "time": 5, "component": 3}
    np.testing.assert_array_equal(data["tension"], motion.tension(TIMES))


def test_times_as_a_list() -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.at_rest(1.0))
    assert motion.to_xarray([0, 1, 2]).sizes["time"] == 3
    assert motion.to_xarray([]).sizes["time"] == 0


@pytest.mark.parametrize(("times", "shape"), [(0.0, r"\(\)"), (np.zeros((2, 2)), r"\(2, 2\)")])
def test_times_on_no_axis_or_on_two(times: object, shape: str) -> None:
    motion = ExactMotion(Pendulum(1.0), Launch.at_rest(1.0))
    with pytest.raises(InvalidInput, match=f"times on one axis, but theirs are {shape}"):
        motion.to_xarray(times)  # pyright: ignore[reportArgumentType]
