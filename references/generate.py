"""Write the reference motions: ``python -m references.generate``, from the repository's root.

Needs python-flint only. ``--check ID …`` computes the named cases again and compares them with the
stored file instead of writing; ``--against FILE`` compares with all cases of another file.
"""

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

from references.cases.edges import edges
from references.cases.limits import picked
from references.cases.regimes import drawn
from references.compare import compare
from references.launch import Case, is_plane
from references.motion import solve
from references.spread import spread
from references.stored import ABOUT, entry, write
from references.verify import AGREEMENT, again, elementary, straight

FILE = Path(__file__).parents[1] / "tests" / "reference" / "ideal.json"
SAME = 1e-24


def cases() -> Iterator[tuple[str, Case]]:
    """All cases with their names: regime and number within it.

    Every fourth is integrated straight through for 40 small-oscillation periods as a check.
    """
    count: Counter[str] = Counter()
    for source in (drawn(), picked(), edges()):
        for case in source:
            number = count[case.regime]
            name = f"{case.regime}-{number}"
            if case.motion == "general" and is_plane(case.kind, case.state):
                raise ValueError(f"{name} has no angular momentum; mark its motion as plane")
            if number % 4 == 0 and case.regime != "fast-spin":
                case = replace(case, check=max(case.check, 40.0))
            yield name, case
            count[case.regime] += 1


def generate(step: int) -> list[dict[str, Any]]:
    """Compute and verify every ``step``-th case of each regime; a disagreement stops everything."""
    entries: list[dict[str, Any]] = []
    worst = {"second": 0.0, "straight": 0.0, "elementary": 0.0}
    begin = time.perf_counter()
    for name, case in cases():
        if int(name.rsplit("-", 1)[1]) % step:
            continue
        clock = time.perf_counter()
        result = solve(case)
        found = {"second": again(case, result), "elementary": elementary(case, result)}
        found["straight"], reached = straight(case, result)
        if max(found.values()) > AGREEMENT:
            raise ArithmeticError(f"{name}: differences {found} exceed {AGREEMENT}")
        entries.append(entry(name, case, result, spread(case), reached))
        worst = {key: max(worst[key], found[key]) for key in worst}
        figures = ", ".join(f"{key} {value:.1e}" for key, value in found.items())
        print(f"{name:28} {time.perf_counter() - clock:7.2f} s  {figures}", flush=True)
    figures = ", ".join(f"{key} {value:.1e}" for key, value in worst.items())
    print(f"{len(entries)} cases in {time.perf_counter() - begin:.0f} s; largest differences:")
    print(figures)
    return entries


def main() -> int:
    """Exit code 0 when all agrees."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--step", type=int, default=1, help="only every Nth case (of each regime)")
    parser.add_argument("--check", nargs="+", metavar="ID", help="compare these stored cases")
    parser.add_argument("--against", type=Path, metavar="FILE", help="compare another file's cases")
    choice = parser.parse_args()
    if choice.check:
        stored = {case["id"]: case for case in json.loads(FILE.read_text())["cases"]}
        return 0 if compare([stored[name] for name in choice.check]) <= SAME else 1
    if choice.against:
        others = json.loads(choice.against.read_text())["cases"]
        return 0 if compare(others[:: choice.step]) <= SAME else 1
    entries = generate(choice.step)
    write(FILE, ABOUT, entries)
    print(f"{FILE.name}: {FILE.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
