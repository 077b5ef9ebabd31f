"""A session as lines of text: what happened, how far it is, how it ended; views built on them, and `gcs run`'s log."""

from __future__ import annotations

import contextlib
import json
import math
import os
import select
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from gcs.processes.startup import STARTING_LINE
from gcs.scenario.goal import Nearest, metres, outcome_text, progress_text

Snapshot = Mapping[str, Any]
"""A message of type "snapshot"; its `events` are those since the snapshot before it."""

SESSION_LOG = "session.log"
NOT_MET = "not met: "
"""How the outcome begins of a goal that was not met."""
PROGRESS_EVERY_S = 2.0
SILENT_S = 4.0
"""[choice] A session that has sent no state for so long may be stopped, or waits for a vehicle."""
JSON_EVERY_S = 1.0
FAREWELL_WIDTH = 80
REPORTED_OFF_M = 0.01
"""Difference from what vehicles reported above which both figures are printed."""
EXPLAINED_WITHIN_S = 2.0
"""A vehicle that announced something this recently (session time) has explained its own change of mode."""


def clean(text: object) -> str:
    """Text from a vehicle or a file, on one line and without what a terminal would act upon."""
    return "".join(letter if letter.isprintable() else " " for letter in str(text))


def name_of(snapshot: Snapshot, sysid: int | None) -> str:
    """`pursuer 5`; the session's own events carry no vehicle's id."""
    for vehicle in snapshot["vehicles"]:
        if vehicle["sysid"] == sysid:
            return clean(vehicle["label"])
    return unnamed(sysid)


def unnamed(sysid: int | None) -> str:
    """Words for a source without a label."""
    return "traffic" if sysid == 255 else f"vehicle {sysid}" if sysid else "session"


def minutes(duration_s: float | None) -> str:
    """`1:21` for 81 s; `-` for unknown."""
    if duration_s is None:
        return "-"
    whole = max(0, int(duration_s))
    return "99+" if whole >= 5940 else f"{whole // 60}:{whole % 60:02d}"


def event_text(snapshot: Snapshot, event: Mapping[str, Any]) -> str:
    """An event with the name of its vehicle in front, unless its text begins with that."""
    who, text = name_of(snapshot, event.get("sysid")), clean(event["text"])
    return text if text.startswith(who) else f"{who}: {text}"


def goal_parts(goal: Mapping[str, Any], refuelled: int) -> list[tuple[str, float, float, str]]:
    """(what, how much, of how much, both for a person) for each part of the session's goal that is gathered."""
    parts = []
    if goal.get("pursue_for_s") is not None:
        have, need = float(goal.get("pursue_held_s") or 0.0), float(goal["pursue_for_s"])
        parts.append(("pursuit", have, need, progress_text(have, need, " s")))
    if goal.get("refuelled_at_least"):
        have, need = float(refuelled), float(goal["refuelled_at_least"])
        parts.append(("refuelled", have, need, progress_text(have, need, "")))
    return parts


def broken_text(goal: Mapping[str, Any]) -> str:
    """`not met: separation 0.02 m (3 and 5 at 12.4 s)` once that cannot be cured any more; else empty."""
    broken = [clean(part["text"]) for part in goal.get("broken") or ()]
    return outcome_text(broken) if broken else ""


def counts(vehicles: Sequence[Mapping[str, Any]]) -> str:
    """`5 Offboard, 1 Refuel`: how many are in which mode, the commonest first."""
    kinds = Counter("dead" if not v["alive"] else v["mode_name"] if v["armed"] else "disarmed" for v in vehicles)
    return ", ".join(f"{number} {clean(kind)}" for kind, number in sorted(kinds.items(), key=lambda item: -item[1]))


