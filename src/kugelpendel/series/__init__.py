"""The theory of the paper carried on: frequency, precession and harmonics to any even order."""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false

import lazy_loader

# Fractions and the table are for those who ask for a series, not for every motion.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
