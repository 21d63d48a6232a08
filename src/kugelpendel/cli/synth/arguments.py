"""The arguments of ``kugelpendel synth``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.cli.options import a_path

if TYPE_CHECKING:
    import argparse

    from kugelpendel.cli.options import Commands


def add(commands: Commands) -> None:
    """Add the command."""
    commands.add_parser(
        "synth",
        help="make a track as a camera would have recorded it",
        description="Write the track of a job's pendulum with noise, gaps and outliers, as a "
        "camera or a sensor would have recorded it: to try `kugelpendel fit` on a known truth.",
        epilog='kugelpendel synth examples/laboratory.toml --duration "20 min" --noise "0.5 mm"',
        arguments=_arguments,
    )


def _arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", type=a_path, metavar="FILE.toml", help="the job; - reads standard input"
    )
    parser.add_argument(
        "--out",
        type=a_path,
        metavar="FILE.csv",
        help="(default: NAME-track.csv; - is standard output)",
    )
    parser.add_argument("--duration", metavar="TIME", help="(default: that of the job)")
    parser.add_argument("--rate", metavar="FPS", default="30", help="points a second (default: 30)")
    parser.add_argument("--noise", metavar="LENGTH", default="0", help="of each coordinate")
    parser.add_argument(
        "--colour", metavar="KIND", default="white",
        help="of the noise: white, slow, t3, or a number: how much a point keeps of the last",
    )  # fmt: skip
    parser.add_argument(
        "--noise-ratio", metavar="N", default="1", help="noise along x over that along y"
    )
    parser.add_argument(
        "--jitter", metavar="PERCENT", default="0", help="of the time of each point"
    )
    parser.add_argument(
        "--gap", metavar="START,LENGTH", action="append", default=[], help="may come several times"
    )
    parser.add_argument("--outliers", metavar="PERCENT", default="0", help="of the points")
    parser.add_argument(
        "--tilt", metavar="PERCENT", default="0", help="by which one scale is short"
    )
    parser.add_argument(
        "--tilt-axis", metavar="ANGLE", default="0", help="the azimuth of that scale"
    )
    parser.add_argument("--pixel", metavar="LENGTH", help="write whole pixels of that size")
    parser.add_argument(
        "--seed", metavar="N", default="0", help="the same one gives the same track (default: 0)"
    )
    parser.set_defaults(do=_synth, extra="fit")


def _synth(options: argparse.Namespace) -> int:
    from kugelpendel.cli.synth.command import synth

    return synth(options)
