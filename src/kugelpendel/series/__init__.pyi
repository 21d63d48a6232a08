from ._functions import Harmonics as Harmonics
from ._functions import frequency as frequency
from ._functions import harmonics as harmonics
from ._functions import precession as precession
from ._polynomial import Polynomial as Polynomial
from ._radius import radius as radius
from ._trust import Trust as Trust
from ._trust import trusted as trusted

__all__ = [
    "Harmonics",
    "Polynomial",
    "Trust",
    "frequency",
    "harmonics",
    "precession",
    "radius",
    "trusted",
]
