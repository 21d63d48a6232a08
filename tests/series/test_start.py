"""A motion alone does not pay for the series."""

import subprocess
import sys


def test_fractions_are_loaded_with_the_first_series() -> None:
    script = (
        "import sys, kugelpendel as kp; kp.ExactMotion; kp.SeriesMotion; "
        "loaded = 'fractions' in sys.modules; kp.series.frequency(2); "
        "print(loaded, 'fractions' in sys.modules)"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["False", "True"]
