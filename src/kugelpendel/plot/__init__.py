"""Figures of a motion."""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false

import lazy_loader

# matplotlib is imported with the first figure.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
