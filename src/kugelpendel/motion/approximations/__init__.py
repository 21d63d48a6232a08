"""The motions of the paper: turning figures, and the equations (12) and (13) integrated."""
