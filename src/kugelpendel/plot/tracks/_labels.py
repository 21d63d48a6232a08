"""What the figures of tracks say, in English and German."""

from __future__ import annotations

from kugelpendel.errors import Language

_LABELS: dict[str, tuple[str, str]] = {
    "a": ("a, half the length", "a, halbe Länge"),
    "b": ("b, half the width, + counter-clockwise", "b, halbe Breite, + gegen den Uhrzeigersinn"),
    "azimuth": ("azimuth of the long axis", "Azimut der langen Achse"),
    "measured": ("measured, with 1 σ", "gemessen, mit 1 σ"),
    "model": ("model", "Modell"),
    "left": ("left over", "Rest"),
    "time": ("time", "Zeit"),
    "points": ("positions", "Orte"),
    "first": ("ellipse at the start", "Ellipse am Anfang"),
    "last": ("ellipse at the end", "Ellipse am Ende"),
    "seen": ("The track from above", "Die Spur von oben"),
    "course": ("The ellipse over time", "Die Ellipse im Lauf der Zeit"),
    "frequency": ("angular frequency, − clockwise", "Kreisfrequenz, − im Uhrzeigersinn"),
    "power": ("power of what is left over", "Leistung des Rests"),
    "spectrum": ("Spectrum of what the ellipses leave over", "Spektrum des Rests der Ellipsen"),
    "line": ("fitted noise", "angepasstes Rauschen"),
    "swing": ("the swing, ±ω", "die Schwingung, ±ω"),
    "correlations": ("Correlations of the parameters", "Korrelationen der Größen"),
    "profile": ("How well the turning is known", "Wie gut die Drehung bekannt ist"),
    "rotation": ("Ω$_z$", "Ω$_z$"),
    "excess": ("χ² above its least", "χ² über seinem kleinsten Wert"),
    "level": ("95 %", "95 %"),
}  # fmt: skip


def label(key: str, language: Language) -> str:
    """What a figure says at a place."""
    return _LABELS[key][language == "de"]


def german_words(sign: str, language: Language) -> str:
    """The sign of a parameter, in which only the tilt is a word."""
    return sign.replace("tilt", "Neigung") if language == "de" else sign
