"""When the frames of a recording came: its own stamps, or the clocks of the vehicles in it."""
