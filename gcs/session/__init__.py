"""Sessions as processes: start, clock, socket and messages, clients, Python API, monitor and replay."""
