"""What a sweep says of its results, in English and German."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language

PHRASES: dict[Language, dict[str, str]] = {
    "en": {
        "cases": "cases",
        "good": "good",
        "refused": "refused",
        "ended": "ended early",
        "late": "not yet",
        "layout": "{motion} motions, {design}, over {varied}",
        "grid": "a grid of {shape}",
        "sample": "a random sample",
        "sobol": "{count} base points of a Sobol design",
        "exact": "exact",
        "averaged": "averaged",
        "real": "real",
        "case": "case {index} ({given}): {why}",
        "result": "result",
        "unit": "unit",
        "least": "least",
        "largest": "largest",
        "answers": "answers",
        "mean": "mean",
        "deviation": "deviation",
        "share": "in {share} % of {count} cases: {text}",
        "stalls": "the plane, with all that acts, turns back or stands instead of going round",
        "clamp_stalls": "the clamp by itself, without drag and drive, makes the plane turn back",
        "agree": "What the plane does and what the portrait of the clamp says agree in {alike} of "
        "{count} cases.",
        "thinned": "Quantiles are those of one case in {every}.",
        "thinned_levels": "Quantiles are those of one level in {every} of the first number.",
        "moves": "What moves the {title}:",
        "refuses": "What moves the {title}: {why}",
        "dropped": "{dropped} of {blocks} blocks of {size} cases have a case without an answer and "
        "are left out; the shares are those of the rest.",
        "one": "Of what moves the {title}, {percent} is {name}{advice}.",
        "two": "Of what moves the {title}, {percent} is {first} and {second}{advice}.",
        "joint": "Of what moves the {title}, {percent} is {first} together with {second}{advice}.",
        "directed": "Of what moves the {title}, {percent} is {first} together with its direction"
        "{advice}.",
        "wide": "What moves the {title} most cannot be told: the intervals are up to ±{error} % "
        "wide; take more base points.",
        "many": "No two numbers alone move most of the {title}; the largest shares are those of "
        "{first} ({one} with all others) and {second} ({two}).",
        "variance": "share of the variance, %",
        "alone": "alone",
        "total": "with all others",
        "interaction": "interaction",
    },
    "de": {
        "cases": "Fälle",
        "good": "gut",
        "refused": "abgelehnt",
        "ended": "früh zu Ende",
        "late": "noch nicht",
        "layout": "{motion} Bewegungen, {design}, über {varied}",
        "grid": "ein Gitter von {shape}",
        "sample": "eine Zufallsstichprobe",
        "sobol": "{count} Grundpunkte eines Sobol-Plans",
        "exact": "exakte",
        "averaged": "gemittelte",
        "real": "reale",
        "case": "Fall {index} ({given}): {why}",
        "result": "Ergebnis",
        "unit": "Einheit",
        "least": "kleinstes",
        "largest": "größtes",
        "answers": "Antworten",
        "mean": "Mittel",
        "deviation": "Streuung",
        "share": "in {share} % von {count} Fällen: {text}",
        "stalls": "die Ebene kehrt mit allem, was wirkt, um oder bleibt stehen, statt umzulaufen",
        "clamp_stalls": "die Klemme allein, ohne Reibung und Antrieb, lässt die Ebene umkehren",
        "agree": "Was die Ebene tut und was das Porträt der Klemme sagt, stimmt in {alike} von "
        "{count} Fällen überein.",
        "thinned": "Quantile sind die jedes {every}. Falls.",
        "thinned_levels": "Quantile sind die jeder {every}. Stufe der ersten Größe.",
        "moves": "Was „{title}“ bewegt:",
        "refuses": "Was „{title}“ bewegt: {why}",
        "dropped": "{dropped} von {blocks} Blöcken zu {size} Fällen haben einen Fall ohne Antwort "
        "und bleiben weg; die Anteile sind die der übrigen.",
        "one": "Von dem, was „{title}“ bewegt, sind {percent} {name}{advice}.",
        "two": "Von dem, was „{title}“ bewegt, sind {percent} {first} und {second}{advice}.",
        "joint": "Von dem, was „{title}“ bewegt, sind {percent} {first} und {second} im "
        "Zusammenspiel{advice}.",
        "directed": "Von dem, was „{title}“ bewegt, sind {percent} {first} zusammen mit ihrer "
        "Richtung{advice}.",
        "wide": "Was „{title}“ am meisten bewegt, lässt sich nicht sagen: Die Intervalle sind bis "
        "zu ±{error} % breit; nehmen Sie mehr Grundpunkte.",
        "many": "Keine zwei Größen allein bewegen das meiste von „{title}“; die größten Anteile "
        "haben {first} ({one} mit allen anderen) und {second} ({two}).",
        "variance": "Anteil an der Varianz, %",
        "alone": "allein",
        "total": "mit allen anderen",
        "interaction": "Wechselwirkung",
    },
}

ADVICE: dict[str, dict[Language, str]] = {
    "suspension.axis": {"en": "align the axis", "de": "Achse ausrichten"},
    "suspension.damping_axis": {
        "en": "align the axis of the clamp's friction",
        "de": "Achse der Reibung der Klemme ausrichten",
    },
    "suspension.anisotropy": {
        "en": "make the clamp more even",
        "de": "Klemme gleichmäßiger machen",
    },
    "suspension.damping_anisotropy": {
        "en": "make the clamp's friction more even",
        "de": "Reibung der Klemme gleichmäßiger machen",
    },
    "launch.b": {"en": "launch it on a narrower ellipse", "de": "schmaler starten"},
}
"""What to do where a number moves most of it, directions before sizes: they cost least."""
