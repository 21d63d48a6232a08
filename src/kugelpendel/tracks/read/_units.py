"""The units in which recordings say times, positions and angles."""

from __future__ import annotations

import math
import re

LENGTHS = {
    **dict.fromkeys(("m", "meter", "metre", "meters", "metres"), 1.0),
    **dict.fromkeys(("cm", "centimeter", "centimetre", "zentimeter"), 1e-2),
    **dict.fromkeys(("mm", "millimeter", "millimetre"), 1e-3),
    **dict.fromkeys(("µm", "μm", "um", "micron", "microns", "mikrometer"), 1e-6),
    "km": 1e3,
    **dict.fromkeys(("in", "inch", "inches", "zoll"), 0.0254),
    **dict.fromkeys(("ft", "feet", "foot"), 0.3048),
}
"""Of one of each in m."""

PIXELS = frozenset(("px", "pixel", "pixels", "pix"))

TIMES = {
    **dict.fromkeys(("s", "sec", "secs", "second", "seconds", "sek", "sekunden", "sekunde"), 1.0),
    **dict.fromkeys(("ms", "msec", "millisecond", "milliseconds", "millisekunden"), 1e-3),
    **dict.fromkeys(("µs", "μs", "us", "usec", "microseconds", "mikrosekunden"), 1e-6),
    **dict.fromkeys(("ns", "nanoseconds", "nanosekunden"), 1e-9),
    **dict.fromkeys(("min", "minutes", "minute", "minuten"), 60.0),
    **dict.fromkeys(("h", "hours", "hour", "stunden", "hr", "hrs"), 3600.0),
    **dict.fromkeys(("d", "days", "tage"), 86400.0),
}
"""Of one of each in s."""

ANGLES = {
    **dict.fromkeys(("deg", "degree", "degrees", "°", "grad"), math.pi / 180),
    **dict.fromkeys(("rad", "radian", "radians"), 1.0),
}
"""Of one of each in rad; "grad" is German for a degree."""

FRAMES = frozenset(("frame", "frames", "fr", "bild", "bilder"))

ACCELERATIONS = {
    **dict.fromkeys(("m/s^2", "m/s²", "m/s2", "m/s/s", "ms^-2", "m s^-2", "m·s⁻²", "m s⁻²"), 1.0),
    **dict.fromkeys(("g",), 9.80665),
}
"""Of one of each in m/s²."""


def is_unit(text: str) -> bool:
    """Say whether a text is the name of one of these units."""
    plain = text.strip().lower()
    return any(
        plain in table for table in (LENGTHS, PIXELS, TIMES, ANGLES, FRAMES, ACCELERATIONS)
    ) or bool(re.fullmatch(r"[a-z]+/[a-z]+(?:\^?2)?", plain))
