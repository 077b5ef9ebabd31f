"""Fleet, arming sequences and radio of a scenario."""

from __future__ import annotations

from collections.abc import Iterable

from gcs.link.impairment import BlackoutWindow, Impairment
from gcs.mavlink.autopilots import PROFILES
from gcs.scenario.faults import Injection
from gcs.scenario.model import Scenario
from gcs.supervisor.arming import SELDOM_S, ArmingSequence
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.supervisor.faults import radio_faults
from gcs.telemetry.fleet import Fleet, GlobalOrigin, Member


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
            external=v.external is not None,
            profile=PROFILES.get(v.external.autopilot) if v.external else None,
            airborne=v.airborne and v.external is None,
        )
        for v in scenario.vehicles.all
    ]
    return Fleet(members, GlobalOrigin(origin.lat_deg, origin.lon_deg, origin.alt_m))


def make_arming_sequences(scenario: Scenario) -> dict[int, ArmingSequence]:
    """An arming sequence for each vehicle, by system id."""
    return {
        v.sysid: ExternalArmingSequence(v.sysid, v.takeoff_m, v.external)
        if v.external
        else ArmingSequence(v.sysid, v.takeoff_m, seldom_s=SELDOM_S, rejoins_itself=True)
        for v in scenario.vehicles.all
    }


def make_radio(scenario: Scenario, injections: Iterable[Injection] = ()) -> Impairment:
    """The radio between vehicles and supervisor, with the faults that befall it."""
    blackouts, bursts = radio_faults(injections, [vehicle.sysid for vehicle in scenario.vehicles.all])
    return Impairment(
        **scenario.radio.model_dump(exclude={"blackouts"}),
        blackouts=[*(BlackoutWindow(b.sysid, b.from_s, b.to_s) for b in scenario.radio.blackouts), *blackouts],
        bursts=bursts,
        seed=scenario.seed,
    )
