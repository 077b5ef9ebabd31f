"""Battery monitor of an ArduPilot whose JSON interface takes no battery: its simulated sensor is moved by parameters.

No socket, no clock. Versions differ in what they read, and nothing says which: so the sensor is started at a voltage
that no battery of ours has, and what the autopilot then measures says whether it has read the answers' `battery`.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from simvehicle.mavlink.codec import ReceivedFrame, decode, message
from skytender import mavlink as mav

MARK_V = 30.0
NEAR_V = 0.5
SET_EVERY_S = 1.0
AMPERES_PER_VOLT = 17.0
"""BATT_AMP_PERVLT of ArduPilot's simulated sensor, which measures 0 V at its current's pin."""
VOLTS, OFFSET = "SIM_BATT_VOLTAGE", "BATT_AMP_OFFSET"
DEFAULTS: Mapping[str, float] = {"BATT_AMP_PERVLT": AMPERES_PER_VOLT, OFFSET: 0.0, VOLTS: MARK_V}


class AnalogBattery:
    """The sensor of one autopilot."""

    def __init__(self, sysid: int, measured_v: float) -> None:
        """`measured_v`: what the autopilot measures where DEFAULTS are in force."""
        self._sysid = sysid
        self.by_parameters = abs(measured_v - MARK_V) < NEAR_V
        self._set_s = -SET_EVERY_S
        self._values: dict[str, float] = {}

    def settings(self, now_s: float, volts: float, amperes: float) -> list[Any]:
        """Parameters to be set now, so that it measures this; none while what it measures is near enough."""
        if not self.by_parameters or now_s - self._set_s < SET_EVERY_S - 1e-6:
            return []
        self._set_s = now_s
        wanted = {VOLTS: round(volts, 2), OFFSET: round(-amperes / AMPERES_PER_VOLT, 3)}
        changed = {name: value for name, value in wanted.items() if self._values.get(name) != value}
        self._values.update(changed)
        return [self._set(name, value) for name, value in changed.items()]

    def answers(self, frame: ReceivedFrame) -> bool:
        """Whether a frame is the autopilot's answer to a setting."""
        if not self.by_parameters or frame.msgid != mav.MAVLINK_MSG_ID_PARAM_VALUE:
            return False
        content: Any = decode(frame)
        return content.param_id in self._values

    def _set(self, name: str, value: float) -> Any:
        autopilot = (self._sysid, mav.MAV_COMP_ID_AUTOPILOT1)
        return message("PARAM_SET")(value, *autopilot, name, mav.MAV_PARAM_TYPE_REAL32)
