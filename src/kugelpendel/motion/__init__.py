"""How it moves: every motion has the one interface of `Motion`.

The names live in `__init__.pyi`; each is imported when it is first used, so that who asks for one
motion does not wait for eight.
"""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
