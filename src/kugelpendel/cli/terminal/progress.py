"""What is shown of work that takes longer than a person waits without wondering."""

from __future__ import annotations

import sys
import time
from typing import TYPE_CHECKING

from kugelpendel.cli.terminal.estimate import TimeEstimate

if TYPE_CHECKING:
    from types import TracebackType

    import rich.progress

    from kugelpendel.cli.terminal.estimate import CtrlC
    from kugelpendel.errors import Language

_PATIENCE = 1.0  # s


class Progress:
    """Counts work done; says how long the whole will take, and draws a bar.

    Both on stderr: the bar once the work has taken a second, and only on a terminal.

    Parameters
    ----------
    title
        What is being done.
    total
        How much work there is, in the units of `advance`.
    ctrl_c
        What Ctrl-C does, said beside the estimate; None where the work was announced before.
    language
        In which the estimate is said; that of the title.
    """

    def __init__(
        self,
        title: str,
        total: float,
        ctrl_c: CtrlC | None = "leaves",
        language: Language = "en",
    ) -> None:
        self._title = title
        self._total = total
        self._done = 0.0
        self._estimate = None if ctrl_c is None else TimeEstimate(total, ctrl_c, language)
        self._started = time.monotonic()
        self._bar: rich.progress.Progress | None = None

    def __enter__(self) -> Progress:
        return self

    def advance(self, amount: float, note: str = "") -> None:
        """Count work as done; a note stands behind the bar."""
        self._done += amount
        if self._estimate is not None:
            self._estimate.after(self._done)
        if self._bar is None and self._is_due():
            self._bar = self._draw()
        if self._bar is not None:
            self._bar.update(self._bar.task_ids[0], completed=self._done, note=note)

    def reach(self, taken: int, steps: int) -> None:
        """Count as much work as done as so many of so many steps are of all of it."""
        self.advance(self._total * taken / steps - self._done)

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def _is_due(self) -> bool:
        late = time.monotonic() - self._started > _PATIENCE
        return late and self._done < self._total and sys.stderr.isatty()

    def _draw(self) -> rich.progress.Progress:
        from rich.console import Console
        from rich.progress import BarColumn, TaskProgressColumn, TextColumn, TimeRemainingColumn
        from rich.progress import Progress as Bar

        columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn())
        last = (TimeRemainingColumn(), TextColumn("{task.fields[note]}"))
        bar = Bar(*columns, *last, console=Console(file=sys.stderr), transient=True)
        task = bar.add_task(self._title, total=self._total, note="")
        bar.update(task, completed=self._done)
        bar.start()
        return bar
