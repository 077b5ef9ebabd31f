"""Sessions one after the other from processes that stay loaded."""
