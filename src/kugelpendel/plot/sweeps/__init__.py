"""Figures of a sweep: maps over what varies, distributions, and what moves a result."""

from kugelpendel.plot.sweeps._basins import basins as basins
from kugelpendel.plot.sweeps._curve import curve as curve
from kugelpendel.plot.sweeps._distribution import distribution as distribution
from kugelpendel.plot.sweeps._map import values_map as values_map
from kugelpendel.plot.sweeps._regions import regions as regions
from kugelpendel.plot.sweeps._shares import shares as shares

__all__ = ["basins", "curve", "distribution", "regions", "shares", "values_map"]
