"""A scripted PX4 as a simulation in the loop: it starts with PX4's flags and start scripts and speaks its HIL messages.

Like the real one it finds its parameters and its MAVLink by the scripts in its working directory, connects to TCP 4560
+ its instance, answers nothing to its first HIL_SENSORs and then one HIL_ACTUATOR_CONTROLS to each, lives by their time
alone, and takes its battery from another component of its system. `--like` says which version's habits it has: 1.15 has
its parameters from the script px4-rc.params, later ones from their environment, PX4_PARAM_<NAME>, but for 1.17's system
id, which follows from its instance unless px4-rc.simulator sets it. Each has a battery of its own that it measures,
unless a parameter of its version turns that off. It knows only what its sensors say: attitude by its
gyros from where accelerometer and magnetometer have it at first, place and velocity by its GNSS and accelerometer. It
flies as the scripted ArduCopter does, which it is but for modes and take-off.
"""

from __future__ import annotations

import argparse
import math
import os
import re
import signal
import socket
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from arducopter import COMMANDS, ArduCopter, Datagrams, done
from arducopter_motion import GUIDED, LAND, LOITER, RTL
from arducopter_parameters import Told
from json_arducopter import JsonArduCopter, JsonCopter, JsonTelemetry, hold
from motion import GRAVITY_M_S2, STEP_S, Place
from pymavlink.dialects.v20 import ardupilotmega as mav

SILENT_STEPS = 10
PREFIX = "PX4_PARAM_"
OWN_BATTERY = {"1.15": "SIM_BAT_ENABLE", "1.17": "SIM_BAT_ENABLE", "1.18": "SIM_BAT_DRAIN"}
"""Parameter that is 0 where it has no battery of its own, by version."""
OWN_V = 16.2
BATTERY = mav.MAV_COMP_ID_BATTERY
OFFBOARD, TAKEOFF = 6 << 16, 4 << 16 | 2 << 24
MODES = {GUIDED: OFFBOARD, LOITER: 4 << 16 | 3 << 24, RTL: 4 << 16 | 5 << 24, LAND: 4 << 16 | 6 << 24}
BY_NUMBER = {(6, 0): GUIDED, (4, 3): LOITER, (4, 5): RTL, (4, 6): LAND}
EVERY = {"ATTITUDE": 15.0, "LOCAL_POSITION_NED": 1.0, "GLOBAL_POSITION_INT": 5.0, "SYS_STATUS": 1.0}
"""Streams that nobody asked for, Hz."""
LACKS = {"1.15": frozenset[int](), "1.17": frozenset[int](), "1.18": frozenset({mav.MAV_CMD_GET_HOME_POSITION})}
"""Commands that it does not know any more; it streams HOME_POSITION."""
HOME_HZ = 0.5
RETURNS = {"RTL_RETURN_ALT": "60", "RTL_DESCEND_ALT": "30", "RTL_LAND_DELAY": "0", "COM_OF_LOSS_T": "1"}


class HilCopter(JsonCopter):
    """Its motion, and the battery that it is told of."""

    said_v, said_w = 0.0, 0.0
    own_v = 0.0
    on_truth = False

    @property
    def volts(self) -> float:
        return self.own_v or self.said_v or 1e-3  # its battery may not have been told yet

    @property
    def power_w(self) -> float:
        return self.said_w

    @property
    def remaining(self) -> float:
        return 1.0

    def _return_height_m(self) -> float:
        return max(self.home[2] - self.body.p[2], self.parameters["RTL_RETURN_ALT"])


class Px4Telemetry(JsonTelemetry):
    """What it tells, in PX4's numbers."""

    def _heartbeat(self) -> Any:
        said = super()._heartbeat()
        said.autopilot = mav.MAV_AUTOPILOT_PX4
        said.custom_mode = TAKEOFF if self.copter.climbing else MODES.get(self.copter.mode, 0)
        return said


