"""The arguments of ``kugelpendel fit``."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from kugelpendel.cli.options import a_folder, a_path

if TYPE_CHECKING:
    from kugelpendel.cli.options import Commands

_EPILOG = """\
A track is a file of times and positions: text in columns, whatever its separator, decimal mark and
units; a project of Tracker (.trk); an export of a phone's sensors; Parquet; or a table of ready
ellipses. Columns are found by their names. Whatever was changed, dropped or assumed is listed.

  kugelpendel fit track.csv --scale "1.25 mm" --y-down --length "2.40 m" --latitude "47.4 N"
  kugelpendel fit film.trk --lang de --out report
  kugelpendel fit log.csv --follow --scale "0.5 mm"
  kugelpendel fit --plan --length "3 m" --a "15 cm" --b "1 cm" --noise "0.5 mm" --rate 30
"""


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "fit",
        help="find the pendulum in a recorded track",
        description="Print the ellipse of a recorded swing, what turns and what brakes it, with\n"
        "errors and what they assume, and write a report, figures and the numbers.",
        epilog=_EPILOG,
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("track", nargs="?", type=a_path, metavar="TRACK", help="the recording")
    reading = parser.add_argument_group("what the file holds")
    reading.add_argument(
        "--columns",
        metavar="time=T,x=X,y=Y",
        help="which column is what, by name or number; also date, frame, a, b, azimuth",
    )
    reading.add_argument("--mass", metavar="NAME", help="which mass, where the file has several")
    reading.add_argument("--rate", metavar="FPS", help="frames a second, where it has no times")
    reading.add_argument(
        "--scale", metavar="LENGTH", help='of one unit of the file, such as "1.25 mm" a pixel'
    )
    upward = reading.add_mutually_exclusive_group()
    upward.add_argument("--y-down", action="store_true", help="y points downward, as in images")
    upward.add_argument("--y-up", action="store_true", help="y points upward, seen from above")
    pendulum = parser.add_argument_group("what is known of the pendulum")
    pendulum.add_argument("--length", metavar="LENGTH", help="(default: from the frequency)")
    pendulum.add_argument(
        "--gravity", metavar="ACCEL", help="(default: of the latitude, or 9.80665)"
    )
    pendulum.add_argument(
        "--latitude", metavar="ANGLE", help='to compare the turning with, such as "47.4 N"'
    )
    pendulum.add_argument(
        "--damping-unevenness",
        metavar="PERCENT",
        default="10",
        help="by how much the damping may differ along its two axes (default: 10)",
    )
    pendulum.add_argument(
        "--tilt",
        metavar="PERCENT",
        default="2",
        help="by how much the scales of the picture may differ (default: 2)",
    )
    pendulum.add_argument(
        "--swings", metavar="N", default="8", help="swings in a window (default: 8)"
    )
    other = parser.add_argument_group("something else")
    other.add_argument(
        "--follow", action="store_true", help="a line each swing, as a logger appends to the file"
    )
    other.add_argument(
        "--idle", metavar="TIME", help="--follow: leave when nothing came for so long"
    )
    other.add_argument(
        "--plan", action="store_true", help="how long to record, before there is a track"
    )
    other.add_argument("--a", metavar="LENGTH", help="--plan: half the length of the swing")
    other.add_argument("--b", metavar="LENGTH", help="--plan: half its width")
    other.add_argument("--noise", metavar="LENGTH", help="--plan: of one position")
    other.add_argument("--half-life", metavar="TIME", help="--plan: of the amplitude")
    parser.add_argument(
        "--out", type=a_folder, metavar="DIR", help="folder for the files (default: out/NAME)"
    )
    parser.add_argument("--lang", metavar="de|en", help="language (default: that of the locale)")
    parser.add_argument(
        "--json", action="store_true", help="print the results as JSON, and nothing else, on stdout"
    )
    parser.set_defaults(do=_fit, extra="fit")


def _fit(options: argparse.Namespace) -> int:
    from kugelpendel.cli.fit.command import fit

    return fit(options)
