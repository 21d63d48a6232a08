"""What the figures of sweeps say, in English and German."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language

_LABELS: dict[str, tuple[str, str]] = {
    "missing": ("no answer", "keine Antwort"),
    "round": ("the plane goes round", "die Ebene läuft um"),
    "stalls": ("it stalls", "sie bleibt stehen"),
    "free": ("the clamp alone lets it go round", "die Klemme allein lässt sie umlaufen"),
    "held": ("the clamp alone stalls it", "die Klemme allein hält sie an"),
    "border": ("border by the portrait", "Grenze nach dem Porträt"),
    "nowhere": ("the plane goes round, or no answer", "die Ebene läuft um, oder keine Antwort"),
    "from_east": ("° counter-clockwise from east", "° gegen den Uhrzeigersinn von Ost"),
    "bars": ("cases in each bar, %", "Fälle in jedem Balken, %"),
    "left_out": ("{left} of {all} cases have no answer", "{left} von {all} Fällen ohne Antwort"),
    "alone": ("alone", "allein"),
    "total": (
        "with all others: gone if it were held",
        "mit allen anderen: weg, wenn sie fest wäre",
    ),
    "together": ("two together", "zwei zusammen"),
    "variance": (
        "share of the variance, %, with its 95 % interval",
        "Anteil an der Varianz, %, mit 95-%-Intervall",
    ),
    "moves": ("What moves the result", "Was das Ergebnis bewegt"),
}


def label(key: str, language: Language) -> str:
    """What a figure says at a place."""
    return _LABELS[key][language == "de"]


def with_unit(name: str, symbol: str) -> str:
    """A label with the unit of its numbers, where they have one."""
    return f"{name}, {symbol}" if symbol else name
