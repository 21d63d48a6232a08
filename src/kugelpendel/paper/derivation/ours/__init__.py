"""The chapters that this project adds to the paper: what a reader asks next."""
