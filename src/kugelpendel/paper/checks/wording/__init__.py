"""Whether the wording says only what is proved: its formulas, its figures, its quantities."""
