"""Types of the lines on a session's socket (docs/protocol/socket.md#session-socket): what a session, an observer and a
replay send. `gcs/schemas/messages.schema.json` is made of them.

Seconds, metres, joules; positions and velocities in the common NED frame. None: not known.
"""

from __future__ import annotations

from typing import Any, Literal

import msgspec
from msgspec import UNSET, Struct, UnsetType

from gcs.telemetry.events import Kind, Level
from gcs.telemetry.state import Vec3


class EventRow(Struct):
    """A happening; `sysid` 0 is the ground station, 255 the traffic."""

    t_s: float
    sysid: int
    level: Level
    text: str
    kind: Kind


class GoalRow(Struct):
    """Goal of the session."""

    separation_m: float | None
    clearance_m: float | None
    traffic_m: float | None
    pursue_within_m: float | None
    pursue_for_s: float | None
    refuelled_at_least: int


class BrokenRow(Struct):
    """A part of the goal that can no longer be met."""

    part: str
    text: str
    t_s: float | None


class GoalStateRow(GoalRow):
    """The goal, for how long its pursuit has been held, and what of it is broken."""

    pursue_held_s: float | None
    broken: list[BrokenRow]


class PlanBRow(Struct):
    """How a vehicle comes home by itself: on `return`, and where it loses the station."""

    return_m: float
    """height above its home at which it flies home; of an external vehicle above the scenario's height 0"""
    level_after_s: float
    """of a timetable for the fleet: it flies level no earlier than so long after its last HEARTBEAT, and 0: no
    timetable; one whose autopilot is not ours holds until then, and climbs"""
    down_after_s: float
    """and comes down no earlier than so long after it"""


class MemberRow(Struct):
    """A vehicle, and its route."""

    sysid: int
    role: str
    label: str
    capacity_j: float | None
    path_ned: list[Vec3]
    colour: int
    """which of the palette's colours it has wherever it is drawn: its place in the scenario, from 0"""
    plan_b: PlanBRow | UnsetType = UNSET
    """unset: it returns by its own parameters, which are not known here"""


class ObstacleRow(Struct):
    """An obstacle to draw: outline from above, centre, and the down coordinates where it begins and ends."""

    name: str | None
    label: str
    kind: str
    outline_ne: list[tuple[float, float]]
    centre_ned: Vec3
    radius_m: float | None
    bottom_d: float
    top_d: float


class BaseRow(Struct):
    """A base."""

    name: str
    p_ned: Vec3


class WindRow(Struct):
    """Mean wind, and where it comes from, degrees clockwise from north."""

    speed_m_s: float
    from_deg: float


class PlanItemRow(Struct):
    """A mission item."""

    number: int
    """by which DO_JUMP counts"""
    command: str
    """of MAV_CMD, without that"""
    frame: str
    """of MAV_FRAME, without that"""
    about: str
    """the parameters that are given and not 0"""
    p_ned: Vec3 | None
    """None: it has no place, or none of its own"""
    height_m: float | None
    above: Literal["sea", "home", "terrain"] | None
    """what its height is above"""
    flown: bool
    """whether the vehicle flies there"""


class FenceRow(Struct):
    """An area of a geofence; the last corner is the first."""

    inside: bool
    """whether a vehicle is to stay in it; else out of it"""
    outline_ne: list[tuple[float, float]]


class PlanRow(Struct):
    """Mission, geofence and rally points of a vehicle, of a file or of the scenario."""

    source: str
    sysid: int | None
    """None: of no vehicle by itself"""
    items: list[PlanItemRow]
    fence: list[FenceRow]
    rally_ned: list[Vec3]
    home_ned: Vec3 | None
    left_out: list[str]
    """parts that are not shown"""


class SessionLine(Struct, tag_field="type", tag="session"):
    """The first line, and again when what it says has changed."""

    name: str
    folder: str | None
    source: Literal["session", "monitor", "replay"]
    duration_s: float | None
    clock: Literal["lockstep", "real", "replay"]
    speed: float | None
    control: bool
    separation_m: float | None
    ring_m: float | None
    """the radius of the ring around a target"""
    vehicles: list[MemberRow]
    obstacles: list[ObstacleRow]
    bases: list[BaseRow]
    goal: GoalRow
    origin: tuple[float, float, float] | None = None
    """of the common frame: latitude and longitude in degrees, altitude above mean sea level in m"""
    wind: WindRow | None = None
    """None: nothing blows"""
    plans: list[PlanRow] | UnsetType = UNSET
    """of the scenario, of the vehicles of a recording and of `--plan`; unset where there are none"""
    events: list[EventRow] | UnsetType = UNSET
    """the last ones that were sent before, where a client connects to a session"""
    told: int | UnsetType = UNSET
    """how many those were in all"""
    contest: list[tuple[float, dict[str, float]]] | UnsetType = UNSET
    """(session time, v by system id) of the last minute before, where a client connects or a recording is sought in"""


class BatteryRow(Struct):
    """One of several batteries of a vehicle."""

    id: int
    compid: int
    """of the component that reports it"""
    function: str
    """"all", "propulsion", "avionics" or "payload"; empty where it is not said"""
    share: float | None
    """of its capacity, 0..1"""
    voltage_v: float | None
    power_w: float | None
    age_s: float


