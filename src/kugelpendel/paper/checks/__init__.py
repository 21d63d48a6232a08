"""What is done with the proofs: all are run, conditions violated, remainders measured."""
