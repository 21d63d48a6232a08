from . import series as series
from .motion import CubicMotion as CubicMotion
from .motion import ExactMotion as ExactMotion
from .motion import LinearMotion as LinearMotion
from .motion import OlssonMotion as OlssonMotion
from .motion import PlaneMotion as PlaneMotion
from .motion import SeriesMotion as SeriesMotion
from .motion import Spectrum as Spectrum
from .observables import precession_rate as precession_rate
from .observables import swing_frequency as swing_frequency
from .parameters import InvalidInput as InvalidInput
from .parameters import Launch as Launch
from .parameters import Pendulum as Pendulum

__all__ = [
    "CubicMotion",
    "ExactMotion",
    "InvalidInput",
    "Launch",
    "LinearMotion",
    "OlssonMotion",
    "Pendulum",
    "PlaneMotion",
    "SeriesMotion",
    "Spectrum",
    "precession_rate",
    "series",
    "swing_frequency",
]
