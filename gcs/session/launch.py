"""`gcs launch`: a scenario's vehicles for another ground station, from start to end."""

from __future__ import annotations

import contextlib
import os
import re
import selectors
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from gcs.link.router import VehicleRouter
from gcs.link.socket import AddressRefused
from gcs.processes.fork_server import ForkServer, LaunchError
from gcs.processes.vehicles import vehicle_orders
from gcs.scenario.endpoint import Endpoint
from gcs.scenario.model import Scenario
from gcs.session.supervised import POLL_S, RunError, Signals, make_folder, write_scenario
from skytender.exit import DONE, NOT_DONE

STARTED_WITHIN_S = 120.0
ENDED_EARLY = "standard input ended before the vehicles were there; --until-eof wants one that stays open"
ADDRESS_LINE = re.compile(r"vehicle \d+: (udpin:(.+):0|udpout:.+) \(local port (\d+)\)")


def launch(
    scenario: Scenario,
    out: Path | None,
    connect: Endpoint | None,
    report: Callable[[list[dict[str, Any]]], object],
    *,
    until_eof: bool = False,
) -> int:
    """Start the scenario's vehicles for another ground station and keep them until Ctrl-C; the exit status.

    `connect`: all of them are there; each listens at a port of its own without it. Raises RunError.
    `report` gets {sysid, role, label, address, log} of each vehicle that came up, once.
    """
    scenario = scenario.model_copy(update={"truth": False})  # a truth file would grow for as long as anyone flies
    with contextlib.ExitStack() as stack:
        router = _routed(connect, stack)
        near = router.near if router is not None else connect.text if connect is not None else "udpin:127.0.0.1:0"
        connection = ["--connect", near]
        if out is None:
            folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="gcs-launch-")))
            (folder / "vehicles").mkdir()
        else:
            folder = make_folder(out, scenario.name)
            write_scenario(folder, scenario)
        signals = stack.enter_context(Signals())
        orders = vehicle_orders(scenario, folder, connection)
        try:
            server = stack.enter_context(ForkServer.of_vehicles())
        except LaunchError as error:
            raise RunError(str(error)) from error
        server.start([order.order() for order in orders])
        waiting = {order.sysid: order.log for order in orders}
        labels = {vehicle.sysid: (vehicle.role, vehicle.label) for vehicle in scenario.vehicles.all}
        alive = set(waiting)
        up: list[dict[str, Any]] = []
        reported = False
        deadline_s = time.monotonic() + STARTED_WITHIN_S
        selector = stack.enter_context(selectors.PollSelector())  # standard input may be a file, or /dev/null
        selector.register(server, selectors.EVENT_READ)
        selector.register(signals, selectors.EVENT_READ)
        if until_eof:
            selector.register(0, selectors.EVENT_READ)
        for fileno in router.filenos() if router is not None else ():
            selector.register(fileno, selectors.EVENT_READ)
        while alive:
            ready = selector.select(None if reported and router is None else POLL_S)
            if router is not None:
                _pump(router)
            if any(key.fd == 0 and not os.read(0, 65536) for key, _ in ready):
                if not reported:
                    print(f"gcs: {ENDED_EARLY}", file=sys.stderr)
                return DONE
            if arrived := signals.pop():
                return 128 + arrived[0]
            for ended in server.events():
                alive.discard(ended.sysid)
                waiting.pop(ended.sysid, None)
                print(f"gcs: {ended.sentence(labels[ended.sysid][1])}", file=sys.stderr, flush=True)
            if not server.alive:
                sentence = "the fork server of the vehicles has ended, and all of them with it"
                if not reported:
                    raise RunError(sentence)
                print(f"gcs: {sentence}", file=sys.stderr)
                break
            for sysid in list(waiting):
                if (address := _address(waiting[sysid])) is not None:
                    address = router.far.addresses[0] if router is not None else address
                    role, label = labels[sysid]
                    log = str(waiting.pop(sysid))
                    up.append({"sysid": sysid, "role": role, "label": label, "address": address, "log": log})
            if not reported and not waiting and up:
                report(sorted(up, key=lambda vehicle: vehicle["sysid"]))
                reported = True
            if waiting and time.monotonic() > deadline_s:
                late = ", ".join(labels[sysid][1] for sysid in waiting)
                raise RunError(
                    f"no sign of life within {STARTED_WITHIN_S:.0f} s from {late}; is the machine overloaded?"
                )
        print("gcs: no vehicle is left", file=sys.stderr)
        return NOT_DONE


def _routed(connect: Endpoint | None, stack: contextlib.ExitStack) -> VehicleRouter | None:
    """VehicleRouter to an address to which vehicles do not speak by themselves. Raises RunError."""
    if connect is None or connect.way == "udpout":
        return None
    try:
        router = VehicleRouter(connect)
    except AddressRefused as error:
        raise RunError(f"--connect: {error}") from None
    stack.callback(router.close)
    return router


def _pump(router: VehicleRouter) -> None:
    router.pump()
    for where, problem in router.far.pop_problems():
        print(f"gcs: {where}: {problem}" if problem else f"gcs: {where} is there", file=sys.stderr, flush=True)


def _address(log: Path) -> str | None:
    """Address where a vehicle listens, or to which it sends, once its log names it."""
    try:
        with log.open(encoding="utf-8", errors="replace") as lines:
            match = ADDRESS_LINE.match(lines.readline())
    except OSError:
        return None
    if match is None:
        return None
    return match[1] if match[2] is None else f"udpout:{match[2]}:{match[3]}"
