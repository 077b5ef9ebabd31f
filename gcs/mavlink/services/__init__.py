"""Microservices of MAVLink that a vehicle may have or not: standard modes, operator control."""
