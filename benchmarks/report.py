"""What a topic hands back, and how it is written: Markdown that also reads well on a terminal."""

from __future__ import annotations

import importlib.metadata
import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

PACKAGES = ("kugelpendel", "numpy", "scipy", "pandas", "heyoka", "mujoco", "python-flint")


@dataclass(frozen=True)
class Ratio:
    """``value`` must be at most (or at least) ``limit``; without a limit nothing is required.

    ``ours`` and ``peers`` are seconds, unless ``unit`` says something else.
    """

    work: str
    peer: str
    ours: float
    peers: float
    value: float
    limit: float | None = None
    at_least: bool = False
    unit: str = "s"

    @property
    def met(self) -> bool | None:
        if self.limit is None:
            return None
        return self.value >= self.limit if self.at_least else self.value <= self.limit

    def cells(self) -> tuple[str, ...]:
        bound = "-"
        if self.limit is not None:
            bound = ("≥ " if self.at_least else "≤ ") + f"{self.limit:g}"
        is_time = self.unit == "s"
        sense = "faster" if self.at_least else "of its time" if is_time else "of it"
        verdict = {True: "yes", False: "NO", None: "-"}[self.met]
        sizes = (
            duration(size) if is_time else f"{size:.3g} {self.unit}"
            for size in (self.ours, self.peers)
        )
        return (self.work, *sizes, self.peer, f"{self.value:.3g} × {sense}", bound, verdict)


RATIO_HEAD = ("work", "ours", "peer's", "peer", "ratio", "required", "met")


@dataclass(frozen=True)
class Table:
    """A caption, a head, and rows of finished strings."""

    caption: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Section:
    """Everything one topic found."""

    title: str
    ratios: Sequence[Ratio] = ()
    tables: Sequence[Table] = ()
    notes: Sequence[str] = field(default_factory=tuple)

    def text(self) -> str:
        parts = [f"## {self.title}"]
        if self.ratios:
            parts.append(grid(RATIO_HEAD, [ratio.cells() for ratio in self.ratios]))
        for table in self.tables:
            parts += [table.caption, grid(table.head, table.rows)]
        if self.notes:
            parts.append("\n".join(f"- {note}" for note in self.notes))
        return "\n\n".join(parts)


def duration(seconds: float) -> str:
    """Three digits and a unit."""
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds / 1e-9:.3g} ns"


def grid(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table with its columns lined up."""
    table = [list(head), *map(list, rows)]
    width = [max(map(len, column)) for column in zip(*table, strict=True)]
    lines = [
        "| " + " | ".join(cell.ljust(w) for cell, w in zip(row, width, strict=True)) + " |"
        for row in table
    ]
    lines.insert(1, "|" + "|".join("-" * (w + 2) for w in width) + "|")
    return "\n".join(lines)


def machine() -> str:
    """The processor, the system and the versions, in words."""
    info = Path("/proc/cpuinfo")
    model = platform.processor() or platform.machine()
    if info.is_file():
        names = [line for line in info.read_text().splitlines() if line.startswith("model name")]
        model = names[0].partition(":")[2].strip() if names else model
    versions = ", ".join(f"{name} {importlib.metadata.version(name)}" for name in PACKAGES)
    return (
        f"{model} ({platform.machine()}, {os.cpu_count()} cores, one thread used), "
        f"{platform.system()}, Python {platform.python_version()}, {versions}"
    )
