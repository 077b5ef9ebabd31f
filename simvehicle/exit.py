"""Exit statuses of a vehicle and of the hatch."""

BAD_INPUT = 2
INTERNAL_ERROR = 70
CANNOT_WRITE = 74
ABANDONED = 75
"""Its supervisor has been silent for too long."""
INTERRUPTED = 130
