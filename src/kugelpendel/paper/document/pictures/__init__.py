"""Pictures of the derivation as SVG: drawn from its formulas and described in words."""
