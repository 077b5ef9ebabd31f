"""Record of one tick: frames in and out, decisions for decisions.jsonl, and the events made of them."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from gcs.recording.decision_lines import Decisions, TickSetPoints
from gcs.refuelling.explain import sentence
from gcs.scenario.guard import PluginFault
from gcs.telemetry.events import Event, Level, level_of
from skytender.mavlink import command_name

if TYPE_CHECKING:  # readers of records need not load their makers
    from gcs.mavlink.setpoints import SetPoint
    from gcs.recording.digest import Digest
    from gcs.recording.recorder import Recorder
    from gcs.refuelling.bidding import CompetitionState
    from gcs.refuelling.service import Decision
    from gcs.telemetry.battery_account import Fact


QUIET = frozenset({"competition", "set_point", "steered", "inject", "program", "planned", "chosen"})
"""Kinds of decision that are no event."""


@dataclass
class TickRecord:
    """Records of one tick, kept until the grants are out."""

    t_ms: int
    arrived: Sequence[bytes]
    sent: Sequence[bytes]
    decisions: Decisions
    late: Sequence[bytes] = ()
    """frames that external vehicles sent until `late_ms` after the tick's time"""
    late_ms: int = 0

    @property
    def received(self) -> Sequence[bytes]:
        """All frames that arrived."""
        return [*self.arrived, *self.late] if self.late else self.arrived

    def write(self, recorder: Recorder, digest: Digest, epoch_us: int) -> None:
        """Record and hash it; `epoch_us` is session time 0 in µs since 1970, UTC.

        The system has all of it then: a supervisor that is killed loses nothing but the tick that it was at.
        """
        t_us = epoch_us + 1000 * self.t_ms
        recorder.frames(t_us, self.arrived, self.sent)
        if self.late:
            recorder.frames(t_us + 1000 * self.late_ms, self.late)
        digest.tick(self.t_ms, self.received, self.sent, recorder.decisions(self.decisions))
        recorder.flush()


def records_of_tick(
    t_s: float,
    decision: Decision,
    set_points: Sequence[SetPoint],
    *,
    pursued: Collection[Mapping[str, Any]],
    facts: Collection[tuple[int, Fact]],
    problems: Collection[PluginFault],
    competition_states: tuple[CompetitionState, CompetitionState],
) -> tuple[list[Mapping[str, Any] | TickSetPoints], list[Event]]:
    """Records and events of all that the tick at `t_s` decided or noticed, in the session's order.

    `pursued` are the pursuit's records, `facts` (system id, what its battery showed), `problems` what people's own
    planner or policy did wrong, `competition_states` the competitions for tankers and for bases.
    """
    records: list[Mapping[str, Any] | TickSetPoints] = []
    events: list[Event] = []
    if decision.records or pursued or facts or problems:  # seldom
        batteries = [{"kind": "battery", "sysid": sysid, **asdict(fact)} for sysid, fact in facts]
        blamed = [problem.record() for problem in problems]
        told = [{"t_s": t_s, **record} for record in (*decision.records, *pursued, *batteries, *blamed)]
        records += told
        events = [event_of(record) for record in told]
    for competition_state in competition_states:
        if competition_state.v:
            giver = {} if competition_state is competition_states[0] else {"giver": "base"}
            records.append(
                {
                    "t_s": t_s,
                    "kind": "competition",
                    **giver,
                    "v": {str(sysid): v for sysid, v in competition_state.v.items()},
                    "tau": {str(sysid): tau for sysid, tau in competition_state.tau.items()},
                    "leader": competition_state.leader,
                    "share": competition_state.share,
                }
            )
    if set_points:
        records.append(TickSetPoints(t_s, set_points))
    return records, events


def mission_sentence(record: Mapping[str, Any]) -> str:
    """Decision about a vehicle's mission, for people."""
    at = f"at item {record['item']} of {record['of']}"
    return {
        "begins": f"Begins its mission of {record['of']} items",
        "held": f"Held on its mission {at}: waits for {record.get('by')}",
        "steps aside": f"Steps aside from its mission {at}, for {record.get('by')}",
        "goes on": f"Goes on with its mission {at}",
    }.get(str(record["state"]), f"Has flown its mission of {record['of']} items")


def is_event(record: Mapping[str, Any]) -> bool:
    """Whether a decision is one for people; an obstacle may be moved in every tick."""
    return record["kind"] not in QUIET and not (record["kind"] == "world" and record.get("change") == "moved")


def event_of(record: Mapping[str, Any]) -> Event:
    """Event for people of a decision, as a line of decisions.jsonl holds it."""
    t_s, kind = float(record["t_s"]), record["kind"]
    if kind == "death":
        return Event(t_s, int(record["sysid"]), "critical", str(record.get("text", "died")), "death")
    if kind == "violation":
        whom = record.get("sysids") or [0]
        return Event(t_s, int(whom[0]), "critical", str(record.get("text", "")), "violation")
    if kind == "fault":
        level: Level = "warning" if record["state"] == "begins" else "info"
        return Event(t_s, int(record["sysid"]), level, str(record["text"]), "fault")
    if kind == "operator":
        level, refused = ("info", "") if record.get("taken") else ("warning", f"{record.get('command')} refused: ")
        text = f"Operator: {refused}{record.get('text', '')}"
        return Event(t_s, int(record.get("sysid", 0)), level, text, "operator")
    if kind == "command":
        text = f"A program sends it MAV_CMD_{command_name(int(record['mav_cmd']))}"
        return Event(t_s, int(record["sysid"]), "info", text, "operator")
    if kind == "world":
        return Event(t_s, int(record.get("sysid", 0)), "info", str(record["text"]), "operator")
    if kind == "pursuit":
        return Event(t_s, int(record["pursuer"]), "info", f"Pursues {record['target']} from now on", "decision")
    if kind == "mission":
        return Event(t_s, int(record["sysid"]), "info", mission_sentence(record), "decision")
    if kind == "safety":
        by = str(record["by"])
        gives = "Gives way to" if by.startswith(("vehicle", "traffic")) else "Keeps clear of"
        return Event(
            t_s, int(record["sysid"]), "info", f"{'Brakes for' if record.get('braked') else gives} {by}", "decision"
        )
    if kind == "event":
        return Event(t_s, int(record["sysid"]), level_of(int(record["severity"])), str(record["text"]), "text")
    if kind == "boot":
        return Event(t_s, int(record["sysid"]), "warning", str(record["text"]), "link")
    if kind == "battery":
        return Event(t_s, int(record["sysid"]), "warning", str(record["text"]))
    if kind == "policy failed":
        problem = PluginFault(int(record["sysid"]), str(record.get("policy")), str(record.get("problem")))
        return Event(t_s, problem.sysid, "warning", problem.sentence, "decision")
    if kind in ("decided", "transfer", "broken off", "served", "settled", "unable"):
        return Event(t_s, int(record["receiver"]), "info", sentence(record), "decision")
    return Event(t_s, int(record.get("sysid", 0)), "info", str(kind), "decision")
