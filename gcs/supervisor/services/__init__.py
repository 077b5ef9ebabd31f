"""Services of external vehicles that a session uses where they are spoken: operator control, events."""
