"""Figures of a motion."""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false, reportUnknownArgumentType=false

import lazy_loader

from kugelpendel.errors import with_extra

# matplotlib is imported with the first figure.
_get, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
__getattr__ = with_extra(_get, "run", __name__, "matplotlib")
