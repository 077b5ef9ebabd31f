"""Autopilot of one vehicle: modes, failsafes, missions, geofence, energy transfer. No message, no socket, no clock."""