class HilPx4(JsonArduCopter):
    """Its life, by HIL_SENSOR."""

    def __init__(self, options: argparse.Namespace, link: Datagrams) -> None:
        super().__init__(options, link)  # type: ignore[arg-type]
        self.copter = HilCopter(options.start, options.battery_wh)
        self.copter.ready_s = options.refuse_arming_s
        self.copter.mode = LOITER
        self.telemetry = Px4Telemetry(self.copter, options)
        self.told = Told(self.copter, si_names=options.si_names, locked=options.locked)
        self.steps = 0
        self.frame_of: Place | None = None
        self.quaternion = np.zeros(0)
        self.p, self.v = np.zeros(3), np.zeros(3)
        self.lockstep = 1
        for name, hertz in {**EVERY, "HOME_POSITION": HOME_HZ}.items():
            self._every(name, 1.0 / hertz)

    # what it is told

    def on_battery_status(self, m: Any) -> None:
        if (m.get_srcSystem(), m.get_srcComponent()) == (self.options.sysid, BATTERY):
            self.copter.said_v = sum(mv for mv in m.voltages if mv != 65535) / 1e3
            self.copter.said_w = self.copter.said_v * m.current_battery / 1e2

    def _command(self, m: Any, params: Sequence[float], place: Sequence[float], z: float) -> None:
        own = {mav.MAV_CMD_COMPONENT_ARM_DISARM: self._arm, mav.MAV_CMD_NAV_TAKEOFF: self._take_off}
        own[mav.MAV_CMD_DO_SET_MODE] = self._set_mode
        handler = own.get(m.command)
        if handler is None and m.command in COMMANDS and m.command not in LACKS[self.options.like]:
            result = COMMANDS[m.command](self, params, place, z)
        else:
            result = mav.MAV_RESULT_UNSUPPORTED if handler is None else handler(params, z)
        self.out.command_ack_send(m.command, result, 0, 0, m.get_srcSystem(), m.get_srcComponent())

    def _arm(self, params: Sequence[float], z: float) -> int:
        mode, self.copter.mode = self.copter.mode, GUIDED  # it arms in Hold
        result = ArduCopter.arm(self, params, (0.0, 0.0), z)
        self.copter.mode = mode
        return result

    def _take_off(self, params: Sequence[float], z: float) -> int:
        """Its height is above mean sea level."""
        copter = self.copter
        height_m = z - self.telemetry.place.to_global(copter.home)[2]
        if not copter.armed or copter.flying or height_m <= 0.0:
            return int(mav.MAV_RESULT_FAILED)
        copter.take_off(height_m)
        return int(mav.MAV_RESULT_ACCEPTED)

    def _set_mode(self, params: Sequence[float], z: float) -> int:
        mode = BY_NUMBER.get((int(params[1]), int(params[2])))
        return done(mode is not None and self.copter.now_s >= self.copter.ready_s and self.copter.enter(mode))

    # its simulation

    def simulate(self, tcp: socket.socket) -> None:
        """Live until its simulation ends."""
        spoken = mav.MAVLink(None, srcSystem=self.options.sysid, srcComponent=1)
        spoken.robust_parsing = True
        tcp.sendall(mav.MAVLink_heartbeat_message(0, 12, 0, 0, 0, 3).pack(spoken))
        while chunk := tcp.recv(65536):
            for message in spoken.parse_buffer(chunk) or []:
                if message.get_type() == "HIL_GPS":
                    self._fix(message)
                elif message.get_type() == "HIL_SENSOR":
                    answer = self._live(message)
                    if self.steps > SILENT_STEPS:
                        tcp.sendall(answer.pack(spoken))
        sys.exit(0)

    def _live(self, sensed: Any) -> Any:
        """One step of its life; its motors' controls after it."""
        self.steps += 1
        if self.steps == 1:
            assert sensed.fields_updated == 0x1BFF  # all of them at first, and no air speed
        now_s = 1e-6 * sensed.time_usec
        if now_s >= self.killed_at_s:
            os.kill(os.getpid(), signal.SIGKILL)
        self._estimate(sensed)
        self.hear(self.link.read())
        if now_s >= self.copter.now_s + STEP_S and self.frame_of is not None:
            self._know()
            self.step()
        if self.frame_of is not None:
            self._steer()
        throttles = [(pwm - 1000.0) / 1000.0 for pwm in self.pwm]
        armed = mav.MAV_MODE_FLAG_SAFETY_ARMED if self.copter.armed else 0
        return mav.MAVLink_hil_actuator_controls_message(sensed.time_usec, throttles + [0.0] * 12, armed, self.lockstep)

    def _fix(self, fix: Any) -> None:
        """GNSS has it where it is, and as fast."""
        self.copter.lose_fix(lost=fix.fix_type < 3)
        if fix.fix_type < 3:
            return
        if self.frame_of is None:
            self.frame_of = Place((1e-7 * fix.lat, 1e-7 * fix.lon, 1e-3 * fix.alt))
            self.telemetry.place = self.frame_of
        self.p = np.array(self.frame_of.to_local(fix.lat, fix.lon, 1e-3 * fix.alt))
        self.v = 0.01 * np.array([fix.vn, fix.ve, fix.vd])

    def _estimate(self, sensed: Any) -> None:
        """STEP of strapdown navigation."""
        gyro = np.array([sensed.xgyro, sensed.ygyro, sensed.zgyro])
        if not self.quaternion.size:
            ahead, right = sensed.xmag, sensed.ymag  # it stands level
            heading = math.radians(self.options.declination_deg) - math.atan2(right, ahead)
            self.quaternion = np.array([math.cos(heading / 2), 0.0, 0.0, math.sin(heading / 2)])
        w, x, y, z = self.quaternion
        a, b, c = 0.5 * 0.004 * gyro
        turned = np.array(
            (w - x * a - y * b - z * c, w * a + x + y * c - z * b, w * b - x * c + y + z * a, w * c + x * b - y * a + z)
        )
        self.quaternion = turned / np.linalg.norm(turned)
        w, u = self.quaternion[0], self.quaternion[1:]
        force = np.array([sensed.xacc, sensed.yacc, sensed.zacc])
        across = np.cross(u, force)
        accel = force + 2.0 * w * across + 2.0 * np.cross(u, across) + [0.0, 0.0, GRAVITY_M_S2]
        self.p = self.p + 0.004 * self.v
        self.v = self.v + 0.004 * accel
        self.state = {
            "position": self.p.tolist(),
            "velocity": self.v.tolist(),
            "quaternion": self.quaternion.tolist(),
            "imu": {"gyro": gyro.tolist()},
        }