class VehicleRow(Struct):
    """A vehicle at the snapshot's time."""

    sysid: int
    role: str
    label: str
    alive: bool
    stage: str
    mode: str
    """takeoff, offboard, hold, land, return, refuel, mission, manual or other, the same of every autopilot"""
    mode_name: str
    """the same as its autopilot's people call it: `AUTO` of an ArduPilot, `Mission` of a PX4"""
    armed: bool
    landed: bool
    autopilot: str | None
    p_ned: Vec3 | None
    v_ned: Vec3 | None
    speed_m_s: float | None
    height_m: float | None
    heading_rad: float | None
    roll_rad: float | None
    pitch_rad: float | None
    aim_ned: Vec3 | None
    """its set point"""
    margin_m: float | None
    """added to separation and clearance for its tracking error; null without the safety filter"""
    age_s: float | None
    """of its position"""
    heard_s: float | None
    """since its last HEARTBEAT"""
    lost: int
    """frames"""
    lost_share: float | None
    """of the frames of the last 10 s, 0..1"""
    target_m: float | None
    battery: float | None
    """share of the capacity, 0..1; of several batteries that of the emptiest that it flies on"""
    remaining_j: float | None
    power_w: float | None
    endurance_s: float | None
    energy_source: str
    v: float | None
    tau: float | None
    state: str
    trouble: list[str]
    """what is wrong, worst first"""
    severity: int
    """0 well, 1 look, 2 act"""
    condition: str
    """dead, silent, failing, low or warned; empty: well"""
    figure: str
    """how badly: `48 s` (left, when low; silent or dead for so long), or a few words"""
    urgency: float
    """among vehicles of one condition the greatest is the worst"""
    note: str
    link: str | UnsetType = UNSET
    """of a vehicle with several links, the address of the one in use"""
    batteries: list[BatteryRow] | UnsetType = UNSET
    """of a vehicle that has reported another than number 0, all"""
    mission_item: int | UnsetType = UNSET
    """of a vehicle that reports MISSION_CURRENT, the number of the item that it flies"""
    remote_id: str | UnsetType = UNSET
    """of a vehicle that sends Remote ID, its id and status: `SKYT500003: airborne`"""


class TrafficRow(Struct):
    """An aircraft by its ADSB_VEHICLE."""

    callsign: str
    p_ned: Vec3
    v_ned: Vec3
    age_s: float


class CompetitionRow(Struct):
    """The competition, by system id as text; `threshold` is the share that wins it."""

    v: dict[str, float]
    tau: dict[str, float]
    leader: int | None
    share: float | None
    runner_up: int | None
    threshold: float


class ServiceRow(Struct):
    """A refuelling under way."""

    receiver: int
    tanker: int | None
    base: str | None
    phase: str
    energy_j: float
    by: str
    decided_at_s: float
    joined_at_s: float | None
    rendezvous_ned: Vec3 | None
    bids: dict[str, float]
    why: str


class ServedRow(Struct):
    """A refuelling that has ended."""

    receiver: int
    tanker: int | None
    base: str | None
    by: str
    decided_at_s: float
    joined_at_s: float | None
    start_s: float | None
    end_s: float | None
    energy_j: float
    reason: str


class StockRow(Struct):
    """Energy of a base."""

    name: str
    remaining_j: float
    stock_j: float


class InspectedRow(Struct):
    """The latest of one message of an inspected vehicle, fields in MAVLink's own units."""

    count: int
    rate_hz: float | None
    age_s: float
    fields: dict[str, Any]


class ReplayRow(Struct):
    """Begin and end of a recording, and how it is played; speed None: without waiting."""

    from_s: float
    to_s: float
    speed: float | None
    paused: bool


class SnapshotMessage(Struct, tag_field="type", tag="snapshot"):
    """The state at a session time, with the events since the last one."""

    t_s: float
    duration_s: float | None
    speed: float | None
    phase: str
    vehicles: list[VehicleRow]
    traffic: list[TrafficRow]
    competition: CompetitionRow
    services: list[ServiceRow]
    history: list[ServedRow]
    refuelled: int
    goal: GoalStateRow
    inspected: dict[str, dict[str, InspectedRow]]
    """by system id and message name"""
    events: list[EventRow]
    bases: list[StockRow] | UnsetType = UNSET
    replay: ReplayRow | UnsetType = UNSET


class Reply(Struct, tag_field="type", tag="reply"):
    """The answer to a line of a client's; `id` is the one given in it."""

    id: str | int | None
    ok: bool
    text: str


class End(Struct, tag_field="type", tag="end"):
    """The last line. That of a session that broke off comes without a snapshot of phase `ended` before it."""

    outcome: str | None
    """None: there is no summary"""
    text: str
    """the outcome as a sentence, or why the session broke off"""
    exit: int | None
    """None: the session's process has ended without a last word"""


SessionMessage = SessionLine | SnapshotMessage | Reply | End


def plain(line: SessionMessage) -> dict[str, Any]:
    """A line as plain data, for JSON."""
    return msgspec.to_builtins(line)


def schema() -> dict[str, Any]:
    """The JSON Schema of a line."""
    about = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "A line of a session's socket"}
    return about | msgspec.json.schema(SessionMessage)
