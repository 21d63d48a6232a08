"""An estimate is said once, where the whole takes long, with what Ctrl-C does."""

import pytest

from kugelpendel.cli.terminal import estimate
from kugelpendel.cli.terminal.estimate import CtrlC, TimeEstimate
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.errors import Language


@pytest.mark.parametrize(
    ("at", "done", "said"),
    [
        (0.4, 0.001, ""),  # too early to judge by
        (1.0, 0.5, ""),  # over in 2 s
        (1.0, 0.0, ""),
        (1.0, 0.01, "this takes about 100 s; Ctrl-C leaves everything as it was."),
    ],
)
def test_long_work_is_announced(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    at: float, done: float, said: str,
) -> None:  # fmt: skip
    now = [100.0]
    monkeypatch.setattr(estimate.time, "monotonic", lambda: now[0])
    waiting = TimeEstimate(1.0, "leaves")
    waiting.after(0.0)
    now[0] += at
    waiting.after(done)
    waiting.after(done)
    err = capsys.readouterr().err
    assert err == (f"kugelpendel: {said}\n" if said else "")


@pytest.mark.parametrize(
    ("ctrl_c", "language", "said"),
    [
        ("leaves", "de", "das dauert etwa 101 s; Strg-C lässt alles, wie es war."),
        ("keeps", "de", "das dauert etwa 101 s; Strg-C behält, was fertig ist."),
        ("keeps", "en", "this takes about 101 s; Ctrl-C keeps what is done."),
    ],
)
def test_it_is_said_in_the_language_of_the_command(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str],
    ctrl_c: CtrlC, language: Language, said: str,
) -> None:  # fmt: skip
    now = [100.0]
    monkeypatch.setattr(estimate.time, "monotonic", lambda: now[0])
    with Progress("Auswertung", 1.0, ctrl_c, language) as progress:
        progress.advance(0.0)
        now[0] += 1.01
        progress.advance(0.01)
    assert capsys.readouterr().err == f"kugelpendel: {said}\n"
