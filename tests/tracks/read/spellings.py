"""One motion in every spelling that instruments, spreadsheets and people have for it."""

from __future__ import annotations

import datetime
import io
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import numpy as np

import kugelpendel as kp

RATE = 30.0
COUNT = 400


@dataclass(frozen=True)
class Spelling:
    """A file that holds the motion.

    Attributes
    ----------
    size
        Of one unit of the track that is read, in m.
    within
        To how many m the file has the positions.
    missing
        How many of the rows it does not have.
    notes
        Kinds of notes that have to be there.
    """

    name: str
    content: bytes
    options: dict[str, Any] = field(default_factory=dict)
    size: float = 1.0
    within: float = 1e-5
    missing: int = 0
    notes: tuple[str, ...] = ()


@cache
def motion() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Time in s, x and y in m of the motion that all files hold."""
    pendulum = kp.Pendulum(length=9.81 * (2.8 / (2 * math.pi)) ** 2, gravity=9.81)
    found = kp.ExactMotion(pendulum, kp.Launch.apsides(0.3, 0.008, azimuth=0.4))
    time = np.arange(COUNT) / RATE
    x, y, _ = found.position(time).T
    return time, x, y


def lines(
    separator: str,
    head: str | None,
    row: Callable[[int, float, float, float], list[str]],
    end: str = "\n",
) -> str:
    rows = [separator.join(row(i, *p)) for i, p in enumerate(zip(*motion(), strict=True))]
    return end.join([*([head] if head is not None else []), *rows]) + end


def point(value: float, digits: int = 5) -> str:
    return f"{value:.{digits}f}"


def comma(value: float, digits: int = 5) -> str:
    return point(value, digits).replace(".", ",")


def plain(i: int, t: float, x: float, y: float) -> list[str]:
    return [point(t), point(x), point(y)]


def german(i: int, t: float, x: float, y: float) -> list[str]:
    return [comma(t), comma(x), comma(y)]


def grouped(value: float, thousands: str, decimal: str) -> str:
    return f"{value:,.2f}".replace(",", "#").replace(".", decimal).replace("#", thousands)


def spellings() -> Iterator[Spelling]:
    """All of them."""
    yield from _texts()
    yield from _numbers()
    yield from _times()
    yield from _names()
    yield from _rows()
    yield from _blocks()
    yield from _binaries()


def _texts() -> Iterator[Spelling]:
    text = lines(",", "time (s),x (m),y (m)", plain)
    yield Spelling("comma", text.encode())
    yield Spelling("tab", lines("\t", "t/s\tx/m\ty/m", plain).encode())
    yield Spelling("semicolon", lines(";", "t [s];x [m];y [m]", plain).encode())
    yield Spelling("bar", lines("|", "t [s]|x [m]|y [m]", plain).encode())
    yield Spelling("comma and blank", lines(", ", "t (s), x (m), y (m)", plain).encode())
    yield Spelling("crlf", text.replace("\n", "\r\n").encode())
    yield Spelling("carriage returns only", text.replace("\n", "\r").encode())
    yield Spelling("byte-order mark", text.encode("utf-8-sig"))
    yield Spelling("utf-16", text.encode("utf-16"))
    yield Spelling("utf-16 without a mark", text.encode("utf-16-le"), notes=("encoding",))
    latin = lines(";", "Zeit (s);x für A (m);y für A (m);Größe", lambda *p: [*plain(*p), "7"])
    yield Spelling("latin-1", latin.encode("latin-1"), notes=("encoding",))
    quoted = lines(",", '"t (s)","x (m)","y (m)"', lambda *p: [f'"{cell}"' for cell in plain(*p)])
    yield Spelling("quoted", quoted.encode())
    yield Spelling(
        "trailing separator", lines(";", "t (s);x (m);y (m);", lambda *p: [*plain(*p), ""]).encode()
    )
    yield Spelling("blank lines", text.replace("\n", "\n\n").encode())
    yield Spelling("no newline at the end", text.rstrip("\n").encode())
    fixed = lines(
        "", f"{'t (s)':>12}{'x (m)':>12}{'y (m)':>12}", lambda i, *p: [f"{v:12.5f}" for v in p]
    )
    yield Spelling("fixed width", fixed.encode(), size=1.0)
    holes = lines(
        "",
        f"{'t':>12}{'x':>12}{'y':>12}",
        lambda i, *p: [
            f"{p[0]:12.5f}",
            *([" " * 24] if i % 50 == 7 else [f"{v:12.5f}" for v in p[1:]]),
        ],
    )
    yield Spelling("fixed width with holes", holes.encode(), missing=8, notes=("rows_not_seen",))
    confident = lines(
        "",
        None,
        lambda i, t, x, y: [f"{t:10.4f}", " " * 10 if i % 40 == 3 else f"{x:10.5f}", f"{y:10.5f}"],
    )
    yield Spelling(
        "fixed width, one cell empty", confident.encode(), missing=10, notes=("rows_not_seen",)
    )


def _numbers() -> Iterator[Spelling]:
    yield Spelling(
        "decimal commas",
        lines(";", "Zeit (s);x (m);y (m)", german).encode(),
        notes=("decimal_comma",),
    )
    quoted = lines(",", "t,x,y", lambda *p: [f'"{cell}"' for cell in german(*p)])
    yield Spelling("quoted decimal commas", quoted.encode(), notes=("decimal_comma", "no_unit"))
    yield Spelling(
        "decimal commas, blanks", lines(" ", None, german).encode(), notes=("columns_by_place",)
    )
    yield Spelling(
        "decimal commas, tabs", lines("\t", "t\tx\ty", german).encode(), notes=("decimal_comma",)
    )
    three = lines(
        ";",
        "t (s);x (mm);y (mm)",
        lambda i, *p: [comma(p[0], 4), *(comma(1e3 * v, 3) for v in p[1:])],
    )
    yield Spelling("three decimals", three.encode(), within=1e-6, notes=("decimal_comma", "unit"))

    def micro(thousands: str, decimal: str) -> Callable[..., list[str]]:
        return lambda i, t, x, y: [
            f"{t:.4f}".replace(".", decimal),
            *(grouped(1e6 * v, thousands, decimal) for v in (x, y)),
        ]

    head = "t (s);x (µm);y (µm)"
    yield Spelling("thousands: comma", lines(";", head, micro(",", ".")).encode(), notes=("unit",))
    yield Spelling("thousands: point", lines(";", head, micro(".", ",")).encode(), notes=("unit",))
    yield Spelling("thousands: blank", lines(";", head, micro(" ", ",")).encode(), notes=("unit",))
    yield Spelling(
        "thousands: narrow blank", lines(";", head, micro("\u202f", ".")).encode(), notes=("unit",)
    )
    yield Spelling(
        "thousands: apostrophe", lines(";", head, micro("'", ".")).encode(), notes=("unit",)
    )
    whole = lines(
        "\t",
        "t (ms)\tx (µm)\ty (µm)",
        lambda i, t, x, y: [f"{1e3 * t:,.2f}", *(f"{1e6 * v:,.0f}" for v in (x, y))],
    )
    yield Spelling("thousands in whole numbers", whole.encode(), notes=("time_unit",))
    minus = lines(",", "t,x,y", plain).replace("-", "−")
    yield Spelling("true minus signs", minus.encode())
    yield Spelling(
        "exponents", lines("\t", "t\tx\ty", lambda i, *p: [f"{v:.9E}" for v in p]).encode()
    )
    fortran = lines(" ", None, lambda i, *p: [f"{v:.9E}".replace("E", "D") for v in p])
    yield Spelling("Fortran's exponents", fortran.encode(), notes=("columns_by_place",))
    units = lines(
        ";", "t;x;y", lambda i, t, x, y: [f"{t:.5f} s", f"{1e3 * x:.3f} mm", f"{1e3 * y:.3f} mm"]
    )
    yield Spelling("units in the cells", units.encode(), notes=("unit",))


def _times() -> Iterator[Spelling]:
    ms = lines(
        ",", "timestamp_ms,x_m,y_m", lambda i, t, x, y: [f"{1e3 * t:.2f}", point(x), point(y)]
    )
    yield Spelling("milliseconds", ms.encode(), notes=("time_unit",))
    epoch = lines(
        ",", "timestamp,x (m),y (m)", lambda i, t, x, y: [f"{1.7e9 + t:.5f}", point(x), point(y)]
    )
    yield Spelling("seconds since 1970", epoch.encode(), notes=("epoch",))
    frames = lines(";", "frame;x (m);y (m)", lambda i, t, x, y: [str(i), point(x), point(y)])
    yield Spelling("frames", frames.encode(), {"rate": RATE}, notes=("frames",))
    bare = lines(";", "x (m);y (m)", lambda i, t, x, y: [point(x), point(y)])
    yield Spelling("no times", bare.encode(), {"rate": RATE}, notes=("rows_are_frames",))

    def clock(moment: float, form: str) -> str:
        start = datetime.datetime(2025, 5, 17, 23, 59, 55)
        return (start + datetime.timedelta(seconds=round(moment, 5))).strftime(form)

    def at(form: str) -> Callable[..., list[str]]:
        return lambda i, t, x, y: [clock(t, form), point(x), point(y)]

    midnight = lines(",", "clock,x (m),y (m)", at("%H:%M:%S.%f"))
    yield Spelling("clock across midnight", midnight.encode(), notes=("midnight", "clock"))
    twelve = lines(",", "Time,x (m),y (m)", at("%I:%M:%S.%f %p"))
    yield Spelling("twelve-hour clock", twelve.encode(), notes=("midnight",))
    iso = lines(",", "time,x (m),y (m)", at("%Y-%m-%dT%H:%M:%S.%fZ"))
    yield Spelling("ISO 8601", iso.encode(), notes=("clock",))
    apart = lines(";", "Datum;Uhrzeit;x (m);y (m)", at("%d.%m.%Y;%H:%M:%S,%f"))
    yield Spelling("German date and clock", apart.encode(), notes=("clock",))
    american = lines("\t", "datetime\tx (m)\ty (m)", at("%m/%d/%Y %H:%M:%S.%f"))
    yield Spelling("American date", american.encode(), notes=("clock",))
    stopwatch = lines(
        ",",
        "time,x (m),y (m)",
        lambda i, t, x, y: [f"{int(t // 60):02d}:{t % 60:08.5f}", point(x), point(y)],
    )
    yield Spelling("stop-watch", stopwatch.encode(), notes=("clock",))


def _names() -> Iterator[Spelling]:
    yield Spelling("no header", lines(",", None, plain).encode(), notes=("columns_by_place",))
    indexed = lines(",", ",t,x,y", lambda i, *p: [str(i), *plain(i, *p)])
    yield Spelling("index column", indexed.encode())
    unnamed = lines("\t", "t\tx\ty", lambda i, *p: [str(i + 1), *plain(i, *p)])
    yield Spelling("index column without a name", unnamed.encode())
    counted = lines(" ", None, lambda i, *p: [str(i), *plain(i, *p)])
    yield Spelling("index and no header", counted.encode(), notes=("columns_by_place",))
    order = lines(
        ";",
        "y (cm);conf;x (cm);t (s)",
        lambda i, t, x, y: [point(1e2 * y, 4), "0.9", point(1e2 * x, 4), point(t)],
    )
    yield Spelling("another order", order.encode(), notes=("unit", "columns_ignored"))
    odd = lines(";", "p;q;r;s", lambda i, t, x, y: [point(y), point(t), "1", point(x)])
    yield Spelling(
        "columns that are given", odd.encode(), {"columns": {"t": "q", "x": "s", "y": 1}}
    )
    row = "# run 7\nframe,time,x,y\n-,s,cm,cm\n"
    below = row + lines(
        ",", None, lambda i, t, x, y: [str(i), point(t), point(1e2 * x, 4), point(1e2 * y, 4)]
    )
    yield Spelling("units in a row of their own", below.encode(), notes=("comment", "unit"))
    hidden = "# t x y\n" + lines(" ", None, plain)
    yield Spelling("header in a comment", hidden.encode())
    image = lines(
        ",",
        "t,x_px,y_px",
        lambda i, t, x, y: [point(t), point(320 + 1e3 * x, 3), point(240 - 1e3 * y, 3)],
    )
    yield Spelling("pixels", image.encode(), size=1e-3, notes=("unit_px", "y_down_assumed"))
    asked = lines(
        ",",
        "t,x,y",
        lambda i, t, x, y: [point(t), point(320 + 1e3 * x, 3), point(240 - 1e3 * y, 3)],
    )
    yield Spelling(
        "pixels with a scale",
        asked.encode(),
        {"y_down": True, "scale": 1e-3},
        notes=("scale", "y_down"),
    )


def _rows() -> Iterator[Spelling]:
    head, *rows = lines(";", "t (s);x (m);y (m)", plain).splitlines()

    def spoilt(new: list[str]) -> bytes:
        return "\n".join([head, *new, ""]).encode()

    words = ["NaN", "n/a", "", "-", "None", "#N/A"]
    lost = [
        f"{r.split(';')[0]};{words[i % 6]};{words[i % 6]}" if i % 20 == 5 else r
        for i, r in enumerate(rows)
    ]
    yield Spelling("not found as a word", spoilt(lost), missing=20, notes=("rows_not_seen",))
    doubled = [row for i, row in enumerate(rows) for row in [row] * (1 + (i % 30 == 2))]
    yield Spelling("doubled rows", spoilt(doubled), notes=("rows_doubled",))
    dropped = [row for i, row in enumerate(rows) if i % 25 != 4]
    yield Spelling("dropped frames", spoilt(dropped), missing=16, notes=("gaps",))
    yield Spelling("unordered", spoilt([*rows[200:], *rows[:200]]), notes=("rows_sorted",))
    yield Spelling(
        "a repeated block", spoilt([*rows, *rows[100:200]]), notes=("rows_doubled", "rows_sorted")
    )
    yield Spelling(
        "a repeated header", spoilt([*rows[:150], head, *rows[150:]]), notes=("headers_repeated",)
    )
    end = ["", "mean;0,01;0,02", "Frames tracked: 400", "generated by a program"]
    yield Spelling("summary at the end", spoilt([*rows, *end]), notes=("rows_foreign",))
    start = [f"{-i / RATE:.5f};{rows[0].split(';', 1)[1]}" for i in range(40, 0, -1)]
    yield Spelling("standstill at the start", spoilt([*start, *rows]), notes=("standstill",))
    frozen = [
        f"{row.split(';')[0]};{rows[i - 1].split(';', 1)[1]}" if i % 21 == 10 else row
        for i, row in enumerate(rows)
    ]
    yield Spelling(
        "pictures stored twice", spoilt(frozen), missing=19, notes=("pictures_repeated",)
    )
    image = lines(
        ";",
        "t;x;y",
        lambda i, t, x, y: [
            point(t),
            *(["-1", "-1"] if i % 50 == 9 else [point(320 + 1e3 * x, 2), point(240 + 1e3 * y, 2)]),
        ],
    )
    yield Spelling(
        "minus one for not found",
        image.encode(),
        {"scale": 1e-3},
        missing=8,
        notes=("marked_not_found",),
    )


def _blocks() -> Iterator[Spelling]:
    rows = [f"{point(t)}\t{point(x)}\t{point(y)}" for t, x, y in zip(*motion(), strict=True)]
    others = [f"{point(t)}\t{point(2 * y)}\t{point(x)}" for t, x, y in zip(*motion(), strict=True)]
    yield Spelling(
        "Tracker's text",
        "\n".join(["\tmass A\t", "t\tx\ty", *rows]).encode(),
        notes=("tracker_metres",),
    )
    two = "\n".join(["mass B\t\t", "t\tx\ty", *others, "mass A\t\t", "t\tx\ty", *rows])
    yield Spelling("two masses in blocks", two.encode(), {"mass": "A"}, notes=("mass_chosen",))
    beside = ["\tmass B\t\tmass A\t", "t\tx\ty\tx\ty"]
    beside += [f"{o}\t{r.split(chr(9), 1)[1]}" for o, r in zip(others, rows, strict=True)]
    yield Spelling(
        "two masses side by side",
        "\n".join(beside).encode(),
        {"mass": "mass A"},
        notes=("mass_chosen",),
    )
    named = ["t,x_left,y_left,x_right,y_right"]
    named += [
        f"{r},{o.split(chr(9), 1)[1]}".replace("\t", ",") for r, o in zip(rows, others, strict=True)
    ]
    yield Spelling(
        "two masses by name", "\n".join(named).encode(), {"mass": "left"}, notes=("mass_chosen",)
    )
    long = ["particle\tt\tx\ty"] + [
        f"{k}\t{r}" for pair in zip(rows, others, strict=True) for k, r in enumerate(pair)
    ]
    yield Spelling(
        "two masses in turn", "\n".join(long).encode(), {"mass": "0"}, notes=("mass_chosen",)
    )


def _binaries() -> Iterator[Spelling]:
    import pandas as pd

    time, x, y = motion()
    file = io.BytesIO()
    pd.DataFrame({"t (s)": time, "x (m)": x, "y (m)": y}).to_parquet(file)
    yield Spelling("Parquet", file.getvalue())
    file = io.BytesIO()
    moments = pd.Timestamp("2025-05-17 12:00") + pd.to_timedelta(time, unit="s")
    pd.DataFrame(
        {"x (mm)": 1e3 * x, "y (mm)": 1e3 * y}, index=pd.Index(moments, name="time")
    ).to_parquet(file)
    yield Spelling("Parquet with dates", file.getvalue(), notes=("unit",))
    yield Spelling("Tracker project", project().encode(), notes=("trk_axes", "trk_scale"))


def project(declaration: str = "", name: str = "mass A") -> str:
    """A small Tracker project: origin, scale and an angle of 10°, frames from 7 on."""
    _, x, y = motion()
    cos, sin = math.cos(math.radians(10)), math.sin(math.radians(10))
    pixels = zip(320 + 800 * (x * cos - y * sin), 240 - 800 * (x * sin + y * cos), strict=True)
    steps = [
        _thing("tracker.PointMass$FrameData", n=i + 7, x=f"{u:.4f}", y=f"{v:.4f}")
        for i, (u, v) in enumerate(pixels)
    ]
    where = {"xorigin": 320, "yorigin": 240, "angle": 10, "xscale": 800, "yscale": 800}
    axes = _thing("ImageCoordSystem$FrameData", **where)
    mass = _thing("tracker.PointMass", name=name, framedata=_array(steps, first=7))
    panel = _thing(
        "tracker.TrackerPanel",
        videoclip=_thing("VideoClip", startframe=7, stepsize=1),
        clipcontrol=_thing("StepperClipControl", delta_t=1000 / RATE),
        coords=_thing("ImageCoordSystem", framedata=_array([axes])),
        tracks=f'<property name="item">{mass}</property>',
    )
    return f'<?xml version="1.0" encoding="UTF-8"?>{declaration}{panel}'


def _thing(kind: str, **entries: object) -> str:
    """An object as Tracker writes it."""
    inner = "".join(f'<property name="{key}">{said}</property>' for key, said in entries.items())
    return f'<object class="org.opensourcephysics.cabrillo.{kind}">{inner}</object>'


def _array(entries: list[str], first: int = 0) -> str:
    return "".join(
        f'<property name="[{number}]">{entry}</property>'
        for number, entry in enumerate(entries, start=first)
    )
