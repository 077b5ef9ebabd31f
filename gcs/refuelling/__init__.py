"""Refuelling in the air and at bases: who is served next, by whom, and each service from decision to end."""
