"""The scripted ArduCopter as a simulation in the loop: it starts with ArduPilot's flags and speaks its JSON interface.

Like the real one it waits for a client on its serial port, repeats a servo packet that is not answered each second with
the same frame count, serves its serial port right after an answer, lives by the answers' time alone, and ends with its
client. `--like` says which version's habits it has: from 4.7 on a simulation that does not keep to the wall clock makes
AHRS_EKF_TYPE 10 its default, and by that it estimates nothing: it is ready at once, has its place without a fix, and
tells no velocity. It flies a cascade of its own on the motion that it is told: velocity, tilt, rates, four motors of a
quad X.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import signal
import socket
import struct
import sys
from collections.abc import Mapping, Sequence
from typing import Any

from arducopter import ArduCopter
from arducopter_motion import GUIDED, INT8, LAND, PARAMETERS, REAL32, Copter
from arducopter_parameters import Told
from arducopter_telemetry import Telemetry
from motion import GRAVITY_M_S2, STEP_S, Place
from pymavlink.dialects.v20 import ardupilotmega as mav

MAGIC, RATE_HZ, CHANNELS = 18458, 250, 16
REPEAT_S = 1.0
ESTIMATE, TRUTH = 3.0, 10.0
"""AHRS_EKF_TYPE."""
GPS_DISABLE, SWITCH_HIGH = 65.0, 2.0
LOST_FOR_S = 2.0
"""Without a fix for so long, it lands."""
TILT_GAIN, RATE_GAIN, YAW_GAIN, YAW_RATE_GAIN = 36.0, 12.0, 4.0, 4.0
MOST_TILT_RAD, HOVER_SHARE = math.radians(30.0), 0.5205
"""Share of the greatest thrust at which it hovers, as a real one would have learnt."""
ROLL_SHARE, PITCH_SHARE, YAW_SHARE = 0.0049, 0.0079, 0.033
"""Share of a rotor's greatest thrust for 1 rad/s² about each axis."""


class Serial:
    """What pymavlink writes to: the client of its serial port."""

    def __init__(self, port: int) -> None:
        with socket.create_server(("127.0.0.1", port)) as server:
            self.socket, _ = server.accept()
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        self.socket.setblocking(False)
        self._out = b""

    def write(self, frame: bytes) -> None:
        self._out += bytes(frame)

    def read(self) -> bytes:
        try:
            heard = self.socket.recv(65536)
        except BlockingIOError:
            return b""
        if not heard:
            sys.exit(0)
        return heard

    def look(self) -> None:
        """End with the client, without reading what it says."""
        try:
            if not self.socket.recv(1, socket.MSG_PEEK):
                sys.exit(0)
        except BlockingIOError:
            return

    def flush(self) -> None:
        self.socket.setblocking(True)
        self.socket.sendall(self._out)
        self.socket.setblocking(False)
        self._out = b""


class JsonCopter(Copter):
    """Its motion and its battery, of which it knows what its simulated sensor measures."""

    ready_s = 0.0
    fix_s: float | None = None
    """when its GNSS lost its fix; None while it has one"""

    @property
    def volts(self) -> float:
        return self.parameters["SIM_BATT_VOLTAGE"]

    @property
    def power_w(self) -> float:
        return -17.0 * self.parameters["BATT_AMP_OFFSET"] * self.volts

    def enter(self, mode: int) -> bool:
        """Not GUIDED before it knows its place, or while it does not."""
        knows = self.now_s >= self.ready_s and self.fix_s is None
        return (mode != GUIDED or knows or self.on_truth) and super().enter(mode)

    @property
    def on_truth(self) -> bool:
        """Whether it flies on what its simulation says, and not on an estimate."""
        return self.parameters["AHRS_EKF_TYPE"] == TRUTH

    def lose_fix(self, *, lost: bool) -> None:
        self.fix_s = None if not lost else self.now_s if self.fix_s is None else self.fix_s

    def step(self) -> None:
        lost_s = 0.0 if self.fix_s is None or self.on_truth else self.now_s - self.fix_s
        if self.flying and self.mode != LAND and lost_s > LOST_FOR_S:
            self.told.append("EKF Failsafe: changed to LAND Mode")
            self.enter(LAND)
        super().step()


