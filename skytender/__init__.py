"""The part that the ground station and the vehicles share."""
