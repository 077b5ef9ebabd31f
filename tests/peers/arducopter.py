"""A scripted ArduCopter: a second vehicle for the ground station's tests that shares no line with ours but pymavlink.

It keeps to the habits that ArduCopter 4.6 shows in its own simulator: console text before the first frame, little but
HEARTBEAT until asked, no origin at first, arming refused for a while, GUIDED before take-off, take-off to a height
above home, integers as floats, silence about unknown parameters, some parameters told unasked and, like answers to a
name, without an index. It leaves the ground three seconds after it was armed; till then it takes a take-off, and after
that it refuses it. A request for a message is accepted, whether or not there is anything to tell yet. Its reasons
follow its acknowledgement. Like one flown without a radio it arms in GUIDED only. It moves as a double integrator with
limits on speed and acceleration, on the wall clock, and ends with its stdin.
"""

from __future__ import annotations

import argparse
import contextlib
import math
import random
import select
import socket
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

from arducopter_files import Files, packed
from arducopter_motion import GUIDED, LAND, LOITER, MODES, PARAMETERS, REAL32, RTL, RUNTIME_EVERY_S, Copter
from arducopter_parameters import Told
from arducopter_plans import RallyPoints
from arducopter_telemetry import Telemetry
from motion import STEP_S, ZERO, Vec3
from pymavlink.dialects.v20 import ardupilotmega as mav

PARAMETERS_PER_STEP = 5
UNASKED = 65535
"""PARAM_VALUE's index where nobody asked for one by its index."""
BANNER = b"\n\nInit ArduCopter V4.6.0 (scripted)\n\nFree RAM: 131072\n", b"load_all took 4100us\nReady to FLY "

STREAMS = {
    mav.MAV_DATA_STREAM_EXTENDED_STATUS: ("SYS_STATUS", "GPS_RAW_INT", "MISSION_CURRENT"),
    mav.MAV_DATA_STREAM_POSITION: ("GLOBAL_POSITION_INT", "LOCAL_POSITION_NED"),
    mav.MAV_DATA_STREAM_EXTRA1: ("ATTITUDE",),
    mav.MAV_DATA_STREAM_EXTRA2: ("VFR_HUD",),
    mav.MAV_DATA_STREAM_EXTRA3: ("BATTERY_STATUS", "SYSTEM_TIME"),
}
"""EXTENDED_SYS_STATE is in none of them: ArduCopter sends it only to who asks for that message."""


PACKED = {mav.MAV_PARAM_TYPE_INT8: 1, mav.MAV_PARAM_TYPE_INT16: 2, mav.MAV_PARAM_TYPE_INT32: 3, REAL32: 4}
LOSSY = (mav.MAVLINK_MSG_ID_LOCAL_POSITION_NED, mav.MAVLINK_MSG_ID_ATTITUDE)


class Datagrams:
    """What pymavlink writes to: each frame in a datagram of its own."""

    def __init__(self, to: str, lose: float = 0.0) -> None:
        self._lose, self._random = lose, random.Random(1)
        kind, host, port = to.split(":")
        if kind != "udpout":
            raise SystemExit(f"--connect {to}: only udpout:HOST:PORT")
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.setblocking(False)
        self.peer = (host, int(port))

    def write(self, frame: bytes) -> None:
        if frame[7] in LOSSY and self._random.random() < self._lose:
            return
        with contextlib.suppress(OSError):  # nobody listens yet, or the buffer is full: as on a radio, it is lost
            self.socket.sendto(frame, self.peer)

    def read(self) -> bytes:
        try:
            return self.socket.recv(65536)
        except OSError:
            return b""


