"""Planner: virtual leaders in a potential field with fuzzy escape, formations, planners of a user's own."""
