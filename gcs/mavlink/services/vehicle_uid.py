"""Vehicles with one system id distinguished by the uid of their hardware (AUTOPILOT_VERSION)."""

from __future__ import annotations

from typing import Any

from gcs.mavlink import codec
from gcs.mavlink.autopilots import Params
from skytender import mavlink as mav

VERSION = codec.msgid("AUTOPILOT_VERSION")
ASKED: tuple[int, Params] = int(mav.MAV_CMD_REQUEST_MESSAGE), (float(VERSION),)
"""The command that asks for it."""


def uid_of(content: Any) -> str:
    """The uid in an AUTOPILOT_VERSION, hexadecimal: uid2 where that is filled in; empty where neither is."""
    if any(content.uid2):
        return bytes(content.uid2).hex()
    return f"{content.uid:x}" if content.uid else ""


def twins(sysid: int, other: object, kept: object, other_uid: str, kept_uid: str) -> str:
    """A sentence about a vehicle at one address that has the id of another, which is kept."""
    text = f"Another vehicle says that it is {sysid}, from {other}: ignored, the one at {kept} is kept"
    if other_uid and other_uid == kept_uid:
        return f"{text}; both have the uid {kept_uid}, as one vehicle that comes two ways has"
    if other_uid or kept_uid:
        return f"{text}; their uids are {other_uid or 'not said'} and {kept_uid or 'not said'}"
    return text
