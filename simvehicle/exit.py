"""What the exit status of a vehicle, or of the hatch, says."""

BAD_INPUT = 2
INTERNAL_ERROR = 70
CANNOT_WRITE = 74
ABANDONED = 75
"""Its supervisor has been silent for too long."""
INTERRUPTED = 130
