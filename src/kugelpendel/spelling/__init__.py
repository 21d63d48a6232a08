"""How quantities are said: in units that a reader takes in at a glance, in English and German.

A number that is spelled has a minus sign, not a hyphen, and in German a decimal comma. Angular
velocities carry their sign, since it is their sense. Nothing here knows physics; every function
turns numbers in SI into text and fails for none of them.
"""

from kugelpendel.spelling._numbers import general as general
from kugelpendel.spelling._numbers import grouped as grouped
from kugelpendel.spelling._numbers import localised as localised
from kugelpendel.spelling._numbers import minus as minus
from kugelpendel.spelling._numbers import significant as significant
from kugelpendel.spelling._numbers import spell_percent as spell_percent
from kugelpendel.spelling._quantities import as_given as as_given
from kugelpendel.spelling._quantities import degrees as degrees
from kugelpendel.spelling._quantities import hourly as hourly
from kugelpendel.spelling._quantities import spell as spell
from kugelpendel.spelling._quantities import spell_bytes as spell_bytes
from kugelpendel.spelling._quantities import spell_rate as spell_rate
from kugelpendel.spelling._units import Unit as Unit
from kugelpendel.spelling._units import rate_unit as rate_unit
from kugelpendel.spelling._units import unit_for as unit_for

__all__ = [
    "Unit",
    "as_given",
    "degrees",
    "general",
    "grouped",
    "hourly",
    "localised",
    "minus",
    "rate_unit",
    "significant",
    "spell",
    "spell_bytes",
    "spell_percent",
    "spell_rate",
    "unit_for",
]
