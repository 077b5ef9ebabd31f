"""Links to vehicles: lockstep over UDP, external vehicles, listeners; radio impairment and link quality."""
