"""A real ArduPilot on our physics, through its JSON interface (docs/protocol/autopilots.md#ardupilot).

It says what it wants of its motors in a servo packet, and lives on once that is answered: so a grant ends by keeping
an answer back.
"""

from __future__ import annotations

import cython.cimports.simvehicle.mavlink.real_autopilots.json_backend as backend

from simvehicle.law.plants import Vec3
from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.real_autopilots.analog_battery import AnalogBattery
from simvehicle.mavlink.real_autopilots.autopilot_boot import ARDUCOPTER_BOOT, AutopilotBoot
from simvehicle.mavlink.real_autopilots.gnss_switch import GnssSwitch
from simvehicle.sitl.ardupilot_link import ArduPilotLink
from simvehicle.sitl.ardupilot_process import STEP_MS
from simvehicle.sitl.autopilot_unit import AutopilotUnit, Throttles


class ArduPilotUnit(AutopilotUnit):
    """The ArduPilot with its physics."""

    boot_mode = ARDUCOPTER_BOOT
    step_ms = STEP_MS

    _link: ArduPilotLink
    _monitor: AnalogBattery
    _receiver: GnssSwitch

    def _open(self) -> ArduPilotLink:
        self._link = ArduPilotLink(self._wanted)
        return self._link

    def _booted(self, boot: AutopilotBoot) -> None:
        self._monitor = AnalogBattery(self._wanted.sysid, boot.volts)
        self._receiver = GnssSwitch(self._wanted.sysid)

    def _throttles(self) -> Throttles:
        return self._link.throttles

    def _report_battery(self) -> None:
        for content in self._monitor.settings(self._boot_s, *self._plant.electric):
            self._say(content)

    def _report_failures(self) -> None:
        for content in self._receiver.settings(lost=self._failures.gnss_lost):
            self._say(content)

    def _is_answer(self, frame: ReceivedFrame) -> bool:
        return self._monitor.answers(frame) or self._receiver.answers(frame)

    def _answer(self, accel_body: Vec3) -> None:
        sensed = self._sense(accel_body)
        volts, amperes = self._plant.electric
        line = backend.answer(
            self._steps,
            STEP_MS / 1e3,
            sensed.rates_body,
            sensed.accel_body,
            sensed.p_ned,
            sensed.v_ned,
            sensed.quaternion,
            volts,
            amperes,
        )
        self._link.answer(line)