def progress(snapshot: Snapshot) -> str:
    """One line: time, speed, modes, how many are silent so that modes and batteries are old, lowest battery, goal."""
    whole = "" if snapshot["duration_s"] is None else f" of {snapshot['duration_s']:.0f} s"
    parts = [f"{_stamp(snapshot['t_s'])}{whole}"]
    if snapshot["speed"] is not None:
        parts.append(f"x{snapshot['speed']:.2f}")
    parts += [clean(snapshot["phase"]), counts(snapshot["vehicles"]) or "no vehicle yet"]
    if silent := sum(v.get("condition") == "silent" for v in snapshot["vehicles"]):
        parts.append(f"{silent} silent")
    known = [v for v in snapshot["vehicles"] if v["alive"] and v["battery"] is not None]
    if known:
        lowest = min(known, key=lambda v: v["battery"])
        parts.append(f"lowest battery {100.0 * lowest['battery']:.0f} % ({clean(lowest['label'])})")
    parts += [f"{what} {text}" for what, _, _, text in goal_parts(snapshot["goal"], snapshot["refuelled"])]
    parts.append(broken_text(snapshot["goal"]))
    return " | ".join(part for part in parts if part)


class EventLines:
    """One line for each event that a person should see. Events alone decide: how often snapshots come does not.

    What is granted goes unsaid, and so does a change of mode that its vehicle has just announced itself.
    """

    def __init__(self) -> None:
        self._said_s: dict[int | None, float] = {}

    def lines(self, snapshot: Snapshot) -> list[str]:
        """Lines of a snapshot's events."""
        return [_line(snapshot, event) for event in snapshot["events"] if self._worth_a_line(event)]

    def _worth_a_line(self, event: Mapping[str, Any]) -> bool:
        kind, sysid, t_s = event.get("kind"), event.get("sysid"), float(event["t_s"])
        if kind == "ack" and event["level"] == "info":
            return False
        if kind in ("mode", "failsafe") and 0.0 <= t_s - self._said_s.get(sysid, -math.inf) <= EXPLAINED_WITHIN_S:
            return False
        self._said_s[sysid] = t_s
        return True


def _line(snapshot: Snapshot, event: Mapping[str, Any]) -> str:
    level = "" if event["level"] == "info" else f"{event['level'].upper()}: "
    return f"{_stamp(event['t_s'])} {level}{event_text(snapshot, event)}"


def _stamp(t_s: float) -> str:
    return f"{t_s:7.1f} s"


def _giver(service: Mapping[str, Any]) -> str:
    return f"by {service['tanker']}" if service.get("base") is None else f"at base {clean(service['base'])}"


def farewell(summary: Mapping[str, Any] | None, outcome: str | None, folder: Path) -> list[str]:
    """Result of the session, for a person; `summary` is None where none was written."""
    known = summary or {}
    lines = [outcome_line(outcome or known.get("outcome"), known.get("outcome_text"))]
    if summary is not None:
        if lost := _losses(summary):
            lines.append(f"lost: {clean(lost)}")
        done = [r for r in summary["refuelling"] if r["energy_j"] > 0]
        order = [
            f"{r['receiver']} {_giver(r)} ({r['energy_j']:.0f} J, {r['by']}{', not ended' * (r['end_s'] is None)})"
            for r in done
        ]
        lines += _listed("refuelled: ", order or ["none"])
        lines += [_closest(summary, name) for name in ("separation", "clearance", "traffic")]
        lines = [line for line in lines if line]
        flown = f"{summary['sim_time_s']:.1f} s flown in {summary['wall_time_s']:.1f} s"
        late = f", {summary['lag_s']:.1f} s behind its pace" if summary["lag_s"] >= 0.1 else ""
        lines.append(f"speed: {summary['speed_achieved']:.2f} ({flown}{late})")
        if summary["digest"]:
            lines.append(f"digest: {summary['digest']}")
    lines.append(f"session: {folder}")
    return lines


def shortfalls(summary: Mapping[str, Any] | None, outcome: str | None) -> list[str]:
    """Those lines of `farewell` that say what went wrong: the goal not met, and losses that it allows."""
    known = summary or {}
    line = outcome_line(outcome or known.get("outcome"), known.get("outcome_text"))
    lost = _losses(summary) if summary is not None else ""
    return [line] * line.startswith(NOT_MET) + [f"lost: {clean(lost)}"] * bool(lost)


