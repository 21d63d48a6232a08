"""How long a job takes, said before it is waited for, and whether the user wants to stop it."""

from __future__ import annotations

import signal
import sys
import time
from types import FrameType
from typing import TYPE_CHECKING, Any, Literal

from kugelpendel.spelling import spell

if TYPE_CHECKING:
    from types import TracebackType

    from kugelpendel.errors import Language

_WORTH_SAYING = 10.0
"""s; jobs that are over sooner say nothing."""

_TRIAL = 0.5
"""s of work, by which the rest is judged."""

_SIGNALS = (signal.SIGINT, signal.SIGTERM)

CtrlC = Literal["leaves", "keeps"]
"""Whether Ctrl-C leaves everything as it was, or keeps what is done."""

_SENTENCES: dict[Language, dict[CtrlC, str]] = {
    "en": {
        "leaves": "this takes about {}; Ctrl-C leaves everything as it was.",
        "keeps": "this takes about {}; Ctrl-C keeps what is done.",
    },
    "de": {
        "leaves": "das dauert etwa {}; Strg-C lässt alles, wie es war.",
        "keeps": "das dauert etwa {}; Strg-C behält, was fertig ist.",
    },
}


class TimeEstimate:
    """Says once on stderr how long the whole will take, when that is long.

    The clock begins with the first piece done: before it, whatever is needed had to be imported.

    Parameters
    ----------
    total
        How much work there is, in any unit.
    ctrl_c
        What Ctrl-C does.
    language
        In which it is said.
    """

    def __init__(self, total: float, ctrl_c: CtrlC, language: Language = "en") -> None:
        self._total = total
        self._sentence = _SENTENCES[language][ctrl_c]
        self._language: Language = language
        self._first: tuple[float, float] | None = None
        self._said = False

    def after(self, done: float) -> None:
        """Judge by the work that is done."""
        now = time.monotonic()
        if self._first is None:
            self._first = (now, done)
        started, before = self._first
        taken = now - started
        if self._said or taken < _TRIAL or done <= before:
            return
        self._said = True
        whole = taken * self._total / (done - before)
        if whole > _WORTH_SAYING:
            whole_time = spell(whole, "s", 2, language=self._language)
            print(f"kugelpendel: {self._sentence.format(whole_time)}", file=sys.stderr)


class StopRequest:
    """Whether the user has asked to stop: by Ctrl-C, or by the signal that ends a program.

    Within the block the first such signal only sets ``stop``, so that nothing is torn apart in the
    middle of a row; a second one interrupts at once.
    """

    def __init__(self) -> None:
        self.stop = False
        self._before: dict[int, Any] = {}

    def __enter__(self) -> StopRequest:
        try:
            for number in _SIGNALS:
                self._before[number] = signal.signal(number, self._ask)
        except ValueError:  # not in the main thread, where no signal arrives
            pass
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _ask(self, number: int, frame: FrameType | None) -> None:
        if self.stop:
            raise KeyboardInterrupt
        self.stop = True
