"""MAVFTP, the MAVLink file transfer protocol, as a reader of a vehicle's files."""
