"""Supervised vehicles of one process whose usual ticks are flown in compiled code (`mavlink/steady_tick.py`).

A vehicle whose tick was usual, and whose next may be, is handed over: from then on its row is what it is. Whatever is
not usual is done by the vehicle and its services themselves, once they are what the row is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from simvehicle.autopilot.maneuvers import OffboardSetPoint
from simvehicle.autopilot.snapshot import Vec3
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.law.plants import Plant, RotorPlant
from simvehicle.law.rotor_flight import NOISE_SIZE
from simvehicle.law.rows import PARAMS_SIZE, ROTOR_STATE_SIZE, STATE_SIZE
from simvehicle.mavlink.codec import HEADER_BYTES, ReceivedFrame, encode
from simvehicle.mavlink.connection import Connection
from simvehicle.mavlink.dispatcher import Services
from simvehicle.mavlink.lockstep import Grants
from simvehicle.mavlink.steady_answer import FRAMES_BYTES, PAYLOAD_BYTES, STEADY, STREAMS, WRITTEN, frame_table
from simvehicle.mavlink.steady_tick import MOST_STEPS, SENT_BYTES
from simvehicle.mavlink.telemetry import TELEMETRY
from simvehicle.sitl import steady_loop
from simvehicle.sitl.link import SUPERVISED_BYTES, SupervisedLink
from simvehicle.sitl.truth import FIXED_NUMBERS, TruthWriter
from skytender import mavlink as mav

STEPS_AHEAD = steady_loop.DATAGRAMS * MOST_STEPS
"""For so many steps noise is drawn in advance: those of one call of the loop."""
MOST_LEFT = 64
"""Stretches of a datagram that are left at once."""
_USUAL = frozenset({mav.MAVLINK_MSG_ID_SET_POSITION_TARGET_LOCAL_NED, mav.MAVLINK_MSG_ID_HEARTBEAT})
_NEVER_MS = 1 << 60


class Flyable(NamedTuple):
    """A vehicle with what makes its answers."""

    vehicle: Vehicle
    services: Services
    truth: TruthWriter | None


class _Member:
    """A vehicle and its link, and the payloads of its streams while they are steady."""

    def __init__(self, flyable: Flyable, connection: Connection, grants: Grants) -> None:
        self.vehicle, self.services, self.truth = flyable
        self.connection, self.grants = connection, grants
        self._payloads_of: tuple[Vec3, float, int, int] | None = None
        self._payloads: NDArray[np.uint8] = np.zeros(0, np.uint8)

    @property
    def is_steady(self) -> bool:
        """Whether its next tick may be usual."""
        return self.vehicle.only_steered and self.services.idle and not self.connection.waiting

    def payloads(self) -> NDArray[np.uint8]:
        """Payloads of the streams that are written in compiled code, as they are now."""
        vehicle = self.vehicle
        now = (vehicle.home_ned, vehicle.yaw_ned, vehicle.given_j, vehicle.received_j)
        if now != self._payloads_of:
            self._payloads_of, snapshot = now, vehicle.snapshot()
            written = (stream.build(snapshot) if stream.key in WRITTEN else None for stream in TELEMETRY)
            self._payloads = np.frombuffer(b"".join(map(_payload, (*written, None))), np.uint8)
        return self._payloads


def _payload(content: object) -> bytes:
    """The payload of a message, filled up with zeros."""
    if content is None:
        return bytes(PAYLOAD_BYTES)
    frame = encode(content, seq=0, sysid=0, compid=0)
    return frame[HEADER_BYTES : HEADER_BYTES + frame[1]].ljust(PAYLOAD_BYTES, b"\0")


class RotorRows:
    """Airframes, weathers, gusts and noise of vehicles on rotors, by rows."""

    def __init__(self, first: tuple[NDArray[np.float64], ...], n: int) -> None:
        airframe, weather, gusts = first
        self._airframes, self._weathers = np.zeros((n, airframe.shape[1])), np.zeros((n, weather.shape[1]))
        self._noise = np.zeros((n, STEPS_AHEAD, NOISE_SIZE))
        self.arrays = (self._airframes, self._weathers, gusts, self._noise)
        """as `steady_loop.serve` has them"""

    @classmethod
    def shared_by(cls, plants: Sequence[Plant], n: int) -> RotorRows | None:
        """For n rows, where these plants have rotors, and one air that is the same everywhere."""
        found = [plant.surroundings if isinstance(plant, RotorPlant) else None for plant in plants]
        if not found or found[0] is None:
            return None
        gusts = found[0][2]
        same = all(one is not None and np.array_equal(one[2], gusts) for one in found)
        return cls(found[0], n) if same else None

    def put(self, row: int, plant: RotorPlant) -> int:
        """Let a row be a plant's; for how many steps there is noise."""
        assert plant.surroundings is not None
        airframe, weather, _ = plant.surroundings
        self._airframes[row], self._weathers[row] = airframe[0], weather[0]
        if plant.still:
            return MOST_STEPS
        self._noise[row] = plant.noise_ahead(STEPS_AHEAD)[0]
        return STEPS_AHEAD


