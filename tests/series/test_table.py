"""The shipped table is what its generator writes."""

import json
import subprocess
import sys
from importlib.resources import files
from pathlib import Path

import kugelpendel as kp
from kugelpendel.series import _table

WRITE = "import sys; from references.series import text; sys.stdout.write(text())"


def test_generator_writes_what_is_shipped(repository: Path) -> None:
    shipped = json.loads(files(kp.series).joinpath(_table.FILE).read_text(encoding="utf-8"))
    done = subprocess.run(
        [sys.executable, "-X", "utf8", "-c", WRITE],
        cwd=repository, capture_output=True, text=True, check=True, encoding="utf-8",
    )  # fmt: skip
    again = json.loads(done.stdout)
    assert again["series"] == shipped["series"]
    # Rounded to seven digits, of which a different mathematical library may change the last.
    for ours, theirs in zip(again["radius"], shipped["radius"], strict=True):
        assert abs(ours - theirs) < 1.5e-7
