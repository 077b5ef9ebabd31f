"""The time between a session's first process and its first tick: until every vehicle is there, and is the only one."""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from gcs.link.link import Link
from gcs.link.lockstep import LockstepLink
from gcs.processes.startup import Arrivals
from gcs.scenario.model import Scenario

if TYPE_CHECKING:  # most sessions have no external vehicle
    from gcs.link.external import ExternalLink

WATCH_EVERY_S = 0.05


class SessionFailed(Exception):
    """The session cannot go on; the text is for its user."""


class BadVehicleError(SessionFailed):
    """A vehicle refused what the scenario gives it."""


class ForkServerDied(SessionFailed):
    """The vehicles' fork server has died."""

    def __init__(self) -> None:
        super().__init__("the fork server of the vehicles (simvehicle fork-server) has died, and they with it")


def arriving(
    scenario: Scenario, labels: Mapping[int, str], link: Link, lockstep: LockstepLink, external: ExternalLink | None
) -> Iterator[list[tuple[int, str]]]:
    """Wait for all vehicles; every WATCH_EVERY_S yield news as (system id, words). Raises SessionFailed.

    `link` is all of the two others.
    """
    booting = [vehicle.sysid for vehicle in scenario.vehicles.all if vehicle.real is not None]
    arrivals, began_s = Arrivals(labels, scenario.vehicles.external, booting), time.monotonic()
    missing: set[int] | None = None
    while missing is None or missing or not (external is None or (external.settled and not external.rivals)):
        missing = {sysid for sysid, _ in link.listen(WATCH_EVERY_S)}
        waited_s = time.monotonic() - began_s
        seen = external.waits() if external is not None else {}
        yield arrivals.look(missing, waited_s, seen)
        reasons = external.signature_reasons if external is not None else {}
        if (why := arrivals.too_late(missing, waited_s, reasons, seen)) is not None:
            raise SessionFailed(why)
        for (sysid, _), (host, port) in lockstep.rivals.items():
            name = labels.get(sysid, f"vehicle {sysid}")
            raise SessionFailed(f"two of the session's own processes say that they are {name}, one from {host}:{port}")
        if external is not None:
            _refuse_rivals(scenario, labels, external)


def _refuse_rivals(scenario: Scenario, labels: Mapping[int, str], external: ExternalLink) -> None:
    """Nothing flies while two say that they are one vehicle: the wrong one would be believed."""
    for key, (one, other) in external.rivals.items():
        sysid, said = key[0], external.twin_sentence(key)
        if said is None:
            continue
        uids = f" ({words})" if (words := said.partition("; ")[2]) else ""
        at = scenario.vehicles.external[sysid].where
        raise SessionFailed(
            f"two say that they are {labels[sysid]} at {at}, {one[0]}:{one[1]} and {other[0]}:{other[1]}{uids}: "
            "end the one that is not, or let the vehicle sign (signing.key_file)"
        )
