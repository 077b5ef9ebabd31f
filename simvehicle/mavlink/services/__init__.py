"""Microservices of MAVLink that say more of a vehicle: metadata, events, operator control, Remote ID."""