class JsonTelemetry(Telemetry):
    """What it tells; it can say that it is another kind of vehicle."""

    copter: JsonCopter
    kind = mav.MAV_TYPE_QUADROTOR

    def _gps_raw_int(self) -> Any:
        said = super()._gps_raw_int()
        said.fix_type = 6 if self.copter.fix_s is None else 1
        return said

    def _local_position_ned(self) -> Any:
        said = super()._local_position_ned()
        if said is not None and self.copter.on_truth:
            said.vx = said.vy = said.vz = 0.0
        return said

    def _heartbeat(self) -> Any:
        said = super()._heartbeat()
        said.type = self.kind
        return said


UNKNOWN = {"WP_SPD", "NO_SUCH_PARAM"}
"""Names that it is given in tests and does not know."""


def hold(given: Mapping[str, str]) -> None:
    """Keep the numbers of these parameters, which may be text, under their names."""
    for name, number in given.items():
        if name not in UNKNOWN:
            kind, _ = PARAMETERS.get(name, (REAL32, 0.0))
            PARAMETERS[name] = (kind, float(number))


class JsonArduCopter(ArduCopter):
    """Its life, by the answers to its servo packets."""

    telemetry: JsonTelemetry
    copter: JsonCopter

    def __init__(self, options: argparse.Namespace, serial: Serial) -> None:
        super().__init__(options)
        self.copter = JsonCopter(options.start, options.battery_wh)
        self.copter.ready_s = options.refuse_arming_s
        self.telemetry = JsonTelemetry(self.copter, options)
        self.told = Told(self.copter, si_names=options.si_names, locked=options.locked)
        self.link = serial  # type: ignore[assignment]
        self.out = mav.MAVLink(serial, srcSystem=options.sysid, srcComponent=mav.MAV_COMP_ID_AUTOPILOT1)
        self.out.robust_parsing = True
        self.frame = 0
        self.pwm = [1000] * 4
        self.state: dict[str, Any] = {}
        self.killed_at_s = math.inf
        self.origin_ned: Any = ()

    def fly(self, udp: socket.socket, to: tuple[str, int]) -> None:
        udp.settimeout(REPEAT_S)
        while True:
            self.frame += 1
            packet = struct.pack(f"<HHI{CHANNELS}H", MAGIC, RATE_HZ, self.frame, *self.pwm, *[0] * (CHANNELS - 4))
            udp.sendto(packet, to)
            while True:
                try:
                    line = udp.recv(4096)
                    break
                except TimeoutError:
                    self.link.look()
                    udp.sendto(packet, to)
            assert line[:1] == line[-1:] == b"\n"
            self.state = json.loads(line)
            assert self.state["no_time_sync"] == 1
            if self.state["timestamp"] >= self.killed_at_s:
                os.kill(os.getpid(), signal.SIGKILL)
            self.hear(self.link.read())
            if self.state["timestamp"] >= self.copter.now_s + STEP_S:
                self._know()
                self.step()
            self._steer()
            self.link.flush()

    def _command(self, m: Any, params: Sequence[float], place: Sequence[float], z: float) -> None:
        """Its switch for tests of GNSS is a matter of this simulation; ArduPilot knows it in each."""
        if (m.command, params[0]) != (mav.MAV_CMD_DO_AUX_FUNCTION, GPS_DISABLE):
            super()._command(m, params, place, z)
            return
        self.copter.lose_fix(lost=params[1] == SWITCH_HIGH)
        self.out.command_ack_send(m.command, 0, 0, 0, m.get_srcSystem(), m.get_srcComponent())

    def _know(self) -> None:
        """Its motion as it is told; its own frame begins where it first stood, as where a GPS has its first fix."""
        body = self.copter.body
        if not self.origin_ned:
            self.origin_ned = tuple(self.state["position"])
            lat_e7, lon_e7, alt_m = self.telemetry.place.to_global(self.origin_ned)
            self.telemetry.place = Place((1e-7 * lat_e7, 1e-7 * lon_e7, alt_m))
        north, east, down = (p - o for p, o in zip(self.state["position"], self.origin_ned, strict=True))
        body.p, body.v = (north, east, down), tuple(self.state["velocity"])
        if not self.copter.flying:
            body.yaw = self._attitude()[2]

    def _attitude(self) -> tuple[float, float, float]:
        w, x, y, z = self.state["quaternion"]
        roll = math.atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y))
        yaw = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        return roll, math.asin(max(-1.0, min(1.0, 2.0 * (w * y - z * x)))), yaw

    def _steer(self) -> None:
        copter = self.copter
        if not copter.flying:
            self.pwm = [1000] * 4
            return
        roll, pitch, yaw = self._attitude()
        p, q, r = self.state["imu"]["gyro"]
        north, east, down = copter.body.a
        ahead = math.cos(yaw) * north + math.sin(yaw) * east
        right = math.cos(yaw) * east - math.sin(yaw) * north
        lift = max(GRAVITY_M_S2 - down, 0.3 * GRAVITY_M_S2)
        wanted_roll = max(-MOST_TILT_RAD, min(MOST_TILT_RAD, math.atan2(right, lift)))
        wanted_pitch = max(-MOST_TILT_RAD, min(MOST_TILT_RAD, -math.atan2(ahead, lift)))
        about = math.remainder(copter.body.yaw - yaw, math.tau)
        roll_share = ROLL_SHARE * (TILT_GAIN * (wanted_roll - roll) - RATE_GAIN * p)
        pitch_share = PITCH_SHARE * (TILT_GAIN * (wanted_pitch - pitch) - RATE_GAIN * q)
        yaw_share = YAW_SHARE * (YAW_GAIN * about - YAW_RATE_GAIN * r)
        thrust = HOVER_SHARE * lift / GRAVITY_M_S2 / (math.cos(roll) * math.cos(pitch))
        shares = (
            thrust - roll_share + pitch_share + yaw_share,
            thrust + roll_share - pitch_share + yaw_share,
            thrust + roll_share + pitch_share - yaw_share,
            thrust - roll_share - pitch_share - yaw_share,
        )
        self.pwm = [round(1000.0 + 1000.0 * math.sqrt(max(0.0, min(1.0, share)))) for share in shares]


