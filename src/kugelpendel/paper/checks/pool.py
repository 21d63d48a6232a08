"""Work on many subjects in as many processes as there are processors."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from concurrent.futures import BrokenExecutor, ProcessPoolExecutor
from contextlib import suppress
from multiprocessing import active_children, get_context
from typing import TypeVar

Found = TypeVar("Found")
Progress = Callable[[int, int, Found], None]
"""Called after each subject with how many are done, of how many, and what was found."""


def one_by_one(
    find: Callable[[str], Found],
    labels: Sequence[str],
    progress: Progress[Found] | None = None,
    parallel: bool = True,
) -> list[Found]:
    """What is found for each label, in their order.

    Parameters
    ----------
    find
        What to do with a label; a function that another process can import.
    labels
        The subjects.
    progress
        Called after each of them, in their order.
    parallel
        In as many processes as there are processors; otherwise in this one.
    """
    found: list[Found] = []

    def note(one: Found) -> None:
        found.append(one)
        if progress is not None:
            progress(len(found), len(labels), one)

    workers = min(os.cpu_count() or 1, len(labels)) if parallel else 1
    if workers > 1:
        others = set(active_children())
        # spawn: a forked child of a process with threads (a progress bar's) may hang
        with (
            ProcessPoolExecutor(workers, mp_context=get_context("spawn")) as pool,
            suppress(BrokenExecutor),
        ):
            try:
                # Not by map, which cancels what is left: Python 3.11 trips over it in a broken pool
                for future in [pool.submit(find, label) for label in labels]:
                    note(future.result())
            except KeyboardInterrupt:
                # A proof lasts for seconds, and leaving the pool waits for those that are begun.
                for worker in set(active_children()) - others:
                    worker.terminate()
                raise
    # where no process can be started (a script read from standard input), this one goes on
    for label in labels[len(found) :]:
        note(find(label))
    return found
