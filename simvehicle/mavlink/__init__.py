"""MAVLink as the vehicle speaks it; nothing here opens a socket, reads a clock or starts a thread."""
