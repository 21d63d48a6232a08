"""Arguments, and what becomes of an error: a sentence on stderr and exit code 2."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from collections.abc import Sequence
    from types import FrameType

_BAD_INPUT = 2
_INTERRUPTED = 130

_EPILOG = """\
A job file looks like this; quantities have a unit or are plain SI numbers. For a real pendulum
there are [site], [drag], [suspension], [bob] and [drive] too: see examples/pantheon-day.toml.

  [pendulum]
  length = "67 m"
  mass = "28 kg"

  [launch]
  kind = "ellipse"      # or apsides, plane, angles, state, at_rest
  a = "3 m"
  b = "1 cm"

  [output]
  duration = "1 h"
  step = "0.1 s"        # or samples = 36001
"""

_DESIGN_EPILOG = """\
A file looks like this; all tables but the first two may be left out:

  [pendulum]
  length = "20 m"
  mass = "60 kg"

  [swing]
  a = "1 m"
  b = "5 mm"

  [site]
  latitude = "50 deg"

  [drag]
  half_life = "3 h"     # or linear, quality, from_bob; quadratic

  [suspension]
  anisotropy = "1e-6 rad/s"   # or period_along, period_across; axis

  [bob]
  diameter = "24 cm"
  density = "7860 kg/m^3"

  [drive]
  push = "1 mm/s"
  radius = "10 cm"      # or phase

  [wire]
  diameter = "1.5 mm"

  [questions]
  share = 0.01          # of the Foucault rate
  after = "1 h"
  radius = "20 cm"
  time = "0.5 s"
"""

_DERIVE: dict[str, Any] = {
    "description": "The derivation of the precession, from Newton's law on, with every step.",
    "epilog": "kugelpendel derive --format html writes the page to read or print.",
}


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line.

    Parameters
    ----------
    arguments : sequence of str, optional
        ``sys.argv`` without the program, unless given.

    Returns
    -------
    int
        Exit code: 0, 1 when a proof fails, 2 for bad input (with a sentence on stderr), 130 when
        interrupted.
    """
    parser = _parser()
    given = parser.parse_args(arguments)
    if given.version:
        from importlib.metadata import version

        print(f"kugelpendel {version('kugelpendel')}")
        return 0
    if given.command is None:
        parser.print_help(sys.stderr)
        return _BAD_INPUT
    try:
        before = signal.signal(signal.SIGTERM, _interrupt)
    except ValueError:  # not in the main thread
        return _run(given)
    try:
        return _run(given)
    finally:
        signal.signal(signal.SIGTERM, before)


def _run(given: argparse.Namespace) -> int:
    try:
        from kugelpendel import KugelpendelError
    except ImportError as missing:
        return _refuse(_not_installed(missing, given.command))
    code = 0
    try:
        code = _COMMANDS[given.command](given)
        sys.stdout.flush()
    except KugelpendelError as error:
        return _refuse(error.sentence(door="file"))
    except ImportError as missing:
        return _refuse(_not_installed(missing, given.command))
    except KeyboardInterrupt as interruption:
        kept = str(interruption) or "interrupted; no file is left half-written."
        print(f"kugelpendel: {kept}", file=sys.stderr)
        return _INTERRUPTED
    except BrokenPipeError:
        # The reader of a pipe, such as `head`, has had enough; all files are written by now.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return code


def _do_run(given: argparse.Namespace) -> int:
    from kugelpendel.cli.run.command import run

    run(given.file, given.out, given.json, given.format)
    return 0


def _do_compare(given: argparse.Namespace) -> int:
    from kugelpendel.cli.compare.command import compare

    compare(given.file, given.out, given.json)
    return 0


def _do_validity(given: argparse.Namespace) -> int:
    from kugelpendel.cli.validity import validity

    validity(given.length, given.a, given.b, given.out)
    return 0


def _do_design(given: argparse.Namespace) -> int:
    from kugelpendel.cli.design.command import design

    design(given.file, given.out, given.json, not given.formulas)
    return 0


def _do_derive(given: argparse.Namespace) -> int:
    from kugelpendel.cli.derive.command import derive, list_misprints, refuse_mixture

    refuse_mixture(
        given.check, given.misprints, given.json, given.equation, given.format, given.out
    )
    if given.check:
        from kugelpendel.cli.derive.check import check

        return check(given.equation, given.lang, given.json)
    if given.misprints:
        list_misprints(given.lang, given.json)
    else:
        derive(given.equation, given.lang, given.format, given.out)
    return 0


