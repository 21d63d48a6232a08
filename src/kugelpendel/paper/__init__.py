"""The paper's derivation, from Newton's equation to (25) and (26), as steps that prove themselves.

Source: the German paper in ../shared/seed, the omitted steps of M. G. Olsson, Am. J. Phys. 49, 531
(1981). This package judges the motions in tests and supplies nothing to them. It needs SymPy and
mpmath, which the extra [paper] brings. The names live in `__init__.pyi`.
"""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import lazy_loader

from kugelpendel.errors import with_extra

# SymPy is imported with the first formula, not with the list of languages.
_get, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_extra(_get, "paper", __name__)
