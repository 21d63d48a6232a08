"""How long a user waits before anything happens: import, --help, and the main job."""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path

from report import Ratio, Section, Table, duration
from timing import paired

PYTHON = sys.executable
COMMAND = str(Path(sys.executable).with_name("kugelpendel"))
EXAMPLES = Path(__file__).parent.parent / "examples"
ROUNDS = 15


def call(*words: str) -> None:
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)


def measure() -> Section:
    contenders = {
        "import": lambda: call(PYTHON, "-c", "import kugelpendel as kp; kp.ExactMotion"),
        "numpy": lambda: call(PYTHON, "-c", "import numpy"),
        "help": lambda: call(COMMAND, "--help"),
        "pass": lambda: call(PYTHON, "-c", "pass"),
    }
    timings = paired(contenders, ROUNDS)

    def ratio(work: str, peer: str, ours: str, theirs: str, limit: float) -> Ratio:
        seconds = timings.seconds(ours), timings.seconds(theirs)
        return Ratio(work, peer, *seconds, timings.ratio(ours, theirs), limit)

    ratios = (
        ratio("import kugelpendel, with ExactMotion", "import numpy", "import", "numpy", 1.5),
        ratio("kugelpendel --help", "python -c pass", "help", "pass", 6.0),
    )
    with tempfile.TemporaryDirectory() as folder:
        jobs = {
            path.stem: lambda path=path: call(
                COMMAND, "run", str(path), "--out", str(Path(folder, path.stem))
            )
            for path in sorted(EXAMPLES.glob("*.toml"))
        }
        answers = paired(jobs, rounds=3)
    rows = [(name, duration(answers.seconds(name))) for name in jobs]
    table = Table("The main job, `kugelpendel run`, on every example:", ("example", "time"), rows)
    notes = ("Times of whole processes, from start to end.",)
    return Section("Start-up and the main job", ratios, (table,), notes)
