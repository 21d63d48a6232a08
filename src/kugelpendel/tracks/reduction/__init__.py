"""From positions to ellipses: carrier, windows, noise, and the labelled result."""

from kugelpendel.tracks.reduction._carrier import polynomial as polynomial
from kugelpendel.tracks.reduction._ellipses import ellipses as ellipses
from kugelpendel.tracks.reduction._ellipses import residuals as residuals
from kugelpendel.tracks.reduction._labelled import column as column
from kugelpendel.tracks.reduction._table import tabulated as tabulated
