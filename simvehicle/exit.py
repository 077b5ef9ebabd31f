"""Exit statuses of a vehicle and of the hatch."""

BAD_INPUT = 2
INTERNAL_ERROR = 70
CANNOT_WRITE = 74
ABANDONED = 75
"""Its supervisor has been silent for too long."""
AUTOPILOT_GONE = 76
"""The autopilot that it flies cannot be started, was not ready, or has ended."""
INTERRUPTED = 130
