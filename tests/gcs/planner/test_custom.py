"""A user's planner beside set points that a program gives."""

from __future__ import annotations

from typing import Any

from scenarios import scenario_of
from sessions import small

from gcs.planner.custom import OwnPlanner
