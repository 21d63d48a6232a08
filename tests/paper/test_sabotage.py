"""Sabotages made by hand in a copy of the derivation: the check must notice every one.

The copy is edited as a text, so that nothing is used of the ways in which the checker spoils a
formula itself. Each sabotage is a place, the text to replace and the subject whose row must find
it, with a part of the sentence that says so. Those of one copy lie in different formulas and are
looked for one by one.
"""

import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import pytest

import kugelpendel

SOURCE = Path(kugelpendel.__file__).parent / "paper"
PROGRAM = """
import json, sys
from sabotaged.checks.run import examined
rows = {label: examined(label, thorough=False) for label in sys.argv[1:]}
said = {
    label: [row.symbolic, row.numeric, list(row.survivors), list(row.faults)]
    for label, row in rows.items()
}
print(json.dumps(said))
"""


@dataclass(frozen=True)
class Hand:
    """A sabotage: in a file, an old text for a new one; found at a subject, with these words."""

    file: str
    old: str
    new: str
    label: str
    words: str


S1, S2, S2E = (f"derivation/section{k}.py" for k in ("1", "2_coordinates", "2_exact"))
S4, S4B = "derivation/section4_ansatz.py", "derivation/section4_balance.py"
EN, DE = "document/sentences/en.toml", "document/sentences/de.toml"
CONDITIONS, STATEMENTS = "derivation/conditions.py", "derivation/statements.py"

