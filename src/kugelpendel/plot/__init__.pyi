from . import sweeps as sweeps
from . import tracks as tracks
from ._compared import compared as compared
from ._day import day as day
from ._design import design as design
from ._overview import overview as overview
from ._overview import save as save
from ._portrait import portrait as portrait
from ._validity import validity as validity

__all__ = [
    "compared",
    "day",
    "design",
    "overview",
    "portrait",
    "save",
    "sweeps",
    "tracks",
    "validity",
]
