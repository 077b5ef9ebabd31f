"""Component metadata and events: what a vehicle says of its parameters, and what happens to it."""
