"""The progress bar: only on a terminal, only when it takes long, never on stdout."""

import io

import pytest

from kugelpendel.cli.terminal import progress


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


@pytest.mark.parametrize(
    ("stream", "patience", "drawn"),
    [(Terminal, 0.0, True), (Terminal, 60.0, False), (io.StringIO, 0.0, False)],
)
def test_bar(
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    stream: type[io.StringIO],
    patience: float,
    drawn: bool,
) -> None:
    err = stream()
    monkeypatch.setattr("sys.stderr", err)
    monkeypatch.setattr(progress, "_PATIENCE", patience)
    with progress.Progress("Writing", 10) as bar:
        for _ in range(10):
            bar.advance(1)
    assert ("Writing" in err.getvalue()) is drawn
    assert capsys.readouterr().out == ""
