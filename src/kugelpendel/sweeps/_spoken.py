"""How what varies and what is read are called, in English and German, and in which units."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kugelpendel.spelling import Unit, rate_unit, spell, unit_for
from kugelpendel.sweeps._quantities import QUANTITIES

if TYPE_CHECKING:
    from kugelpendel.errors import Language

_PARAMETERS: dict[str, dict[Language, tuple[str, str]]] = {
    "pendulum.length": {"en": ("length", "the length"), "de": ("Länge", "die Länge")},
    "pendulum.gravity": {"en": ("gravity", "gravity"), "de": ("Schwere", "die Schwere")},
    "pendulum.mass": {"en": ("mass", "the mass"), "de": ("Masse", "die Masse")},
    "launch.a": {"en": ("amplitude a", "the amplitude"), "de": ("Amplitude a", "die Amplitude")},
    "launch.b": {
        "en": ("width b at the launch", "the width at the launch"),
        "de": ("Breite b beim Start", "die Breite beim Start"),
    },
    "launch.azimuth": {
        "en": ("azimuth of the launch", "the azimuth of the launch"),
        "de": ("Azimut des Starts", "das Azimut des Starts"),
    },
    "launch.theta": {
        "en": ("angle of the launch θ", "the angle of the launch"),
        "de": ("Winkel des Starts θ", "der Winkel des Starts"),
    },
    "launch.phi": {
        "en": ("azimuth of the launch φ", "the azimuth of the launch"),
        "de": ("Azimut des Starts φ", "das Azimut des Starts"),
    },
    "site.latitude": {"en": ("latitude", "the latitude"), "de": ("Breite", "die Breite")},
    "site.height": {
        "en": ("height of the site", "the height of the site"),
        "de": ("Höhe des Ortes", "die Höhe des Ortes"),
    },
    "drag.linear": {
        "en": ("linear drag γ", "linear drag"),
        "de": ("lineare Reibung γ", "die lineare Reibung"),
    },
    "drag.quadratic": {
        "en": ("quadratic drag c", "quadratic drag"),
        "de": ("quadratische Reibung c", "die quadratische Reibung"),
    },
    "drag.quality": {"en": ("quality Q", "the quality"), "de": ("Güte Q", "die Güte")},
    "drag.half_life": {
        "en": ("half life of the swing", "the half life of the swing"),
        "de": ("Halbwertszeit der Schwingung", "die Halbwertszeit der Schwingung"),
    },
    "suspension.anisotropy": {
        "en": ("unevenness of the clamp δ", "the clamp's unevenness"),
        "de": ("Ungleichheit der Klemme δ", "die Ungleichheit der Klemme"),
    },
    "suspension.axis": {
        "en": ("direction of the clamp χ", "the clamp's direction"),
        "de": ("Richtung der Klemme χ", "die Richtung der Klemme"),
    },
    "suspension.damping_anisotropy": {
        "en": ("unevenness of the friction Δγ", "the unevenness of the clamp's friction"),
        "de": ("Ungleichheit der Reibung Δγ", "die Ungleichheit der Reibung der Klemme"),
    },
    "suspension.damping_axis": {
        "en": ("direction of the friction χd", "the direction of the clamp's friction"),
        "de": ("Richtung der Reibung χd", "die Richtung der Reibung der Klemme"),
    },
    "bob.radius": {
        "en": ("radius of the bob", "the radius of the bob"),
        "de": ("Radius der Kugel", "der Radius der Kugel"),
    },
    "bob.diameter": {
        "en": ("diameter of the bob", "the diameter of the bob"),
        "de": ("Durchmesser der Kugel", "der Durchmesser der Kugel"),
    },
    "bob.density": {
        "en": ("density of the bob", "the density of the bob"),
        "de": ("Dichte der Kugel", "die Dichte der Kugel"),
    },
    "bob.air_density": {
        "en": ("density of the air", "the density of the air"),
        "de": ("Dichte der Luft", "die Dichte der Luft"),
    },
    "drive.push": {"en": ("push", "the push"), "de": ("Stoß", "der Stoß")},
    "drive.phase": {
        "en": ("phase of the push", "the phase of the push"),
        "de": ("Phase des Stoßes", "die Phase des Stoßes"),
    },
    "drive.radius": {
        "en": ("radius of the push", "the radius of the push"),
        "de": ("Radius des Stoßes", "der Radius des Stoßes"),
    },
}
"""What stands at an axis, and what stands in a sentence."""

_GERMAN = {
    "frequency": "Kreisfrequenz",
    "precession": "Präzession",
    "period": "Periode",
    "azimuth": "Azimut",
    "a": "Amplitude a",
    "b": "halbe Breite b",
    "mean_rate": "mittlere Rate",
    "largest_b": "größtes |b|",
    "quarter_turn": "Vierteldrehung",
    "stalls": "bleibt stehen",
    "final_direction": "letzte Richtung",
    "stands_since": "steht seit",
    "clamp_stalls": "Klemme hält an",
    "slowest_rate": "langsamste Rate",
    "fastest_rate": "schnellste Rate",
    "least_tension": "kleinster Zug",
    "largest_tension": "größter Zug",
    "error_25": "Fehler von (25)",
    "error_26": "Fehler von (26)",
    "averaging_error": "Fehler der Mittelung",
}

_ENGLISH = {
    "a": "amplitude a",
    "b": "half-width b",
    "largest_b": "largest |b|",
    "error_25": "error of (25)",
    "error_26": "error of (26)",
}
"""Where it is not the name with blanks."""

_LADDERS = ("m", "m/s", "s", "rad", "kg", "N")
_BARE = {"1", ""}


def called(name: str, language: Language = "en") -> str:
    """What a parameter or a quantity is called beside numbers."""
    if name in QUANTITIES:
        usual = _ENGLISH.get(name, name.replace("_", " "))
        return _GERMAN[name] if language == "de" else usual
    return _PARAMETERS[name][language][0] if name in _PARAMETERS else name


def in_a_sentence(name: str, language: Language = "en") -> str:
    """What a parameter is called in a sentence."""
    return _PARAMETERS[name][language][1] if name in _PARAMETERS else name


def called_after(name: str, time: float | None, language: Language = "en") -> str:
    """What a quantity is called, with the time in s at which it was read."""
    if time is None:
        return called(name, language)
    after = {"en": "after", "de": "nach"}[language]
    return f"{called(name, language)} {after} {spell(time, 's', 3, language=language)}"


def unit_of(name: str, magnitude: float, si: str) -> Unit:
    """The unit in which values of a parameter or a quantity are said.

    Parameters
    ----------
    name
        Of the parameter or the quantity.
    magnitude
        The largest of the values, in SI.
    si
        Their SI unit, "1" for none.
    """
    quantity = QUANTITIES.get(name)
    if quantity is not None and quantity.holds == "rate":
        return rate_unit(magnitude)
    if quantity is not None and quantity.holds == "axis":
        return unit_for(1.0, "rad")
    if si in _LADDERS:
        return unit_for(magnitude, si)
    return Unit("" if si in _BARE else si, 1.0, 0.0)
