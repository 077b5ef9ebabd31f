"""A fleet that competes on board, flown in this process: real vehicles with their MAVLink services, the real radios in
between, and a ground station that only listens, or decides in the shadow what a session's would.

    fleet = FleetInProcess(content)
    fleet.fly(30.0)
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from gcs.mavlink import codec
from gcs.planner.failsafes import failsafes_of
from gcs.processes.vehicles import fleet_rules, vehicle_parameters
from gcs.scenario.model import Scenario
from gcs.supervisor.factory import make_fleet, make_schedule
from gcs.supervisor.radios import make_peer_radio, make_radio
from simvehicle.autopilot.body import Start
from simvehicle.autopilot.geodesy import LocalFrame
from simvehicle.autopilot.identity import IDENTITIES
from simvehicle.autopilot.maneuvers import OffboardSetPoint
from simvehicle.autopilot.modes import Trigger
from simvehicle.autopilot.parameters import Parameters
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.fleet.member import FleetMember
from simvehicle.fleet.peers import PeerStage
from simvehicle.fleet.rules import read_rules
from simvehicle.mavlink.codec import split
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.fleet_messages import FleetService

PERIOD_MS = 100
APART_M = 2.0


def on_board(
    pursuers: Mapping[int, tuple[tuple[float, float, float], float]],
    tankers: Mapping[int, tuple[float, float, float]],
    **changes: Any,
) -> dict[str, Any]:
    """Scenario of vehicles in the air: pursuers at a place with a charge in %, tankers at a place; NED, m."""
    content: dict[str, Any] = {
        "schema": 1,
        "name": "fleet",
        "axes": "ned",
        "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
        "clock": {"mode": "lockstep"},
        "goal": {"duration_s": 60.0},
        "vehicles": {
            "pursuers": [
                {
                    "sysid": sysid,
                    "start_m": list(place),
                    "airborne": True,
                    "waypoints_m": [list(place)],
                    "battery": {"capacity_j": 24000, "initial_percent": percent},
                }
                for sysid, (place, percent) in pursuers.items()
            ],
            "tankers": [
                {
                    "sysid": sysid,
                    "start_m": list(place),
                    "home_m": list(place),
                    "airborne": True,
                    "battery": {"capacity_j": 200000},
                }
                for sysid, place in tankers.items()
            ],
        },
        "competition": {"where": "vehicles"},
    }
    for key, value in changes.items():
        content[key] = {**content.get(key, {}), **value} if isinstance(value, dict) else value
    return content


class FleetInProcess:
    """The vehicles of a scenario, tick by tick, as a session grants them their time."""

    def __init__(self, content: Mapping[str, Any], *, tankers_from_s: float = 0.0, with_shadow: bool = False) -> None:
        """tankers_from_s: until then no tanker takes part. with_shadow: let a schedule that decides look on, too."""
        self.scenario = Scenario.model_validate(content)
        central = {**content, "competition": {**content["competition"], "where": "supervisor"}}
        central["radio"] = {key: value for key, value in content.get("radio", {}).items() if key != "splits"}
        self.now_ms = 0
        self._tankers_from_s = tankers_from_s
        self._peer_radio = make_peer_radio(self.scenario)
        self._radio = make_radio(self.scenario)
        self.ground = make_fleet(self.scenario)
        self.watched = make_schedule(self.scenario, None)
        self.shadow = make_schedule(Scenario.model_validate(central), None) if with_shadow else None
        rules = read_rules(fleet_rules(self.scenario))
        origin = self.scenario.origin
        frame = LocalFrame(origin.lat_deg, origin.lon_deg, origin.alt_m)
        self.vehicles: dict[int, Vehicle] = {}
        self._services: dict[int, Services] = {}
        self._connections: dict[int, Connection] = {}
        failsafes = failsafes_of(self.scenario)
        for one in self.scenario.vehicles.all:
            parameters = Parameters(vehicle_parameters(one, self.scenario, failsafes[one.sysid]))
            vehicle = Vehicle(IDENTITIES["px4"], parameters, frame, Start(one.start_m, airborne=one.airborne))
            connection = Connection(one.sysid)
            services = Services(vehicle, one.sysid, [connection], None, rules)
            vehicle.set_clock(0, 1_767_225_600_000_000)
            if one.role == "tanker" and tankers_from_s > 0.0:
                vehicle.trigger(Trigger.HOLD)
            else:
                self._lead(services)
            self.vehicles[one.sysid] = vehicle
            self._services[one.sysid], self._connections[one.sysid] = services, connection

    @property
    def now_s(self) -> float:
        """Session time."""
        return self.now_ms / 1e3

    def member(self, sysid: int) -> FleetMember:
        """A vehicle's part in the fleet."""
        return self.service(sysid).member

    def service(self, sysid: int) -> FleetService:
        """MAVLink face of that part."""
        service = self._services[sysid].fleet
        assert service is not None
        return service

    def believed(self, sysid: int) -> dict[int, int]:
        """Receiver of each tanker as a vehicle knows it; a tanker knows its own."""
        member = self.member(sysid)
        peers = member.peers.fresh(self.now_s)
        known = {tanker.sysid: peers[tanker.sysid].partner for tanker in self._tankers() if tanker.sysid in peers}
        if member.tanker is not None:
            known[sysid] = member.tanker.receiver
        return known

    def served(self) -> dict[int, list[int]]:
        """Receivers of each tanker, in the order in which it took them."""
        found = {}
        for tanker in self._tankers():
            duty = self.member(tanker.sysid).tanker
            assert duty is not None
            found[tanker.sysid] = [service.receiver for service in duty.services]
        return found

    def fly(self, seconds: float, each: Callable[[], bool] | None = None) -> None:
        """So long, or until `each`, asked after every tick, says that it is enough."""
        for _ in range(round(1e3 * seconds / PERIOD_MS)):
            self.tick()
            if each is not None and each():
                return

    def tick(self) -> None:
        """One period: what was sent is received, everyone flies, the ground station listens."""
        assert self._peer_radio is not None
        inbox = {sysid: self._peer_radio.receive(sysid, self.now_s) for sysid in self.vehicles}
        if 0.0 < self._tankers_from_s <= self.now_s:
            self._tankers_from_s = 0.0
            for tanker in self._tankers():
                vehicle = self.vehicles[tanker.sysid]
                vehicle.set_point(OffboardSetPoint(vehicle.p_ned, (0.0, 0.0, 0.0), (True,) * 3, None, self.now_s))
                vehicle.trigger(Trigger.OFFBOARD)
                self._lead(self._services[tanker.sysid])
        self.now_ms += PERIOD_MS
        for sysid, vehicle in self.vehicles.items():
            services, connection = self._services[sysid], self._connections[sysid]
            for frame in split(inbox[sysid]):
                services.receive(frame, connection)
            vehicle.advance(self.now_ms)
            services.decide()
            services.report()
            frames = [frame for raw in connection.frames() for frame in codec.split(raw).frames]
            self._peer_radio.send(sysid, frames)
            for frame in self._radio.apply(sysid, "in", self.now_s, frames):
                self.ground.ingest(frame, self.now_s)
                if frame.msgid == codec.msgid("DEBUG_FLOAT_ARRAY"):
                    self.watched.receive(frame.sysid, codec.fields(frame), self.now_s)
        self.ground.pop_acks()
        snapshot = self.ground.snapshot(self.now_s)
        self.watched.decide(snapshot)
        if self.shadow is not None:
            self.shadow.decide(snapshot)

    def distances_m(self) -> Iterator[tuple[int, int, float]]:
        """Distance of each pair that are not partners of a service."""
        sysids = sorted(self.vehicles)
        for i, a in enumerate(sysids):
            for b in sysids[i + 1 :]:
                partners = self.member(b).tanker is not None and self.member(b).tanker.receiver == a
                if not partners:
                    yield a, b, math.dist(self.vehicles[a].p_ned, self.vehicles[b].p_ned)

    def transferring(self) -> list[tuple[int, int]]:
        """(tanker, receiver) of each transfer under way."""
        duties = {t.sysid: self.member(t.sysid).tanker for t in self._tankers()}
        return [(s, d.receiver) for s, d in duties.items() if d is not None and d.stage is PeerStage.TRANSFERS]

    def _lead(self, services: Services) -> None:
        """The ground station's last set point: from now on the vehicle is alone."""
        assert services.fleet is not None
        services.fleet.member.led()

    def _tankers(self) -> tuple[Any, ...]:
        return self.scenario.vehicles.tankers


