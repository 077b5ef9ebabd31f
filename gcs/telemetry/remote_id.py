"""Remote ID of vehicles: their own id and status as one line, each time that one of them changes.

An id of another aircraft, which a transmitter has received, names that transmitter (id_or_mac) and is passed over.
[lineage] https://mavlink.io/en/services/opendroneid.html
"""

from __future__ import annotations

from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from skytender import mavlink as mav

_BASIC, _LOCATION = codec.msgid("OPEN_DRONE_ID_BASIC_ID"), codec.msgid("OPEN_DRONE_ID_LOCATION")
_MESSAGES = (_BASIC, _LOCATION)
_STATUS = {
    mav.MAV_ODID_STATUS_GROUND: "on the ground",
    mav.MAV_ODID_STATUS_AIRBORNE: "airborne",
    mav.MAV_ODID_STATUS_EMERGENCY: "in an emergency",
    mav.MAV_ODID_STATUS_REMOTE_ID_SYSTEM_FAILURE: "its transmitter has failed",
}
_SEVERE = (mav.MAV_ODID_STATUS_EMERGENCY, mav.MAV_ODID_STATUS_REMOTE_ID_SYSTEM_FAILURE)


class RemoteIds:
    """Ids and statuses by system id, as last reported."""

    def __init__(self) -> None:
        self._ids: dict[int, str] = {}
        self._statuses: dict[int, int] = {}
        self._said: dict[int, tuple[str, int]] = {}

    def receive(self, frame: Frame) -> tuple[int, str] | None:
        """(MAV_SEVERITY, text) where a frame changes what is known of its sender."""
        if frame.msgid not in _MESSAGES:
            return None
        content = codec.fields(frame)
        if any(content.id_or_mac):
            return None
        if frame.msgid == _BASIC:
            self._ids[frame.sysid] = _text(content)
        else:
            self._statuses[frame.sysid] = content.status
        now = self._ids.get(frame.sysid), self._statuses.get(frame.sysid)
        if None in now or self._said.get(frame.sysid) == now:
            return None
        self._said[frame.sysid] = own, status = str(now[0]), int(now[1] or 0)
        severity = mav.MAV_SEVERITY_WARNING if status in _SEVERE else mav.MAV_SEVERITY_INFO
        return severity, f"Remote ID {own}: {_STATUS.get(status, 'status not declared')}"


def _text(content: Any) -> str:
    """The id for a person: as text where it is one, else in hexadecimal digits."""
    raw = bytes(content.uas_id).rstrip(b"\0")
    text = raw.decode("ascii", "replace")
    return text if text.isascii() and text.isprintable() and text else raw.hex() or "without an id"
