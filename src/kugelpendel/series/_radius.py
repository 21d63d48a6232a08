"""How far the series converge."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from kugelpendel.parameters import InvalidInput, Scalars, as_numbers
from kugelpendel.series._orders import Variables, checked_variables
from kugelpendel.series._table import stored


def radius(ratio: ArrayLike, variables: Variables = "radii") -> Scalars:
    """The a/l below which the series converge, for b = ratio · a.

    Parameters
    ----------
    ratio
        b/a from −1 to 1.
    variables
        What a and b are: "radii", the turning radii, or "harmonics", the semi-axes of the ellipse
        that the first harmonics make.

    Returns
    -------
    Dimensionless, in the shape of the ratio; NaN in an array where the ratio is out of range.

    Raises
    ------
    InvalidInput
        A single ratio out of range; other variables.

    Notes
    -----
    In the radii it is 1 for every ratio: the heights are 1 − √(1 − ρ²), with a branch point where
    the bob turns at the equator, and no other singularity is as near. In the first harmonics it is
    the largest a that any motion with this ratio has: 1.1750 for swings in a plane (a turning point
    105.2° from the bottom), 1 for cones. Interpolated from stored values of the exact motion to
    2e-4. Both are confirmed by the ratios of the coefficients: tests/series/test_radius.py,
    docs/series.md.
    """
    share = as_numbers(ratio, "The ratio b/a", "1")
    outside = ~(np.abs(share) <= 1)
    if isinstance(share, float) and outside:
        raise InvalidInput(
            f"The ratio b/a must lie between −1 and 1, but it is {share}; "
            f"let a be the larger of the two."
        )
    if checked_variables(variables) == "radii":
        values = np.ones_like(share)
    else:
        nodes = stored()["radius"]
        values = np.interp(np.abs(share), np.linspace(0, 1, len(nodes)), nodes)
    return as_numbers(np.where(outside, np.nan, values), "the radius", "1")
