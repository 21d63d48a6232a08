"""The formulas that the wording uses, each named once, and the wording as it is written.

A sentence does not hold a formula of its own: it names one of these, `$@lagrange$`, and what stands
in the document is what `checks.statements` reads and proves. In the same way `[fifth](order-13a)`
is a word that must say the number which is worked out under that name. Only single quantities that
stand in the formulas beside them, such as $x$ or $a-b$, are written out in a sentence.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from typing import Any

from kugelpendel.errors import Language

LANGUAGES: tuple[Language, ...] = ("de", "en")
STATEMENT = re.compile(r"\$@([a-z0-9-]+)\$?")
FIGURE = re.compile(r"\[([^\[\]]+)\]\(([a-zA-Z0-9.-]+)\)")

STATEMENTS: dict[str, str] = {
    "at-rest": r"z = l",
    "natural-frequency": r"\omega_0 = \sqrt{\frac{g}{l}}",
    "near-the-bottom": r"z \approx l",
    "straight": r"b = 0",
    "period-factor": r"1 + \frac{a^2}{16l^2}",
    "x-vanishes": r"x = 0",
    "tripled": r"3\omega",
    "tripled-phase": r"3\omega t",
    "pumping-term": r"2\frac{\dot{l}}{l} \dot{\theta}",
    "root-above": r"-\sqrt{1 - \frac{\rho^2}{l^2}}",
    "level": r"\rho = l",
    "nothing": r"0 = 0",
    "falling": r"\ddot{\theta} = -\frac{g}{l}",
    "missing-in-13a": (
        r"\frac{x}{l^4} (x\dot{x} + y\dot{y})^2 - \frac{1}{8} \omega_0^2 \frac{x\rho^4}{l^4}"
    ),
    "no-turning": r"\Omega = 0",
    "circle": r"a = b",
    "opposite-circle": r"a = -b",
    "cone": r"\omega + \Omega \approx \sqrt{\frac{g}{l \cos \theta}}",
    "opposite-cone": r"\omega - \Omega \approx \sqrt{\frac{g}{l \cos \theta}}",
    "turning-per-swing": r"\frac{\Omega}{\omega_0} = \frac{3}{8} \frac{ab}{l^2}",
    "turning-per-minor-axis": r"\frac{a\Omega}{b\omega_0} = \frac{3}{8} \frac{a^2}{l^2}",
    "third-harmonic": (
        r"-\frac{3}{64} \frac{a^2 - b^2}{l^2} "
        r"(a \cos 3\omega t \cos \Omega t - b \sin 3\omega t \sin \Omega t)"
    ),
    "squared-share": r"\frac{9}{8} \frac{a^2b^2}{(a^2 + b^2)l^2}",
    "acceleration": r"\ddot{\vec{r}} = \ddot{x}\vec{e}_x + \ddot{y}\vec{e}_y + \ddot{z}\vec{e}_z",
    "one": r"\sin^2 \phi + \cos^2 \phi = 1",
    "one-again": r"\sin^2 \Omega t + \cos^2 \Omega t = 1",
    "pushing": r"T < 0",
    "half-the-change": r"x\dot{x} + y\dot{y} = \frac{1}{2} \frac{d}{dt} (x^2 + y^2)",
    "gravity": r"\omega_0^2 = \frac{g}{l}",
    "root-below": r"\sqrt{1 - \sin^2 \theta} = \cos \theta",
    "lagrange": (
        r"(x\dot{x} + y\dot{y})^2 + (x\dot{y} - y\dot{x})^2 = \rho^2 (\dot{x}^2 + \dot{y}^2)"
    ),
    "other-acceleration": r"\ddot{y} = \frac{y}{x}\ddot{x}",
    "small": r"|x|, |y| \ll l",
    "sideways": r"\dot{y} = b\omega_0",
    "cosine-cubed": r"4 \cos^3 \omega t = 3 \cos \omega t + \cos 3\omega t",
    "sine-cubed": r"4 \sin^3 \omega t = 3 \sin \omega t - \sin 3\omega t",
    "cosine-squared": r"4 \cos^2 \omega t \sin \omega t = \sin \omega t + \sin 3\omega t",
    "sine-squared": r"4 \sin^2 \omega t \cos \omega t = \cos \omega t - \cos 3\omega t",
    "omega-beside-omega": r"2ab\omega\Omega",
    "third-component": r"m (x\dot{y} - y\dot{x})",
    "in-a-plane": r"x\dot{y} = y\dot{x}",
    "two-shares": r"\frac{3}{8} = \frac{1}{8} + \frac{1}{4}",
    "two-shares-of-frequency": r"-\frac{1}{8} = -\frac{3}{8} + \frac{1}{4}",
    "action": r"J_1 = \omega_0 A_1^2",
    "other-action": r"J_2 = \omega_0 A_2^2",
    "normal-form": r"H \approx \omega_0 (J_1 + J_2) + \frac{1}{8l^2} (J_1^2 + J_2^2 - 4J_1J_2)",
    "rate-of-normal-form": r"\omega_1 \approx \omega_0 + \frac{1}{4l^2} (J_1 - 2J_2)",
    "area": r"\pi ab",
    "three-quarters": r"\frac{3}{4}",
    "energy-of-ellipse": r"E \approx \frac{1}{2} \omega_0^2 (a^2 + b^2)",
    "frequency-by-energy": r"\omega^2 \approx \omega_0^2 \left( 1 - \frac{E}{4gl} \right)",
    "low-of-25": r"\frac{7}{32} \frac{a^2 + b^2}{l^2}",
    "cubic-alone": (
        r"\Omega = \frac{3}{8} \omega_0 \frac{ab}{l^2} "
        r"\left( 1 + \frac{13}{96} \frac{a^2 + b^2}{l^2} \right)"
    ),
    "missing-twelfth": r"\frac{7}{32} = \frac{13}{96} + \frac{1}{12}",
}


@cache
def sentences(language: str) -> Mapping[str, Any]:
    """Read the wording of a language as it is, with the names of statements and figures in it."""
    folder = files("kugelpendel.paper.document") / "sentences"
    paper, ours = (
        tomllib.loads((folder / f"{name}.toml").read_text(encoding="utf-8"))
        for name in (language, f"{language}_chapters")
    )
    return _joined(paper, ours)


def _joined(first: Mapping[str, Any], second: Mapping[str, Any]) -> dict[str, Any]:
    """Two files of sentences as one; what is a table in both holds the entries of both."""
    both = {
        key: _joined(first[key], entry) if isinstance(first.get(key), dict) else entry
        for key, entry in second.items()
    }
    return {**first, **both}


def named_statements(text: str) -> tuple[str, ...]:
    """Give the names of the statements that a text uses."""
    return tuple(STATEMENT.findall(text))


def named_figures(text: str) -> tuple[tuple[str, str], ...]:
    """Give the words of a text that say a figure, each with the name of the figure."""
    return tuple((word, name) for word, name in FIGURE.findall(text))


def resolved(text: str) -> str:
    """Put formulas in the places of their names, and leave the names of figures out."""
    return FIGURE.sub(r"\1", STATEMENT.sub(lambda found: f"${STATEMENTS[found[1]]}$", text))
