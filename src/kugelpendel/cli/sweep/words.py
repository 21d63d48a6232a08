"""What the command says while it works, in English and German."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from kugelpendel.errors import Language

WORDS: dict[Language, dict[str, str]] = {
    "en": {
        "title": "Pendulums",
        "rate": "{rate} cases/s",
        "bad": "{bad} bad",
        "resumed": "{done} of {size} cases are done already; going on.",
        "kept": "interrupted; {done} of {size} cases are done and kept in {folder}. The same "
        "command goes on: kugelpendel sweep {file}{out}",
        "files": "In {folder}: {files}",
    },
    "de": {
        "title": "Pendel",
        "rate": "{rate} Fälle/s",
        "bad": "{bad} schlecht",
        "resumed": "{done} von {size} Fällen sind schon fertig; es geht weiter.",
        "kept": "abgebrochen; {done} von {size} Fällen sind fertig und bleiben in {folder}. "
        "Derselbe Befehl geht weiter: kugelpendel sweep {file}{out}",
        "files": "In {folder}: {files}",
    },
}
