"""``kugelpendel fit --follow``: a line a swing, and a restart loses nothing."""

import csv
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from tests.cli.fit.test_fit import REAL
from tests.tracks.read.spellings import Spelling, spellings

import kugelpendel as kp
from kugelpendel.tracks.read import Appended

GROWING = (
    "comma",
    "clock across midnight",
    "German date and clock",
    "seconds since 1970",
    "frames",
)


@pytest.fixture(scope="module")
def rows() -> list[str]:
    track = kp.tracks.synthesise(REAL, 200.0, 12.0, noise=5e-4, seed=7)
    lines = [
        f"{t:.4f},{x:.6f},{y:.6f}\n" for t, x, y in zip(track.time, track.x, track.y, strict=True)
    ]
    return ["time (s),x (m),y (m)\n", *lines]


def swings(path: Path) -> np.ndarray:
    with path.open() as file:
        table = list(csv.reader(file))
    return np.array([[float(cell) for cell in row[:8]] for row in table[1:]])


def test_a_line_a_swing_and_nothing_lost(call, rows: list[str]) -> None:
    log = Path("log.csv")
    log.write_text("".join(rows))
    assert call("fit", log, "--follow", "--idle", "0", "--out", "whole").code == 0
    whole = swings(Path("whole/swings.csv"))
    period = 2 * np.pi * np.sqrt(1.5 / 9.80665)
    # Until 48 swings are there, the windows are shorter and so are not one a swing.
    told = whole[:, 0]
    steady = told > 45 * period
    assert np.diff(told).min() > 0.4 * period
    assert np.diff(told).max() < 4 * period
    assert np.allclose(np.diff(told[steady]), period, rtol=0.2)
    assert told[-1] > 200 - 6 * period
    b = kp.EnvelopeMotion(REAL.pendulum, REAL.launch, REAL.forces).semi_axes(told)[:, 1]
    assert (np.abs(whole[:, 2] - b) < 6 * whole[:, 5] + 1e-3 * np.abs(b)).mean() > 0.95

    # The same in pieces, with a line that is cut off as when the machine fails.
    cut = Path("cut.csv")
    for until in (1100, 1700, len(rows)):
        cut.write_text("".join(rows[:until]))
        assert call("fit", cut, "--follow", "--idle", "0", "--out", "cut").code == 0
        with Path("cut/swings.csv").open("a") as file:
            file.write("99.5,0.1")
    parts = Path("cut/swings.csv").read_text().splitlines()
    assert parts.pop() == "99.5,0.1"
    Path("cut/swings.csv").write_text("\n".join(parts) + "\n")
    pieces = swings(Path("cut/swings.csv"))
    assert np.diff(pieces[:, 0]).min() > 0.4 * period
    assert np.diff(pieces[:, 0]).max() < 4 * period
    assert abs(len(pieces) - len(whole)) <= 4


def test_lines_of_another_file_are_kept(call, rows: list[str]) -> None:
    for name in ("one.csv", "other.csv"):
        Path(name).write_text("".join(rows[:800]))
    assert call("fit", "one.csv", "--follow", "--idle", "0", "--out", "o").code == 0
    outcome = call("fit", "other.csv", "--follow", "--idle", "0", "--out", "o")
    assert outcome.code == 2
    assert "choose another folder with --out" in outcome.err


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "interrupted; {} swings are in {}, and the same command goes on from there."),
        ("de", "abgebrochen; {} Schwingungen stehen in {}, und derselbe Befehl macht dort weiter."),
    ],
)
def test_interrupted_it_says_what_is_kept_and_goes_on_from_there(
    call, tmp_path: Path, rows: list[str], language: str, said: str
) -> None:
    log, folder = tmp_path / "log.csv", tmp_path / "o"
    log.write_text("".join(rows[:1500]))
    command = [sys.executable, "-m", "kugelpendel", "fit", log, "--follow", "--out", folder]
    command += ["--lang", language]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as process:
        assert process.stdout is not None
        for _ in range(4):  # the head, and three swings
            assert process.stdout.readline()
        process.send_signal(signal.SIGINT)
        _, err = process.communicate(timeout=60)
    assert process.returncode == 130
    before = (folder / "swings.csv").read_text()
    count = len(swings(folder / "swings.csv"))
    assert count >= 3
    assert before.endswith("\n")
    assert err == f"kugelpendel: {said.format(count, folder / 'swings.csv')}\n"
    assert {path.name for path in folder.iterdir()} == {"swings.csv", "follow.json"}

    log.write_text("".join(rows))
    assert call("fit", log, "--follow", "--idle", "0", "--out", folder).code == 0
    assert (folder / "swings.csv").read_text().startswith(before)
    assert call("fit", log, "--follow", "--idle", "0", "--out", tmp_path / "whole").code == 0
    found, whole = swings(folder / "swings.csv"), swings(tmp_path / "whole" / "swings.csv")
    period = 2 * np.pi * np.sqrt(1.5 / 9.80665)
    assert np.diff(found[:, 0]).min() > 0.4 * period
    assert np.diff(found[:, 0]).max() < 4 * period
    assert found[-1, 0] == pytest.approx(whole[-1, 0], abs=2 * period)
    assert abs(len(found) - len(whole)) <= 4


