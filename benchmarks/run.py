"""Measure every ratio against the peers in one run.

python benchmarks/run.py [--only TOPIC ...] [--write FILE]
"""

from __future__ import annotations

import argparse
import datetime
import importlib
import os
import sys
import time
from pathlib import Path

TOPICS = (
    "sampling", "scattered", "ensembles", "real", "walk", "envelope", "ladder", "series", "peers",
    "startup", "tracks", "explorer", "sweeps",
)  # fmt: skip
THREADS = (
    "RAYON_NUM_THREADS",
    "OMP_NUM_THREADS",
    "OPENBLAS_NUM_THREADS",
    "MKL_NUM_THREADS",
    "VECLIB_MAXIMUM_THREADS",
)


def main() -> int:
    parser = argparse.ArgumentParser(description="Measure every ratio against the peers.")
    parser.add_argument("--only", choices=TOPICS, nargs="+", default=TOPICS, metavar="TOPIC")
    parser.add_argument("--write", type=Path, metavar="FILE", help="also write the report here")
    options = parser.parse_args()

    # The libraries read these when they are imported: that is why the topics are imported late.
    os.environ.update(dict.fromkeys(THREADS, "1"))
    sections = []
    for topic in options.only:
        start = time.perf_counter()
        sections.append(importlib.import_module(topic).measure())
        print(sections[-1].text(), flush=True)
        print(f"\n({topic}: {time.perf_counter() - start:.0f} s)\n", flush=True)

    report = importlib.import_module("report")
    required = [ratio for s in sections for ratio in s.ratios if ratio.limit is not None]
    missed = [ratio for ratio in required if not ratio.met]
    verdict = f"{len(required) - len(missed)} of {len(required)} requirements met."
    print(verdict)
    for ratio in missed:
        print("not met: " + ", ".join(ratio.cells()))
    if options.write:
        head = [
            "# Speed and accuracy beside the peers",
            f"Written by `make bench` on {datetime.datetime.now(datetime.UTC):%Y-%m-%d}; "
            "edit nothing here, run it again.",
            f"Machine: {report.machine()}.",
            "Every ratio comes from paired runs in one process: the contenders take turns, the "
            "times are medians, the ratio is the median of the ratios of each round. Only "
            f"ratios carry over to another machine. {verdict}",
        ]
        options.write.parent.mkdir(parents=True, exist_ok=True)
        options.write.write_text("\n\n".join([*head, *(s.text() for s in sections)]) + "\n")
        print(f"written: {options.write}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
