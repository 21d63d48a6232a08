"""Nine files of one motion as they come in the world, where ../shared has them."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import kugelpendel as kp

pytestmark = pytest.mark.shared

TRACKS: dict[str, tuple[dict[str, Any], float, float]] = {
    "01_semicolon_decimal_comma_bom_crlf.csv": ({}, 1e-3, 0.4),
    "02_phyphox_like.csv": ({}, 1e-3, 0.4),
    "04_tracker_tab_mass_name.txt": ({}, 1e-3, 0.4),
    "06_units_row_and_comments.csv": ({}, 1.0, 0.4),
    "08_epoch_ms_frames_dropped_and_doubled.csv": ({}, 1.0, 0.4),
    "09_missing_written_as_text.csv": ({"y_down": True}, 1.0, 0.4),
    "15_frame_number_only_no_time.csv": ({"rate": 30}, 1.0, 0.4),
    "19_trk_minimal.trk": ({}, 1 / 800, 0.4 - np.radians(1.5)),
}
"""Options, the unit of the track that is read, and the azimuth at its first row."""


@pytest.mark.parametrize("name", TRACKS)
def test_track(name: str, shared: Path) -> None:
    options, unit, azimuth = TRACKS[name]
    track = kp.tracks.read(shared / "data/formats" / name, **options)
    assert isinstance(track, kp.tracks.Track)
    turn = np.exp(2j * np.pi / 2.8 * track.time)
    basis = np.column_stack((turn, 1 / turn, np.ones(len(track))))
    ahead, behind, _ = np.linalg.lstsq(basis, track.x + 1j * track.y, rcond=None)[0]
    a, b = abs(ahead) + abs(behind), abs(ahead) - abs(behind)
    assert a == pytest.approx(300 * unit, rel=2e-3)
    assert b == pytest.approx(8 * unit, abs=0.3 * unit)
    assert np.angle(ahead * behind) / 2 == pytest.approx(azimuth, abs=2e-3)
    assert (track.axes == "phone") is (name == "02_phyphox_like.csv")


def test_frames_without_a_rate(shared: Path) -> None:
    with pytest.raises(kp.InvalidInput, match="frames a second"):
        kp.tracks.read(shared / "data/formats/15_frame_number_only_no_time.csv")


def test_table_of_ellipses(shared: Path) -> None:
    table = kp.tracks.read(shared / "data/formats/18_ellipse_table_axial_wrap.csv")
    assert isinstance(table, kp.tracks.EllipseTable)
    assert table.time[-1] == 179 * 60
    assert np.allclose(np.degrees(table.azimuth), 80 + 0.3 * np.arange(180), atol=1e-3)
    assert table.b[-1] == pytest.approx(-0.486)


def test_real_tracks(shared: Path) -> None:
    (path,) = (shared / "data/florence").glob("2021*.csv")
    track = kp.tracks.read(path)
    assert isinstance(track, kp.tracks.Track)
    assert len(track) > 12_500
    (path,) = (shared / "data/engbrecht").glob("*.csv")
    table = kp.tracks.read(path)
    assert isinstance(table, kp.tracks.EllipseTable)
    assert len(table) > 2_900
