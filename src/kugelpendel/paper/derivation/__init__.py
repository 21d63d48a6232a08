"""What the paper says: formulas, steps, conditions, misprints, and what rests on what."""
