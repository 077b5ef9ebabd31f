"""Builds the lines of the session's socket (`message_types`): session, snapshot, reply and end."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from typing import TYPE_CHECKING, Any, Literal

import msgspec
from msgspec import UNSET, UnsetType

from gcs.link.quality import LinkQuality
from gcs.mavlink import autopilots
from gcs.missions.items import GlobalPlace, MissionItem, MissionPlan
from gcs.missions.placed import Origin, outline_ne, place_ned
from gcs.planner.failsafes import failsafes_of, foreign_returns_of
from gcs.refuelling import explain
from gcs.refuelling.bidding import CompetitionState
from gcs.refuelling.participation import ON_MISSION, OUT_OF_ORDER, RELEASED
from gcs.refuelling.service import Phase, Service, by_text
from gcs.scenario.goal import asked
from gcs.scenario.model import Obstacle, Scenario, VehicleBase
from gcs.scenario.parts.mission import plan_of
from gcs.scenario.weather import CALM
from gcs.session import message_types as types
from gcs.telemetry.batteries import FUNCTIONS, VehicleBattery
from gcs.telemetry.events import Event
from gcs.telemetry.health import AS_PLANNED, Known, State, health, health_issues, state
from gcs.telemetry.proximity import too_near
from gcs.telemetry.state import FleetSnapshot, TrafficView, Vec3, VehicleView
from skytender import elementary

if TYPE_CHECKING:  # a monitor and a replay have none
    from gcs.supervisor.supervisor import Supervisor

CONTEST_S, CONTEST_EVERY_S = 60.0, 0.5
"""For how long, and how often, the competition's states are kept for later clients."""
ROUND_CORNERS = 32
"""of the outline of what is round"""


def vehicle_row(
    view: VehicleView,
    now_s: float,
    quality: LinkQuality,
    known: Known = AS_PLANNED,
    *,
    unanswered_s: float = 0.0,
) -> types.VehicleRow:
    """One vehicle at `now_s`: its state, link and health (gcs/telemetry/health.py). Its place in the plan is left open.

    `known`, `unanswered_s`: as `health_issues` takes them.
    """
    lost_share = quality.lost_share(view.sysid)
    issues = health_issues(view, now_s, known, lost_share=lost_share, unanswered_s=unanswered_s)
    wrong = health(issues)
    received, silent_s = view.last_received_s >= 0.0, view.silent_s(now_s)
    charged = view.energy_source != "none"
    return types.VehicleRow(
        sysid=view.sysid,
        role=view.role,
        label=view.label,
        alive=view.alive,
        stage="",
        mode=str(view.mode),
        mode_name=view.mode_name,
        armed=view.armed,
        landed=view.landed,
        autopilot=view.profile.name if received else None,
        p_ned=view.p_ned,
        v_ned=view.v_ned if view.placed else None,
        speed_m_s=elementary.norm(view.v_ned) if view.placed else None,
        height_m=-view.p_ned[2] if view.p_ned is not None else None,
        heading_rad=view.heading_rad,
        roll_rad=view.roll_rad,
        pitch_rad=view.pitch_rad,
        aim_ned=None,
        margin_m=None,
        age_s=_known(view.age_s),
        heard_s=_known(silent_s),
        lost=quality.lost(view.sysid),
        lost_share=lost_share,
        target_m=None,
        battery=view.remaining_j / view.capacity_j if charged else None,
        remaining_j=view.remaining_j if charged else None,
        power_w=view.power_w if view.metered else None,
        endurance_s=_known(view.endurance_s),
        energy_source=view.energy_source,
        v=None,
        tau=None,
        state=State.IDLE if view.alive else State.LOST,
        trouble=list(wrong.texts),
        severity=wrong.severity,
        condition=wrong.condition,
        figure=wrong.figure,
        urgency=wrong.urgency,
        note="",
    )


def _known(number: float) -> float | None:
    return number if math.isfinite(number) else None


