from ._compared import compared as compared
from ._constants import Constants as Constants
from ._day import day as day
from ._design import design as design
from ._overview import overview as overview
from ._overview import save as save
from ._portrait import portrait as portrait
from ._turning import turning_rate as turning_rate
from ._units import Unit as Unit
from ._units import rate_unit as rate_unit
from ._units import significant as significant
from ._units import spell as spell
from ._units import spell_percent as spell_percent
from ._units import spell_rate as spell_rate
from ._units import unit_for as unit_for
from ._validity import LEVELS as LEVELS
from ._validity import validity as validity

__all__ = [
    "LEVELS",
    "Constants",
    "Unit",
    "compared",
    "day",
    "design",
    "overview",
    "portrait",
    "rate_unit",
    "save",
    "significant",
    "spell",
    "spell_percent",
    "spell_rate",
    "turning_rate",
    "unit_for",
    "validity",
]
