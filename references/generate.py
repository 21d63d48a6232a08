"""Write ``tests/reference/ideal.json``: ``python -m references.generate`` from the root of the repository.

Needs python-flint only. ``--check ID …`` computes the named cases again and compares them with the stored file instead
of writing; ``--golden FILE`` compares the method with another file of the same format.
"""

import argparse
import json
import sys
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from flint import arb

from . import fixed
from .edges import edges
from .launch import Case, is_plane
from .limits import picked
from .motion import Result, solve
from .regimes import drawn
from .spread import spread
from .stored import ABOUT, entry, write
from .verify import AGREEMENT, again, elementary, straight

FILE = Path(__file__).parents[1] / "tests" / "reference" / "ideal.json"


def cases() -> Iterator[tuple[str, Case]]:
    """All cases with their names: regime and number within it. Every fourth is integrated straight for 40 periods."""
    count: Counter[str] = Counter()
    for source in (drawn(), picked(), edges()):
        for case in source:
            if case.motion == "general" and is_plane(case.kind, case.state):
                raise ValueError(f"{case.regime}-{count[case.regime]} has no angular momentum; mark it as plane")
            number = count[case.regime]
            if number % 4 == 0 and case.regime != "fast-spin":
                case = replace(case, check=max(case.check, 40.0))
            yield f"{case.regime}-{number}", case
            count[case.regime] += 1


def generate(chosen: list[str] | None) -> list[dict[str, object]]:
    """Compute and verify all cases (or the chosen ones); a disagreement stops everything."""
    entries: list[dict[str, object]] = []
    worst = {"second": 0.0, "straight": 0.0, "elementary": 0.0}
    seconds = {"motion": 0.0, "second": 0.0, "straight": 0.0, "spread": 0.0}
    for name, case in cases():
        if chosen and name not in chosen:
            continue
        clock = [time.perf_counter()]
        result = solve(case)
        clock.append(time.perf_counter())
        found = {"second": again(case, result)}
        clock.append(time.perf_counter())
        found["straight"], reached = straight(case, result)
        found["elementary"] = elementary(case, result)
        clock.append(time.perf_counter())
        if max(found.values()) > AGREEMENT:
            raise ArithmeticError(f"{name}: differences {found} exceed {AGREEMENT}")
        entries.append(entry(name, case, result, spread(case), reached))
        clock.append(time.perf_counter())
        worst = {key: max(worst[key], found[key]) for key in worst}
        for n, key in enumerate(seconds):
            seconds[key] += clock[n + 1] - clock[n]
        print(f"{name:28} {clock[-1] - clock[0]:7.2f} s  {found}", file=sys.stderr, flush=True)
    print(f"{len(entries)} cases; largest differences {worst}; seconds {seconds}")
    return entries


def compare(stored: list[dict[str, object]], kind: str) -> float:
    """Largest difference of stored numbers from ones computed now: relative, positions relative to the length."""
    worst = 0.0
    for old in stored:
        case = _case(old)
        new = solve(case)
        worst = max(worst, difference(old, new))
        print(f"{old['id']:28} {difference(old, new):.1e}")
    print(f"{len(stored)} {kind} cases, largest difference {worst:.1e}")
    return worst


def difference(old: dict[str, object], new: Result) -> float:
    """Largest difference of one stored case from a result."""
    length, speed = new.start.length, new.start.length * new.start.angular_frequency
    worst = 0.0
    for key, unit, axes in (("position", length, slice(0, 3)), ("velocity", speed, slice(3, 6))):
        for texts, state in zip(old[key], new.states, strict=True):  # type: ignore[call-overload]
            for text, number in zip(texts, state[axes], strict=True):
                worst = max(worst, float(abs(arb(text) / unit - fixed.to_arb(number, new.bits))))
    for key, value in (
        ("frequency", new.frequency),
        ("precession", new.precession),
        ("radial_period", new.radial_period),
        ("energy_above_bottom", new.start.energy),
        ("angular_momentum", new.start.angular_momentum),
    ):
        text = old[key]
        if (text is None) != (value is None):
            raise ValueError(f"{old['id']}: {key} is {text}, now {value}")
        if value is None or text == "inf":
            continue
        scale = abs(arb(text)) if float(text) else arb(1)  # type: ignore[arg-type]
        worst = max(worst, float(abs(arb(text) - value) / scale))
    return worst


def _case(old: dict[str, object]) -> Case:
    kind, state = str(old["kind"]), tuple(old["state"])  # type: ignore[arg-type]
    motion = str(old.get("motion") or ("plane" if is_plane(kind, state) else "general"))
    return Case(str(old["regime"]), old["length"], old["gravity"], kind, state, tuple(old["times"]), motion)  # type: ignore[arg-type]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", nargs="+", metavar="ID", help="compute only these, and print instead of writing")
    parser.add_argument("--subset", type=int, default=1, metavar="N", help="every Nth case of each regime only")
    parser.add_argument("--check", nargs="+", metavar="ID", help="compare these cases of the stored file")
    parser.add_argument("--golden", type=Path, metavar="FILE", help="compare all cases of another file")
    choice = parser.parse_args()
    if choice.check:
        stored = [c for c in json.loads(FILE.read_text())["cases"] if c["id"] in choice.check]
        return 0 if len(stored) == len(choice.check) and compare(stored, "stored") < 1e-23 else 1
    if choice.golden:
        return 0 if compare(json.loads(choice.golden.read_text())["cases"], "golden") < 1e-23 else 1
    chosen = choice.only
    if choice.subset > 1:
        chosen = [name for name, _ in cases() if int(name.rsplit("-", 1)[1]) % choice.subset == 0]
    entries = generate(chosen)
    if not choice.only:
        write(FILE, ABOUT, entries)
        print(f"{FILE.name}: {FILE.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
