"""Competition and services as numbers to show, and in a sentence why a tanker flies where it flies."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any

from gcs.mavlink.command_protocol import OPERATOR, CommandResult, result_in_words
from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.participation import Participation
from gcs.refuelling.service import Phase, Service, by_text
from gcs.refuelling.target_assignment import meeting_s, way
from gcs.scenario.model import CompetitionRules, RefuellingRules
from gcs.telemetry.state import FleetSnapshot, Vec3
from skytender.rolling_horizon import COST

HISTORY = 20
LEAST_MORE, MOST_MORE = 0.05, 1.0
"""Vehicles that are said to be lost more if another is served first: from so many on, and at most."""


def competition_of(competition_state: CompetitionState, rules: CompetitionRules) -> dict[str, Any]:
    """The competition as it stands; `threshold` is the share that wins it once it is held long enough."""
    behind = [sysid for sysid in competition_state.v if sysid != competition_state.leader]
    return {
        "v": by_text(competition_state.v),
        "tau": by_text(competition_state.tau),
        "leader": competition_state.leader,
        "share": competition_state.share if competition_state.leader is not None else None,
        "runner_up": max(behind, key=lambda sysid: (competition_state.v[sysid], -sysid), default=None),
        "threshold": rules.share,
    }


def service_of(
    service: Service,
    snapshot: FleetSnapshot,
    rules: RefuellingRules,
    competition: CompetitionRules,
    speed_m_s: float,
    base_ned: Vec3 | None = None,
) -> dict[str, Any]:
    """A service under way; `speed_m_s` is its tanker's, `base_ned` its base's place."""
    return {
        "receiver": service.receiver,
        "tanker": service.tanker,
        "base": service.base,
        "phase": str(service.phase),
        "energy_j": service.energy_j,
        "by": service.by,
        "decided_at_s": service.decided_at_s,
        "joined_at_s": service.joined_at_s,
        "rendezvous_ned": base_ned or rendezvous_ned(service, snapshot, rules.height_m, speed_m_s),
        "bids": by_text(service.bids),
        "why": why(service, snapshot, rules, competition),
    }


def history_of(services: Iterable[Service]) -> list[dict[str, Any]]:
    """The last services that have ended, in the order of their decisions."""
    keys = ("receiver", "tanker", "base", "by", "decided_at_s", "joined_at_s", "start_s", "end_s", "energy_j")
    ended = [service for service in services if service.phase is Phase.DONE]
    return [
        {**{key: getattr(service, key) for key in keys}, "reason": service.ended_by} for service in ended[-HISTORY:]
    ]


def rendezvous_ned(service: Service, snapshot: FleetSnapshot, height_m: float, speed_m_s: float) -> Vec3 | None:
    """Point where the tanker meets its receiver if that flies straight on; above it where it is, once they have met."""
    if service.tanker is None:
        return None
    receiver, tanker = snapshot.vehicle(service.receiver), snapshot.vehicle(service.tanker)
    if receiver.p_ned is None or tanker.p_ned is None:
        return None
    n, e, d = receiver.p_now_ned()
    place = (n, e, d - height_m)
    if service.phase is not Phase.JOIN:
        return place
    left_s = meeting_s(way(tanker.p_now_ned(), place), receiver.v_ned, speed_m_s) or 0.0
    vn, ve, vd = receiver.v_ned
    return (place[0] + vn * left_s, place[1] + ve * left_s, place[2] + vd * left_s)


def why(service: Service, snapshot: FleetSnapshot, rules: RefuellingRules, competition: CompetitionRules) -> str:
    """One sentence for a person: by what this receiver was chosen, and when its tanker meets it."""
    receiver = snapshot.vehicle(service.receiver).label
    need = f"its need {service.need:.2f}"
    if math.isnan(service.need):
        reason = "its decision is in no part of the recording that was kept"
    elif service.by == "competition" and competition.bids == "losses":
        reason = f"{_gained(service.gain)} ({need})"
    elif service.by == "competition" and competition.bids == "time":
        reason = f"it has the least flight time left, and has led for {competition.dwell_s:g} s ({need})"
    elif service.by == "competition" and competition.bids == "effort":
        reason = (
            "of those that compete it had used most control effort since it last received energy, and held "
            f"{100.0 * service.share:.4g} % of the competition for {competition.dwell_s:g} s ({need})"
        )
    elif service.by == "competition":
        largest = "is the largest" if service.need_is_largest else "had been the largest"
        reason = f"{need} {largest} and it held {100.0 * service.share:.0f} % of the competition"
        reason += f" for {competition.dwell_s:g} s"
    elif service.by == "unopposed":
        reason = f"it is the only candidate ({need})"
    elif service.by == "timeout":
        reason = f"no vehicle held {100.0 * competition.share:.0f} % of the competition within"
        reason += f" {competition.decide_within_s:g} s, and it was ahead with {need}"
    elif service.by == "urgency":
        urgent_s = (
            2.0 * competition.dwell_s if competition.bids in {"losses", "time"} else rules.hold_s + rules.reserve_s
        )
        reason = f"it would be empty within {urgent_s:g} s of the rendezvous"
    elif service.by == "operator":
        reason = f"the operator asked for it ({need})"
    else:
        reason = f"the policy {competition.policy} chose it ({need})"
    met = ""
    if service.meets_in_s is not None and service.phase is Phase.JOIN and service.joined_at_s is None:
        left_s = max(service.decided_at_s + service.meets_in_s - snapshot.time_s, 0.0)
        if service.tanker is None:
            met = f"; it is there in {left_s:.0f} s" if left_s >= 0.5 else "; it is nearly there"
        else:
            tanker = snapshot.vehicle(service.tanker).label
            met = f"; {tanker} meets it in {left_s:.0f} s" if left_s >= 0.5 else f"; {tanker} closes in on it"
    where = (
        "" if service.base is None else f" at base {service.base}, for it cannot take a transfer ({service.why_base})"
    )
    when = "next" if service.phase in (Phase.JOIN, Phase.LAND) else "now"
    return f"{receiver[:1].upper()}{receiver[1:]} is refuelled {when}{where}: {reason}{met}."


def _gained(gain: float | None) -> str:
    """Why the competition by likely losses chose a vehicle."""
    if gain is None:
        return "it won the competition of the vehicles"
    more = min(gain / COST, MOST_MORE)
    if more < LEAST_MORE:
        return "no order of services that begins with another is likely to lose fewer vehicles"
    at_least = "at least " if more == MOST_MORE else ""
    return f"if another were served first, {at_least}{more:.1f} vehicles more would likely be lost"


def notes_of(services: Iterable[Service], participation: Participation) -> Mapping[int, str]:
    """Part of each vehicle in refuelling, by system id: a side of a service, asked for next, or out of it."""
    notes = {**dict.fromkeys(participation.asked, "refuelled next, by the operator"), **participation.out}
    for service in services:
        notes[service.receiver] = f"served by {service.giver}: {service.phase}"
        if service.tanker is not None:
            notes[service.tanker] = f"serves {service.receiver}: {service.phase}"
    return notes


def sentence(record: Mapping[str, Any]) -> str:
    """A decision for a person."""
    receiver, kind = record["receiver"], record["kind"]
    if kind == "settled":
        giver = f"Base {record['base']}" if "base" in record else f"Tanker {record['tanker']}"
        return f"{giver} took back {record['energy_j']:.0f} J that had not arrived at {receiver}"
    if kind == "unable":
        return f"Vehicle {receiver} cannot take a transfer: {record['reason']}; only a base can serve it"
    if "base" in record:
        where = f"at base {record['base']}"
        if kind == "decided":
            return f"Refuelling of {receiver} {where} decided by {record['by']}: it {record['reason']}"
        if kind == "transfer":
            return f"Charging of {receiver} {where} begun"
        return f"Refuelling of {receiver} {where} ended: {record['reason']}, {record['energy_j']:.0f} J"
    tanker = record["tanker"]
    if kind == "decided":
        how = ", unopposed" if record["by"] == "unopposed" else f" by {record['by']}"
        return f"Refuelling of {receiver} by {tanker} decided{how}"
    if kind == "broken off":
        return f"Transfer from {tanker} to {receiver} broken off, join again"
    if kind == "transfer":
        return f"Transfer from {tanker} to {receiver} begun"
    return f"Refuelling of {receiver} by {tanker} ended: {record['reason']}, {record['energy_j']:.0f} J"


def acknowledged(result: CommandResult) -> str:
    """Result of a command, for a person."""
    refused = result_in_words(result.result or 0)
    code = "" if refused == f"result {result.result}" else f"result {result.result}, "
    if str(result.token).startswith(OPERATOR):
        order = str(result.token).removeprefix(OPERATOR).strip().capitalize()
        if result.outcome == "timeout":
            return f"{order} was not acknowledged, though it was sent {result.attempts} times"
        return f"{order} accepted" if result.outcome == "accepted" else f"{order} refused: {refused}"
    how = {
        "accepted": "was accepted",
        "timeout": "timed out",
        "rejected": f"was refused ({code}{refused})",
    }
    return f"Command {result.command} ({result.token}) {how[result.outcome]}"
