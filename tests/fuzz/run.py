"""The long fuzz: ``make fuzz``. Ends with exit code 1 if anything was dealt with wrongly.

python -m tests.fuzz.run [--seed N] [--files N] [--processes N] [--calls N] [--kills N]
"""

import argparse
import sys

from tests.fuzz.calls import call_faults
from tests.fuzz.in_process import all_faults
from tests.fuzz.processes import kill_faults, process_faults

from kugelpendel.cli.terminal.progress import Progress

SHOWN = 20


def main() -> int:
    """Run all four kinds and print every fault with what leads to it."""
    parser = argparse.ArgumentParser(description="Hand spoilt input to every door.")
    parser.add_argument("--seed", type=int, default=20261126)
    parser.add_argument("--files", type=int, default=10_000, help="in this process")
    parser.add_argument("--processes", type=int, default=300, help="files in processes")
    parser.add_argument("--calls", type=int, default=5000, help="calls from Python")
    parser.add_argument("--kills", type=int, default=40, help="of a job that runs")
    options = parser.parse_args()
    faults: list[str] = []
    with Progress("Files", options.files) as progress:
        found = all_faults(options.files, options.seed, lambda: progress.advance(1))
        faults += [f"{command}: {wrong}\n{data!r}" for command, data, wrong in found]
    with Progress("Processes", options.processes) as progress:
        found = process_faults(options.processes, options.seed + 1, lambda: progress.advance(1))
        faults += [f"process {command}: {wrong}\n{data!r}" for command, data, wrong in found]
    with Progress("Calls", options.calls) as progress:
        faults += call_faults(options.calls, options.seed + 2, lambda: progress.advance(1))
    with Progress("Kills", options.kills) as progress:
        faults += kill_faults(options.kills, options.seed + 3, lambda: progress.advance(1))
    for one in faults[:SHOWN]:
        print(f"\n{one}")
    print(
        f"\nSeed {options.seed}: {options.files} files, {options.processes} processes, "
        f"{options.calls} calls, {options.kills} kills: {len(faults)} faults."
    )
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