def _losses(summary: Mapping[str, Any]) -> str:
    """Vehicles lost that the outcome does not name: as many as the goal allows; the dead where it was not judged."""
    judged = next((part for part in summary.get("goal") or () if part["part"] == "lost"), {"met": None})
    if judged["met"] is None:
        return ", ".join(f"{v['role']} {v['sysid']}" for v in summary["vehicles"] if v["final_mode"] == "dead")
    return str(judged["reached"]) if judged["met"] and judged["value"] else ""


def outcome_line(outcome: str | None, text: str | None) -> str:
    """`outcome: met`, or `not met: ` and why; the bare name of a part is never shown."""
    text = clean(text or "")
    if text.startswith(NOT_MET):
        return text
    return f"outcome: {text or clean(outcome or 'none')}"


def _closest(summary: Mapping[str, Any], name: str) -> str:
    """`minimum separation: 0.85 m (3 and 5 at 12.4 s)`; by truth with what was reported beside it where they differ."""
    key = f"min_{name}_m"
    value, believed = summary.get(key), summary.get(f"believed_{key}")
    if value is None:
        return "" if name == "traffic" else f"minimum {name}: -"
    limit = next((part["limit"] for part in summary.get("goal") or () if part["part"] == name), -math.inf)
    who = (summary.get("closest") or {}).get(name)
    text = f"minimum {name}: {metres(value, limit)}"
    if who:
        text += f" ({Nearest(value, tuple(who['sysids']), who['t_s'], clean(who['what'])).who})"
    if believed is not None and abs(believed - value) >= REPORTED_OFF_M:
        text += f"; reported: {metres(believed, limit)}"
    return text


def _listed(title: str, parts: Sequence[str]) -> list[str]:
    """The parts behind their title, in lines that a terminal of 80 columns need not break."""
    lines, margin = [title + parts[0]], " " * len(title)
    for part in parts[1:]:
        lines[-1] += ","
        if len(lines[-1]) + len(part) + 2 < FAREWELL_WIDTH:
            lines[-1] += f" {part}"
        else:
            lines.append(margin + part)
    return lines


def mute(descriptor: int) -> None:
    """Discard further output: what is still written to this descriptor goes nowhere, and is no error."""
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, descriptor)
    os.close(null)


def mute_gone() -> None:
    """Discard further output to standard output and error where their terminal, or their reader, is gone."""
    poll = select.poll()
    for descriptor in (1, 2):
        poll.register(descriptor, 0)
    for descriptor, _ in poll.poll(0):
        mute(descriptor)


class View:
    """Shows snapshots as they come; by itself nothing of them."""

    def show(self, snapshot: Any) -> None:
        """Take in the newest state."""

    def tick(self, now_s: float) -> None:
        """Show what is due at wall time `now_s`."""

    def close(self) -> None:
        """Show the last state and let go of the screen."""


class PlainView(View):
    """Events as they happen, and a line of progress every two seconds of wall time."""

    def __init__(self, write: Callable[[str], object]) -> None:
        self._write = write
        self._event_lines = EventLines()
        self._last: Snapshot | None = None
        self._printed: Snapshot | None = None
        self._printed_s = -PROGRESS_EVERY_S
        self._begun_s: float | None = None
        self._seen: Snapshot | None = None
        self._seen_s = 0.0
        """the newest state at the last `tick`, and since when it has been that"""

    def show(self, snapshot: Snapshot) -> None:
        """Take in the newest state."""
        for line in self._event_lines.lines(snapshot):
            self._write(line)
        self._last = snapshot

    def tick(self, now_s: float) -> None:
        """Write the line that is due at wall time `now_s`."""
        if self._last is not self._seen:
            self._seen, self._seen_s = self._last, now_s
        if self._last is not None and self._last is self._printed and now_s - self._seen_s >= SILENT_S:
            if now_s - self._printed_s >= PROGRESS_EVERY_S:
                self._write(f"the session has said nothing for {now_s - self._seen_s:.0f} s")
                self._printed_s = now_s
        elif self._last is not None and now_s - self._printed_s >= PROGRESS_EVERY_S:
            self._print_progress(now_s)
        elif self._last is None and self._begun_s is None:
            self._begun_s = now_s
        elif self._last is None and now_s - (self._begun_s or 0.0) >= PROGRESS_EVERY_S:
            self._write(STARTING_LINE)
            self._begun_s = math.inf

    def close(self) -> None:
        """Write how far it got."""
        if self._last is not self._printed:
            self._print_progress(self._printed_s)

    def _print_progress(self, now_s: float) -> None:
        assert self._last is not None
        self._write(progress(self._last))
        self._printed, self._printed_s = self._last, now_s


