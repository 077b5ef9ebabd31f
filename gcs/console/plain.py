"""A session as lines of text: what happened, how far it is, how it ended. Pure functions, and views built on them."""

from __future__ import annotations

import json
import os
from collections import Counter, deque
from collections.abc import Callable, Container, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

Snapshot = Mapping[str, Any]
"""A message of type "snapshot"; its `events` are those since the snapshot before it."""

PROGRESS_EVERY_S = 2.0
JSON_EVERY_S = 1.0
RECENT_EVENTS = 1000
EXPLAINED_WITHIN_S = 2.0
"""A vehicle that announced something this recently (session time) has explained its own change of mode."""


def clean(text: object) -> str:
    """Text from a vehicle or a file, on one line and without what a terminal would act upon."""
    return "".join(letter if letter.isprintable() else " " for letter in str(text))


def name_of(snapshot: Snapshot, sysid: int | None) -> str:
    """`pursuer 5`; the supervisor's own events carry no vehicle's id."""
    for vehicle in snapshot["vehicles"]:
        if vehicle["sysid"] == sysid:
            return clean(vehicle["label"])
    return "traffic" if sysid == 255 else f"vehicle {sysid}" if sysid else "supervisor"


def giver_of(snapshot: Snapshot, service: Mapping[str, Any]) -> str:
    """`tanker 201`, or `base pad`."""
    base = service.get("base")
    return name_of(snapshot, service["tanker"]) if base is None else f"base {clean(base)}"


def minutes(duration_s: float | None) -> str:
    """`1:21` for 81 s; `-` for unknown."""
    if duration_s is None:
        return "-"
    whole = max(0, int(duration_s))
    return "99+" if whole >= 5940 else f"{whole // 60}:{whole % 60:02d}"


def told(snapshot: Snapshot, event: Mapping[str, Any]) -> str:
    """An event with the name of whom it concerns in front, unless its text begins with that."""
    who, text = name_of(snapshot, event.get("sysid")), clean(event["text"])
    return text if text.startswith(who) else f"{who}: {text}"


def worth_a_line(event: Mapping[str, Any]) -> bool:
    """Whether lines of text tell of an event: modes they read off the vehicles, and what is granted goes unsaid."""
    kind = event.get("kind")
    return kind not in ("mode", "failsafe") and (kind != "ack" or event["level"] != "info")


def goal_parts(snapshot: Snapshot) -> list[tuple[str, float, float, str]]:
    """(what, how much, of how much, unit) for each part of the session's goal."""
    goal = snapshot["goal"]
    parts = []
    if goal.get("pursue_for_s") is not None:
        parts.append(("pursuit", float(goal.get("pursue_held_s") or 0.0), float(goal["pursue_for_s"]), " s"))
    if goal.get("refuelled_at_least"):
        parts.append(("refuelled", float(snapshot["refuelled"]), float(goal["refuelled_at_least"]), ""))
    return parts


def counts(vehicles: Sequence[Mapping[str, Any]]) -> str:
    """`5 offboard, 1 refuel`: how many are in which mode, the commonest first."""
    kinds = Counter("dead" if not v["alive"] else v["mode"] if v["armed"] else "disarmed" for v in vehicles)
    return ", ".join(f"{number} {clean(kind)}" for kind, number in sorted(kinds.items(), key=lambda item: -item[1]))


def progress(snapshot: Snapshot) -> str:
    """One line: time, speed, modes, lowest battery, goal."""
    whole = "" if snapshot["duration_s"] is None else f" of {snapshot['duration_s']:.0f} s"
    parts = [f"{_stamp(snapshot['t_s'])}{whole}", f"x{snapshot['speed']:.2f}"]
    parts += [clean(snapshot["phase"]), counts(snapshot["vehicles"])]
    known = [v for v in snapshot["vehicles"] if v["alive"] and v["battery"] is not None]
    if known:
        lowest = min(known, key=lambda v: v["battery"])
        parts.append(f"lowest battery {100.0 * lowest['battery']:.0f} % ({clean(lowest['label'])})")
    for what, have, need, unit in goal_parts(snapshot):
        parts.append(f"{what} {have:.0f}/{need:.0f}{unit}")
    return " | ".join(part for part in parts if part)


def news(previous: Snapshot | None, snapshot: Snapshot, recent: Iterable[Mapping[str, Any]] = ()) -> list[str]:
    """One line for each thing that happened between two snapshots; `recent` are the events before these.

    Events come first, then what the vehicles' states show and no event of theirs has just said, then refuelling.
    """
    lines = []
    for event in snapshot["events"]:
        level = "" if event["level"] == "info" else f"{event['level'].upper()}: "
        lines.append(f"{_stamp(event['t_s'])} {level}{told(snapshot, event)}")
    if previous is not None:
        now = _stamp(snapshot["t_s"])
        since_s = previous["t_s"] - EXPLAINED_WITHIN_S
        explained = {event.get("sysid") for event in (*recent, *snapshot["events"]) if event["t_s"] >= since_s}
        lines += [f"{now} {line}" for line in _vehicle_news(previous, snapshot, explained)]
        lines += [f"{now} {line}" for line in _service_news(previous, snapshot, explained)]
    return lines


def _vehicle_news(previous: Snapshot, snapshot: Snapshot, explained: Container[int | None]) -> list[str]:
    before = {vehicle["sysid"]: vehicle for vehicle in previous["vehicles"]}
    lines = []
    for vehicle in snapshot["vehicles"]:
        old = before.get(vehicle["sysid"])
        if old is None or vehicle["sysid"] in explained:
            continue
        if old["alive"] and not vehicle["alive"]:
            lines.append(f"CRITICAL: {clean(vehicle['label'])}: died")
        elif old["mode"] != vehicle["mode"]:
            lines.append(f"{clean(vehicle['label'])}: {clean(old['mode'])} -> {clean(vehicle['mode'])}")
    return lines


