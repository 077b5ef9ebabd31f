"""On what each external vehicle flies, an estimate or its simulation's truth, asked for once and said.

On truth errors and faults of its sensors do nothing: those that the scenario has for it are named.
"""

from __future__ import annotations

from collections.abc import Iterable

from gcs.mavlink import codec
from gcs.mavlink.autopilots import Profile
from gcs.mavlink.codec import Frame, Message
from gcs.mavlink.ids import AUTOPILOT
from gcs.scenario.model import Scenario
from gcs.telemetry.events import Event

ASK_EVERY_S, ASK_TIMES = 2.0, 5
OF_SENSORS = frozenset({"gps_off", "gps_jump"})
"""Faults that reach a vehicle by what it senses."""
_PARAM_VALUE = codec.msgid("PARAM_VALUE")


class _Asked:
    """Requests to one vehicle so far."""

    def __init__(self) -> None:
        self.profile: Profile | None = None
        self.tries, self.due_s = 0, 0.0


class Estimators:
    """Estimators of the vehicles of a session that are not ours."""

    def __init__(self, scenario: Scenario) -> None:
        self._asked = {sysid: _Asked() for sysid in scenario.vehicles.foreign}
        self._without_effect = {
            vehicle.sysid: [
                *(["sensors"] if vehicle.sensors is not None else []),
                *sorted({f.fault for f in scenario.faults if f.sysid == vehicle.sysid and f.fault in OF_SENSORS}),
            ]
            for vehicle in scenario.vehicles.all
        }

    def requests(self, sysid: int, profile: Profile, now_s: float) -> list[Message]:
        """Messages that ask a vehicle that is received for its estimator."""
        asked = self._asked.get(sysid)
        if asked is None or not profile.estimator_parameter or asked.tries >= ASK_TIMES or now_s < asked.due_s:
            return []
        asked.profile, asked.tries, asked.due_s = profile, asked.tries + 1, now_s + ASK_EVERY_S
        to = {"target_system": sysid, "target_component": AUTOPILOT}
        return [codec.message("PARAM_REQUEST_READ", **to, param_id=profile.estimator_parameter, param_index=-1)]

    def receive(self, sysid: int, frames: Iterable[Frame], now_s: float) -> Event | None:
        """Event that says what a vehicle flies on, where it has just reported that."""
        asked = self._asked.get(sysid)
        if asked is None or asked.profile is None:
            return None
        for frame in frames:
            if frame.msgid != _PARAM_VALUE:
                continue
            content, profile = codec.fields(frame), asked.profile
            if content.param_id == profile.estimator_parameter:
                del self._asked[sysid]
                return self._said(
                    sysid, profile, int(profile.parameter(content.param_value, content.param_type).number), now_s
                )
        return None

    def _said(self, sysid: int, profile: Profile, number: int, now_s: float) -> Event:
        by = f"{profile.estimator_parameter} {number}"
        if number != profile.estimator_truth:
            name = profile.estimators.get(number, "an estimator that is not known here")
            return Event(now_s, sysid, "info", f"Flies on {name} ({by})", "session")
        lost = ", ".join(self._without_effect[sysid])
        effect = (
            f"so these have no effect on it: {lost}" if lost else "so errors and faults of its sensors have no effect"
        )
        text = f"Flies on its simulation's truth ({by}) and not on an estimate, {effect}"
        return Event(now_s, sysid, "warning", text, "session")
