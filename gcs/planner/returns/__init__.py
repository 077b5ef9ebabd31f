"""Returns of vehicles that have lost the ground station, looked at before anything flies."""