def given_parameters(like: str) -> dict[str, str]:
    """Parameters by name, as text, where its version looks for them."""
    if like != "1.15":
        return {name[len(PREFIX) :]: value for name, value in os.environ.items() if name.startswith(PREFIX)}
    lines = [line.split() for line in Path("px4-rc.params").read_text(encoding="utf-8").splitlines()]
    return {name: value for _, _, name, value in lines}


def main() -> None:
    says = argparse.ArgumentParser(description="A scripted PX4 in a simulation of somebody else's.")
    says.add_argument("--like", choices=tuple(OWN_BATTERY), default="1.18")
    says.add_argument("-i", dest="instance", type=int, default=0)
    says.add_argument("-d", action="store_true", required=True)
    says.add_argument("etc", type=Path)
    given = says.parse_args()
    assert (given.etc / "init.d-posix" / "rcS").is_file()
    assert os.environ["PATH"].split(":")[0] == "."
    assert os.environ["PX4_SIM_MODEL"] == "none_iris"
    parameters = given_parameters(given.like)
    hold(RETURNS | parameters)
    if "CRASH" in parameters:
        print("ERROR [init] a parameter that it cannot bear", flush=True)
        sys.exit(3)
    simulator = Path("px4-rc.simulator").read_text(encoding="utf-8")
    assert simulator.endswith("\n. etc/init.d-posix/px4-rc.simulator\n")
    own = re.search(r"^param set MAV_SYS_ID (\d+)$", simulator, re.MULTILINE)
    by_instance = given.instance + 1
    sysid = int(own[1] if own else by_instance if given.like == "1.17" else parameters.get("MAV_SYS_ID", by_instance))
    ports = re.search(r"^mavlink start .*-u (\d+) -o (\d+)", Path("px4-rc.mavlink").read_text(encoding="utf-8"))
    assert ports is not None
    print(f"INFO  [px4] instance: {given.instance}", flush=True)
    options = argparse.Namespace(
        sysid=sysid, connect=f"udpout:127.0.0.1:{ports[2]}", origin=(0.0, 0.0, 0.0), start=(0.0, 0.0, 0.0), lose=0.0,
        refuse_arming_s=float(parameters.get("READY_S", 2.0)), refuse_intervals=False, battery_wh=70.0,
        battery_told="current", lies=False, says="", param=[], si_names=False, locked=(), way=None, like=given.like,
        declination_deg=float(parameters.get("DECLINATION_DEG", 0.0)),
    )  # fmt: skip
    link = Datagrams(options.connect)
    link.socket.bind(("127.0.0.1", int(ports[1])))
    px4 = HilPx4(options, link)
    px4.telemetry.kind = int(float(parameters.get("KIND", px4.telemetry.kind)))
    px4.killed_at_s = float(parameters.get("KILLED_AT_S", math.inf))
    px4.copter.own_v = OWN_V if float(parameters.get(OWN_BATTERY[given.like], 1.0)) else 0.0
    px4.lockstep = int(float(parameters.get("LOCKSTEP", 1)))
    with socket.create_connection((os.environ["PX4_SIM_HOSTNAME"], 4560 + given.instance)) as tcp:
        tcp.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        px4.simulate(tcp)


if __name__ == "__main__":
    main()
