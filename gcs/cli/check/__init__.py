"""A conformance check of any vehicle: what MAVSDK, QGroundControl and MAVProxy ask, and what they would miss."""
