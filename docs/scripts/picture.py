"""Draw the picture of the README: ``python docs/scripts/picture.py docs/laboratory.svg``."""

import re
import sys
from pathlib import Path

import kugelpendel as kp
from kugelpendel import plot

LAUNCH = kp.Launch.apsides(a=0.20, b=0.10)
DURATION = 21.0  # s; 10 swings, in which the ellipse turns by 29°


def draw(path: Path) -> None:
    """Write the pendulum of examples/laboratory.toml, trimmed for the repository."""
    motion = kp.ExactMotion(kp.Pendulum(length=1.0), LAUNCH)
    approximate = float(kp.olsson.precession(0.20, 0.10, 1.0, 9.80665))
    figure = plot.overview(
        motion, DURATION, approximate, "A pendulum of 1 m with turning radii 20 cm and 10 cm"
    )
    plot.save(figure, path)
    text = re.sub(r"\n +", "\n", path.read_text(encoding="utf-8"))
    path.write_text(re.sub(r' d="[^"]*"', _rounded, text), encoding="utf-8")


def _rounded(outline: re.Match[str]) -> str:
    lines = re.sub(r" \nL ", " ", outline[0])  # what follows M without a letter is a line
    return re.sub(r"\d+\.\d+", lambda number: f"{float(number[0]):.1f}", lines)


if __name__ == "__main__":
    draw(Path(sys.argv[1]))
