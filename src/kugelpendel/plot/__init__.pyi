from ._compared import compared as compared
from ._constants import Constants as Constants
from ._day import day as day
from ._design import design as design
from ._overview import overview as overview
from ._overview import save as save
from ._turning import turning_rate as turning_rate
from ._validity import LEVELS as LEVELS
from ._validity import validity as validity

__all__ = [
    "LEVELS",
    "Constants",
    "compared",
    "day",
    "design",
    "overview",
    "save",
    "turning_rate",
    "validity",
]
