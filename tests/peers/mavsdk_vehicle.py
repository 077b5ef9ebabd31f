"""A PX4 made of MAVSDK's server plugins, in the peers' own Python: a vehicle whose protocol is a stranger's work.

MAVSDK 4.1.0 answers parameters, missions, arming, take-off, modes, intervals and versions by itself, and builds every
message. It leaves most other commands without a word; the vehicle acknowledges those. Set points reach it by
MavlinkDirectServer. What cannot be said through the plugins is set right in the frames on their way out: in HEARTBEAT
the identity, which is GENERIC of no type, and a failsafe; in HOME_POSITION the altitude, which is always 0. Holding by
DO_SET_MODE is refused by the plugin whatever it is allowed. As a real PX4 1.17 it returns a second after the last set
point, and is in offboard again by itself once they flow. Moves as a double integrator, on the wall clock; ends with its
stdin.
"""

from __future__ import annotations

import argparse
import contextlib
import json
import math
import queue
import select
import socket
import sys
import time
from collections.abc import Callable
from typing import Any

from mavsdk.mavsdk import Configuration, Mavsdk
from mavsdk.plugins.action_server.action_server import ActionServer, AllowableFlightModes, FlightMode
from mavsdk.plugins.mavlink_direct_server.mavlink_direct_server import MavlinkDirectServer, MavlinkMessage
from mavsdk.plugins.mission_raw_server.mission_raw_server import MissionRawServer
from mavsdk.plugins.param_server.param_server import ParamServer
from mavsdk.plugins.telemetry_server import telemetry_server as told
from motion import STEP_S, ZERO, Body, Place, Vec3
from pymavlink.dialects.v20 import common as mav

FAST_HZ, SLOW_HZ = 20.0, 2.0
SET_POINTS_LAST_S = 1.0
ACCELERATION_M_S2 = 3.0
HOVER_W, IDLE_W, FULL_V, EMPTY_V = 350.0, 6.0, 16.8, 14.0
THERE_M = 0.15
RETURN_HEIGHT_M = 2.0
SPEEDS = {"MPC_XY_CRUISE": 5.0, "MPC_TKO_SPEED": 1.5, "MPC_LAND_SPEED": 0.7, "MIS_TAKEOFF_ALT": 2.5}
ANSWERED_BY_MAVSDK = {
    mav.MAV_CMD_COMPONENT_ARM_DISARM,
    mav.MAV_CMD_NAV_TAKEOFF,
    mav.MAV_CMD_DO_SET_MODE,
    mav.MAV_CMD_SET_MESSAGE_INTERVAL,
    mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES,
}
MESSAGES_ON_REQUEST = {mav.MAVLINK_MSG_ID_AUTOPILOT_VERSION, mav.MAVLINK_MSG_ID_HOME_POSITION}
OURS, ACCEPTED, UNSUPPORTED = mav.MAV_COMP_ID_AUTOPILOT1, mav.MAV_RESULT_ACCEPTED, mav.MAV_RESULT_UNSUPPORTED


class Wire:
    """MAVSDK's frames, over a UDP socket of the vehicle's own."""

    def __init__(self, mavsdk: Mavsdk, to: str, home_amsl_m: float) -> None:
        kind, host, port = to.split(":")
        if kind != "udpout":
            raise SystemExit(f"--connect {to}: only udpout:HOST:PORT")
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self._peer = (host, int(port))
        self._mavsdk = mavsdk
        self._home_mm = round(1000.0 * home_amsl_m)
        self.failsafe = False
        self._reader = mav.MAVLink(None)
        mavsdk.add_any_connection("raw://")
        mavsdk.subscribe_raw_bytes_to_be_sent(self._send)

    def receive(self) -> None:
        """Everything that has come, to MAVSDK."""
        with contextlib.suppress(OSError):
            while True:
                self._mavsdk.pass_received_raw_bytes(self.socket.recv(65536))

    def _send(self, frame: bytes) -> None:
        with contextlib.suppress(OSError):  # nobody listens yet: as on a radio, it is lost
            self.socket.sendto(self._corrected(frame), self._peer)

    def _corrected(self, frame: bytes) -> bytes:
        msgid = int.from_bytes(frame[7:10], "little")
        if msgid not in (mav.MAVLINK_MSG_ID_HEARTBEAT, mav.MAVLINK_MSG_ID_HOME_POSITION):
            return frame
        (message,) = self._reader.parse_buffer(frame)
        if msgid == mav.MAVLINK_MSG_ID_HEARTBEAT:
            message.type, message.autopilot = mav.MAV_TYPE_QUADROTOR, mav.MAV_AUTOPILOT_PX4
            message.base_mode |= mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
            if self.failsafe:
                message.system_status = mav.MAV_STATE_CRITICAL
        else:
            message.altitude = self._home_mm
        writer = mav.MAVLink(None, message.get_srcSystem(), message.get_srcComponent())
        writer.seq = message.get_seq()
        return bytes(message.pack(writer))


