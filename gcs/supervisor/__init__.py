"""Supervisor: one tick of a session, from the answers of the vehicles to their next set points."""
