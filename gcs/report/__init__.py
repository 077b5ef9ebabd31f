"""Report of a recorded session as one HTML page, JUnit, and the studies of the paper."""