_COMMANDS = {
    "run": _do_run,
    "compare": _do_compare,
    "validity": _do_validity,
    "design": _do_design,
    "derive": _do_derive,
}


def _not_installed(missing: ImportError, command: str) -> str:
    from kugelpendel.errors import MissingExtra, require_extra

    try:
        require_extra("paper" if command == "derive" else "run", f"`kugelpendel {command}`")
    except MissingExtra as error:
        return str(error)
    return f"{missing.name or missing} cannot be imported: {missing}"


def _refuse(sentence: str) -> int:
    print(f"kugelpendel: {sentence}", file=sys.stderr)
    return _BAD_INPUT


def _interrupt(number: int, frame: FrameType | None) -> None:
    raise KeyboardInterrupt


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="kugelpendel",
        description="The exact motion of the spherical pendulum and its precession.",
        epilog="kugelpendel run --help shows what a job file looks like.",
    )
    parser.add_argument("--version", action="store_true", help="print the version and leave")
    commands = parser.add_subparsers(dest="command", metavar="COMMAND")
    run = commands.add_parser(
        "run",
        help="do the job that a file describes",
        description="Print what the pendulum does, and write its track, a figure and the results.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    _takes_a_job(run)
    run.add_argument(
        "--format", choices=("csv", "netcdf", "parquet"), help="format of the track (default: csv)"
    )
    compare = commands.add_parser(
        "compare",
        help="compare the paper's motions with the exact one",
        description="Print how far every motion goes astray, and write a figure and the results.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    _takes_a_job(compare)
    validity = commands.add_parser(
        "validity",
        help="say how good the formulas for small ellipses are",
        description="Print the errors of (25), (26) and of the series of each order, for one "
        "pendulum or for all. Lengths have a unit or are in m.",
    )
    validity.add_argument("--length", metavar="LENGTH", help='of the pendulum, such as "67 m"')
    validity.add_argument("--a", metavar="LENGTH", help="outer turning radius")
    validity.add_argument(
        "--b", metavar="LENGTH", help="inner turning radius (default: the limit b = 0)"
    )
    validity.add_argument(
        "--out", type=Path, metavar="FILE.png", help="draw the map; .svg and .pdf do as well"
    )
    design = commands.add_parser(
        "design",
        help="answer what the builder of a pendulum asks",
        description="Print period, turning, decay, suspension, drive, passage and wire of a "
        "pendulum, each by its formula and by the full equations, and write a figure and the "
        "results.",
        epilog=_DESIGN_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    _takes_a_job(design)
    design.add_argument(
        "--formulas", action="store_true", help="leave out the checks by the full equations"
    )
    _add_derive(commands.add_parser("derive", help="show or check why it is true", **_DERIVE))
    return parser


def _takes_a_job(command: argparse.ArgumentParser) -> None:
    command.add_argument("file", type=Path, metavar="FILE.toml", help="the job")
    command.add_argument(
        "--out",
        type=Path,
        metavar="DIR",
        help="folder for the files (default: out/JOB)",
    )
    command.add_argument(
        "--json", action="store_true", help="print the results as JSON, and nothing else, on stdout"
    )


def _add_derive(derive: argparse.ArgumentParser) -> None:
    derive.add_argument(
        "equation",
        nargs="?",
        metavar="EQUATION",
        help="such as 25: show only this one and what it rests on (default: everything)",
    )
    derive.add_argument("--lang", metavar="de|en", help="language (default: that of the locale)")
    derive.add_argument(
        "--format", metavar="html|md|latex|text", help="default: by the name of the file, or text"
    )
    derive.add_argument(
        "--out",
        type=Path,
        metavar="FILE",
        help="file to write (default: the terminal; derivation.LANG.html for html)",
    )
    derive.add_argument("--misprints", action="store_true", help="list the misprints of the paper")
    derive.add_argument(
        "--check", action="store_true", help="run all proofs; the exit code is 1 if one fails"
    )
    derive.add_argument(
        "--json", action="store_true", help="print the list of --misprints or --check as JSON"
    )
