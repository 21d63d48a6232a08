from .motion import ExactMotion as ExactMotion
from .motion import Spectrum as Spectrum
from .observables import precession_rate as precession_rate
from .observables import swing_frequency as swing_frequency
from .parameters import InvalidInput as InvalidInput
from .parameters import Launch as Launch
from .parameters import Pendulum as Pendulum

__all__ = [
    "ExactMotion",
    "InvalidInput",
    "Launch",
    "Pendulum",
    "Spectrum",
    "precession_rate",
    "swing_frequency",
]
