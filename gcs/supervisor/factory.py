"""Fleet, arming sequences and schedule of a scenario."""

from __future__ import annotations

from gcs.mavlink.autopilots import PROFILES
from gcs.refuelling.bidding import BiddingRule
from gcs.refuelling.scheduler import Scheduler
from gcs.refuelling.settlement import transfers_until_s
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import SELDOM_S, ArmingSequence
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.track import Member


def make_fleet(scenario: Scenario) -> Fleet:
    """The collector of all vehicles' telemetry."""
    members = [
        Member(
            v.sysid,
            v.role,
            v.label,
            v.battery.capacity_j,
            v.battery.capacity_j * v.battery.initial_percent / 100.0,
            external=v.is_foreign,
            profile=PROFILES.get(rules.autopilot) if (rules := v.foreign) else None,
            airborne=v.airborne and not v.is_foreign,
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
