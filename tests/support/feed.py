"""A fabricated session, as the session's socket tells it: the same messages for the same moment, on every machine."""

from __future__ import annotations

import math
import queue
from collections.abc import Iterator, Mapping
from typing import Any

PURSUERS = (1, 2, 3, 4, 5)
TARGET, TANKER = 101, 201
DURATION_S = 150.0
HISTORY = [
    {
        "receiver": 2,
        "tanker": TANKER,
        "by": "competition",
        "decided_at_s": 12.0,
        "joined_at_s": 21.5,
        "start_s": 22.0,
        "end_s": 34.9,
        "energy_j": 8120,
        "reason": "full",
    }
]
EVENTS = (
    (0.0, 0, "info", "session", "All 7 vehicles are there"),
    (1.2, 1, "info", "mode", "Takeoff"),
    (12.0, 2, "info", "decision", "Refuelling of 2 by 201 decided by competition"),
    (22.0, 2, "info", "decision", "Transfer from 201 to 2 begun"),
    (34.9, 2, "info", "decision", "Refuelling of 2 by 201 ended: full, 8120 J"),
    (36.0, 0, "info", "operator", "Operator: hold 4"),
    (36.1, 4, "info", "ack", "hold: accepted"),
    (36.2, 4, "info", "mode", "Hold"),
    (38.0, 5, "info", "decision", "Refuelling of 5 by 201 decided by competition"),
    (40.0, 3, "warning", "failsafe", "Failsafe: battery low, return"),
    (44.0, 3, "critical", "text", "Battery 8 %"),
    (46.0, 1, "warning", "link", "No telemetry for 1.5 s"),
    (47.5, 1, "info", "link", "Heard again"),
)
"""(session time in s, system id, level, kind, text)"""


def circle(n: float, e: float, radius: float, corners: int = 24) -> list[list[float]]:
    """A closed outline, NE in m."""
    angles = [2.0 * math.pi * i / corners for i in range(corners + 1)]
    return [[n + radius * math.cos(a), e + radius * math.sin(a)] for a in angles]


def known(sysid: int, role: str, capacity_j: int, path_ned: list[list[float]]) -> dict[str, Any]:
    """What the session message says of a vehicle."""
    named = {"sysid": sysid, "role": role, "label": f"{role} {sysid}"}
    return {**named, "capacity_j": capacity_j, "path_ned": path_ned}


def session(**other: Any) -> dict[str, Any]:
    """What the socket tells first."""
    path = [[6.0 * math.sin(a), 9.0 * math.cos(a) * math.cos(a / 2), -3.0] for a in (0.2618 * i for i in range(25))]
    return {
        "type": "session",
        "name": "demo",
        "folder": "sessions/demo",
        "source": "session",
        "duration_s": DURATION_S,
        "clock": "real",
        "speed": 5.0,
        "control": True,
        "separation_m": 0.6,
        "ring_m": 2.2,
        "vehicles": [
            *(known(s, "pursuer", 24000, []) | {"colour": k} for k, s in enumerate(PURSUERS)),
            known(TARGET, "target", 60000, path) | {"colour": 5},
            known(TANKER, "tanker", 150000, []) | {"colour": 6},
        ],
        "obstacles": [
            {
                "name": name,
                "kind": "cylinder",
                "label": name,
                "outline_ne": circle(n, e, r),
                "centre_ned": [n, e, -3.0],
                "bottom_d": 0.0,
                "top_d": -6.0,
            }
            for name, n, e, r in (("mast", 4.0, 5.0, 0.8), ("silo", -3.0, -6.0, 1.4), ("tree", -4.5, 3.5, 0.6))
        ],
        "bases": [{"name": "home", "p_ned": [-6.5, -9.0, 0.0]}],
        "goal": {"pursue_within_m": 3.5, "pursue_for_s": 20.0, "refuelled_at_least": 3},
    } | other


