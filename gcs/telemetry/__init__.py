"""Telemetry: messages of any autopilot in, one immutable state of the fleet in SI and NED out; health and metrics."""
