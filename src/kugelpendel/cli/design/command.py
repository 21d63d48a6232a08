"""``kugelpendel design``: the answers to what a builder asks."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import kugelpendel as kp
from kugelpendel import plot
from kugelpendel.cli.design.design_file import read_questions
from kugelpendel.cli.design.report import design_report
from kugelpendel.cli.json_text import json_text
from kugelpendel.cli.output import staged
from kugelpendel.cli.terminal.progress import Progress
from kugelpendel.cli.terminal.streams import write_json

if TYPE_CHECKING:
    from kugelpendel.cli.design.design_file import Questions

FIGURE = "design.png"
PORTRAIT = "portrait.png"
RESULTS = "design.json"


def design(file: Path, folder: Path | None, as_json: bool, checked: bool) -> None:
    """Answer what a file asks.

    Parameters
    ----------
    file
        The file.
    folder
        Where the files go; ``out/`` and the name of the file, unless given.
    as_json
        Print the results as JSON in place of the tables.
    checked
        Whether the full equations are run beside the formulas.

    Raises
    ------
    InvalidInput
        Anything wrong with the file or the folder. Nothing is left half-written.
    """
    questions = read_questions(file)
    with questions.document.named():
        found = _answered(questions, checked)
    target = folder if folder is not None else Path("out") / questions.file.stem
    results = _as_json(questions, found)
    title = questions.file.stem.replace("-", " ").replace("_", " ")
    drawn = (FIGURE, PORTRAIT) if "turning_by_anisotropy" in found else (FIGURE,)
    with staged(target, (FIGURE, PORTRAIT, RESULTS), (*drawn, RESULTS)) as temporary:
        plot.save(plot.design(found, title), temporary / FIGURE)
        if PORTRAIT in drawn:
            plot.save(plot.portrait(found.portrait, title=title), temporary / PORTRAIT)
        (temporary / RESULTS).write_text(results, encoding="utf-8")
    if as_json:
        write_json(results)
    else:
        print(design_report(questions, found))
        print(f"\nIn {target}: {', '.join((*drawn, RESULTS))}")


def _answered(questions: Questions, checked: bool) -> kp.Design:
    with Progress("Running the checks", 1.0) as progress:
        return kp.design(
            questions.pendulum,
            questions.a,
            questions.b,
            azimuth=questions.azimuth,
            forces=questions.forces,
            wire=questions.wire,
            share=questions.share,
            after=questions.after,
            radius=questions.radius,
            time=questions.time,
            checked=checked,
            done=progress.reach,
        )


def _as_json(questions: Questions, found: kp.Design) -> str:
    tables: dict[str, Any] = {
        "about": "kugelpendel: what a builder asks; SI units, named beside each value; rates and "
        "the sign of b are positive counter-clockwise seen from above; measured is by the full "
        "equations; null is never, or not there",
        "file": questions.file.name,
        "swing": {"a_m": found.a, "b_m": found.b, "azimuth_rad": found.azimuth},
        "rates_at_the_start_rad_per_s": found.budget,
        "answers": [_answer(answer) for answer in found.answers],
    }
    return json_text(tables)


def _answer(answer: kp.DesignAnswer) -> dict[str, Any]:
    check = answer.check
    return {
        "key": answer.key,
        "group": answer.group,
        "name": answer.name,
        "value": answer.value if math.isfinite(answer.value) else None,
        "unit": answer.unit,
        "formula": answer.formula,
        "source": answer.source,
        "note": answer.note or None,
        "check": None
        if check is None
        else {
            "expected": check.expected,
            "measured": check.measured,
            "difference": check.difference,
            "judged_by": check.of or "measured",
            "agrees": check.agrees,
            "how": check.how,
        },
    }
