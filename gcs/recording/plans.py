"""Missions, fences and rally points in a recording, each from the time on at which its vehicle had it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from typing import Any, NamedTuple

import numpy as np

from gcs.mavlink import codec
from gcs.mavlink.autopilots import profile_of
from gcs.mavlink.codec import Frame
from gcs.mavlink.ids import AUTOPILOT, STATION
from gcs.missions.items import MissionPlan, joined
from gcs.missions.transfers import MESSAGES, Held, Transfers, plan_of
from gcs.recording.tlog_walk import COMPID, MSGID, SYSID, Chunk, raw_at
from skytender import mavlink as mav

_HEARTBEAT, _HOME = codec.msgid("HEARTBEAT"), codec.msgid("HOME_POSITION")
_WANTED = np.array([_HOME, *map(codec.msgid, MESSAGES)])


class HeldPlan(NamedTuple):
    """All that some vehicles have by a time, each the same: mission, fence and rally points."""

    sysids: tuple[int, ...]
    plan: MissionPlan
    home_alt_m: float | None
    """altitude above the sea of the vehicles' home, where it is known"""


class RecordedPlans:
    """Plans of a recording's vehicles; times are s since its zero."""

    def __init__(
        self, held: Sequence[Held], homes: Sequence[tuple[float, int, float]], ardupilots: AbstractSet[int]
    ) -> None:
        """homes: (time, system id, altitude in m). ardupilots: vehicles whose item 0 is home."""
        self._held = [(one.t_s, one.sysid, one.kind, plan_of(one, has_home=one.sysid in ardupilots)) for one in held]
        self._homes = homes

    def at(self, t_s: float) -> list[HeldPlan]:
        """Plans that vehicles have at a time, in the order of system ids."""
        found: dict[int, dict[int, MissionPlan]] = {}
        for since_s, sysid, kind, plan in self._held:
            if since_s <= t_s:
                found.setdefault(sysid, {})[kind] = plan
        homes = {sysid: alt_m for since_s, sysid, alt_m in self._homes if since_s <= t_s}
        alike: dict[str, HeldPlan] = {}
        for sysid, of in sorted(found.items()):
            plan, home_alt_m = joined(of.values()), homes.get(sysid)
            if not plan.empty:
                key = repr((plan, home_alt_m if plan.mission or plan.rally else None))
                others = alike[key].sysids if key in alike else ()
                alike[key] = HeldPlan((*others, sysid), plan, home_alt_m)
        return list(alike.values())

    def next_change_s(self, t_s: float) -> float:
        """Time after `t_s` at which the answer of `at` changes next; infinite where it does no more."""
        times_s = [one[0] for one in self._held] + [one[0] for one in self._homes]
        return min((since_s for since_s in times_s if since_s > t_s), default=math.inf)


class PlansReader:
    """Reads the plans out of a recording that another reader walks: `add` each stretch of it, ask at its end."""

    def __init__(self) -> None:
        self._held: list[Held] = []
        self._transfers = Transfers(self._held.append)
        self._stations: set[tuple[int, int]] = {STATION}
        self._known: set[tuple[int, int]] = set()
        self._ardupilots: set[int] = set()
        self._homes: list[tuple[float, int, float]] = []
        self._latest_s = 0.0

    def add(self, chunk: Chunk) -> None:
        """Take in the next stretch."""
        heads = chunk.heads
        data: bytes | None = None
        wanted = np.isin(heads[:, MSGID], _WANTED)
        beats = heads[heads[:, MSGID] == _HEARTBEAT]
        _, first = np.unique(beats[:, SYSID] << 8 | beats[:, COMPID], return_index=True)
        for _, at, sysid, compid, seq, msgid in beats[
            first
        ].tolist():  # also of a station that uploads before its HEARTBEAT
            if (sysid, compid) not in self._known:
                data = data or chunk.octets.tobytes()
                self._meet((sysid, compid), codec.fields(Frame(sysid, compid, seq, msgid, raw_at(data, at))))
        for t_us, at, sysid, compid, seq, msgid in heads[wanted].tolist():
            data = data or chunk.octets.tobytes()
            self._latest_s = max(self._latest_s, t_us / 1e6)
            self._take(Frame(sysid, compid, seq, msgid, raw_at(data, at)))

    def plans(self, zero_s: float) -> RecordedPlans:
        """Everything found, with times since `zero_s` of the stamps, s since 1970."""
        held = sorted([*self._held, *self._transfers.incomplete()], key=lambda one: one.t_s)
        homes = [(since_s - zero_s, sysid, alt_m) for since_s, sysid, alt_m in self._homes]
        return RecordedPlans([one._replace(t_s=one.t_s - zero_s) for one in held], homes, self._ardupilots)

    def _meet(self, sender: tuple[int, int], content: Any) -> None:
        self._known.add(sender)
        if content.type == mav.MAV_TYPE_GCS:
            self._stations.add(sender)
        elif profile_of(content.autopilot).plans.begin_with_home:
            self._ardupilots.add(sender[0])

    def _take(self, frame: Frame) -> None:
        content, sysid, t_s = codec.fields(frame), frame.sysid, self._latest_s
        if frame.msgid == _HOME:
            alt_m = content.altitude / 1e3
            if next((known for _, one, known in reversed(self._homes) if one == sysid), None) != alt_m:
                self._homes.append((t_s, sysid, alt_m))
            return
        itself = content.target_system == sysid and frame.compid != AUTOPILOT
        from_vehicle = (sysid, frame.compid) not in self._stations and not itself
        self._transfers.receive(codec.name(frame.msgid), content, sysid, t_s, from_vehicle=from_vehicle)
