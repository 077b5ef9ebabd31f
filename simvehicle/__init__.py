"""Software-in-the-loop quadrotor vehicles that speak MAVLink."""