def random_fleet(
    seed: int, *, pursuers: int, tankers: int, half_m: float, percent: tuple[float, float], **changes: Any
) -> dict[str, Any]:
    """A fleet at random places at least 2 m apart, tankers above; charges within some percents."""
    rng = random.Random(seed)
    placed: dict[int, tuple[tuple[float, float, float], float]] = {}
    above: dict[int, tuple[float, float, float]] = {}
    taken: list[tuple[float, float, float]] = []

    def place(low_m: float, high_m: float) -> tuple[float, float, float]:
        while True:
            spot = (rng.uniform(-half_m, half_m), rng.uniform(-half_m, half_m), -rng.uniform(low_m, high_m))
            if all(math.dist(spot, other) > APART_M for other in taken):
                taken.append(spot)
                return spot

    for i in range(pursuers):
        placed[i + 1] = (place(1.5, 4.0), rng.uniform(*percent))
    for i in range(tankers):
        above[201 + i] = place(6.0, 10.0)
    return on_board(placed, above, seed=seed, **changes)


class Agreement(NamedTuple):
    """First decision of a fleet, s of the session: of the schedule that decides in the shadow, of the tankers, and
    when every vehicle knew it; who was chosen by each; and calls that a tanker refused for another one."""

    central_s: float
    accepted_s: float
    agreed_s: float
    central: Mapping[int, int]
    on_board: Mapping[int, int]
    refused_calls: int


