"""What a tick leaves behind: its frames, and its decisions as records and as events for people."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from gcs.contest import Standing
from gcs.energy import Fact
from gcs.events import Event
from gcs.explain import sentence
from gcs.guard import Problem
from gcs.planner.plan import SetPoint
from gcs.recorder import Digest, Recorder
from gcs.service import Decision


@dataclass
class Recording:
    """What one tick leaves behind, kept until the grants are out."""

    t_ms: int
    arrived: list[bytes]
    sent: list[bytes]
    decisions: list[dict[str, Any]]

    def write(self, recorder: Recorder, digest: Digest, epoch_us: int) -> None:
        """Record and hash it; `epoch_us` is session time 0 in µs since 1970, UTC."""
        t_us = epoch_us + 1000 * self.t_ms
        recorder.frames(t_us, self.arrived)
        recorder.frames(t_us, self.sent)
        digest.frames_in(self.t_ms, self.arrived)
        digest.frames_out(self.t_ms, self.sent)
        for content in self.decisions:
            digest.decision(self.t_ms, recorder.decision(content))


def records_of_tick(
    t_s: float,
    decision: Decision,
    set_points: Iterable[SetPoint],
    *,
    pursued: Iterable[Mapping[str, Any]],
    facts: Iterable[tuple[int, Fact]],
    problems: Iterable[Problem],
    standings: tuple[Standing, Standing],
) -> tuple[list[dict[str, Any]], list[Event]]:
    """Records and events of all that the tick at `t_s` decided or noticed, in the session's order.

    `pursued` are the pursuit's records, `facts` (system id, what its battery showed), `problems` what people's own
    planner or policy did wrong, `standings` the competitions for tankers and for bases.
    """
    records: list[dict[str, Any]] = [{"t_s": t_s, **record} for record in decision.records]
    events = [Event(t_s, int(record["receiver"]), "info", sentence(record), "decision") for record in records]
    for chosen in pursued:
        records.append({"t_s": t_s, **chosen})
        text = f"Pursues {chosen['target']} from now on"
        events.append(Event(t_s, int(chosen["pursuer"]), "info", text, "decision"))
    for sysid, fact in facts:
        records.append({"t_s": t_s, "kind": "battery", "sysid": sysid, **fact.record()})
        events.append(Event(t_s, sysid, "warning", fact.text))
    for problem in problems:
        records.append({"t_s": t_s, **problem.record()})
        events.append(Event(t_s, problem.sysid, "warning", problem.sentence, "decision"))
    for standing, giver in zip(standings, ({}, {"giver": "base"}), strict=True):
        if standing.v:
            records.append(
                {
                    "t_s": t_s,
                    "kind": "competition",
                    **giver,
                    "v": {str(sysid): v for sysid, v in standing.v.items()},
                    "tau": {str(sysid): tau for sysid, tau in standing.tau.items()},
                    "leader": standing.leader,
                    "share": standing.share,
                }
            )
    records += [
        {"t_s": t_s, "kind": "set_point", "sysid": point.sysid, "p_ned": point.p_ned, "v_ned": point.v_ned}
        for point in set_points
    ]
    return records, events
