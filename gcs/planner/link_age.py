"""Silent and slow links, by the age of vehicles' reports [choice].

A link that loses nothing brings a report in every period: four periods without one are an outage, in which the vehicle
no longer obeys. Where frames are lost or vehicles report seldom, reports are as old as that often. On a slow link all
are old, the newest too.
"""

from __future__ import annotations

import math

LEAST_S, MOST_S = 0.35, 1.0
"""Age of a report from which a vehicle is silent, at least and at most."""
USUAL_SHARE, SPARE_S = 1.5, 0.2
"""Of the oldest report of late, and beyond it."""
FIRST_S = 0.5
"""Taken for the oldest report before there was one."""
DECAY_S = 10.0
"""The oldest report of late counts by 1/e less after so long."""
SLOW_S = 0.4
"""Age of the newest reports from which a link is slow."""
RISE = 0.1
"""s/s: so slowly the age of the newest report of late rises, so that a second of silence makes no slow link."""


class LinkAge:
    """Oldest report of late of each vehicle, at the time when the next one came."""

    def __init__(self) -> None:
        self._oldest_s: dict[int, float] = {}
        self._age_s: dict[int, float] = {}

    def receive(self, sysid: int, age_s: float, period_s: float) -> None:
        """Take in a vehicle's age, once a period."""
        before_s, oldest_s = self._age_s.get(sysid, age_s), self._oldest_s.get(sysid, FIRST_S)
        oldest_s *= math.exp(-period_s / DECAY_S)
        if age_s < before_s + 0.5 * period_s:  # a report has come
            oldest_s = max(oldest_s, before_s, age_s)
        self._age_s[sysid], self._oldest_s[sysid] = age_s, min(oldest_s, MOST_S)

    def silent(self, sysid: int, age_s: float) -> bool:
        """Whether a vehicle's last report is older than its link explains."""
        usual_s = USUAL_SHARE * self._oldest_s.get(sysid, FIRST_S) + SPARE_S
        return age_s > min(max(usual_s, LEAST_S), MOST_S)


class SlowLinks:
    """Age of the newest report of late of each vehicle."""

    def __init__(self) -> None:
        self._newest_s: dict[int, float] = {}

    def receive(self, sysid: int, age_s: float, period_s: float) -> None:
        """Take in a vehicle's age, once a period."""
        self._newest_s[sysid] = min(age_s, self._newest_s.get(sysid, math.inf) + RISE * period_s)

    def slow(self, sysid: int) -> bool:
        """Whether whatever a vehicle reports has been flown long ago."""
        return self._newest_s.get(sysid, 0.0) >= SLOW_S
