"""The parts that a scenario is made of; frozen, strict, and NED (gcs/scenario/types.py)."""
