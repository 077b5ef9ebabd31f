"""Families of random scenarios, by name and seed."""

from gcs.campaign.families.makers import FAMILIES, family

__all__ = ["FAMILIES", "family"]
