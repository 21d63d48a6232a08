"""The launches of the set: drawn from regimes, and picked by hand at limits and edges."""
