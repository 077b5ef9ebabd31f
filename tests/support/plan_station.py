"""A ground station that reads and writes plans as QGroundControl's PlanManager does, of many vehicles at once over one
socket (mavlink/qgroundcontrol 00d5b5e0, src/MissionManager/PlanManager.cc).

What a vehicle says goes to that vehicle's manager: of MISSION_COUNT, MISSION_ITEM_INT, requests and MISSION_ACK the
type is compared, and of items whether the number is still missing. A list, an item or a count is asked for or said
again, five times; what a vehicle asks for late or not at all is an error. What is for another station is left out, as
by the router before it: QGroundControl itself does not look.
"""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import Any

from patience import PATIENCE_S
from pymavlink import mavutil

ANSWER_WITHIN_S, ITEM_WITHIN_S, MOST_RETRIES = 1.5, 0.25, 5
ACCEPTED, INVALID_SEQUENCE = 0, 13
STATION = 252


class PlanError(AssertionError):
    """What such a station would show its user as an error."""


class _Manager:
    """One plan of one vehicle, read or, where there are items, written."""

    def __init__(self, link: Any, sysid: int, kind: int, items: Sequence[Any] | None) -> None:
        self._link, self._sysid, self._kind, self._items = link, sysid, kind, items
        self.read: list[Any] = []
        self.done = False
        self._missing = None if items is None else set(range(len(items)))
        self._retries = 0
        self._until_s = 0.0

    def begin(self) -> None:
        """Ask for the list, or say how many there are to write."""
        if self._items is None:
            self._link.mav.mission_request_list_send(self._sysid, 1, self._kind)
        else:
            self._link.mav.mission_count_send(self._sysid, 1, len(self._items), self._kind)
        self._until_s = time.monotonic() + ANSWER_WITHIN_S

    def look(self) -> None:
        """Go on where an answer is late."""
        if self.done or time.monotonic() < self._until_s:
            return
        if self._items is not None and self._missing != set(range(len(self._items))):
            raise PlanError(f"vehicle {self._sysid} did not ask for {sorted(self._missing or ())}, or sent no ack")
        self._retries += 1
        if self._retries > MOST_RETRIES:
            raise PlanError(f"vehicle {self._sysid} does not answer")
        if self._items is None and self._missing:
            self._ask()
        else:
            self.begin()

    def take(self, m: Any) -> None:
        """Act on a message of the vehicle."""
        if self.done or m.mission_type != self._kind:
            return
        name = m.get_type()
        if name == "MISSION_ACK":
            self._acknowledged(m.type)
        elif self._items is not None and name in ("MISSION_REQUEST", "MISSION_REQUEST_INT"):
            assert self._missing is not None
            self._missing.discard(m.seq)
            self._link.mav.mission_item_int_send(self._sysid, 1, m.seq, *self._items[m.seq], self._kind)
            self._until_s = time.monotonic() + ANSWER_WITHIN_S
        elif self._items is None and name == "MISSION_COUNT" and self._missing is None:
            self._missing, self._retries = set(range(m.count)), 0
            self._ask()
        elif self._items is None and name == "MISSION_ITEM_INT" and m.seq in (self._missing or ()):
            assert self._missing is not None
            self._missing.discard(m.seq)
            self.read.append(m)
            self._retries = 0
            self._ask()

    def _ask(self) -> None:
        """The next item that is missing, or an end."""
        if not self._missing:
            self._link.mav.mission_ack_send(self._sysid, 1, ACCEPTED, self._kind)
            self.done = True
            return
        self._link.mav.mission_request_int_send(self._sysid, 1, min(self._missing), self._kind)
        self._until_s = time.monotonic() + ITEM_WITHIN_S

    def _acknowledged(self, result: int) -> None:
        if result == INVALID_SEQUENCE:  # ArduPilots say it of a request that came twice
            return
        if self._items is None or self._missing or result != ACCEPTED:
            raise PlanError(f"vehicle {self._sysid} ended it with MISSION_ACK {result}")
        self.done = True


def exchange(port: int, kind: int, plans: Mapping[int, Sequence[Any] | None]) -> dict[int, list[Any]]:
    """Read the plan of each vehicle, or write it where there are items (frame to z of MISSION_ITEM_INT), all at once;
    the items that were read. Raises PlanError."""
    link = mavutil.mavlink_connection(f"udpin:127.0.0.1:{port}", source_system=STATION, source_component=190)
    try:
        managers = {sysid: _Manager(link, sysid, kind, items) for sysid, items in plans.items()}
        unheard, until_s = set(managers), time.monotonic() + PATIENCE_S
        while not all(one.done for one in managers.values()):
            if time.monotonic() > until_s:
                raise PlanError(f"not done: {[sysid for sysid, one in managers.items() if not one.done]}")
            m = link.recv_match(blocking=True, timeout=0.05)
            if unheard:
                unheard.discard(None if m is None else m.get_srcSystem())
                if not unheard:
                    for one in managers.values():
                        one.begin()
                continue
            ours = m is not None and m.get_srcSystem() in managers and "mission_type" in m.fieldnames
            if ours and m.target_system == STATION:
                managers[m.get_srcSystem()].take(m)
            for one in managers.values():
                one.look()
        return {sysid: one.read for sysid, one in managers.items()}
    finally:
        link.close()
