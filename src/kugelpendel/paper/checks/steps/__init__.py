"""Whether a step is what it says: its operation, and the conditions that it needs."""
