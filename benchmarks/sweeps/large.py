"""Do 1e8 exact cases once, all values kept: ``python -m sweeps.large`` in the folder benchmarks."""

import time

import kugelpendel as kp
from kugelpendel.spelling import spell_bytes
from sweeps import HUNDRED_MILLION, exact, folder


def main() -> None:
    with folder() as path:
        began, used = time.perf_counter(), time.process_time()
        found = kp.sweep(exact(HUNDRED_MILLION), path)
        taken, used = time.perf_counter() - began, time.process_time() - used
        stored = sum(file.stat().st_size for file in path.rglob("*") if file.is_file())
        good = found.status.attrs["counts"][1]
    print(
        f"{good} good cases in {taken:.0f} s ({used:.0f} s of processor time), "
        f"{spell_bytes(stored)} stored"
    )


if __name__ == "__main__":
    main()
