"""Two recordings that the project does not contain: Florence, and Engbrecht's fifty hours."""

import csv
import datetime
from pathlib import Path

import numpy as np
import pytest

import kugelpendel as kp

pytestmark = pytest.mark.shared


@pytest.fixture(scope="module")
def florence(shared: Path) -> kp.tracks.Track:
    """In metres by the corners of the base plate, 640 × 638 mm; y of the image points down."""
    folder = shared / "data" / "florence"
    time, x, y = np.loadtxt(
        folder / "2021_09_17_14_57_N.csv", delimiter=";", skiprows=1, unpack=True
    )
    first, second, third, fourth = np.loadtxt(folder / "calibration.txt", delimiter=";")
    across = np.mean([np.linalg.norm(second - first), np.linalg.norm(fourth - third)])
    down = np.mean([np.linalg.norm(third - first), np.linalg.norm(fourth - second)])
    return kp.tracks.Track(time - time[0], 0.640 / across * x, -0.638 / down * y)


def test_florence(florence: kp.tracks.Track) -> None:
    ellipses = kp.tracks.ellipses(florence, swings=10.0)
    fit = kp.tracks.fit(ellipses, gravity=9.805)
    measured = fit.models["measured"]
    rest = np.degrees(np.sqrt(np.mean(measured.residual_azimuth**2)))
    assert rest <= 0.013
    kappa = measured.parameters["intrinsic"]
    assert kappa.value == pytest.approx(0.22, abs=0.011)
    assert 0.1 < kappa.low < kappa.high < 0.375  # significant, and not 3/8
    for model in ("uneven", "tilted", "headline"):
        assert fit.models[model].parameters["rotation"].verdict == "not determined", model
    assert fit.misfit.is_misfit
    assert fit.period is not None
    assert fit.period.slope.value == pytest.approx(0.3, abs=0.02)
    assert fit.period.theory == -1 / 16
    assert fit.stiffening is not None
    assert not fit.stiffening.agree  # in sign as a support that stiffens, in size not
    assert fit.stiffening.from_intrinsic.value > 0
    assert fit.stiffening.from_period.value > 0


def test_engbrecht(shared: Path) -> None:
    path = shared / "data" / "engbrecht" / "run_2025-05-17_19.csv"
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    clock = np.array(
        [
            datetime.datetime.fromisoformat(f"{row['date_recorded']}T{row['time_recorded']}")
            for row in rows
        ]
    )
    time = np.array([(one - clock[0]).total_seconds() for one in clock])
    keep = np.concatenate([[True], np.diff(time) > 0])
    names = ("semi_major_axis", "semi_minor_axis", "rotation_angle_deg")
    a, b, angle = (np.array([float(row[name]) for row in rows])[keep] for name in names)
    table = kp.tracks.tabulated(time[keep], a, b, np.radians(angle), unit="px")
    fit = kp.tracks.fit(table, length=4.0, models=("measured",))
    wobble = fit.wobble
    assert wobble is not None
    hourly = np.degrees(3600)
    assert wobble.rate * hourly == pytest.approx(9.73, abs=0.05)
    assert wobble.rate_stderr * hourly == pytest.approx(0.2, abs=0.05)
    assert 8 < wobble.rate_stderr / wobble.naive_stderr < 14
    assert 0.2 < wobble.explained_2 < 0.5
    assert wobble.explained_4 == pytest.approx(0.64, abs=0.02)
