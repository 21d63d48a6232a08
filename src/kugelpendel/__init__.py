"""The spherical pendulum: its exact motion from any launch, at any time.

Conventions: SI units and radians; the support is the origin and z points down, so the bob rests at
(0, 0, length); azimuths, precession and angular momentum are positive counter-clockwise seen from
above. The names live in `__init__.pyi`; each is imported when it is first used.
"""

# lazy_loader has no types; those of the names are in `__init__.pyi`.
# pyright: reportMissingTypeStubs=false, reportUnknownVariableType=false

import lazy_loader

_named, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> object:
    if name == "__version__":
        from importlib.metadata import version  # takes longer than all else at the start

        return version("kugelpendel")
    return _named(name)