class VerboseView(PlainView):
    """The plain view, with a line for each vehicle under each line of progress."""

    def _print_progress(self, now_s: float) -> None:
        super()._print_progress(now_s)
        assert self._last is not None
        for vehicle in self._last["vehicles"]:
            self._write(_vehicle_line(vehicle))


def _vehicle_line(vehicle: Mapping[str, Any]) -> str:
    n, e, d = vehicle["p_ned"] or (None, None, None)
    high, percent = None if d is None else 0.0 - d, None if vehicle["battery"] is None else 100.0 * vehicle["battery"]
    state = vehicle["mode_name"] if vehicle["alive"] else "dead"
    line = f"{'':12}{clean(vehicle['label']):<12} {clean(state):<9} N {_column(n, 7)}  E {_column(e, 7)}"
    line += f"  {_column(high, 6)} m high  {_column(vehicle['speed_m_s'], 5)} m/s  {_column(percent, 5, 1)} %"
    return f"{line}  {clean(vehicle['note'])}".rstrip()


def _column(value: float | None, width: int, decimals: int = 2) -> str:
    return f"{'-':>{width}}" if value is None else f"{value:{width}.{decimals}f}"


class JsonView(View):
    """The newest snapshot as one line of JSON every second of wall time, and the last one; no event is left out."""

    def __init__(self, write: Callable[[str], object]) -> None:
        self._write = write
        self._waiting: Snapshot | None = None
        self._printed_s = -JSON_EVERY_S

    def show(self, snapshot: Snapshot) -> None:
        """Take in the newest state."""
        events = [*(self._waiting["events"] if self._waiting else ()), *snapshot["events"]]
        self._waiting = {**snapshot, "events": events}

    def tick(self, now_s: float) -> None:
        """Write the snapshot that is due at wall time `now_s`."""
        if self._waiting is not None and now_s - self._printed_s >= JSON_EVERY_S:
            self.close()
            self._printed_s = now_s

    def close(self) -> None:
        """Write the last snapshot."""
        if self._waiting is not None:
            self._write(json.dumps(self._waiting))
        self._waiting = None


class _Both(View):
    def __init__(self, shown: View, kept: View) -> None:
        self._shown, self._kept = shown, kept

    def show(self, snapshot: Any) -> None:
        self._kept.show(snapshot)
        self._shown.show(snapshot)

    def tick(self, now_s: float) -> None:
        self._kept.tick(now_s)
        self._shown.tick(now_s)

    def close(self) -> None:
        self._kept.close()
        self._shown.close()


@contextlib.contextmanager
def logged(view: View, echo: Callable[[str], object], folder: Path) -> Iterator[tuple[View, Callable[[str], object]]]:
    """The view and the teller, all of it also written to FOLDER/session.log as lines; a full disk ends only that."""
    try:
        log = (folder / SESSION_LOG).open("w", encoding="utf-8", buffering=1, errors="replace")
    except OSError:
        yield view, echo
        return

    def keep(line: str) -> None:
        with contextlib.suppress(OSError):
            log.write(line + "\n")

    def both(line: str) -> None:
        keep(line)
        echo(line)

    try:
        yield _Both(view, PlainView(keep)), both
    finally:
        with contextlib.suppress(OSError):  # closing tries once more to write what a full disk has not taken
            log.close()
