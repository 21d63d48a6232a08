from ._check import check as check
from ._check import examined as examined
from ._consequences import CONSEQUENCES as CONSEQUENCES
from ._counterexample import Counterexample as Counterexample
from ._counterexample import counterexample as counterexample
from ._graph import FORMULAS as FORMULAS
from ._graph import UnknownLabel as UnknownLabel
from ._graph import edges as edges
from ._graph import formula as formula
from ._graph import parts as parts
from ._graph import printed as printed
from ._graph import rests_on as rests_on
from ._graph import right as right
from ._misprints import MISPRINTS as MISPRINTS
from ._model import Condition as Condition
from ._model import Formula as Formula
from ._model import Kind as Kind
from ._model import Misprint as Misprint
from ._model import Row as Row
from ._model import Step as Step
from ._remainders import Remainder as Remainder
from ._remainders import dropped_harmonics as dropped_harmonics
from ._remainders import remainders as remainders
from ._remainders import third_harmonic as third_harmonic
from ._rendering import document as document
from ._rendering import misprint_list as misprint_list
from ._words import LANGUAGES as LANGUAGES
from ._words import Words as Words
from ._words import words as words

__all__ = [
    "CONSEQUENCES",
    "FORMULAS",
    "LANGUAGES",
    "MISPRINTS",
    "Condition",
    "Counterexample",
    "Formula",
    "Kind",
    "Misprint",
    "Remainder",
    "Row",
    "Step",
    "UnknownLabel",
    "Words",
    "check",
    "counterexample",
    "document",
    "dropped_harmonics",
    "edges",
    "examined",
    "formula",
    "misprint_list",
    "parts",
    "printed",
    "remainders",
    "rests_on",
    "right",
    "third_harmonic",
    "words",
]