class SteadyFlight:
    """The vehicles of one process by rows, in order; None for a unit that is no vehicle of ours."""

    def __init__(self, members: Sequence[tuple[Flyable | None, Connection, Grants]]) -> None:
        n = len(members)
        self._members = [
            None if flyable is None else _Member(flyable, connection, grants) for flyable, connection, grants in members
        ]
        self._rows = np.zeros(n, STEADY)
        plants = [member.vehicle.plant for member in self._members if member is not None]
        self._rotors = RotorRows.shared_by(plants, n)
        state_size = STATE_SIZE if self._rotors is None else ROTOR_STATE_SIZE
        self._states, self._parameters = np.zeros((n, state_size)), np.zeros((n, PARAMS_SIZE))
        self._row_of = np.full(256, -1)
        for row, (_, connection, _) in enumerate(members):
            self._rows[row]["sysid"] = connection.sysid
            self._row_of[connection.sysid] = row
        self._truth = np.zeros((n, FIXED_NUMBERS + MOST_STEPS))
        self._flown, self._left = np.zeros(n, np.int64), np.zeros((MOST_LEFT, 2), np.int64)
        self._buffer = np.zeros(SUPERVISED_BYTES, np.uint8)
        self.waits = np.zeros(steady_loop.WAITS, np.int64)
        """what the loop keeps of its waits for datagrams"""
        self._arguments = (
            *(self._buffer, n > 1, self._row_of, self._rows, self._states, self._parameters),
            *((None,) * 4 if self._rotors is None else self._rotors.arrays),
            *(frame_table(), self._truth, self._flown, self._left),
            *(np.zeros(SENT_BYTES + FRAMES_BYTES, np.uint8), self.waits),
        )
        self._stand = (0,) * 6
        """of the datagram that is read, between two calls of the loop"""

    def ticks(self, row: int) -> int:
        """How many ticks of a vehicle were flown here."""
        return int(self._rows[row]["ticks"])

    def serve(self, link: SupervisedLink) -> list[bytes]:
        """Receive and fly while that is usual, for a while at most; what was received and is not usual, in stretches.
        Raises OSError where truth cannot be written."""
        if self._rotors is not None:
            self._draw_ahead(self._rotors)
        have, at, others, flown, first, unsent = steady_loop.serve(link.fileno(), *self._stand, *self._arguments)
        while flown:
            self._finish(int(self._flown[first]))
            stand = have, at, others, flown, first + 1, unsent
            have, at, others, flown, first, unsent = steady_loop.serve(link.fileno(), *stand, *self._arguments)
        self._stand = have, at, 0, 0, 0, 0
        return [self._buffer[start:stop].tobytes() for start, stop in self._left[:others].tolist()]

    def _draw_ahead(self, rotors: RotorRows) -> None:
        """Let no vehicle run out of noise while the loop flies it."""
        for row in np.flatnonzero(self._rows["steady"] & (self._rows["noise_step"] > 0)).tolist():
            member, one = self._members[row], self._rows[row]
            assert member is not None
            if isinstance(member.vehicle.plant, RotorPlant):
                member.vehicle.plant.leave_behind(int(one["noise_step"]))
                one["noise_step"], one["noise_end"] = 0, rotors.put(row, member.vehicle.plant)

    def _finish(self, row: int) -> None:
        """Write what the disk has not taken of a vehicle's record of truth: why, the system says once more."""
        member, one, record = self._members[row], self._rows[row], self._truth[row]
        assert member is not None
        assert member.truth is not None
        rest = record[: FIXED_NUMBERS + int(record[1])].tobytes()[int(one["truth_taken"]) :]
        member.truth.go_on(float(one["truth_due_s"]), int(one["truth_bytes"]), rest)
        one["truth_bytes"] = 0

    def take_back(self, row: int) -> None:
        """Let a vehicle and its link be what its row is, before anything else is done with them."""
        one, member = self._rows[row], self._members[row]
        if member is None or not one["steady"]:
            return
        one["steady"] = 0
        if member.truth is not None:
            member.truth.go_on(float(one["truth_due_s"]), int(one["truth_bytes"]))
        vehicle, gcs_seen_s = member.vehicle, float(one["gcs_seen_s"])
        vehicle.time_ms = int(one["time_ms"])
        vehicle.plant.go_on_from(self._states[row])
        if isinstance(vehicle.plant, RotorPlant):
            vehicle.plant.leave_behind(int(one["noise_step"]))
        vehicle.power_w = float(one["power_w"])
        vehicle.gcs_seen_s = None if math.isnan(gcs_seen_s) else gcs_seen_s
        p_ned, v_ned = one["set_p_ned"].tolist(), one["set_v_ned"].tolist()
        vehicle.setpoint = OffboardSetPoint(tuple(p_ned), tuple(v_ned), (True, True, True), None, float(one["set_s"]))
        member.connection.seq = int(one["seq"])
        member.connection.streams.set_due(one["due_ms"].tolist())
        member.grants.number, member.grants.time_ms = int(one["number"]), int(one["granted_ms"])
        if one["answer_bytes"]:
            member.grants.last_answer = [one["answer"][: one["answer_bytes"]].tobytes()]

    def hand_over(self, row: int, applied: Iterable[ReceivedFrame]) -> None:
        """Fly a vehicle here from its next tick on, if that may be usual; `applied`: the frames of its last one."""
        member = self._members[row]
        if member is None or not all(frame.msgid in _USUAL for frame in applied) or not member.is_steady:
            return
        plant, ahead = member.vehicle.plant, MOST_STEPS
        if self._rotors is not None and isinstance(plant, RotorPlant):
            ahead = self._rotors.put(row, plant)
        elif type(plant) is not Plant:
            return
        one, vehicle, grants = self._rows[row], member.vehicle, member.grants
        timetable = member.connection.streams.timetable()
        others = zip(STREAMS, timetable, strict=True)
        others_ms = (due_ms for key, (interval_ms, due_ms) in others if interval_ms and key not in WRITTEN)
        truth_fd, truth_period_s, truth_due_s = (-1, 0.0, 0.0) if member.truth is None else member.truth.schedule
        parameters, setpoint = vehicle.parameters, vehicle.setpoint
        assert setpoint is not None
        self._states[row], self._parameters[row] = vehicle.state[0], vehicle.plant.packed[0]
        for name, value in (
            ("granted_ms", grants.time_ms),
            ("time_ms", vehicle.time_ms),
            ("number", grants.number),
            ("seq", member.connection.seq),
            ("until_ms", min(others_ms, default=_NEVER_MS)),
            ("ground", vehicle.ground),
            ("checked", parameters["ARMING_CHECK"]),
            ("unix_epoch_us", vehicle.unix_epoch_us),
            ("given_j", vehicle.given_j),
            ("received_j", vehicle.received_j),
            ("truth_fd", truth_fd),
            ("truth_period_s", truth_period_s),
            ("truth_due_s", truth_due_s),
            ("truth_bytes", 0),
            ("gcs_seen_s", math.nan if vehicle.gcs_seen_s is None else vehicle.gcs_seen_s),
            ("gcs_loss_s", parameters["COM_DL_LOSS_T"]),
            ("set_s", setpoint.time_s),
            ("set_p_ned", setpoint.p_ned),
            ("set_v_ned", setpoint.v_ned),
            ("set_loss_s", parameters["COM_OF_LOSS_T"]),
            ("yaw_ned", vehicle.yaw_ned),
            ("fastest_m_s", parameters["MPC_XY_VEL_MAX"]),
            ("power_w", vehicle.power_w),
            ("floor_j", parameters["BAT_EMERGEN_THR"] * vehicle.capacity_j),
            ("capacity_j", vehicle.capacity_j),
            ("home_down_m", vehicle.home_ned[2]),
            ("origin", vehicle.frame.row),
            ("interval_ms", [interval_ms for interval_ms, _ in timetable]),
            ("due_ms", [due_ms for _, due_ms in timetable]),
            ("payloads", member.payloads()),
            ("rotors", isinstance(plant, RotorPlant)),
            ("senses", isinstance(plant, RotorPlant) and plant.own.errors is not None),
            ("noise_step", 0),
            ("noise_end", ahead),
            ("noise_moves", ahead > MOST_STEPS),
            ("answer_bytes", 0),
            ("steady", 1),
        ):
            one[name] = value