def _service_news(previous: Snapshot, snapshot: Snapshot, explained: Container[int | None]) -> list[str]:
    before, after = _services(previous), _services(snapshot)
    lines = []
    for receiver, giver in sorted({*before, *after}):
        old, new = before.get((receiver, giver)), after.get((receiver, giver))
        if receiver in explained:
            continue
        who = f"refuelling {name_of(snapshot, receiver)} <- {giver}"
        if old is None and new is not None:
            lines.append(f"{who}: {clean(new['phase'])} (by {clean(new['by'])})")
        elif new is None and old is not None:
            lines.append(f"{who}: over, at least {old['energy_j']:.0f} J given")
        elif old is not None and new is not None and old["phase"] != new["phase"]:
            lines.append(f"{who}: {clean(new['phase'])}")
    return lines


def _services(snapshot: Snapshot) -> dict[tuple[int, str], Mapping[str, Any]]:
    return {(service["receiver"], giver_of(snapshot, service)): service for service in snapshot["services"]}


def _stamp(t_s: float) -> str:
    return f"{t_s:7.1f} s"


def _giver(service: Mapping[str, Any]) -> str:
    return f"by {service['tanker']}" if service.get("base") is None else f"at base {clean(service['base'])}"


def farewell(summary: Mapping[str, Any] | None, outcome: str | None, folder: Path) -> list[str]:
    """How the session ended, for a person; `summary` is None where none was written."""
    lines = [f"outcome: {clean(outcome or (summary or {}).get('outcome') or 'none')}"]
    if summary is not None:
        if lost := [f"{v['role']} {v['sysid']}" for v in summary["vehicles"] if v["final_mode"] == "dead"]:
            lines.append(f"lost: {clean(', '.join(lost))}")
        done = [r for r in summary["refuelling"] if r["energy_j"] > 0]
        order = ", ".join(f"{r['receiver']} {_giver(r)} ({r['energy_j']:.0f} J, {r['by']})" for r in done)
        lines.append(f"refuelled: {order or 'nobody'}")
        lines.append(f"minimum separation: {_metres(summary['min_separation_m'])}")
        lines.append(f"minimum clearance: {_metres(summary['min_clearance_m'])}")
        flown = f"{summary['sim_time_s']:.1f} s flown in {summary['wall_time_s']:.1f} s"
        late = f", {summary['lag_s']:.1f} s behind its pace" if summary["lag_s"] >= 0.1 else ""
        lines.append(f"speed: {summary['speed_achieved']:.2f} ({flown}{late})")
        if summary["digest"]:
            lines.append(f"digest: {summary['digest']}")
    lines.append(f"session: {folder}")
    return lines


def _metres(value: float | None) -> str:
    return "-" if value is None else f"{value:.2f} m"


def mute_stdout() -> None:
    """Nobody can be told any more: what is still written to stdout goes nowhere, and is no error."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.close(null)


class QuietView:
    """Shows nothing."""

    def show(self, snapshot: Any) -> None:
        """Nothing."""

    def tick(self, now_s: float) -> None:
        """Nothing."""

    def close(self) -> None:
        """Nothing."""


class PlainView:
    """What happened as it happens, and a line of progress every two seconds of wall time."""

    def __init__(self, write: Callable[[str], object]) -> None:
        self._write = write
        self._recent: deque[Mapping[str, Any]] = deque(maxlen=RECENT_EVENTS)
        self._last: Snapshot | None = None
        self._told: Snapshot | None = None
        self._told_s = -PROGRESS_EVERY_S

    def show(self, snapshot: Snapshot) -> None:
        """Take in the newest state."""
        snapshot = {**snapshot, "events": [event for event in snapshot["events"] if worth_a_line(event)]}
        for line in news(self._last, snapshot, self._recent):
            self._write(line)
        self._recent.extend(snapshot["events"])
        self._last = snapshot

    def tick(self, now_s: float) -> None:
        """Write the line that is due at wall time `now_s`."""
        if self._last is not None and now_s - self._told_s >= PROGRESS_EVERY_S:
            self._tell(now_s)

    def close(self) -> None:
        """Write how far it got."""
        if self._last is not self._told:
            self._tell(self._told_s)

    def _tell(self, now_s: float) -> None:
        assert self._last is not None
        self._write(progress(self._last))
        self._told, self._told_s = self._last, now_s


class JsonView:
    """The newest snapshot as one line of JSON every second of wall time, and the last one; no event is left out."""

    def __init__(self, write: Callable[[str], object]) -> None:
        self._write = write
        self._waiting: Snapshot | None = None
        self._told_s = -JSON_EVERY_S

    def show(self, snapshot: Snapshot) -> None:
        """Take in the newest state."""
        events = [*(self._waiting["events"] if self._waiting else ()), *snapshot["events"]]
        self._waiting = {**snapshot, "events": events}

    def tick(self, now_s: float) -> None:
        """Write the snapshot that is due at wall time `now_s`."""
        if self._waiting is not None and now_s - self._told_s >= JSON_EVERY_S:
            self.close()
            self._told_s = now_s

    def close(self) -> None:
        """Write the last snapshot."""
        if self._waiting is not None:
            self._write(json.dumps(self._waiting))
        self._waiting = None
