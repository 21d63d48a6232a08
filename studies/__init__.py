"""Studies on synthetic data whose tables stand in the documents."""
