from . import olsson as olsson
from . import plot as plot
from . import series as series
from . import sweeps as sweeps
from . import tracks as tracks
from .builder import Design as Design
from .builder import DesignAnswer as DesignAnswer
from .builder import DesignCheck as DesignCheck
from .builder import design as design
from .citation import cite as cite
from .errors import EventNotFound as EventNotFound
from .errors import InvalidInput as InvalidInput
from .errors import KugelpendelError as KugelpendelError
from .errors import MissingExtra as MissingExtra
from .errors import MotionEnded as MotionEnded
from .motion import CubicMotion as CubicMotion
from .motion import EnvelopeMotion as EnvelopeMotion
from .motion import ExactMotion as ExactMotion
from .motion import LinearMotion as LinearMotion
from .motion import Motion as Motion
from .motion import OlssonMotion as OlssonMotion
from .motion import PlaneMotion as PlaneMotion
from .motion import PrecessionBudget as PrecessionBudget
from .motion import RealMotion as RealMotion
from .motion import SeriesMotion as SeriesMotion
from .motion import Spectrum as Spectrum
from .observables import Comparison as Comparison
from .observables import Ellipse as Ellipse
from .observables import IdealSummary as IdealSummary
from .observables import Portrait as Portrait
from .observables import Rates as Rates
from .observables import Validity as Validity
from .observables import ValidityMap as ValidityMap
from .observables import compare as compare
from .observables import ellipse as ellipse
from .observables import measured_rates as measured_rates
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
from .sweeps import Sweep as Sweep
from .sweeps import sweep as sweep

__version__: str

__all__ = [
    "Bob",
    "Comparison",
    "CubicMotion",
    "Design",
    "DesignAnswer",
    "DesignCheck",
    "Drag",
    "Drive",
    "Ellipse",
    "EnvelopeMotion",
    "EventNotFound",
    "ExactMotion",
    "Forces",
    "IdealSummary",
    "InvalidInput",
    "KugelpendelError",
    "Launch",
    "LinearMotion",
    "MissingExtra",
    "Motion",
    "MotionEnded",
    "OlssonMotion",
    "Pendulum",
    "PlaneMotion",
    "Portrait",
    "PrecessionBudget",
    "Rates",
    "RealMotion",
    "SeriesMotion",
    "Site",
    "Spectrum",
    "Suspension",
    "Sweep",
    "Validity",
    "ValidityMap",
    "Wire",
    "cite",
    "compare",
    "design",
    "ellipse",
    "measured_rates",
    "olsson",
    "plot",
    "series",
    "sweep",
    "sweeps",
    "tracks",
    "validity",
    "validity_map",
]
