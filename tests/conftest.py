"""What all tests need of their own process."""

import signal

# A shell that starts the tests in the background lets them ignore SIGINT, and every program under test inherits that.
signal.signal(signal.SIGINT, signal.default_int_handler)