def _values(t_s: float) -> dict[str, float]:
    """A competition in three rounds of 17 s that 2, 5 and 1 win."""
    v = {}
    for sysid in PURSUERS:
        winner = (2, 5, 1)[int(t_s // 17.0) % 3]
        x = (t_s % 17.0) / 17.0
        v[str(sysid)] = round(0.2 + (0.75 * x if sysid == winner else -0.17 * min(1.0, 1.6 * x)) + 0.01 * sysid, 4)
    return v


def _place(sysid: int, t_s: float) -> tuple[list[float], list[float]]:
    """(position, velocity), NED in m and m/s."""
    w = 0.06
    centre = [5.0 * math.sin(w * t_s), 6.0 * math.cos(w * t_s), -3.0]
    v = [5.0 * w * math.cos(w * t_s), -6.0 * w * math.sin(w * t_s), 0.0]
    if sysid == TARGET:
        return centre, v
    if sysid == TANKER:
        return [centre[0] - 3.2, centre[1] - 4.1, -4.0], v
    angle = 2.0 * math.pi * (sysid - 1) / 5.0
    return [centre[0] + 2.2 * math.cos(angle), centre[1] + 2.2 * math.sin(angle), -3.0 - 0.1 * sysid], v


def vehicle(sysid: int, t_s: float, **other: Any) -> dict[str, Any]:
    """One vehicle of the demo at `t_s`, well."""
    p_ned, v_ned = _place(sysid, t_s)
    role = {TARGET: "target", TANKER: "tanker"}.get(sysid, "pursuer")
    capacity = {TARGET: 60000, TANKER: 150000}.get(sysid, 24000)
    share = max(0.02, 0.95 - 0.004 * t_s - 0.02 * (sysid % 7))
    v = _values(t_s).get(str(sysid))
    return {
        "sysid": sysid,
        "role": role,
        "label": f"{role} {sysid}",
        "alive": True,
        "stage": "fly",
        "mode": "offboard",
        "mode_name": "Offboard",
        "armed": True,
        "landed": False,
        "autopilot": "px4",
        "p_ned": p_ned,
        "v_ned": v_ned,
        "aim_ned": [p_ned[0] + 2.0 * v_ned[0], p_ned[1] + 2.0 * v_ned[1], p_ned[2]],
        "heading_rad": math.atan2(v_ned[1], v_ned[0]),
        "roll_rad": 0.05,
        "pitch_rad": -0.08,
        "speed_m_s": math.hypot(*v_ned),
        "height_m": -p_ned[2],
        "target_m": math.dist(p_ned, _place(TARGET, t_s)[0]) if role == "pursuer" else None,
        "age_s": 0.1,
        "heard_s": 0.4,
        "lost": 0,
        "lost_share": 0.0,
        "battery": share,
        "remaining_j": share * capacity,
        "endurance_s": share * capacity / 120.0,
        "power_w": 118.5,
        "energy_source": "BATTERY_STATUS",
        "v": v,
        "tau": None if v is None else round(1.0 - share, 3),
        "state": "competing" if v is not None else "idle",
        "note": "",
        "trouble": [],
        "severity": 0,
    } | other


def snapshot(t_s: float, *, since_s: float | None = None, **other: Any) -> dict[str, Any]:
    """The demo at `t_s`, with the events after `since_s` (all so far by default)."""
    fleet = {s: vehicle(s, t_s) for s in (*PURSUERS, TARGET, TANKER)}
    v = _values(t_s)
    ranked = sorted(v, key=lambda name: -v[name])
    services = []
    if t_s >= 12.0:
        receiver = 5 if t_s >= 38.0 else 2
        fleet[receiver] |= {"state": "served", "mode": "refuel", "mode_name": "Refuel"}
        fleet[receiver] |= {"note": f"served by {TANKER}: join"}
        fleet[TANKER] |= {"state": "serves", "note": f"serves {receiver}: join"}
        services.append(
            {
                "receiver": receiver,
                "tanker": TANKER,
                "phase": "join",
                "energy_j": 1240,
                "by": "competition",
                "decided_at_s": 38.0,
                "joined_at_s": None,
                "rendezvous_ned": [*(x + 1.5 for x in fleet[receiver]["p_ned"][:2]), -4.0],
                "bids": {name: fleet[int(name)]["tau"] for name in v},
                "why": f"Vehicle {receiver} is refuelled next: its need 0.71 is the largest and it held 93 % of the "
                f"competition for 2 s; tanker {TANKER} meets it in 14 s.",
            }
        )
    if t_s >= 36.2:
        fleet[4] |= {"mode": "hold", "mode_name": "Hold", "trouble": ["held by the operator"], "severity": 1}
    if t_s >= 40.0:
        low = {"battery": 0.08, "remaining_j": 1920.0, "endurance_s": 16.0, "mode": "return", "mode_name": "Return"}
        fleet[3] |= {**low, "trouble": ["battery 8 %", "Return"], "severity": 2, "state": "waits"}
    fleet[int(ranked[0])] |= {"state": "leads"} if fleet[int(ranked[0])]["state"] == "competing" else {}
    after_s = -1.0 if since_s is None else since_s
    return {
        "type": "snapshot",
        "t_s": t_s,
        "duration_s": DURATION_S,
        "speed": 4.98,
        "phase": "flying",
        "vehicles": list(fleet.values()),
        "traffic": [
            {"callsign": "HB-JET", "p_ned": [6.0, -8.0 + 0.2 * t_s, -20.0], "v_ned": [0.0, 0.2, 0.0], "age_s": 0.1}
        ],
        "services": services,
        "competition": {
            "v": v,
            "tau": {name: fleet[int(name)]["tau"] for name in v},
            "leader": int(ranked[0]),
            "share": round(min(0.97, 0.4 + 0.6 * (t_s % 17.0) / 17.0), 3),
            "runner_up": int(ranked[1]),
            "threshold": 0.9,
        },
        "history": HISTORY if t_s >= 34.9 else [],
        "refuelled": 1 if t_s >= 34.9 else 0,
        "goal": {
            "pursue_within_m": 3.5,
            "pursue_for_s": 20.0,
            "pursue_held_s": min(t_s, 12.0),
            "refuelled_at_least": 3,
            "broken": [],
        },
        "events": [
            {"t_s": t, "sysid": s, "level": level, "kind": kind, "text": text}
            for t, s, level, kind, text in EVENTS
            if after_s < t <= t_s
        ],
    } | other


def _told(count: int, rate_hz: float, age_s: float, **fields: Any) -> dict[str, Any]:
    return {"count": count, "rate_hz": rate_hz, "age_s": age_s, "fields": fields}


INSPECTED = {
    "ATTITUDE": _told(482, 10.0, 0.1, time_boot_ms=48200, roll=0.0213, pitch=-0.0107, yaw=1.52, yawspeed=0.02),
    "BATTERY_STATUS": _told(96, 2.0, 0.4, id=0, battery_remaining=71, energy_consumed=68, voltages=[11100, 65535]),
    "HEARTBEAT": _told(51, 1.0, 0.4, type=2, autopilot=12, base_mode=209, custom_mode=393216, system_status=4),
    "LOCAL_POSITION_NED": _told(482, 10.0, 0.1, x=3.25, y=-1.5, z=-3.125, vx=0.31, vy=-0.02, vz=0.0),
}


def flight(until_s: float = 48.2, step_s: float = 0.1) -> Iterator[dict[str, Any]]:
    """The messages of the demo from its start."""
    yield session()
    ticks = round(until_s / step_s)
    for i in range(ticks + 1):
        t_s = round(i * step_s, 3)
        yield snapshot(t_s, since_s=-1.0 if i == 0 else round((i - 1) * step_s, 3))


def crowd(number: int, t_s: float) -> dict[str, Any]:
    """`number` vehicles that fly circles; 77 is dead, 200 has little energy left."""
    fleet = []
    for sysid in range(1, number + 1):
        role = "target" if sysid % 50 == 0 else "tanker" if sysid % 50 == 1 else "pursuer"
        angle = 0.05 * t_s + sysid
        n, e = 10.0 * (sysid % 16) + 3.0 * math.cos(angle), 10.0 * (sysid // 16) + 3.0 * math.sin(angle)
        other: dict[str, Any] = {
            "role": role,
            "label": f"{role} {sysid}",
            "p_ned": [n, e, -3.0],
            "v_ned": [-0.15 * math.sin(angle), 0.15 * math.cos(angle), 0.0],
            "heading_rad": angle + math.pi / 2.0,
            "aim_ned": [n, e, -3.0],
            "target_m": 2.0 + sysid % 7,
            "v": 0.01 + sysid / 1000.0,
            "tau": 0.5,
            "state": "competing",
            "battery": 0.9 - 0.6 * sysid / number,
        }
        fleet.append(vehicle(1, t_s) | {"sysid": sysid} | other)
    fleet[76] |= {"alive": False, "trouble": ["dead"], "severity": 2}
    fleet[199] |= {"battery": 0.11, "trouble": ["battery 11 %"], "severity": 1}
    v = {str(x["sysid"]): x["v"] for x in fleet}
    content = snapshot(t_s, since_s=t_s - 0.1, vehicles=fleet, services=[])
    content["competition"] |= {"v": v, "tau": dict.fromkeys(v, 0.5), "leader": number, "runner_up": number - 1}
    return content


class Fed:
    """A source that hands out what it was given, and keeps what it is told."""

    def __init__(self, *messages: Mapping[str, Any]) -> None:
        self.sent: list[Mapping[str, Any]] = []
        self.connected = True
        self._waiting: queue.SimpleQueue[Mapping[str, Any]] = queue.SimpleQueue()
        self.feed(*messages)

    def feed(self, *messages: Mapping[str, Any]) -> None:
        """Have these handed out at the next call."""
        for message in messages:
            self._waiting.put(message)

    def receive(self) -> list[Mapping[str, Any]]:
        """What was given since the last call."""
        return [self._waiting.get() for _ in range(self._waiting.qsize())]

    def send(self, command: Mapping[str, Any]) -> None:
        """Keep it."""
        self.sent.append(command)

    def close(self) -> None:
        """Remember that."""
        self.connected = False
