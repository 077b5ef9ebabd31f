"""The radios among vehicles, as parts of the simulated world."""
