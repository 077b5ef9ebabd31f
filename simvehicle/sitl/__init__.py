"""Software in the loop: processes, sockets, clocks and files around the autopilot."""
