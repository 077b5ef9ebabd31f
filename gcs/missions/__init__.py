"""Missions, geofences and rally points: their model, the file formats that carry them, their transfer by MAVLink."""
