"""``kugelpendel sweep``: all cases of a file, and what they come to."""

from __future__ import annotations

import time
from contextlib import contextmanager, nullcontext
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

import kugelpendel as kp
from kugelpendel.cli.sweep.sweep_file import read_sweep_file
from kugelpendel.cli.sweep.words import WORDS
from kugelpendel.cli.terminal.interrupted import Interrupted
from kugelpendel.cli.terminal.language import known_language
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import complain, write_json
from kugelpendel.spelling import grouped, significant
from kugelpendel.sweeps import chunk_for, kept_store, progressed

if TYPE_CHECKING:
    import argparse
    from collections.abc import Generator
    from contextlib import AbstractContextManager

    from xarray import Dataset

    from kugelpendel.cli.sweep.sweep_file import SweepFile
    from kugelpendel.errors import Language
    from kugelpendel.sweeps import SweepStore

RESULTS = "results.json"
MOST_WORKERS = 4096


def sweep(options: argparse.Namespace) -> None:
    """Do what the options ask.

    Raises
    ------
    InvalidInput
        Anything wrong with the options, the file or the folder. Nothing is left half-written.
    KugelpendelError
        The disk is full, or no worker is left: what is done is kept.
    """
    language = known_language(options.lang)
    workers = _workers(options.workers)
    asked = read_sweep_file(options.file)
    folder: Path = options.out if options.out is not None else Path("out") / asked.file.stem
    engine = _engine(workers, options.scheduler)
    out = "" if options.out is None else f" --out {options.out}"
    spec = asked.sweep
    with (
        kept_store(folder.absolute(), spec, lambda: chunk_for(spec)) as store,
        engine as client,
        _told(store, asked, folder, out, language) as progress,
    ):
        for _ in progressed(store, client, progress):
            pass
    _answer(asked, store, folder, options.json, language)


def _engine(workers: int | None, address: str | None) -> AbstractContextManager[Any]:
    """Whoever does the chunks: a client of Dask, or nobody else."""
    if workers is None and address is None:
        return nullcontext()
    from kugelpendel.sweeps import _cluster as cluster

    return cluster.local_workers(workers) if workers else cluster.workers_of(str(address))


def _workers(text: str | None) -> int | None:
    if text is None:
        return None
    if not (text.isascii() and text.isdigit() and 1 <= int(text) <= MOST_WORKERS):
        raise kp.InvalidInput.of("sweep_workers", seen=repr(text), most=MOST_WORKERS)
    return int(text)


class _Told:
    """Shows how far a sweep has come, how fast it goes, and how many cases are bad."""

    def __init__(self, bar: Progress, language: Language) -> None:
        self.done = 0
        self._bar = bar
        self._language: Language = language
        self._first: tuple[float, int] | None = None

    def __call__(self, done: int, size: int, bad: int) -> None:
        now = time.monotonic()
        if self._first is None:
            self._first = (now, done)
        started, before = self._first
        words = WORDS[self._language]
        rate = (done - before) / max(now - started, 1e-3)
        note = words["rate"].format(rate=significant(rate, 3, language=self._language))
        if bad:
            note = f"{note}, {words['bad'].format(bad=grouped(bad))}"
        self._bar.advance(done - self.done, note)
        self.done = done


@contextmanager
def _told(
    store: SweepStore, asked: SweepFile, folder: Path, out: str, language: Language
) -> Generator[_Told]:
    """Lend what is told of each chunk; an interruption says what is kept and how it goes on."""
    words = WORDS[language]
    size = asked.sweep.size
    begun = int(store.done().sum())
    if 0 < begun < store.chunks:
        done = min(begun * store.chunk_size, size)
        complain(words["resumed"].format(done=grouped(done), size=grouped(size)))
    with Progress(words["title"], size, ctrl_c="keeps", language=language) as bar:
        told = _Told(bar, language)
        try:
            yield told
        except KeyboardInterrupt:
            raise Interrupted(
                words["kept"].format(
                    done=grouped(told.done),
                    size=grouped(size),
                    folder=folder,
                    file=asked.file,
                    out=out,
                )
            ) from None


def _answer(
    asked: SweepFile, store: SweepStore, folder: Path, as_json_only: bool, language: Language
) -> None:
    """Write figures and results, and print what was found."""
    from kugelpendel import plot
    from kugelpendel.cli.output import staged
    from kugelpendel.cli.sweep.as_json import as_json
    from kugelpendel.cli.sweep.figures import figures
    from kugelpendel.cli.sweep.report import report
    from kugelpendel.sweeps import dataset_of

    found: Dataset = dataset_of(store)
    results = as_json(asked.sweep, found)
    drawn: dict[str, bytes] = {}
    for name, figure in figures(asked.sweep, found, language).items():
        plot.save(figure, file := BytesIO())
        drawn[f"{name}.png"] = file.getvalue()
    with staged(folder, (*drawn, RESULTS)) as temporary:
        for name, content in drawn.items():
            (temporary / name).write_bytes(content)
        (temporary / RESULTS).write_text(results, encoding="utf-8")
    if as_json_only:
        write_json(results)
        return
    print(report(asked.sweep, found, language))
    files = ", ".join(("sweep.zarr", *drawn, RESULTS))
    print(f"\n{WORDS[language]['files'].format(folder=folder, files=files)}")