def agreement(content: Mapping[str, Any], *, tankers_from_s: float = 5.0, within_s: float = 40.0) -> Agreement:
    """Fly a fleet until every one of its tankers has been given a receiver and everybody knows which. Tankers take
    part late, so that the radio has told everyone of everyone before there is anything to decide."""
    fleet = FleetInProcess(content, tankers_from_s=tankers_from_s, with_shadow=True)
    assert fleet.shadow is not None
    shadow = fleet.shadow
    tankers = [tanker.sysid for tanker in fleet.scenario.vehicles.tankers]
    central_s = accepted_s = agreed_s = math.inf

    def each() -> bool:
        nonlocal central_s, accepted_s, agreed_s
        if len(shadow.services) >= len(tankers):
            central_s = min(central_s, fleet.now_s)
        if all(fleet.served().values()):
            accepted_s = min(accepted_s, fleet.now_s)
            known = [fleet.believed(sysid) for sysid in fleet.vehicles]
            if all(one == known[0] and len(one) == len(tankers) and all(one.values()) for one in known):
                agreed_s = min(agreed_s, fleet.now_s)
        return math.isfinite(central_s) and math.isfinite(agreed_s)

    fleet.fly(within_s, each)
    receivers = (fleet.member(pursuer.sysid).receiver for pursuer in fleet.scenario.vehicles.pursuers)
    return Agreement(
        central_s,
        accepted_s,
        agreed_s,
        {int(s.tanker or 0): s.receiver for s in shadow.services[: len(tankers)]},
        {tanker: served[0] for tanker, served in fleet.served().items() if served},
        sum(receiver.refused_calls for receiver in receivers if receiver is not None),
    )