def main() -> None:
    says = argparse.ArgumentParser(description="A scripted ArduCopter in a simulation of somebody else's.")
    says.add_argument("--like", choices=("4.6", "4.7"), default="4.7")
    says.add_argument("--model", required=True)
    says.add_argument("-I", dest="instance", type=int, default=0)
    says.add_argument("--home", required=True)
    says.add_argument("--defaults", required=True)
    says.add_argument("-w", action="store_true")
    says.add_argument("--start-time", type=int, required=True)
    says.add_argument("--sysid", type=int, required=True)
    says.add_argument("--serial1")
    says.add_argument("--serial2")
    given = says.parse_args()
    assert given.model == "JSON:127.0.0.1"
    with open(given.defaults, encoding="utf-8") as file:
        parameters = dict(line.split() for line in file)
    PARAMETERS["AHRS_EKF_TYPE"] = (INT8, TRUTH if given.like == "4.7" else ESTIMATE)
    hold(parameters)
    if "CRASH" in parameters:
        print("PANIC: a parameter that it cannot bear", flush=True)
        sys.exit(3)
    print(f"Starting sketch 'ArduCopter', instance {given.instance}", flush=True)
    lat, lon, alt, _ = map(float, given.home.split(","))
    on_truth = PARAMETERS["AHRS_EKF_TYPE"][1] == TRUTH
    options = argparse.Namespace(
        sysid=given.sysid, connect="udpout:127.0.0.1:9", origin=(lat, lon, alt), start=(0.0, 0.0, 0.0), lose=0.0,
        refuse_arming_s=0.0 if on_truth else float(parameters.get("READY_S", 2.0)), refuse_intervals=False,
        battery_wh=70.0, battery_told="current", lies=False, says="", param=[], si_names=False, locked=(), way=None,
    )  # fmt: skip
    serial = Serial(5760 + 10 * given.instance)
    copter = JsonArduCopter(options, serial)
    copter.telemetry.kind = int(float(parameters.get("KIND", copter.telemetry.kind)))
    copter.killed_at_s = float(parameters.get("KILLED_AT_S", math.inf))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as udp:
        copter.fly(udp, ("127.0.0.1", 9002 + 10 * given.instance))


if __name__ == "__main__":
    main()
