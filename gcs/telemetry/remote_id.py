"""Remote ID of a vehicle: its own id and status as one line, and that line each time that one of them changes.

An id of another aircraft, which a transmitter has received, names that transmitter (id_or_mac) and is passed over.
[lineage] https://mavlink.io/en/services/opendroneid.html
"""

from __future__ import annotations

from typing import Any

from skytender import mavlink as mav

_STATUS = {
    mav.MAV_ODID_STATUS_GROUND: "on the ground",
    mav.MAV_ODID_STATUS_AIRBORNE: "airborne",
    mav.MAV_ODID_STATUS_EMERGENCY: "in an emergency",
    mav.MAV_ODID_STATUS_REMOTE_ID_SYSTEM_FAILURE: "its transmitter has failed",
}
_SEVERE = (mav.MAV_ODID_STATUS_EMERGENCY, mav.MAV_ODID_STATUS_REMOTE_ID_SYSTEM_FAILURE)


class RemoteId:
    """One vehicle's own id and status, as last reported."""

    def __init__(self) -> None:
        self._id: str | None = None
        self._status: int | None = None
        self.text = ""
        """both, for a person: `SKYT500003: airborne`; empty until both have come"""

    def take(self, content: Any) -> list[tuple[int, str]]:
        """Take OPEN_DRONE_ID_BASIC_ID's or OPEN_DRONE_ID_LOCATION's fields; (MAV_SEVERITY, text) where they change what
        is known, else nothing."""
        if any(content.id_or_mac):
            return []
        if hasattr(content, "uas_id"):
            self._id = _id(content)
        else:
            self._status = int(content.status)
        if self._id is None or self._status is None:
            return []
        before, self.text = self.text, f"{self._id}: {_STATUS.get(self._status, 'status not declared')}"
        severity = mav.MAV_SEVERITY_WARNING if self._status in _SEVERE else mav.MAV_SEVERITY_INFO
        return [] if self.text == before else [(severity, f"Remote ID {self.text}")]


def _id(content: Any) -> str:
    """The id for a person: as text where it is one, else in hexadecimal digits."""
    raw = bytes(content.uas_id).rstrip(b"\0")
    text = raw.decode("ascii", "replace")
    return text if text.isascii() and text.isprintable() and text else raw.hex() or "without an id"