class ArduCopter:
    """The vehicle on the air."""

    def __init__(self, options: argparse.Namespace) -> None:
        self.options = options
        self.copter = Copter(options.start, options.battery_wh)
        self.copter.parameters["SYSID_THISMAV"] = options.sysid
        self.copter.parameters.update(options.param)
        self.telemetry = Telemetry(self.copter, options)
        self.link = Datagrams(options.connect, options.lose)
        self.out = mav.MAVLink(self.link, srcSystem=options.sysid, srcComponent=mav.MAV_COMP_ID_AUTOPILOT1)
        self.out.robust_parsing = True
        self.due: dict[str, float] = {}
        self.interval: dict[str, float] = {}
        self.parameters_to_tell: list[int] = []
        self.told = Told(self.copter, si_names=options.si_names, locked=options.locked)
        self.files = Files({})
        self.rally = RallyPoints()
        self.origin_told = False
        self.began_s = 0.0
        self.way = options.way.open("w", encoding="utf-8", buffering=1) if options.way is not None else None
        self.heartbeat_s = 0.0
        self.runtime_s = 1.0
        self.reasons: list[tuple[int, str]] = []
        for text in BANNER:
            self.link.write(text)

    # what it tells

    def say(self, severity: int, text: str) -> None:
        """After what is being answered has been acknowledged."""
        self.reasons.append((severity, text))

    def _say_it(self) -> None:
        if self.options.says and self.copter.flying:
            text, self.options.says = self.options.says.encode(), ""
            for number, at in enumerate(range(0, len(text), 50)):
                self.out.statustext_send(mav.MAV_SEVERITY_WARNING, text[at : at + 50], id=7, chunk_seq=number)
        for severity, text in self.reasons:
            self.out.statustext_send(severity, text.encode())
        self.reasons.clear()

    def tell(self, name: str) -> bool:
        """One message of its telemetry; False where it has none of that name, or nothing to put in it yet."""
        message = self.telemetry.message(name)
        if message is not None:
            self.out.send(message)
        return message is not None

    def _parameter(self, name: str, index: int = UNASKED) -> None:
        told = self.told
        self.out.param_value_send(name.encode(), told.number(name), told.kind(name), len(told.names), index)

    # what it is told

    def hear(self, datagram: bytes) -> None:
        for message in self.out.parse_buffer(datagram) or []:
            target = getattr(message, "target_system", 0), getattr(message, "target_component", 0)
            if target[0] not in (0, self.options.sysid) or target[1] not in (0, mav.MAV_COMP_ID_AUTOPILOT1):
                continue
            handler = getattr(self, f"on_{message.get_type().lower()}", None)
            if handler is not None:
                handler(message)

    def on_heartbeat(self, m: Any) -> None:
        if m.type == mav.MAV_TYPE_GCS:
            self.copter.station_s = self.copter.now_s

    def on_command_long(self, m: Any) -> None:
        place = (m.param5 * 1e7, m.param6 * 1e7)
        self._command(m, (m.param1, m.param2, m.param3, m.param4), place, m.param7)

    def on_command_int(self, m: Any) -> None:
        self._command(m, (m.param1, m.param2, m.param3, m.param4), (m.x, m.y), m.z)

    def _command(self, m: Any, params: Sequence[float], place: Sequence[float], z: float) -> None:
        command = COMMANDS.get(m.command)
        result = mav.MAV_RESULT_UNSUPPORTED if command is None else command(self, params, place, z)
        self.out.command_ack_send(m.command, result, 0, 0, m.get_srcSystem(), m.get_srcComponent())

    def on_set_mode(self, m: Any) -> None:
        self.copter.enter(m.custom_mode)

    def on_request_data_stream(self, m: Any) -> None:
        everything = m.req_stream_id == mav.MAV_DATA_STREAM_ALL
        for stream in STREAMS if everything else [m.req_stream_id]:
            for name in STREAMS.get(stream, ()):
                self._every(name, 1.0 / m.req_message_rate if m.start_stop and m.req_message_rate else 0.0)

    def _every(self, name: str, interval_s: float) -> None:
        if interval_s > 0.0:
            self.interval[name], self.due[name] = max(interval_s, STEP_S), self.copter.now_s
        else:
            self.due.pop(name, None)

    def on_param_request_list(self, m: Any) -> None:
        self.parameters_to_tell = list(range(len(self.told.names)))

    def on_param_request_read(self, m: Any) -> None:
        names = self.told.names
        if 0 <= m.param_index < len(names):
            self._parameter(names[m.param_index], m.param_index)
        elif m.param_index < 0 and m.param_id in names:
            self._parameter(m.param_id)

    def on_param_set(self, m: Any) -> None:
        if self.told.write(m.param_id, m.param_value):
            self._parameter(m.param_id)

    def on_file_transfer_protocol(self, m: Any) -> None:
        """By MAVFTP its parameters come in one file."""
        told = self.told
        kinds = {name: (told.number(name), PACKED[told.kind(name)]) for name in told.names}
        self.files.files = {"@PARAM/param.pck": packed(kinds)}
        for answer in self.files.hear(m):
            self.out.send(answer)

    def on_plan(self, m: Any) -> None:
        for answer in self.rally.hear(m):
            self.out.send(answer)

    on_mission_request_list = on_mission_count = on_mission_item_int = on_mission_request_int = on_plan

    def on_log_request_list(self, _: Any) -> None:
        """None yet, which an ArduCopter says while it is disarmed."""
        if not self.copter.armed:
            self.out.log_entry_send(0, 0, 0, 0, 0)

    def on_timesync(self, m: Any) -> None:
        if m.tc1 == 0:
            self.out.timesync_send(round(1e9 * self.copter.now_s), m.ts1)

    def on_set_position_target_local_ned(self, m: Any) -> None:
        """Positions, velocities or both; anything else is passed over, as is all while it is not flown in GUIDED."""
        no_p, no_v, no_yaw = m.type_mask & 0x7 == 0x7, m.type_mask & 0x38 == 0x38, m.type_mask & 0x400
        part = m.type_mask & 0x7 not in (0, 0x7) or m.type_mask & 0x38 not in (0, 0x38)
        values = (*((m.x, m.y, m.z) if not no_p else ()), *((m.vx, m.vy, m.vz) if not no_v else ()))
        if self.copter.mode != GUIDED or not self.copter.flying or part or (no_p and no_v):
            return
        if not all(map(math.isfinite, values)):
            return
        p, v = (m.x, m.y, m.z), (m.vx, m.vy, m.vz)
        cos, sin = math.cos(self.copter.body.yaw), math.sin(self.copter.body.yaw)
        if m.coordinate_frame in (mav.MAV_FRAME_BODY_NED, mav.MAV_FRAME_BODY_OFFSET_NED):
            p, v = ((cos * u[0] - sin * u[1], sin * u[0] + cos * u[1], u[2]) for u in (p, v))
        if m.coordinate_frame != mav.MAV_FRAME_LOCAL_NED:
            here = self.copter.body.p
            p = (p[0] + here[0], p[1] + here[1], p[2] + here[2])
        self.copter.aim(None if no_p else p, ZERO if no_v else v, None if no_yaw else m.yaw)

    # commands: each returns its MAV_RESULT

    def arm(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        copter, forced = self.copter, params[1] in (2989.0, 21196.0)
        if params[0] == 0.0:
            if copter.flying and not forced:
                return mav.MAV_RESULT_FAILED
            copter.disarm()
            return mav.MAV_RESULT_ACCEPTED
        if copter.armed:
            return mav.MAV_RESULT_ACCEPTED
        reason = None
        if not self.telemetry.has_origin:
            reason = "PreArm: AHRS: waiting for home"
        elif copter.now_s < self.options.refuse_arming_s:
            reason = "Arm: Need Position Estimate"
        elif copter.mode != GUIDED:
            reason = f"Arm: {MODES[copter.mode]} mode not armable"
        if reason is not None and not forced:
            self.say(mav.MAV_SEVERITY_CRITICAL, reason)
            return mav.MAV_RESULT_FAILED
        copter.arm()
        self.say(mav.MAV_SEVERITY_INFO, "Arming motors")
        return mav.MAV_RESULT_ACCEPTED

    def take_off(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        copter = self.copter
        if not (copter.armed and copter.mode == GUIDED and not copter.flying and z > 0.0):
            return mav.MAV_RESULT_FAILED
        copter.take_off(z)
        return mav.MAV_RESULT_ACCEPTED

    def set_mode(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        custom = math.isfinite(params[0]) and int(params[0]) & mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED
        known = custom and math.isfinite(params[1]) and self.copter.enter(int(params[1]))
        return done(bool(known))

    def set_interval(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        if self.options.refuse_intervals:
            return mav.MAV_RESULT_UNSUPPORTED
        name = named(params[0])
        if not self.telemetry.knows(name) or not math.isfinite(params[1]):
            self.say(mav.MAV_SEVERITY_INFO, f"No ap_message for mavlink id ({params[0]:.0f})")
            return mav.MAV_RESULT_DENIED
        self._every(name, 1e-6 * params[1])
        return mav.MAV_RESULT_ACCEPTED

    def request_message(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        self.tell(named(params[0]))
        return done(self.telemetry.knows(named(params[0])))

    def get_home(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        return done(self.tell("HOME_POSITION") and self.tell("GPS_GLOBAL_ORIGIN"))

    def reposition(self, params: Sequence[float], place: Sequence[float], z: float) -> int:
        if self.copter.mode != GUIDED or not self.copter.flying or not all(map(math.isfinite, (*place, z))):
            return mav.MAV_RESULT_FAILED
        self.copter.aim(self.telemetry.place.to_local(place[0], place[1], z), ZERO, None)
        return mav.MAV_RESULT_ACCEPTED

    # its life

    def step(self) -> None:
        """One step, and what is due after it."""
        self.copter.step()
        if self.way is not None:
            print(self.began_s + self.copter.now_s / self.options.speedup, *self.copter.body.p, file=self.way)
        now_s = self.copter.now_s
        if now_s >= self.heartbeat_s:
            self.tell("HEARTBEAT")
            self.heartbeat_s += 1.0
        if self.telemetry.has_origin and not self.origin_told:
            self.origin_told = True
            self.say(mav.MAV_SEVERITY_INFO, "EKF3 IMU0 origin set")
            self.tell("GPS_GLOBAL_ORIGIN")
            self.tell("HOME_POSITION")
        for text in self.copter.told:
            self.say(mav.MAV_SEVERITY_WARNING, text)
        self.copter.told.clear()
        self._say_it()
        for name, due_s in self.due.items():
            if now_s >= due_s:
                self.tell(name)
                self.due[name] = max(due_s + self.interval[name], now_s - self.interval[name])
        tell, self.parameters_to_tell = self.parameters_to_tell, self.parameters_to_tell[PARAMETERS_PER_STEP:]
        for index in tell[:PARAMETERS_PER_STEP]:
            self._parameter(self.told.names[index], index)
        if now_s >= self.runtime_s:
            self.runtime_s += RUNTIME_EVERY_S
            self.copter.parameters["STAT_RUNTIME"] = math.floor(now_s)
            self._parameter("STAT_RUNTIME")

    def live(self) -> None:
        """Until stdin ends."""
        self.began_s, speed = time.monotonic(), self.options.speedup
        began_s = self.began_s
        while True:
            wait_s = max(0.0, began_s + (self.copter.now_s + STEP_S) / speed - time.monotonic())
            ready, _, _ = select.select([self.link.socket, sys.stdin], [], [], wait_s)
            if sys.stdin in ready and not sys.stdin.buffer.read1():
                return
            if self.link.socket in ready:
                self.hear(self.link.read())
            while time.monotonic() >= began_s + (self.copter.now_s + STEP_S) / speed:
                self.step()


COMMANDS: dict[int, Callable[[ArduCopter, Sequence[float], Sequence[float], float], int]] = {
    mav.MAV_CMD_COMPONENT_ARM_DISARM: ArduCopter.arm,
    mav.MAV_CMD_NAV_TAKEOFF: ArduCopter.take_off,
    mav.MAV_CMD_DO_SET_MODE: ArduCopter.set_mode,
    mav.MAV_CMD_SET_MESSAGE_INTERVAL: ArduCopter.set_interval,
    mav.MAV_CMD_REQUEST_MESSAGE: ArduCopter.request_message,
    mav.MAV_CMD_GET_HOME_POSITION: ArduCopter.get_home,
    mav.MAV_CMD_DO_REPOSITION: ArduCopter.reposition,
    mav.MAV_CMD_REQUEST_AUTOPILOT_CAPABILITIES: lambda self, *_: done(self.tell("AUTOPILOT_VERSION")),
    mav.MAV_CMD_NAV_LAND: lambda self, *_: done(self.copter.enter(LAND)),
    mav.MAV_CMD_NAV_RETURN_TO_LAUNCH: lambda self, *_: done(self.copter.enter(RTL)),
    mav.MAV_CMD_NAV_LOITER_UNLIM: lambda self, *_: done(self.copter.enter(LOITER)),
}


def done(well: bool) -> int:
    return int(mav.MAV_RESULT_ACCEPTED if well else mav.MAV_RESULT_FAILED)


def named(msgid: float) -> str:
    """A message's name by its number as it stands in a command."""
    known = mav.mavlink_map.get(int(msgid)) if math.isfinite(msgid) else None
    return str(known.msgname) if known is not None else "none"


def three(text: str) -> Vec3:
    first, second, third = map(float, text.split(","))
    return first, second, third


def parameter(text: str) -> tuple[str, float]:
    name, value = text.split("=")
    if name not in PARAMETERS:
        raise ValueError(name)
    return name, float(value)


def main() -> None:
    says = argparse.ArgumentParser(description="A scripted ArduCopter on the wall clock, until its stdin ends.")
    says.add_argument("--sysid", type=int, default=1)
    says.add_argument("--connect", default="udpout:127.0.0.1:14550", metavar="udpout:HOST:PORT")
    says.add_argument("--origin", type=three, default=(47.3978, 8.5455, 487.0), metavar="LAT,LON,ALT")
    says.add_argument("--start", type=three, default=ZERO, metavar="N,E,D", help="from its own origin, m")
    says.add_argument("--refuse-arming-s", type=float, default=2.0, help="how long after its start arming is refused")
    says.add_argument("--speedup", type=float, default=1.0, help="how much faster than real time its time runs")
    says.add_argument("--refuse-intervals", action="store_true", help="know no SET_MESSAGE_INTERVAL")
    says.add_argument("--battery-wh", type=float, default=70.0)
    says.add_argument(
        "--battery-told",
        choices=["energy", "current", "remaining"],
        default="current",
        help="what BATTERY_STATUS holds: all; no energy; nothing but the share that remains",
    )
    says.add_argument("--lose", type=float, default=0.0, help="share of its positions and attitudes that never come")
    says.add_argument("--lies", action="store_true", help="tell a place where nothing can be, once it flies")
    says.add_argument("--says", default="", help="a text, in as many chunks as it needs, once it flies")
    says.add_argument("--si-names", action="store_true", help="have the names of 4.7, in SI units")
    says.add_argument("--locked", action="append", default=[], metavar="NAME", help="keep it, whatever is written")
    says.add_argument("--way", type=Path, help="file for the monotonic clock and its place, s and m, after each step")
    says.add_argument("--param", type=parameter, action="append", default=[], metavar="NAME=VALUE")
    ArduCopter(says.parse_args()).live()


if __name__ == "__main__":
    main()