def test_lines_that_no_follow_has_made_are_kept(call, rows: list[str]) -> None:
    log = Path("log.csv")
    log.write_text("".join(rows[:800]))
    Path("o").mkdir()
    Path("o/swings.csv").write_text("mine\n")
    outcome = call("fit", log, "--follow", "--idle", "0", "--out", "o")
    assert outcome.code == 2
    assert "o has swings.csv already, which no --follow of this file has made" in outcome.err
    assert Path("o/swings.csv").read_text() == "mine\n"
    assert [path.name for path in Path("o").iterdir()] == ["swings.csv"]


def test_a_place_that_cannot_be_read_is_refused(call, rows: list[str]) -> None:
    log = Path("log.csv")
    log.write_text("".join(rows[:800]))
    assert call("fit", log, "--follow", "--idle", "0", "--out", "o").code == 0
    before = Path("o/swings.csv").read_text()
    Path("o/follow.json").write_text('{"file": ')
    outcome = call("fit", log, "--follow", "--idle", "0", "--out", "o")
    assert outcome.code == 2
    assert "follow.json cannot be read: " in outcome.err
    assert "choose another folder with --out." in outcome.err
    assert Path("o/swings.csv").read_text() == before


@pytest.mark.parametrize("name", GROWING)
def test_a_growing_file_gives_the_rows_of_the_whole(name: str, tmp_path: Path) -> None:
    one: Spelling = next(one for one in spellings() if one.name == name)
    path = tmp_path / "log.csv"
    path.write_bytes(b"")
    lines = one.content.splitlines(keepends=True)
    appended, found = Appended(path, one.options), []
    for start in range(0, len(lines), 11):
        piece = b"".join(lines[start : start + 11])
        for part in (piece[:-3], piece[-3:]):  # a line may be written in two parts
            with path.open("ab") as file:
                file.write(part)
            if (more := appended.more()) is not None:
                found.append(more)
        if start == 220:  # a restart
            appended = Appended(path, one.options, appended.place)
    whole = kp.tracks.read(path, **one.options)
    assert isinstance(whole, kp.tracks.Track)
    assert len(found) > 10
    assert np.allclose(np.concatenate([one.time for one in found]), whole.time, atol=1e-9, rtol=0)
    assert np.array_equal(np.concatenate([one.x for one in found]), whole.x)


def test_a_file_that_shrinks_is_another(tmp_path: Path, rows: list[str]) -> None:
    path = tmp_path / "log.csv"
    path.write_text("".join(rows))
    appended = Appended(path, {})
    assert appended.more() is not None
    assert appended.more() is None
    path.write_text("".join(rows[:50]))
    with pytest.raises(kp.InvalidInput, match="shorter than it was"):
        appended.more()


def test_rows_without_times_cannot_be_followed(tmp_path: Path, rows: list[str]) -> None:
    path = tmp_path / "log.csv"
    path.write_text("".join(row.split(",", 1)[1] for row in rows))
    with pytest.raises(kp.InvalidInput, match="cannot be followed"):
        Appended(path, {"rate": 12.0}).more()
