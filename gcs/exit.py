"""What a program's exit status says; the help of each command tells what that is for it."""

DONE = 0
NOT_DONE = 1
BAD_INPUT = 2
INTERNAL_ERROR = 70
INTERRUPTED = 130
