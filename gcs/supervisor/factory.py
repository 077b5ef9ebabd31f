"""Fleet, arming sequences, radios and schedule of a scenario."""

from __future__ import annotations

from collections.abc import Iterable

from gcs.link.impairment import Burst, Impairment
from gcs.link.peers.peer_radio import PeerRadio
from gcs.link.peers.place_radio import PlaceRadio
from gcs.mavlink.autopilots import PROFILES
from gcs.refuelling.bidding import BiddingRule
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.settlement import transfers_until_s
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.scenario.faults import Injection
from gcs.scenario.model import Scenario, keeps_apart
from gcs.supervisor.arming import SELDOM_S, ArmingSequence
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.supervisor.faults import radio_faults
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member

_SHARES = {"loss", "delay_s", "jitter_s", "duplicate", "reorder"}


def make_fleet(scenario: Scenario) -> Fleet:
    """The collector of all vehicles' telemetry."""
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
    return Fleet(members, GlobalOrigin(**dict(scenario.origin)))


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
    blackouts, bursts = radio_faults(injections, scenario)
    dead = [Burst(None, silence.from_s, silence.to_s, loss=1.0) for silence in radio.ground_blackouts]
    return Impairment(
        **{name: getattr(radio, name) for name in _SHARES}, bursts=[*blackouts, *dead, *bursts], seed=scenario.seed
    )


def make_peer_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> PeerRadio | None:
    """The radio among vehicles that compete on board, with the blackouts that befall it; None where they do not."""
    if scenario.competition.where == "supervisor":
        return None
    radio = scenario.radio
    return PeerRadio(
        [vehicle.sysid for vehicle in scenario.vehicles.all],
        Impairment(**{name: getattr(radio, name) for name in _SHARES}, seed=scenario.seed),
        blackouts=radio_faults(injections, scenario)[0],
        splits=radio.splits,
    )


def make_place_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> PlaceRadio | None:
    """The radio on which launched vehicles receive each other's places; None where they do not keep apart on board."""
    if not keeps_apart(scenario):
        return None
    radio = scenario.radio
    return PlaceRadio(
        [vehicle.sysid for vehicle in scenario.vehicles.launched if vehicle.real is None],
        Impairment(**{name: getattr(radio, name) for name in _SHARES}, seed=scenario.seed),
        blackouts=radio_faults(injections, scenario)[0],
        splits=radio.splits,
        traffic=bool(scenario.traffic),
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
        transfers_until_s=transfers_until_s(scenario),
    )
    if isinstance(schedule, WatchedSchedule):
        schedule.watch(scenario.competition, frozenset(pursuer.sysid for pursuer in vehicles.pursuers))
    return schedule
