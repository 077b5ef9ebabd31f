"""Question about Remote ID: whether a vehicle that sends an id or an operator's sends all that the standard wants.

PX4s send LOCATION and SYSTEM alone, for a transmitter on board that has the id from a ground station.
"""

from __future__ import annotations

from collections.abc import Sequence

from gcs.cli.check.asking import QGC, judged
from gcs.cli.check.dialogue import CheckedVehicle, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK, streamed

RATES_HZ = {"LOCATION": 1.0, "BASIC_ID": 1.0 / 3.0, "SYSTEM": 1.0 / 3.0, "OPERATOR_ID": 1.0 / 3.0}
"""At least, by ASTM F3411."""


def _remote_id(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
    for name, rate_hz in RATES_HZ.items():
        verdict = streamed(f"OPEN_DRONE_ID_{name}", rate_hz)(vehicle, received)
        if verdict.outcome != "ok":
            return verdict._replace(text=f"{name}: {verdict.text}")
    own = bytes(vehicle.of("OPEN_DRONE_ID_BASIC_ID").uas_id).rstrip(b"\0")
    return OK if own else Verdict("wrong", "BASIC_ID holds no id")


def _sends_none(vehicle: CheckedVehicle) -> str:
    if vehicle.of("OPEN_DRONE_ID_BASIC_ID") is not None or vehicle.of("OPEN_DRONE_ID_OPERATOR_ID") is not None:
        return ""
    feeds = any(vehicle.of(f"OPEN_DRONE_ID_{name}") for name in RATES_HZ)
    return "it has no id, and says where it is to a transmitter that has one" if feeds else "it sends none of it"


REMOTE_ID = judged(
    "remote-id",
    "Remote ID: LOCATION each second, BASIC_ID, SYSTEM and OPERATOR_ID every three",
    {QGC: "says that Remote ID is not ready"},
    _remote_id,
    when=_sends_none,
)
