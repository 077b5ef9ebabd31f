"""Whether an external vehicle keeps its fence by itself: autopilots have a switch for that, beside the fence.

    FENCE_ENABLE, FENCE_AUTOENABLE  ArduPilot: 1, or in flight alone
    GF_ACTION                       PX4: what it does at a breach, 0 for nothing

[lineage] https://ardupilot.org/copter/docs/parameters.html, https://docs.px4.io/main/en/advanced_config/parameter_reference
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gcs.mavlink.codec import Message
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters.client import ParameterClient
from gcs.telemetry.state import VehicleView

SWITCHES: Mapping[str, tuple[str, ...]] = {
    "copter": ("FENCE_ENABLE", "FENCE_AUTOENABLE"),
    "main and sub": ("GF_ACTION",),
}
"""By `Profile.mode_table`; of other autopilots none is known here."""


class FenceSwitch:
    """The questions to one vehicle; `note` is empty where it keeps its fence, or does not say."""

    def __init__(self, sysid: int) -> None:
        self.note = ""
        self._sysid = sysid
        self._client: ParameterClient | None = None

    def receive(self, name: str, content: Any, now_s: float) -> None:
        """Take a message of this vehicle's: its name and fields."""
        if self._client is not None:
            self._client.receive(name, content, now_s)

    def poll(self, view: VehicleView, now_s: float) -> list[Message]:
        """Messages that ask for its switches; none once `done`."""
        if self._client is None:
            self._client = ParameterClient(self._sysid, AUTOPILOT, view.profile)
            self._client.read(SWITCHES.get(view.profile.mode_table, ()))
        messages = self._client.poll(now_s)
        known = self._client.known
        if self._client.done and known and not any(value.number for value in known.values()):
            self.note = f"{next(iter(known))} is 0: by itself it keeps no fence"
        return messages

    @property
    def done(self) -> bool:
        """Whether all that it will say has been said."""
        return self._client is not None and self._client.done
