"""A vehicle's signing key, set or taken away by SETUP_SIGNING, and what it does then seen by a signed exchange.

1. Nothing is sent to a vehicle that is armed: PX4 and ArduPilot refuse it, and other stations would lose it in the air.
2. SETUP_SIGNING has no acknowledgement: it is sent up to TRIES times, and each time the vehicle is asked for
   AUTOPILOT_VERSION as one that has obeyed must be asked.
3. Where it answers neither so nor as before, that is said, with the key file that it may have.
The key is in a file before it is sent, so that it cannot be lost with the link.
[lineage] https://mavlink.io/en/guide/message_signing.html; PX4's mavlink_sign_control.cpp and ArduPilot's
GCS_Signing.cpp: a key and a time stamp of zeros take the key away
"""

from __future__ import annotations

import time
from pathlib import Path

from gcs.link.fleet_client import FleetClient
from gcs.mavlink import codec
from gcs.mavlink.ids import AUTOPILOT
from gcs.scenario.endpoint import Endpoint, beyond_this_machine
from skytender.key_files import read_key
from skytender.signing import KEY_BYTES, ticks

TRIES = 4
ANSWERS_WITHIN_S = 2.5
CABLES = ("/dev/ttyACM",)
"""Devices that are an autopilot's own USB port; others may be a radio."""


class KeyNotSet(Exception):
    """Why a vehicle's key is not as it should be; one sentence, and whether the vehicle is as before."""


def others_may_read(at: Endpoint) -> bool:
    """Whether what is sent to an address may pass a radio or a network."""
    return not at.host.startswith(CABLES) if at.way == "serial" else beyond_this_machine(at.text)


def set_key(fleet: FleetClient, sysid: int, before: Path | None, after: Path | None) -> None:
    """Let a vehicle that was found have the key of the file `after` instead of that of `before`, or none. Raises
    KeyNotSet, KeyRefused."""
    if sysid in fleet.armed:
        raise KeyNotSet(f"vehicle {sysid} is armed, and keys are set on the ground: it is as it was")
    key = bytes(KEY_BYTES) if after is None else read_key(after)
    setup = codec.message(
        "SETUP_SIGNING",
        target_system=sysid,
        target_component=AUTOPILOT,
        secret_key=list(key),
        initial_timestamp=0 if after is None else ticks(time.time()),
    )
    for _ in range(TRIES):
        fleet.listener.use_key(before)
        fleet.send_to(sysid, setup)
        fleet.listener.use_key(after)
        if _answers(fleet, sysid):
            return
    fleet.listener.use_key(before)
    if _answers(fleet, sysid):
        raise KeyNotSet(f"vehicle {sysid} answers as before: it has not taken the message; does it know SETUP_SIGNING?")
    files = " or ".join(str(path) for path in (before, after) if path is not None)
    raise KeyNotSet(
        f"vehicle {sysid} answers neither with its new key nor as before: ask it again with --key-file {files}, "
        "or without, before you go on"
    )


def _answers(fleet: FleetClient, sysid: int) -> bool:
    """Whether a vehicle answers a request with the key, or without one, that is used now."""
    return "AUTOPILOT_VERSION" in fleet.request(("AUTOPILOT_VERSION",), ANSWERS_WITHIN_S).get(sysid, {})
