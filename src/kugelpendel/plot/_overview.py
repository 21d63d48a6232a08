"""One figure of a motion: from above, from the side, and how its apsides turn."""

# matplotlib's stubs leave **kwargs untyped.
# pyright: reportUnknownMemberType=false
from __future__ import annotations

import math
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
from matplotlib.ticker import MaxNLocator

from kugelpendel.motion import Motion
from kugelpendel.observables import IdealSummary
from kugelpendel.parameters import InvalidInput, require_type
from kugelpendel.plot import _ink
from kugelpendel.plot._apsides import draw_apsides
from kugelpendel.plot._path import visible_path
from kugelpendel.plot._plan import draw_plan, draw_stretched, is_narrow
from kugelpendel.plot._side import draw_side

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def overview(
    motion: Motion, duration: float, approximate: float | None = None, title: str = ""
) -> Figure:
    """Draw a motion from its launch on.

    Parameters
    ----------
    motion
        Any of the motions, a single one. Turning circles and heights are those of the ideal motion
        from the same launch.
    duration
        How long, s. Of a long time only part of the swings is drawn, and the figure says which; a
        motion that ends before is drawn up to its end.
    approximate
        Precession by formula (25), rad/s, drawn beside the exact one; None where it does not apply.
    title
        A line above the figure.

    Returns
    -------
    A figure of matplotlib without a window or a global state, which a notebook shows at once;
    `save` writes it.

    Raises
    ------
    InvalidInput
        For an ensemble, for what is no motion, a duration that is not positive and finite, an
        approximate rate that is no finite number, and a title that is no text.
    """
    way_out = "write kp.ExactMotion(pendulum, launch), for instance"
    require_type("What is drawn", motion, Motion, way_out=way_out)
    known = IdealSummary.of(motion)
    duration = _ink.one_number("duration", duration, "s")
    if not 0 < duration < math.inf:
        raise InvalidInput(
            f"A figure needs a duration that is positive and finite, but it is {duration:.6g} s; "
            f"give the seconds from the launch on that are to be shown."
        )
    if approximate is not None and not math.isfinite(
        _ink.one_number("approximate", approximate, "rad/s")
    ):
        raise InvalidInput(
            f"A precession that is drawn must be a finite rate in rad/s, but it is {approximate}; "
            f"leave it out where formula (25) does not apply."
        )
    duration = min(duration, motion.span[1])
    with mpl.rc_context(_ink.STYLE):
        path = visible_path(motion, known, duration)
        narrow = is_narrow(path)
        figure = _ink.blank(11, 8.2)
        grid = figure.add_gridspec(2, 2, width_ratios=(1.25, 1))
        plan = figure.add_subplot(grid[0, 0] if narrow else grid[:, 0])
        side = figure.add_subplot(grid[0, 1])
        apsides = figure.add_subplot(grid[1, 1])
        timeline = _ink.Timeline(path.until)
        lines = draw_plan(plan, known, path, timeline)
        from_above = [plan]
        if narrow:
            stretched = figure.add_subplot(grid[1, 0])
            draw_stretched(stretched, known, path, timeline)
            from_above.append(stretched)
        draw_side(side, known, path, timeline)
        draw_apsides(apsides, motion, known, duration, approximate)
        for axes in (*from_above, side, apsides):
            axes.xaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
            axes.yaxis.set_major_locator(MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
        bar = figure.colorbar(lines, ax=from_above, location="left", shrink=0.6, aspect=30)
        bar.set_label(f"time ({timeline.unit.symbol})" + (path.caption and f", {path.caption}"))
        bar.outline.set_visible(False)  # pyright: ignore[reportCallIssue]
        _ink.entitle(figure, title, 100)
    return figure


def save(figure: Figure, path: Path | str | BytesIO) -> None:
    """Write a figure; the ending of the name says as what: png, svg or pdf; into memory as png.

    The same figure gives the same file, byte for byte, with the same version of matplotlib. Raises
    InvalidInput for another ending, for what is no figure, and for what is no file's name.
    """
    if not isinstance(figure, _ink.Figure):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(
            f"Only a figure can be saved, but this is {figure!r:.60} of type "
            f"{type(figure).__name__}; write save(plot.overview(motion, duration), path)."
        )
    if not isinstance(path, (str, Path, BytesIO)):  # pyright: ignore[reportUnnecessaryIsInstance]
        raise InvalidInput(
            f"A figure is saved under a file's name, but this is {path!r:.60} of type "
            f'{type(path).__name__}; write save(figure, "figure.png").'
        )
    known = figure.canvas.get_supported_filetypes()
    ending = "png" if isinstance(path, BytesIO) else Path(path).suffix.lstrip(".").lower()
    if ending not in known:
        raise InvalidInput(
            f"The file's name {str(path)!r} does not end with a kind of picture; let it end with "
            f".png, .svg or .pdf."
        )
    metadata = {"Date": None} if str(path).endswith(".svg") else None
    with mpl.rc_context(_ink.STYLE):
        figure.savefig(path, metadata=metadata)
