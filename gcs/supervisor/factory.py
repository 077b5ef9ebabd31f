"""Fleet, arming sequences, radios and schedule of a scenario."""

from __future__ import annotations

import math
from collections.abc import Iterable

from gcs.link.impairment import BlackoutWindow, Impairment
from gcs.link.peer_radio import PeerRadio, SplitWindow
from gcs.mavlink.autopilots import PROFILES
from gcs.refuelling.bidding import BiddingRule
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.scenario.faults import RADIO, Injection
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import SELDOM_S, ArmingSequence
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.supervisor.faults import radio_faults
from gcs.telemetry.fleet import Fleet, GlobalOrigin, Member

_SHARES = {"loss", "delay_s", "jitter_s", "duplicate", "reorder"}


SETTLES_S, SETTLES_BY_LOSS_S, SETTLES_WAYS = 3.0, 24.0, 4
"""[choice] How long it takes to stop and settle a transfer, by the share of frames lost and the delay of one way: with
half of all frames lost both stops, both counters and the settlement, each asked for again until answered, took 10 s."""


def make_fleet(scenario: Scenario) -> Fleet:
    """The collector of all vehicles' telemetry."""
    origin = scenario.origin
    members = [
        Member(
            v.sysid,
            v.role,
            v.label,
            v.battery.capacity_j,
            v.battery.capacity_j * v.battery.initial_percent / 100.0,
            external=v.foreign is not None,
            profile=PROFILES.get(rules.autopilot) if (rules := v.foreign) else None,
            airborne=v.airborne and v.foreign is None,
            battery_apart=v.real is not None,
        )
        for v in scenario.vehicles.all
    ]
    return Fleet(members, GlobalOrigin(origin.lat_deg, origin.lon_deg, origin.alt_m))


def make_arming_sequences(scenario: Scenario) -> dict[int, ArmingSequence]:
    """An arming sequence for each vehicle, by system id."""
    return {
        v.sysid: ExternalArmingSequence(v.sysid, v.takeoff_m, rules)
        if (rules := v.foreign)
        else ArmingSequence(v.sysid, v.takeoff_m, seldom_s=SELDOM_S, rejoins_itself=True)
        for v in scenario.vehicles.all
    }


def make_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> Impairment:
    """The radio between vehicles and supervisor, with the faults that befall it."""
    radio = scenario.radio
    blackouts, bursts = radio_faults(injections, [vehicle.sysid for vehicle in scenario.vehicles.all])
    return Impairment(
        **radio.model_dump(include=_SHARES),
        blackouts=[*(BlackoutWindow(b.sysid, b.from_s, b.to_s) for b in radio.blackouts), *blackouts],
        ground_blackouts=[(b.from_s, b.to_s) for b in radio.ground_blackouts],
        bursts=bursts,
        seed=scenario.seed,
    )


def make_peer_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> PeerRadio | None:
    """The radio among vehicles that compete on board, with the blackouts that befall it; None where they do not."""
    if scenario.competition.where == "supervisor":
        return None
    radio = scenario.radio
    blackouts, _ = radio_faults(injections, [vehicle.sysid for vehicle in scenario.vehicles.all])
    return PeerRadio(
        [vehicle.sysid for vehicle in scenario.vehicles.all],
        Impairment(**radio.model_dump(include=_SHARES), seed=scenario.seed),
        blackouts=[*(BlackoutWindow(b.sysid, b.from_s, b.to_s) for b in radio.blackouts), *blackouts],
        splits=[SplitWindow(frozenset(split.sysids), split.from_s, split.to_s) for split in radio.splits],
    )


def make_schedule(scenario: Scenario, bidding: BiddingRule | None) -> Scheduler:
    """Schedule of refuelling; `bidding` as the scenario names it. Vehicles that do it themselves are watched."""
    vehicles = scenario.vehicles
    served = bool(vehicles.tankers or scenario.bases)
    kind = Scheduler if scenario.competition.where == "supervisor" else WatchedSchedule
    schedule = kind(
        scenario.competition,
        scenario.refuelling,
        vehicles.tankers,
        bidding,
        bases=scenario.bases,
        transfer_capable={v.sysid: v.transfer_capable for v in vehicles.pursuers if served},
        cruise_m_s=scenario.planner.cruise_m_s,
        transfers_until_s=_transfers_until_s(scenario),
    )
    if isinstance(schedule, WatchedSchedule):
        schedule.watch(scenario.competition, frozenset(pursuer.sysid for pursuer in vehicles.pursuers))
    return schedule


def _transfers_until_s(scenario: Scenario) -> float:
    """Session time at which transfers in the air are stopped, so that they are settled before the end."""
    if not _frames_may_be_late(scenario):
        return math.inf
    radio, faults = scenario.radio, scenario.faults
    loss = max([radio.loss, *(one.share or 0.0 for one in faults if one.fault == "loss")])
    late_s = max([radio.delay_s + radio.jitter_s, *(one.delay_s or 0.0 for one in faults)])
    return scenario.goal.duration_s - SETTLES_S - SETTLES_BY_LOSS_S * loss - SETTLES_WAYS * late_s


def _frames_may_be_late(scenario: Scenario) -> bool:
    """Whether a transfer may end with joules on the way: over a radio, real or simulated."""
    befallen = any(one.fault in RADIO for one in scenario.faults)
    return bool(scenario.vehicles.external) or befallen or not make_radio(scenario).clear
