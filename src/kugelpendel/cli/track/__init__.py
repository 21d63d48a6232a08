"""The track of a motion, written row by row in the format that was asked for."""
