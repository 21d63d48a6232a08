"""kugelpendel validity: how good the formulas for small ellipses are."""
