from .checks.conditions_violated import CONSEQUENCES as CONSEQUENCES
from .checks.counterexample import Counterexample as Counterexample
from .checks.counterexample import counterexample as counterexample
from .checks.evidence import Evidence as Evidence
from .checks.evidence import Point as Point
from .checks.evidence import Residual as Residual
from .checks.evidence import evidence as evidence
from .checks.evidence import proved as proved
from .checks.remainders import Remainder as Remainder
from .checks.remainders import dropped_harmonics as dropped_harmonics
from .checks.remainders import remainders as remainders
from .checks.remainders import third_harmonic as third_harmonic
from .checks.row import Row as Row
from .checks.run import check as check
from .checks.run import examined as examined
from .checks.run import subjects as subjects
from .checks.wording.figures import FIGURES as FIGURES
from .checks.wording.figures import figure as figure
from .derivation.graph import FORMULAS as FORMULAS
from .derivation.graph import UnknownLabel as UnknownLabel
from .derivation.graph import edges as edges
from .derivation.graph import formula as formula
from .derivation.graph import leading_to as leading_to
from .derivation.graph import parts as parts
from .derivation.graph import printed as printed
from .derivation.graph import rests_on as rests_on
from .derivation.graph import right as right
from .derivation.misprints import MISPRINTS as MISPRINTS
from .derivation.model import Condition as Condition
from .derivation.model import Formula as Formula
from .derivation.model import Misprint as Misprint
from .derivation.model import Step as Step
from .derivation.model import StepKind as StepKind
from .derivation.statements import LANGUAGES as LANGUAGES
from .derivation.statements import STATEMENTS as STATEMENTS
from .document.proof import Proofs as Proofs
from .document.wording import Words as Words
from .document.wording import words as words
from .rendering import handout as handout
from .rendering import misprint_list as misprint_list
from .rendering import write as write

__all__ = [
    "CONSEQUENCES",
    "FIGURES",
    "FORMULAS",
    "LANGUAGES",
    "MISPRINTS",
    "STATEMENTS",
    "Condition",
    "Counterexample",
    "Evidence",
    "Formula",
    "Misprint",
    "Point",
    "Proofs",
    "Remainder",
    "Residual",
    "Row",
    "Step",
    "StepKind",
    "UnknownLabel",
    "Words",
    "check",
    "counterexample",
    "dropped_harmonics",
    "edges",
    "evidence",
    "examined",
    "figure",
    "formula",
    "handout",
    "leading_to",
    "misprint_list",
    "parts",
    "printed",
    "proved",
    "remainders",
    "rests_on",
    "right",
    "subjects",
    "third_harmonic",
    "words",
    "write",
]
