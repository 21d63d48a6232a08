"""The paper's derivation, from Newton's equation to (25) and (26), as steps that prove themselves.

Source: the German paper in ../shared/seed, the omitted steps of M. G. Olsson, Am. J. Phys. 49, 531
(1981). This package judges the motions in tests and supplies nothing to them. It needs SymPy and
mpmath, which the extra [paper] brings.
"""

from ._graph import FORMULAS as FORMULAS
from ._graph import UnknownLabel as UnknownLabel
from ._graph import edges as edges
from ._graph import formula as formula
from ._graph import parts as parts
from ._graph import rests_on as rests_on
from ._misprints import MISPRINTS as MISPRINTS
from ._model import Condition as Condition
from ._model import Formula as Formula
from ._model import Kind as Kind
from ._model import Misprint as Misprint
from ._model import Row as Row
from ._model import Step as Step
from ._rendering import document as document
from ._rendering import misprint_list as misprint_list
from ._words import LANGUAGES as LANGUAGES
from ._words import Words as Words
from ._words import words as words
