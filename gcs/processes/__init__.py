"""Processes of a session: the vehicles' host, the forked supervisor, their start, pace and suspension."""
