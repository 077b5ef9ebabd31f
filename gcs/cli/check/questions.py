"""Questions of MAVSDK, QGroundControl and MAVProxy to a vehicle, all in order (MAVSDK 4.1.0 and MAVProxy 1.8.75 as
measured, QGroundControl as its source says)."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from gcs.cli.check.asking import PEERS
from gcs.cli.check.connect import CONNECT, MISSIONS
from gcs.cli.check.dialogue import Question
from gcs.cli.check.metadata import metadata
from gcs.cli.check.parameters import PARAMETERS
from gcs.cli.check.preparation import PREPARATION
from gcs.cli.check.presence import AT_LAST, PRESENCE
from gcs.cli.check.readiness import readiness
from gcs.cli.check.remote_id import REMOTE_ID
from gcs.cli.check.services import ALONE, LOGS, TWIN, clock, signing


def questions(
    peers: Sequence[str] = PEERS,
    *,
    arm: bool = False,
    ready_within_s: float | None = None,
    now_unix_s: Callable[[], float] | None = None,
    signed: bool = False,
) -> list[Question]:
    """Questions of these peers, in order; with `arm` also what changes the mode, arms and disarms. `ready_within_s`:
    at first wait so long until it could be armed. `now_unix_s`: with the clock that its own is compared with.
    `signed`: over a link with a key."""
    services = [*metadata(), LOGS, *([clock(now_unix_s)] if now_unix_s is not None else ()), signing(signed=signed)]
    everything = [
        *PRESENCE, *CONNECT, *PARAMETERS, *MISSIONS, *services, *(PREPARATION if arm else ()), *AT_LAST, REMOTE_ID,
        ALONE, TWIN,
    ]  # fmt: skip
    ready = [] if ready_within_s is None else [readiness(ready_within_s)]
    return ready + [q for q in everything if set(q.misses) & set(peers) or q.key == "heartbeat"]