SIGNS = [
    Hand(S4B, r'r"\Omega = \frac{3}{8}', r'r"\Omega \approx \frac{3}{8}', "25", "has the sign ≈"),
    Hand(S1, r"\frac{{g}}{{l}} \sin \theta = 0", r"\frac{{g}}{{l}} \sin \theta \ll 0", "5b", "≪"),
    Hand(S2, r'r"\rho^2 = x^2', r'r"\rho^2 \approx x^2', "6:1", "has the sign ≈"),
    Hand(S4, r"x^2 + y^2 = a^2 \cos^2", r"x^2 + y^2 \approx a^2 \cos^2", "20.2", "has the sign ≈"),
    Hand(S4, r'_SLOW_SPEED % r"\approx"', '_SLOW_SPEED % "="', "20.6", "has the sign ="),
]
STEPS = [
    Hand(
        S4B,
        'StepKind.DIVIDE, ("23.7:1",)',
        'StepKind.MULTIPLY, ("23.7:1",)',
        "23.8:1",
        "“multiply”",
    ),
    Hand(S4B, "Step(StepKind.ADD, ", "Step(StepKind.SUBTRACT, ", "23.7:1", "“subtract”"),
    Hand(S2, 'StepKind.REARRANGE, ("10.2",)', 'StepKind.NEGLECT, ("10.2",)', "10.3", "“neglect”"),
    Hand(S1, r"\vec{e}_\phi, \quad \frac{1}{ml}", r"\vec{e}_\phi, \quad \frac{1}{m}", "5c", "step"),
    Hand(S2E, r"\frac{x}{x^2 + y^2} = \frac{x}{\rho^2}", r"\frac{1}{\rho^2}", "12", "step"),
    Hand(S4B, r'detail=r"4\omega_0"', r'detail=r"2\omega_0"', "25", "step"),
]
NEGLECTED = [
    Hand(
        S2E, r'neglected=r"\frac{\rho^4}{l^4}"', r'neglected=r"\frac{\rho^2}{l^2}"', "12.1", "neg"
    ),
    Hand(S4, r'r"2ab\omega_0\Omega"', r'r"2ab\Omega^2"', "20.6", "neglect"),
    Hand(S4B, r"-a\Omega^2 - \frac", r"-2a\Omega^2 - \frac", "23.4", "neglect"),
    Hand(S4, r"(a^3 - ab^2) \cos 3", r"(a^3 - 2ab^2) \cos 3", "20.8:1", "neglect"),
]
CONDITIONED = [
    Hand(CONDITIONS, r"\cos \theta \geq 0", r"\cos \theta < 0", "10.2", "lower-half, which is not"),
    Hand(CONDITIONS, r"a \neq b", "a = b", "23.8:2", "not-circle, which is not met"),
    Hand(
        CONDITIONS, r"\sin \theta \neq 0", r"\sin \theta = 0", "6.3", "off-axis, which is not met"
    ),
]
DROPPED = [
    Hand(S4, "(c.SLOW, c.SLOW_MINOR)", "(c.SLOW_MINOR,)", "20.6", "what the paper states"),
    Hand(S2, '("6.2:2",), (c.INEXTENSIBLE,)', '("6.2:2",)', "8:1", "a length that changes"),
    Hand(S2E, "(c.SMALL, c.SMALL_RATES),", "(c.SMALL,),", "13a", "a large velocity"),
    Hand(S2E, "(c.SMALL, c.SMALL_RATES, c.SAME", "(c.SMALL, c.NOT_EQUATOR, c.SAME", "13b",
         "does not need the condition off-equator"),
    Hand(S4B, "(c.NOT_OPPOSITE,)", "(c.NOT_OPPOSITE, c.NEAR)", "23.8:1", "does not need"),
    Hand(S2, 'Step(StepKind.REARRANGE, ("10.2",))',
         'Step(StepKind.REARRANGE, ("10.2",), (c.OFF_AXIS,))', "10.3",
         "does not need the condition off-axis"),
]  # fmt: skip
PREMISES = [
    Hand(
        S4B,
        'StepKind.SOLVE, ("23.9",)',
        'StepKind.SOLVE, ("23.9", "26")',
        "25",
        "does not come before",
    ),
    Hand(
        S4B,
        'StepKind.SUBTRACT, ("23.8",)',
        'StepKind.SUBTRACT, ("23.8", "25")',
        "23.9",
        "before it",
    ),
    Hand(
        S2,
        'StepKind.REARRANGE, ("9:1",)',
        'StepKind.REARRANGE, ("9:1", "5b")',
        "9:2",
        "does not use",
    ),
]
PRINTED = [
    Hand(S2, r'printed=r"\frac{1}{l^2} \frac{d}{dt}', r'printed=r"l^2 \frac{d}{dt}', "8:1",
         "not printed as it stands"),
    Hand(S4, '_YY % "-"', '_YY % "+"', "20.1:y", "not printed as it stands"),
    Hand(S2E, r"\frac{x}{l^2}(x\dot{x} + y\dot{y})^2", r"\frac{x}{l^3}(x\dot{x} + y\dot{y})^2",
         "12", "not printed as it stands"),
]  # fmt: skip
TYPESET = [
    Hand(S2, r"x^2 + y^2 = l^2 \sin^2 \theta", r"x^2 + y^2 = l^2 \sin^2 \theta^2", "5.1", "read"),
    Hand(S2, '_IN_ANGLES % "l^4"', '_IN_ANGLES % "l^04"', "10.1", "cannot be read"),
    Hand(S4B, r"\cdot 12ab = 0", r"\cdot 12ab . = 0", "23.9", "cannot be read"),
]
WORDING = [
    Hand(STATEMENTS, r"-\frac{3}{64}", r"-\frac{3}{32}", "third-harmonic", ""),
    Hand(STATEMENTS, r"\frac{9}{8}", r"\frac{9}{4}", "squared-share", ""),
    Hand(STATEMENTS, r"1 + \frac{a^2}{16l^2}", r"1 + \frac{a^2}{8l^2}", "period-factor", ""),
    Hand(
        STATEMENTS, r"(x\dot{x} + y\dot{y})^2 + (x", r"(x\dot{x} + y\dot{y})^2 - (x", "lagrange", ""
    ),
]
WORDS = [
    Hand(EN, "that of {26} with the [fourth](error-26) power. The exact",
         "that of {26} with the [second](error-26) power. The exact", "en", "should say 4"),
    Hand(DE, "wächst mit dem [Quadrat](error-25) der Amplitude, der von {26} mit der "
         "[vierten](error-26) Potenz. Die", "wächst mit der [vierten](error-25) Potenz. Die", "de",
         "vierten should say 2"),
    Hand(EN, "because $a-b$ is divided by", "because $a+b$ is divided by", "en", "does not stand"),
    Hand(DE, "in dieser Ordnung um den Faktor $@period-factor$",
         r"in dieser Ordnung um den Faktor $1+\\frac{a^2}{8l^2}$", "de", "is no statement"),
    Hand(EN, "of [third](order-third-harmonic) order", "of third order", "en", "is no figure"),
]  # fmt: skip


