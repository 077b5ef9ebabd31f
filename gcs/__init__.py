"""MAVLink ground-station supervisor: plans, competes, refuels, records."""
