"""Write the tables of what a file may say: ``python docs/scripts/job_files.py``.

They come from the schema that the command line reads files by, and stand in README.md and docs
between two comments that no reader sees.
"""

import re
import sys
from pathlib import Path

from kugelpendel.cli.job_file import schema
from kugelpendel.cli.job_file.schema_text import markdown
from kugelpendel.cli.job_file.sweep_schema import SWEEP
from kugelpendel.sweeps import QUANTITIES

CLASSES = {section.name: section.name.capitalize() for section in schema.FORCES}


def quantities() -> str:
    """The table of what a sweep may read."""
    lines = ["| quantity | unit | of | what |", "|---|---|---|---|"]
    for quantity in QUANTITIES.values():
        motions = ", ".join(
            word for word in ("exact", "averaged", "real") if word in quantity.motions
        )
        when = " at each of the times:" if quantity.per_time else ""
        text = f"{when} {quantity.text}".strip()
        lines.append(f"| `{quantity.name}` | {quantity.unit} | {motions} | {text} |")
    return "\n".join(lines).replace("|b|", "\\|b\\|") + "\n"


PAGES = {
    "README.md": markdown((schema.PENDULUM, schema.LAUNCH, schema.OUTPUT)),
    "docs/real.md": markdown(schema.FORCES, CLASSES),
    "docs/design.md": markdown((schema.SWING, schema.WIRE, schema.QUESTIONS)),
    "docs/sweeps.md": f"{markdown((SWEEP,))}\n{quantities()}",
}
"""The table of each page."""

START, END = "<!-- What a file may say, by docs/scripts/job_files.py -->", "<!-- End -->"


def written(page: str, table: str) -> str:
    """The text of a page with its table anew."""
    pattern = rf"({re.escape(START)}\n)(.*?)({re.escape(END)})"
    text, count = re.subn(
        pattern, lambda match: f"{match[1]}\n{table}\n{match[3]}", page, flags=re.DOTALL
    )
    if count != 1:
        sys.exit(f"a page has {count} places for its table, between {START} and {END}")
    return text


def main() -> None:
    """Write all pages."""
    root = Path(__file__).resolve().parents[2]
    for name, table in PAGES.items():
        path = root / name
        path.write_text(written(path.read_text(encoding="utf-8"), table), encoding="utf-8")


if __name__ == "__main__":
    main()
