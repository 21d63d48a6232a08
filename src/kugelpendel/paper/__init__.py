"""The paper's derivation, from Newton's equation to (25) and (26), as steps that prove themselves.

Source: the German paper in ../shared/seed, the omitted steps of M. G. Olsson, Am. J. Phys. 49, 531
(1981). This package judges the motions in tests and supplies nothing to them. It needs SymPy and
mpmath, which the extra [paper] brings.
"""

from ._model import Condition as Condition
from ._model import Formula as Formula
from ._model import Kind as Kind
from ._model import Misprint as Misprint
from ._model import Row as Row
from ._model import Step as Step

# The rest comes with the first commit of the sections:
# FORMULAS: tuple[Formula, ...]; MISPRINTS: tuple[Misprint, ...]
# formula(label) -> Formula; parts(display) -> tuple[Formula, ...]
# rests_on(label) -> tuple[str, ...] (labels back to (1), in the paper's order); GRAPH edges()
# check(parallel=True, progress=None) -> tuple[Row, ...]; progress(done, total, row)