def battery_rows(batteries: Collection[VehicleBattery], now_s: float) -> list[types.BatteryRow] | UnsetType:
    """All batteries of a vehicle with several, or with another than number 0; else unset."""
    if all(one.id == 0 for one in batteries) and len(batteries) <= 1:
        return UNSET
    return [
        types.BatteryRow(
            id=one.id,
            compid=one.compid,
            function=FUNCTIONS.get(one.function, ""),
            share=one.report.remaining,
            voltage_v=one.voltage_v,
            power_w=one.report.power_w,
            age_s=max(now_s - one.report.time_s, 0.0),
        )
        for one in batteries
    ]


def traffic_row(aircraft: TrafficView) -> types.TrafficRow:
    """One aircraft by its ADSB_VEHICLE."""
    return types.TrafficRow(aircraft.callsign, aircraft.p_ned, aircraft.v_ned, aircraft.age_s)


def event_row(event: Event) -> types.EventRow:
    """One event."""
    return types.EventRow(event.t_s, event.sysid, event.level, event.text, event.kind)


def reply_message(given: object, ok: bool, text: str) -> dict[str, Any]:
    """The message of type "reply" to a line whose "id" was `given`."""
    return types.plain(types.Reply(given if isinstance(given, str | int) else None, ok, text))


def end_message(outcome: str | None, status: int, text: str) -> dict[str, Any]:
    """The message of type "end"."""
    return types.plain(types.End(outcome, text, status))


def distance_m(a: Vec3 | None, b: Vec3 | None) -> float | None:
    """Between two places; None where one is not known."""
    return None if a is None or b is None else elementary.distance(a, b)


def snapshot_message(
    supervisor: Supervisor,
    *,
    phase: str,
    speed: float,
    refuelled: int,
    events: Iterable[Event],
    unanswered_s: Mapping[int, float] | None = None,
) -> dict[str, Any]:
    """The present state; `speed` is session time over wall time so far, `events` are those that were not sent yet;
    `unanswered_s`: vehicles for whose answers the session stands still, and for how long, in wall time."""
    scenario, snapshot, schedule = supervisor.scenario, supervisor.snapshot, supervisor.schedule
    return types.plain(
        types.SnapshotMessage(
            t_s=snapshot.time_s,
            duration_s=scenario.goal.duration_s,
            speed=speed,
            phase=phase,
            vehicles=_vehicles(supervisor, unanswered_s or {}),
            traffic=[traffic_row(aircraft) for aircraft in snapshot.traffic],
            competition=types.CompetitionRow(
                **explain.competition_of(schedule.competition_state, scenario.competition)
            ),
            services=services_of(schedule.open_services, snapshot, scenario),
            history=[types.ServedRow(**row) for row in explain.history_of(schedule.services)],
            bases=[types.StockRow(stock.base.name, stock.remaining_j, stock.base.stock_j) for stock in schedule.stocks],
            refuelled=refuelled,
            goal=goal_state(
                supervisor.worlds.judged,
                supervisor.metrics.pursuit_held_s,
                [types.BrokenRow(one.part, one.text, one.t_s) for one in supervisor.goal_watch.broken()],
            ),
            inspected=supervisor.inspection.latest(snapshot.time_s),
            events=[event_row(event) for event in events],
        )
    )


def services_of(services: Iterable[Service], snapshot: FleetSnapshot, scenario: Scenario) -> list[types.ServiceRow]:
    """Services under way, each with its reasons."""
    tanker_m_s: dict[int | None, float] = {tanker.sysid: tanker.speed_m_s for tanker in scenario.vehicles.tankers}
    base_ned: dict[str | None, Vec3] = {base.name: base.position_m for base in scenario.bases}
    rules = scenario.refuelling, scenario.competition
    return [
        types.ServiceRow(
            **explain.service_of(one, snapshot, *rules, tanker_m_s.get(one.tanker, 0.0), base_ned.get(one.base))
        )
        for one in services
    ]


