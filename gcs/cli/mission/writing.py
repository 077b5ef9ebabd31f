"""Plans on their way to vehicles: what a vehicle has while its plan is written, and where that was refused or ended."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import click

from gcs.link.fleet_client import FleetClient
from gcs.mavlink.codec import Message
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.plans.client import ItemDifference, PlanClient, PlanClients
from gcs.mavlink.plans.items import PlanItem

REFUSED = ("refused", "unsupported")
_ENDS = {"kept": "there already", "uploaded": "written and read back"}


class PlanWriting(PlanClient):
    """The dialogue with one vehicle about one kind of plan, and what is known of the plan that it had."""

    sent = 0
    """items that it has asked for, home among them"""
    had = 0
    """how many items it had before that, home aside"""
    old: tuple[PlanItem, ...] = ()
    """these, where they were read: a plan of another length is only counted"""
    after = ""
    """words on what it has after a refusal"""

    def poll(self, now_s: float) -> list[Message]:
        """Messages to send now."""
        messages = super().poll(now_s)
        if not self.sent:
            self.had, self.old = self.count, self.found or ()
        self.sent = max(self.sent, self._sent)
        return messages

    @property
    def all_there(self) -> bool:
        """Whether it has every item that was written, though it has not kept all numbers."""
        items = self.items or ()
        if self.outcome != "differs" or not self.has_count(items):
            return False
        # where another station was at work as well, it may be no plan of ours
        return not self._others and all(one.difference.name != "command" for one in self.compare(items))

    @property
    def not_kept(self) -> list[ItemDifference]:
        """Differences between the given and the kept plan; unexpected ones before the autopilot's known habits."""
        if not self.all_there:
            return self.lost
        return sorted(self.compare(self.items or ()), key=lambda one: one.difference.lost)

    @property
    def so_far(self) -> str:
        """Words on what it has, as far as is known, where the dialogue is broken off."""
        items = self.items or ()
        sent, whole = max(self.sent - self._home, 0), self.expected(items)
        if self.outcome is not None:
            return _ENDS.get(self.outcome, self.outcome)
        if not self._writes:
            return "as it was"
        if not items:
            return "it was asked to clear it, and not read back"
        if self.sent < len(items):
            return f"{sent} of {whole} items were sent, and may be in the place of old ones"
        return f"all {whole} items were sent, and not read back"

    def compare_after(self, now: PlanClient) -> str:
        """Words on what it has after a refusal, by a reading since."""
        if now.outcome != "read":
            return f"what it has now could not be read: {now.why}"
        known = self.expected(self.old) == self.had
        if known and now.has_count(self.old) and not now.compare(self.old):
            return f"it still has its old plan, {_items(self.had)}" if self.had else "it has none, as before"
        items = self.items or ()
        differing = {one.number for one in now.compare(items) if not one.difference.lost}
        as_given = min(now.count, self.expected(items)) - len(differing)
        has = f"it has {_items(now.count)} now, {as_given} as in the file, and had {self.had} before"
        return f"its plan is changed: {has}" if self.had and (known or now.count != self.had) else has


class _ReadingAfter(PlanClient):
    """A reading after a refusal. The vehicle has asked for items of this kind, so it takes such plans: a refusal that
    comes now is the same one again, or passes."""

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if name != "MISSION_ACK":
            super().receive(name, content, now_s)


Writings = Mapping[int, Mapping[str, PlanWriting]]
"""Dialogues by system id and part."""


def read_after_refusals(fleet: FleetClient, found: Writings, station: tuple[int, int], at_once: int) -> None:
    """Read what vehicles have that refused a plan under way. MAVLink wants the old one to stay until the new one is
    whole, but an ArduPilot puts each item in an old one's place as it comes (MissionItemProtocol.cpp)."""
    vehicles = []
    for sysid, clients in found.items():
        refused = [one for one in clients.values() if one.outcome in REFUSED and one.sent]
        readers = [
            _ReadingAfter(sysid, AUTOPILOT, one.kind, None, fleet.profiles[sysid].plans, station=station)
            for one in refused
        ]
        if readers:
            vehicles.append((PlanClients(readers), refused))
    fleet.converse([readings for readings, _ in vehicles], at_once=at_once)
    for readings, refused in vehicles:
        for now, one in zip(readings.clients, refused, strict=True):
            one.after = one.compare_after(now)


def say_interrupted(found: Writings) -> None:
    """Say what vehicles have where Ctrl-C ends the writing of their plans."""
    by_words: dict[str, list[str]] = {}
    for sysid, clients in found.items():
        for part, client in clients.items():
            if client.items is not None:
                by_words.setdefault(client.so_far, []).append(f"vehicle {sysid} {part}")
    if by_words:
        click.echo(f"gcs: interrupted: {'; '.join(_clauses(by_words.items()))}", err=True)


def _clauses(rows: Iterable[tuple[str, list[str]]]) -> Iterable[str]:
    return (f"{', '.join(names)}: {words}" for words, names in rows)


def _items(count: int) -> str:
    return f"{count} item{'s' * (count != 1)}"
