"""MAVLink, JSON and HIL as they pass between this process and an autopilot that is not ours: no socket, no clock."""