def states_of(
    snapshot: FleetSnapshot, competition_state: CompetitionState, services: Collection[Service]
) -> dict[int, State]:
    """State of each vehicle in the competition and in the services under way, by system id."""
    waiting = {service.receiver for service in services if service.phase is Phase.JOIN}
    served = {service.receiver for service in services} - waiting
    serving = {service.tanker for service in services if service.tanker is not None}
    competing = competition_state.v or competition_state.tau
    leader = competition_state.leader
    return {
        view.sysid: state(view, competing=competing, leader=leader, waiting=waiting, served=served, serving=serving)
        for view in snapshot.vehicles
    }


def known_of(ordered: autopilots.End | None, down: bool, kept_out: Collection[str], near: str) -> Known:
    """Knowledge of a vehicle of a session; `kept_out`: what keeps it out of the refuelling."""
    on_mission, out_of_order = ON_MISSION in kept_out, OUT_OF_ORDER in kept_out
    return Known(RELEASED not in kept_out, ordered, on_mission, down, out_of_order, near)


def near_to(supervisor: Supervisor) -> dict[int, str]:
    """Vehicles that are too near to something in the present snapshot, and how near."""
    return too_near(supervisor.goal_watch.breaches, supervisor.snapshot, supervisor.worlds.now)


def known_to(supervisor: Supervisor, view: VehicleView, near: Mapping[int, str]) -> Known:
    """A session's knowledge of a vehicle beside its messages; `near`: of all, as of `near_to`."""
    arming = supervisor.arming[view.sysid]
    ordered = arming.ordered or ("land" if view.sysid in supervisor.grounded else None)
    lost = view.sysid in supervisor.goal_watch.lost and not view.flying
    kept_out = supervisor.schedule.participation.reasons.get(view.sysid, ())
    return known_of(ordered, lost or (arming.down and ordered is None), kept_out, near.get(view.sysid, ""))


def kept_of_snapshot(supervisor: Supervisor, events: Iterable[Event]) -> dict[str, Any]:
    """The part of the present `snapshot_message` that is kept for later clients."""
    return {
        "t_s": supervisor.snapshot.time_s,
        "competition": {"v": by_text(supervisor.schedule.competition_state.v)},
        "events": [msgspec.to_builtins(event_row(event)) for event in events],
    }


def _vehicles(supervisor: Supervisor, unanswered_s: Mapping[int, float]) -> list[types.VehicleRow]:
    snapshot, competition_state = supervisor.snapshot, supervisor.schedule.competition_state
    services = supervisor.schedule.open_services
    notes = explain.notes_of(services, supervisor.schedule.participation)
    states = states_of(snapshot, competition_state, services)
    at = {view.sysid: view.p_ned for view in snapshot.vehicles}
    aims = {point.sysid: point.p_ned for point in supervisor.set_points}
    target_of = supervisor.metrics.target_of
    used = {sysid: one.connect for sysid, links in supervisor.link.links().items() for one in links if one.used}
    rows, near = [], near_to(supervisor)
    for view in snapshot.vehicles:
        sysid, arming = view.sysid, supervisor.arming[view.sysid]
        known, waited_s = known_to(supervisor, view, near), unanswered_s.get(sysid, 0.0)
        row = vehicle_row(view, snapshot.time_s, supervisor.quality, known, unanswered_s=waited_s)
        notes_of = [supervisor.missions.note(sysid), notes.get(sysid, "")]
        row.stage, row.note, row.state = arming.stage, "; ".join(filter(None, notes_of)), states[sysid]
        row.mission_item = supervisor.missions.item(sysid) or UNSET
        row.target_m = distance_m(view.p_ned, at.get(target_of.get(sysid, -1)))
        row.v, row.tau = competition_state.v.get(sysid), competition_state.tau.get(sysid)
        row.aim_ned, row.margin_m = aims.get(sysid), supervisor.planner.margin_m(sysid)
        row.link = used.get(sysid, UNSET)
        row.batteries = battery_rows(supervisor.fleet.batteries(sysid), snapshot.time_s)
        row.remote_id = supervisor.fleet.remote_id(sysid) or UNSET
        rows.append(row)
    return rows


