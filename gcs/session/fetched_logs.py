"""After a session: the logs that external vehicles wrote themselves, downloaded into the session's folder.

1. A vehicle that comes down is waited for until it is disarmed: before that its log is not whole, and ArduPilot keeps
   it back. One that was ordered to hold is not waited for.
   Autopilots write a log on for seconds then: its size is asked for until it stands.
2. The newest log of each is downloaded, all side by side, for FETCH_WITHIN_S at most. What came whole stays.
3. A vehicle whose log did not come whole is named, with the path of the part that came. That changes nothing about how
   the session ended.
"""

from __future__ import annotations

import contextlib
import json
import time
from collections.abc import Callable, Iterable
from pathlib import Path

from gcs.link.fleet_client import FleetClient
from gcs.link.log_folder import LogFolder, newest, problems
from gcs.link.socket import AddressRefused
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.log_client import LogClient, LogEntry
from gcs.scenario.endpoint import address
from gcs.scenario.model import Scenario
from skytender.key_files import KeyRefused

FOLDER, FILE = "logs", "logs.json"
FIND_WITHIN_S, LAND_WITHIN_S, FETCH_WITHIN_S = 5.0, 60.0, 300.0
SAY_EVERY_S = 5.0
LIST_EVERY_S, STANDS_FOR_S, GROWS_FOR_S = 1.0, 5.0, 30.0
"""An ArduPilot writes a log on for 15 s after it was disarmed, what it has every 2 s at least: a size that was the same
twice in 2 s still grew. One that grows for longer is written while its vehicle lives, as ours."""


def fetch_logs(
    scenario: Scenario, session: Path, say: Callable[[str], object], *, fetch_within_s: float = FETCH_WITHIN_S
) -> list[str]:
    """Download into SESSION/logs, with a logs.json of what is there; sentences about what did not come.

    `say` gets what is waited for and the progress.
    """
    folder = session / FOLDER
    try:
        folder.mkdir(exist_ok=True)
    except OSError as error:
        return [f"{folder} cannot be made: {error.strerror}; no log is fetched"]
    with contextlib.ExitStack() as stack:
        found, missed = _find(scenario, stack)
        missed += _wait_until_down(scenario, found, say)
        clients: list[LogClient] = []
        kept = LogFolder(folder, clients)
        stack.callback(kept.close)
        why = f" in {fetch_within_s:.0f} s (`gcs logs get` has no limit)"
        try:
            listed, growing = _listed(found)
            clients += listed
            for sysid in growing:
                say(f"the log of vehicle {sysid} grows on: what it has by now is fetched")
            _download(found, clients, kept, say, fetch_within_s)
        except KeyboardInterrupt:
            missed.append("the download of logs was stopped: `gcs logs get` begins it again")
            why = " until the download was stopped"
        for client in clients:
            for message in client.stop(why):
                found[client.sysid].send_to(client.sysid, message)
        kept.close()
        missed += problems(clients)
    for log in kept.kept:
        say(f"log {log.number} of vehicle {log.sysid}: {log.file}, {log.size_bytes} bytes, sha256 {log.sha256}")
    rows = {kind: [{**row, "file": Path(row["file"]).name} for row in of_kind] for kind, of_kind in kept.rows().items()}
    content = {**rows, "problems": missed}
    with contextlib.suppress(OSError):
        (folder / FILE).write_text(json.dumps(content, indent=1) + "\n", encoding="utf-8")
    return missed


def _find(scenario: Scenario, stack: contextlib.ExitStack) -> tuple[dict[int, FleetClient], list[str]]:
    """The fleet by which each external vehicle is received, by system id; sentences about the ones that are not."""
    found: dict[int, FleetClient] = {}
    expected, missed = scenario.vehicles.external, []
    for connect in dict.fromkeys(text for rules in expected.values() for text in rules.addresses):
        wanted = [sysid for sysid, rules in expected.items() if connect in rules.addresses and sysid not in found]
        at = address(connect)
        if not wanted or at is None:
            continue
        signing = expected[wanted[0]].signing
        try:
            fleet = FleetClient(at, Path(signing.key_file) if signing else None, scenario.station.ids)
        except (AddressRefused, KeyRefused) as error:
            missed.append(f"{connect}: {error}")
            continue
        stack.callback(fleet.close)
        fleet.find(wanted, FIND_WITHIN_S)
        found |= dict.fromkeys(fleet.profiles, fleet)
    for sysid in sorted(expected.keys() - found.keys()):
        where = expected[sysid].where
        missed.append(f"vehicle {sysid}: not heard at {where} after the session, so its log is still with it")
    return found, missed


def _wait_until_down(scenario: Scenario, found: dict[int, FleetClient], say: Callable[[str], object]) -> list[str]:
    """Wait for those that come down; a vehicle that stays armed is taken out of `found`, and named."""
    expected = scenario.vehicles.external
    begun_s, said = time.monotonic(), False
    while coming := [s for s, fleet in found.items() if s in fleet.armed and expected[s].at_end != "hold"]:
        if time.monotonic() - begun_s >= LAND_WITHIN_S:
            break
        if not said:
            said = True
            say(f"waiting until vehicle {', '.join(map(str, sorted(coming)))} is down and disarmed, for its log ...")
        _round(found.values(), [])
    armed = sorted(sysid for sysid, fleet in found.items() if sysid in fleet.armed)
    for sysid in armed:
        del found[sysid]
    return [
        f"vehicle {sysid}: still armed, so its log is not whole: `gcs logs get --connect "
        f"{expected[sysid].addresses[0]}` once it is down"
        for sysid in armed
    ]


def _listed(
    found: dict[int, FleetClient], clock: Callable[[], float] = time.monotonic
) -> tuple[list[LogClient], list[int]]:
    """Dialogues that know the logs of each vehicle, the newest in a size that it keeps, and the system ids of those
    whose newest has not kept one."""
    before: dict[int, list[LogEntry]] = {}
    begun_s = clock()
    stands_s = dict.fromkeys(found, begun_s)
    while True:
        clients = [LogClient(s, AUTOPILOT, found[s].profiles[s].log_folders) for s in sorted(found)]
        for client in clients:
            client.list_logs()
        while not all(client.done for client in clients):
            _round(found.values(), clients)
        latest, now_s = {client.sysid: newest(client) for client in clients}, clock()
        stands_s |= dict.fromkeys((sysid for sysid, log in latest.items() if log != before.get(sysid)), now_s)
        growing = [sysid for sysid, log in latest.items() if log and now_s - stands_s[sysid] < STANDS_FOR_S]
        if not growing or now_s - begun_s >= GROWS_FOR_S:
            return clients, growing
        before = latest
        while clock() - now_s < LIST_EVERY_S:
            _round(found.values(), [])


def _download(
    found: dict[int, FleetClient],
    clients: list[LogClient],
    kept: LogFolder,
    say: Callable[[str], object],
    within_s: float,
) -> None:
    begun_s = said_s = time.monotonic()
    for client in clients:
        client.download(kept.missing(client, newest(client)))
    while not all(client.done for client in clients):
        _round(found.values(), clients)
        kept.save()
        now_s = time.monotonic()
        if now_s - begun_s >= within_s:
            return
        if now_s - said_s >= SAY_EVERY_S:
            said_s = now_s
            say(f"logs: {kept.bytes_so_far / 1e6:.2f} of {kept.wanted_bytes / 1e6:.2f} MB")


def _round(fleets: Iterable[FleetClient], clients: list[LogClient]) -> None:
    for fleet in dict.fromkeys(fleets):
        fleet.exchange([client for client in clients if client.sysid in fleet.profiles])