class Vehicle:
    """What it flies; events from MAVSDK's threads wait in a queue until the next step."""

    def __init__(self, options: argparse.Namespace, mavsdk: Mavsdk) -> None:
        self.options = options
        self.place = Place(options.origin)
        self.body = Body(options.start, options.start[2])
        self.home: Vec3 = options.start
        self.wire = Wire(mavsdk, options.connect, self.place.to_global(self.home)[2])
        self.now_s = self.used_j = 0.0
        self.mode, self.armed, self.flying, self.fresh = FlightMode.HOLD, False, False, False
        self.coming_down = False
        self.target_p: Vec3 | None = None
        self.target_v, self.target_yaw, self.target_s = ZERO, 0.0, -math.inf
        self.events: queue.SimpleQueue[tuple[Callable[..., None], tuple[Any, ...]]] = queue.SimpleQueue()
        component = mavsdk.server_component(0)
        self.action, self.direct = ActionServer(component), MavlinkDirectServer(component)
        self.telemetry, self.params = told.TelemetryServer(component), ParamServer(component)
        self.mission = MissionRawServer(component)
        for name, value in SPEEDS.items():
            self.params.provide_param_float(name, value)
        self.params.provide_param_float("RTL_RETURN_ALT", RETURN_HEIGHT_M)
        self.params.provide_param_int("SYS_AUTOSTART", 4001)
        self.action.set_disarmable(True, True)
        self.action.set_allow_takeoff(True)
        self.action.subscribe_arm_disarm(lambda result, order, _: self._later(self.on_arm, result, order))
        self.action.subscribe_takeoff(lambda result, _taken, __: self._later(self.on_takeoff, result))
        self.action.subscribe_flight_mode_change(lambda result, mode, _: self._later(self.on_mode, result, mode))
        for name in ("COMMAND_LONG", "SET_POSITION_TARGET_LOCAL_NED"):
            self.direct.subscribe_message(name, lambda message, _: self._later(self.on_message, message))
        self.takeoff_amsl_m = math.nan
        self.ready = False
        self.allow()

    def _later(self, what: Callable[..., None], *about: Any) -> None:
        self.events.put((what, about))

    def allow(self) -> None:
        """Tell the plugin what it may accept now: arming after a while, offboard with fresh set points."""
        self.ready = self.now_s >= self.options.refuse_arming_s
        self.action.set_armable(self.ready, self.ready)
        self.action.set_allowable_flight_modes(
            AllowableFlightModes(
                can_auto_mode=True,
                can_guided_mode=self.fresh,
                can_stabilize_mode=True,
                can_auto_rtl_mode=True,
                can_auto_takeoff_mode=True,
                can_auto_land_mode=True,
                can_auto_loiter_mode=True,
            )
        )

    def param(self, name: str) -> float:
        return float(self.params.retrieve_param_float(name))

    # what it is told

    def on_arm(self, result: int, order: Any) -> None:
        if result == 1:
            self.armed = order.arm
            self.flying = self.flying and order.arm
            return
        text = told.StatusText(told.StatusTextType.CRITICAL, "Preflight Fail: ekf2 missing data")
        self.telemetry.publish_status_text(text)

    def on_takeoff(self, result: int) -> None:
        if result == 1 and self.armed and not self.flying:
            self.flying = True
            height_m = self.takeoff_amsl_m - self.place.to_global(self.home)[2]
            height_m = height_m if math.isfinite(height_m) else self.param("MIS_TAKEOFF_ALT")
            self.target_p, self.target_v = (self.body.p[0], self.body.p[1], self.home[2] - height_m), ZERO
            self.enter(FlightMode.TAKEOFF)

    def on_mode(self, result: int, mode: int) -> None:
        if result == 1:
            self.enter(FlightMode(mode))

    def enter(self, mode: FlightMode) -> None:
        self.mode, self.wire.failsafe, self.coming_down = mode, False, mode is FlightMode.LAND
        self.action.set_flight_mode_internal(mode)
        if mode is FlightMode.HOLD:
            self.target_p, self.target_v = None, ZERO
        elif mode is FlightMode.RETURN_TO_LAUNCH:
            high = min(self.body.p[2], self.home[2] - self.param("RTL_RETURN_ALT"))
            self.target_p, self.target_v = (self.home[0], self.home[1], high), ZERO

    def on_message(self, message: Any) -> None:
        """A command that MAVSDK does not answer, or a set point, as JSON; NaN comes as null."""
        numbers = {k: math.nan if v is None else v for k, v in json.loads(message.fields_json).items()}
        if numbers["target_system"] not in (0, self.options.sysid) or numbers["target_component"] not in (0, OURS):
            return
        if message.message_name == "COMMAND_LONG":
            self._command(numbers, message.system_id, message.component_id)
        else:
            self._set_point(numbers)

    def _command(self, numbers: dict[str, Any], system: int, component: int) -> None:
        command = numbers["command"]
        if command == mav.MAV_CMD_NAV_TAKEOFF:
            self.takeoff_amsl_m = numbers["param7"]
        by_mavsdk = command == mav.MAV_CMD_REQUEST_MESSAGE and numbers["param1"] in MESSAGES_ON_REQUEST
        if by_mavsdk or command in ANSWERED_BY_MAVSDK:
            return
        modes = {
            mav.MAV_CMD_NAV_LAND: FlightMode.LAND,
            mav.MAV_CMD_NAV_RETURN_TO_LAUNCH: FlightMode.RETURN_TO_LAUNCH,
            mav.MAV_CMD_NAV_LOITER_UNLIM: FlightMode.HOLD,
        }
        result = UNSUPPORTED
        if command == mav.MAV_CMD_REQUEST_MESSAGE and numbers["param1"] == mav.MAVLINK_MSG_ID_GPS_GLOBAL_ORIGIN:
            self.tell_origin()
            result = ACCEPTED
        elif command in modes:
            self.enter(modes[command])
            result = ACCEPTED
        self.tell(
            "COMMAND_ACK",
            command=command,
            result=result,
            progress=255,
            result_param2=0,
            target_system=system,
            target_component=component,
        )

    def _set_point(self, numbers: dict[str, Any]) -> None:
        """Positions, velocities or both, in the local frame; anything else is passed over."""
        mask = int(numbers["type_mask"])
        p, v = (tuple(float(numbers[key]) for key in keys) for keys in (("x", "y", "z"), ("vx", "vy", "vz")))
        no_p, no_v = mask & 0x7 == 0x7, mask & 0x38 == 0x38
        whole = mask & 0x7 in (0, 0x7) and mask & 0x38 in (0, 0x38) and not (no_p and no_v)
        used = (*(() if no_p else p), *(() if no_v else v))
        if numbers["coordinate_frame"] != mav.MAV_FRAME_LOCAL_NED or not whole or not all(map(math.isfinite, used)):
            return
        self.target_s = self.now_s
        if self.mode is FlightMode.OFFBOARD:
            self.target_p, self.target_v = None if no_p else p, ZERO if no_v else v  # type: ignore[assignment]
            if not mask & 0x400 and math.isfinite(numbers["yaw"]):
                self.target_yaw = float(numbers["yaw"])

    # what it tells

    def tell(self, name: str, **fields: Any) -> None:
        content = json.dumps(fields)
        self.direct.send_message(MavlinkMessage(name, self.options.sysid, OURS, 0, 0, content))

    def tell_origin(self) -> None:
        lat, lon, alt_m = self.place.to_global(ZERO)
        self.tell("GPS_GLOBAL_ORIGIN", latitude=lat, longitude=lon, altitude=round(1000.0 * alt_m), time_usec=0)

    def _here(self, p: Vec3) -> Any:
        lat, lon, alt_m = self.place.to_global(p)
        return told.Position(lat * 1e-7, lon * 1e-7, alt_m, self.home[2] - p[2])

    def publish_fast(self) -> None:
        p, v = told.PositionNed(*self.body.p), told.VelocityNed(*self.body.v)
        roll, pitch = self.body.tilt
        attitude = told.EulerAngle(
            *(math.degrees(a) for a in (roll, pitch, math.remainder(self.body.yaw, math.tau))), 0
        )
        self.telemetry.publish_position_velocity_ned(told.PositionVelocityNed(p, v))
        heading = told.Heading(math.degrees(self.body.yaw) % 360.0)
        self.telemetry.publish_position(self._here(self.body.p), v, heading)
        self.telemetry.publish_attitude(attitude, told.AngularVelocityBody(0.0, 0.0, 0.0))

    def publish_slowly(self) -> None:
        """The battery's percent go into the plugin as a share of 1."""
        left = self.remaining
        battery = told.Battery(EMPTY_V + (FULL_V - EMPTY_V) * left, left)
        self.telemetry.publish_sys_status(battery, True, True, True, True, True)
        self.telemetry.publish_battery(battery)
        state = told.LandedState.IN_AIR if self.flying else told.LandedState.ON_GROUND
        self.telemetry.publish_extended_sys_state(told.VtolState.UNDEFINED, state)
        here = self._here(self.body.p)
        gps = told.RawGps(round(1e6 * self.now_s), here.latitude_deg, here.longitude_deg, here.absolute_altitude_m)
        self.telemetry.publish_raw_gps(gps, told.GpsInfo(12, told.FixType.FIX_3D))
        self.telemetry.publish_home(self._here(self.home))
        self.tell_origin()

    @property
    def remaining(self) -> float:
        return max(0.0, 1.0 - self.used_j / (3600.0 * self.options.battery_wh))

    # its life

    def step(self) -> None:
        self.now_s += STEP_S
        while not self.events.empty():
            what, about = self.events.get()
            what(*about)
        self.used_j += (HOVER_W if self.flying else IDLE_W) * STEP_S
        fresh = self.now_s - self.target_s < SET_POINTS_LAST_S
        if fresh != self.fresh or self.ready != (self.now_s >= self.options.refuse_arming_s):
            self.fresh = fresh
            self.allow()
        if self.flying:
            self._fly()

    def _fly(self) -> None:
        if self.mode is FlightMode.OFFBOARD and not self.fresh:
            self.enter(FlightMode.RETURN_TO_LAUNCH)
            self.wire.failsafe = True
        elif self.wire.failsafe and self.fresh:
            self.enter(FlightMode.OFFBOARD)
        if self.mode is FlightMode.RETURN_TO_LAUNCH and self._there():
            self.coming_down = True  # in the same mode, which set points can still end
        if self.remaining <= 0.0 and self.mode is not FlightMode.LAND:
            self.enter(FlightMode.LAND)
        if self.mode is FlightMode.TAKEOFF and self._there():
            self.enter(FlightMode.HOLD)
        speed_m_s = self.param("MPC_TKO_SPEED" if self.mode is FlightMode.TAKEOFF else "MPC_XY_CRUISE")
        wanted = self.target_v
        if self.coming_down:
            wanted = (0.0, 0.0, self.param("MPC_LAND_SPEED"))
        elif self.target_p is not None:
            wanted = self.body.towards(self.target_p, self.target_v, speed_m_s, ACCELERATION_M_S2)
        self.body.turn(self.target_yaw)
        if self.body.follow(wanted, ACCELERATION_M_S2) and self.coming_down:
            self.armed = self.flying = False
            self.action.set_armed_state(False)
            self.enter(FlightMode.HOLD)

    def _there(self) -> bool:
        return self.target_p is not None and math.dist(self.body.p, self.target_p) < THERE_M

    def live(self) -> None:
        """Until stdin ends."""
        began_s = time.monotonic()
        fast_s = slow_s = 0.0
        while True:
            wait_s = max(0.0, began_s + self.now_s + STEP_S - time.monotonic())
            ready, _, _ = select.select([self.wire.socket, sys.stdin], [], [], wait_s)
            if sys.stdin in ready and not sys.stdin.buffer.read1():
                return
            if self.wire.socket in ready:
                self.wire.receive()
            while time.monotonic() >= began_s + self.now_s + STEP_S:
                self.step()
            if self.now_s >= fast_s:
                fast_s += 1.0 / FAST_HZ
                self.publish_fast()
            if self.now_s >= slow_s:
                slow_s += 1.0 / SLOW_HZ
                self.publish_slowly()


def three(text: str) -> Vec3:
    first, second, third = map(float, text.split(","))
    return first, second, third


def main() -> None:
    says = argparse.ArgumentParser(description="A PX4 made of MAVSDK's server plugins, until its stdin ends.")
    says.add_argument("--sysid", type=int, default=1)
    says.add_argument("--connect", default="udpout:127.0.0.1:14550", metavar="udpout:HOST:PORT")
    says.add_argument("--origin", type=three, default=(47.3977, 8.5457, 488.5), metavar="LAT,LON,ALT")
    says.add_argument("--start", type=three, default=ZERO, metavar="N,E,D", help="from its own origin, m")
    says.add_argument("--refuse-arming-s", type=float, default=2.0, help="how long after its start arming is refused")
    says.add_argument("--battery-wh", type=float, default=70.0)
    options = says.parse_args()
    with Mavsdk(Configuration.create_manual(options.sysid, OURS, True)) as mavsdk:
        Vehicle(options, mavsdk).live()


if __name__ == "__main__":
    main()