def session_message(
    scenario: Scenario,
    folder: str | None,
    *,
    source: Literal["session", "monitor", "replay"] = "session",
    clock: Literal["lockstep", "real", "replay"] | None = None,
    control: bool = True,
) -> dict[str, Any]:
    """The message of type "session"; `clock` is the scenario's own unless given, `control`: commands are taken."""
    mode = clock or scenario.clock.mode
    return types.plain(
        types.SessionLine(
            name=scenario.name,
            folder=folder,
            source=source,
            duration_s=scenario.goal.duration_s,
            clock=mode,
            speed=scenario.clock.speed if mode == "real" else None,
            control=control,
            separation_m=scenario.planner.separation_m,
            ring_m=scenario.formation.ring_m or None,
            vehicles=_members(scenario),
            obstacles=[obstacle_of(shape, f"{shape.kind} {i + 1}") for i, shape in enumerate(scenario.obstacles)],
            bases=[types.BaseRow(base.name, base.position_m) for base in scenario.bases],
            goal=goal_of(scenario),
            origin=(scenario.origin.lat_deg, scenario.origin.lon_deg, scenario.origin.alt_m),
            plans=plans_of(scenario) or UNSET,
            wind=None if scenario.wind == CALM else types.WindRow(scenario.wind.speed_m_s, scenario.wind.from_deg),
        )
    )


def _members(scenario: Scenario) -> list[types.MemberRow]:
    members = [vehicle_of(vehicle, colour) for colour, vehicle in enumerate(scenario.vehicles.all)]
    failsafes, foreign = failsafes_of(scenario), foreign_returns_of(scenario)
    for member in members:
        if (own := failsafes.get(member.sysid)) is not None:
            after_s = own.loss_s if own.down_after_s else 0.0  # by the timetable
            member.plan_b = types.PlanBRow(own.altitude_m, own.level_after_s + after_s, own.down_after_s + after_s)
        elif (other := foreign.get(member.sysid)) is not None:
            member.plan_b = types.PlanBRow(other.height_m, other.begins_after_s, other.lands_after_s)
    return members


def plan_row(
    plan: MissionPlan, source: str, sysid: int | None, origin: Origin, home_alt_m: float | None
) -> types.PlanRow:
    """A plan in the common frame; home_alt_m: of the vehicle's home above the sea, where it is known."""
    if home_alt_m is None:
        home_alt_m = plan.home.height_m if plan.home is not None and math.isfinite(plan.home.height_m) else origin[2]
    return types.PlanRow(
        source=source,
        sysid=sysid,
        items=[_item(item, number, origin, home_alt_m) for number, item in enumerate(plan.mission, plan.first)],
        fence=[types.FenceRow(area.inclusion, outline_ne(area, origin)) for area in plan.fence],
        rally_ned=[place_ned(point, origin, home_alt_m) for point in plan.rally],
        home_ned=None if plan.home is None else place_ned(plan.home, origin, home_alt_m),
        left_out=list(plan.left_out),
    )


def _item(item: MissionItem, number: int, origin: Origin, home_alt_m: float) -> types.PlanItemRow:
    place = item.place
    of_earth = isinstance(place, GlobalPlace) and math.isfinite(place.height_m)
    return types.PlanItemRow(
        number=number,
        command=item.name,
        frame=item.frame_name,
        about=item.about,
        p_ned=None if place is None else place_ned(place, origin, home_alt_m),
        height_m=place.height_m if isinstance(place, GlobalPlace) and of_earth else None,
        above=place.above if isinstance(place, GlobalPlace) and of_earth else None,
        flown=item.flown,
    )


def plans_of(scenario: Scenario) -> list[types.PlanRow]:
    """The scenario's own fence and rally points, and the missions of its vehicles; none where it has none."""
    origin = (scenario.origin.lat_deg, scenario.origin.lon_deg, scenario.origin.alt_m)
    missions = [
        plan_row(plan_of(vehicle), vehicle.label, vehicle.sysid, origin, None)
        for vehicle in scenario.vehicles.on_missions
    ]
    own = scenario_plan(scenario)
    return missions if own is None else [own, *missions]


