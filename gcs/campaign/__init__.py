"""Campaigns: one scenario flown many times, varied, and what comes of it with its uncertainty."""
