"""What both programs know of a vehicle of ours."""