CIRCLES, AREAS, EXACT, NEXT = (
    f"derivation/ours/{name}.py" for name in ("circles", "areas", "exact", "next_order")
)
CHAPTERS = [
    Hand(CIRCLES, r"\Omega = \frac{1}{8}", r"\Omega = \frac{2}{8}", "A17:1", ""),
    Hand(CIRCLES, '(c.NOT_OPPOSITE,), detail="-A_1"', '(), detail="-A_1"', "A12:1", "a = −b"),
    Hand(AREAS, "(c.SMALL,),", "(),", "B4:2", "a large displacement"),
    Hand(EXACT, r"\frac{19}{512}", r"\frac{21}{512}", "C11", ""),
    Hand(EXACT, 'INTEGRATE, ("C4", "C5")', 'SUBSTITUTE, ("C4", "C5")', "C8", "“substitute”"),
    Hand(NEXT, r"\frac{7}{32}", r"\frac{13}{96}", "D2", ""),
    Hand(NEXT, r"\frac{309}{32768}", r"\frac{310}{32768}", "D3", "neglect"),
    Hand(STATEMENTS, r"\frac{13}{96} + \frac{1}{12}", r"\frac{13}{96} + \frac{1}{6}",
         "missing-twelfth", ""),
]  # fmt: skip


def rows_of(folder: Path, hands: Sequence[Hand]) -> dict[str, list[object]]:
    """Copy the derivation under another name, spoil the copy and examine what was spoilt."""
    copy = folder / "sabotaged"
    shutil.copytree(SOURCE, copy, ignore=shutil.ignore_patterns("__pycache__"))
    for hand in hands:
        path = copy / hand.file
        text = path.read_text(encoding="utf-8")
        assert hand.old in text, hand.old
        path.write_text(text.replace(hand.old, hand.new, 1), encoding="utf-8")
    for path in copy.rglob("*.py*"):
        text = path.read_text(encoding="utf-8")
        path.write_text(text.replace("kugelpendel.paper", "sabotaged"), encoding="utf-8")
    labels = dict.fromkeys(hand.label for hand in hands)
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, *labels],
        cwd=folder, capture_output=True, text=True, check=True,
    )  # fmt: skip
    found: dict[str, list[object]] = json.loads(done.stdout)
    return found


KINDS = {
    "sign": SIGNS, "step": STEPS, "neglected": NEGLECTED, "condition": CONDITIONED,
    "needed": DROPPED, "premise": PREMISES, "printed": PRINTED, "typeset": TYPESET,
    "statement": WORDING, "word": WORDS, "chapter": CHAPTERS,
}  # fmt: skip


@pytest.mark.parametrize("hands", KINDS.values(), ids=KINDS)
def test_each_sabotage_is_noticed(tmp_path: Path, hands: list[Hand]) -> None:
    rows = rows_of(tmp_path, hands)
    for hand in hands:
        symbolic, _, survivors, faults = rows[hand.label]
        assert isinstance(faults, list)
        assert isinstance(survivors, list)
        if hand.words:
            assert any(hand.words in fault for fault in faults), (hand, faults)
        else:
            assert not symbolic, hand


def test_the_untouched_copy_holds(tmp_path: Path) -> None:
    """The test of the tests above: without a sabotage nothing is found."""
    untouched = Hand(S1, "Newton", "Newton", "5b", "")
    others = [Hand(S1, "Newton", "Newton", label, "") for label in ("12", "25", "lagrange", "en")]
    for symbolic, numeric, survivors, faults in rows_of(tmp_path, [untouched, *others]).values():
        assert symbolic
        assert numeric
        assert survivors == []
        assert faults == []
