"""The world that a vehicle on rotors flies in: airframes, rotors, wind, battery and estimate errors, compiled."""
