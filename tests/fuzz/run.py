"""The long fuzz: ``make fuzz``. Ends with exit code 1 if anything was dealt with wrongly.

python -m tests.fuzz.run [--seed N] [--files N] [--processes N] [--calls N] [--kills N] [--write]
"""

import argparse
import sys
from datetime import date
from importlib.metadata import version
from pathlib import Path

from tests.fuzz.calls import call_faults
from tests.fuzz.in_process import all_faults
from tests.fuzz.processes import kill_faults, process_faults

from kugelpendel.cli.terminal.progress import Progress

SHOWN = 20
TABLE = Path(__file__).with_name("result.md")


def main() -> int:
    """Run all four kinds and print every fault with what leads to it."""
    parser = argparse.ArgumentParser(description="Hand spoilt input to every door.")
    parser.add_argument("--seed", type=int, default=20261126)
    parser.add_argument("--files", type=int, default=10_000, help="in this process")
    parser.add_argument("--processes", type=int, default=300, help="files in processes")
    parser.add_argument("--calls", type=int, default=5000, help="calls from Python")
    parser.add_argument("--kills", type=int, default=40, help="of a job that runs")
    parser.add_argument("--write", action="store_true", help=f"the table into {TABLE.name}")
    options = parser.parse_args()
    files, seed = options.files, options.seed
    found: dict[str, tuple[int, list[str]]] = {}
    with Progress("Files", files) as progress:
        spoilt = all_faults(files, seed, lambda: progress.advance(1))
    said = [f"{command}: {wrong}\n{data!r}" for command, data, wrong in spoilt]
    found["files in one process"] = files, said
    with Progress("Processes", options.processes) as progress:
        spoilt = process_faults(options.processes, seed + 1, lambda: progress.advance(1))
    said = [f"process {command}: {wrong}\n{data!r}" for command, data, wrong in spoilt]
    found["files in processes of their own"] = options.processes, said
    with Progress("Calls", options.calls) as progress:
        said = call_faults(options.calls, seed + 2, lambda: progress.advance(1))
    found["calls from Python"] = options.calls, said
    with Progress("Kills", options.kills) as progress:
        said = kill_faults(options.kills, seed + 3, lambda: progress.advance(1))
    found["kills of a job that runs"] = options.kills, said
    faults = [fault for _, some in found.values() for fault in some]
    for one in faults[:SHOWN]:
        print(f"\n{one}")
    text = table(seed, {kind: (count, len(some)) for kind, (count, some) in found.items()})
    print(f"\n{text}", end="")
    if options.write:
        TABLE.write_text(text, encoding="utf-8")
    return 1 if faults else 0


def table(seed: int, found: dict[str, tuple[int, int]]) -> str:
    """How many there were of each kind and how many were dealt with wrongly, in Markdown."""
    lines = [
        f"kugelpendel {version('kugelpendel')}, {date.today().isoformat()}, seed {seed}: "
        f"`make fuzz FUZZ=--write`",
        "",
        "| what | how many | faults |",
        "| --- | --- | --- |",
        *(f"| {kind} | {count} | {faults} |" for kind, (count, faults) in found.items()),
    ]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    sys.exit(main())
