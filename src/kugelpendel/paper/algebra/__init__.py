"""Symbols of the paper, how its formulas are read, and what can be done with them."""
