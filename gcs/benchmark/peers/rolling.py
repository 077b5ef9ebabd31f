"""Solvers asked again and again: the next service of each receiver that lands soon, on the places of now.

What both see: the receivers that land first, MOST of them, each with the time from which it may be served, the time
until which energy must flow, and how long its service takes; all tankers, with where and when they are free; ways
between the places of now. The first receiver of each free tanker is served once it waits. An instance's time is shared
among the calls that are still to be expected; when it is used up, the rest is by earliest deadline, and so is a call
in which the solver finds nothing.
"""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from typing import NamedTuple

import numpy as np

from gcs.benchmark.arrays import Arrays, Floats
from gcs.benchmark.peers.dispatching import FirstToLand
from gcs.benchmark.peers.flight import WANTS_FROM, DispatchedFlight

MOST = 12
UNIT_S = 0.1
LEAST_S = 0.03
SERVICES = 1.5
"""[choice] Calls for a receiver, about."""
AGAIN_S = 2.0
"""It is asked again when a tanker became free, a receiver began to wait, or after so long."""


class Jobs(NamedTuple):
    """n receivers, m tankers; times from now."""

    receivers: list[int]
    tankers: list[int]
    from_s: Floats
    until_s: Floats
    """(n,) until then it must begin"""
    takes_s: Floats
    free_s: Floats
    """(m,)"""
    first_s: Floats
    """(m, n) ways from where the tankers are free"""
    between_s: Floats
    """(m, n, n) ways from one receiver to another"""


def jobs_of(flight: DispatchedFlight) -> Jobs:
    """The jobs that are to be planned now."""
    arrays, now_s = flight.arrays, flight.now_s
    alive = (flight.lands_s > now_s) & (flight.lands_s < arrays.horizon_s - 1e-6)
    order = sorted(np.flatnonzero(alive), key=lambda i: float(flight.lands_s[i]))
    receivers = [int(i) for i in order][:MOST]
    at = np.array(receivers)
    from_s = np.maximum(np.maximum(flight.holds_in_s(receivers, WANTS_FROM), flight.busy_s[at] - now_s), 0.0)
    until_s = flight.lands_s[at] - arrays.setup_s - now_s
    begins_s = np.maximum(from_s, 0.5 * (from_s + until_s)) + now_s + arrays.setup_s
    tankers = [int(t) for t in range(arrays.m) if t in flight.free or flight.free_s[t] > now_s]
    places, speeds = arrays.at(at, now_s), arrays.speed_m_s[tankers]
    first_m = np.sqrt(np.square(flight.place_ned[tankers][:, None] - places).sum(axis=2))
    between_m = np.sqrt(np.square(places[:, None] - places).sum(axis=2))
    return Jobs(
        receivers, tankers, from_s, until_s, arrays.setup_s + flight.takes_s(receivers, begins_s),
        np.maximum(flight.free_s[tankers] - now_s, 0.0), first_m / speeds[:, None],
        between_m[None] / speeds[:, None, None],
    )  # fmt: skip


class Rolling(ABC):
    """A rule that plans again when something has changed."""

    def __init__(self, arrays: Arrays, seconds: float) -> None:
        self._arrays, self._left_s = arrays, seconds  # of processor time
        self._asked: tuple[tuple[int, ...], tuple[int, ...]] | None = None
        self._asked_s = -AGAIN_S

    def assign(self, flight: DispatchedFlight) -> dict[int, int]:
        """Receiver by tanker."""
        state = (tuple(flight.free), tuple(flight.waiting))
        if state == self._asked and flight.now_s < self._asked_s + AGAIN_S:
            return {}
        self._asked, self._asked_s = state, flight.now_s
        if self._left_s <= 0.0:
            return FirstToLand().assign(flight)
        share = (self._arrays.horizon_s - flight.now_s) / self._arrays.horizon_s
        began_s = time.process_time()
        jobs = jobs_of(flight)
        plan = self.plan(jobs, max(self._left_s / (1.0 + SERVICES * self._arrays.n * share), LEAST_S))
        self._left_s -= time.process_time() - began_s
        if plan is None:
            return FirstToLand().assign(flight)
        found = {}
        for k, j in plan.items():
            tanker, receiver = jobs.tankers[k], jobs.receivers[j]
            if tanker in flight.free and receiver in flight.waiting:
                found[tanker] = receiver
        return found

    @abstractmethod
    def plan(self, jobs: Jobs, seconds: float) -> dict[int, int] | None:
        """The first job of each tanker that has one; None where no plan was found in time."""
