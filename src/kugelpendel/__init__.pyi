from . import series as series
from .builder import Design as Design
from .builder import DesignAnswer as DesignAnswer
from .builder import DesignCheck as DesignCheck
from .builder import design as design
from .errors import EventNotFound as EventNotFound
from .errors import InvalidInput as InvalidInput
from .errors import KugelpendelError as KugelpendelError
from .errors import MissingExtra as MissingExtra
from .errors import MotionEnded as MotionEnded
from .motion import CubicMotion as CubicMotion
from .motion import EnvelopeMotion as EnvelopeMotion
from .motion import ExactMotion as ExactMotion
from .motion import LinearMotion as LinearMotion
from .motion import OlssonMotion as OlssonMotion
from .motion import PlaneMotion as PlaneMotion
from .motion import PrecessionBudget as PrecessionBudget
from .motion import RealMotion as RealMotion
from .motion import SeriesMotion as SeriesMotion
from .motion import Spectrum as Spectrum
from .observables import Comparison as Comparison
from .observables import Portrait as Portrait
from .observables import Validity as Validity
from .observables import ValidityMap as ValidityMap
from .observables import compare as compare
from .observables import ellipse as ellipse
from .observables import precession_rate as precession_rate
from .observables import swing_frequency as swing_frequency
from .observables import validity as validity
from .observables import validity_map as validity_map
from .parameters import Bob as Bob
from .parameters import Drag as Drag
from .parameters import Drive as Drive
from .parameters import Forces as Forces
from .parameters import Launch as Launch
from .parameters import Pendulum as Pendulum
from .parameters import Site as Site
from .parameters import Suspension as Suspension
from .parameters import Wire as Wire

__all__ = [
    "Bob",
    "Comparison",
    "CubicMotion",
    "Design",
    "DesignAnswer",
    "DesignCheck",
    "Drag",
    "Drive",
    "EnvelopeMotion",
    "EventNotFound",
    "ExactMotion",
    "Forces",
    "InvalidInput",
    "KugelpendelError",
    "Launch",
    "LinearMotion",
    "MissingExtra",
    "MotionEnded",
    "OlssonMotion",
    "Pendulum",
    "PlaneMotion",
    "Portrait",
    "PrecessionBudget",
    "RealMotion",
    "SeriesMotion",
    "Site",
    "Spectrum",
    "Suspension",
    "Validity",
    "ValidityMap",
    "Wire",
    "compare",
    "design",
    "ellipse",
    "precession_rate",
    "series",
    "swing_frequency",
    "validity",
    "validity_map",
]
