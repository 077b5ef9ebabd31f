"""Studies of the paper that need the flight law alone."""