def scenario_plan(scenario: Scenario) -> types.PlanRow | None:
    """The scenario's own fence and rally points, on the ground; None where it has none."""
    sides = ((True, scenario.fence.inside), (False, scenario.fence.outside))
    fence = [
        types.FenceRow(inside, [*area.border_ned, area.border_ned[0]]) for inside, areas in sides for area in areas
    ]
    if not fence and not scenario.rally_m:
        return None
    rally = [(north_m, east_m, 0.0) for north_m, east_m in scenario.rally_m]
    return types.PlanRow("scenario", None, [], fence, rally, None, [])


def first_broken(violations: Iterable[Mapping[str, Any]]) -> list[types.BrokenRow]:
    """How each part of the goal was first broken, and when, by the records of it in the order of their times."""
    first: dict[str, types.BrokenRow] = {}
    for record in violations:
        part, at_s = str(record["part"]), float(record["at_s"])
        when = "" if record.get("by") == "truth" else f" ({at_s:.1f} s)"  # by truth the text has it
        first.setdefault(part, types.BrokenRow(part, f"{part}: {record['text']}{when}", at_s))
    return list(first.values())


def goal_of(scenario: Scenario | None) -> types.GoalRow:
    """Goal of the session; a limit is None where nothing is demanded, or no scenario is known."""
    if scenario is None:
        return types.GoalRow(None, None, None, None, None, 0)
    goal, limits = scenario.goal, asked(scenario)
    return types.GoalRow(
        separation_m=limits.get("separation"),
        clearance_m=limits.get("clearance"),
        traffic_m=limits.get("traffic"),
        pursue_within_m=goal.pursue.within_m if goal.pursue else None,
        pursue_for_s=goal.pursue.for_s if goal.pursue else None,
        refuelled_at_least=goal.refuelled_at_least,
    )


def goal_state(
    scenario: Scenario | None, pursue_held_s: float | None, broken: list[types.BrokenRow]
) -> types.GoalStateRow:
    """The goal, and how far it is."""
    return types.GoalStateRow(**msgspec.structs.asdict(goal_of(scenario)), pursue_held_s=pursue_held_s, broken=broken)


def vehicle_of(vehicle: VehicleBase, colour: int) -> types.MemberRow:
    """The vehicles, and their routes where they have one; a closed path ends where it begins."""
    path = list(getattr(vehicle, "path_m", None) or getattr(vehicle, "waypoints_m", None) or ())
    if getattr(vehicle, "closed", False):
        path.append(path[0])
    return types.MemberRow(vehicle.sysid, vehicle.role, vehicle.label, vehicle.battery.capacity_j, path, colour)


def obstacle_of(shape: Obstacle, default_label: str) -> types.ObstacleRow:
    """An obstacle to draw: outline from above (its last point is its first), centre, and where it begins and ends."""
    (n0, e0, d0), (n1, e1, d1) = shape.low_m, shape.high_m
    up_m = shape.radius_m if shape.kind == "sphere" else 0.0
    return types.ObstacleRow(
        name=shape.name,
        label=shape.name or default_label,
        kind=shape.kind,
        outline_ne=_outline(shape),
        centre_ned=((n0 + n1) / 2.0, (e0 + e1) / 2.0, (d0 + d1) / 2.0),
        radius_m=shape.radius_m if shape.kind in ("sphere", "cylinder") else None,
        bottom_d=d1 + up_m,
        top_d=d0 - up_m,
    )


def _outline(shape: Obstacle) -> list[tuple[float, float]]:
    (n0, e0, _), (n1, e1, _) = shape.low_m, shape.high_m
    if shape.kind == "point":
        return []
    if shape.kind == "box":
        return [(n0, e0), (n0, e1), (n1, e1), (n1, e0), (n0, e0)]
    angles = [2.0 * math.pi * i / ROUND_CORNERS for i in range(ROUND_CORNERS)]
    r = shape.radius_m
    corners = [(n0 + r * elementary.cos(angle), e0 + r * elementary.sin(angle)) for angle in angles]
    return [*corners, corners[0]]
