"""`simvehicle fork-server`: loads once, then forks every vehicle."""

# ruff: noqa: PLC0415 - so that help and a bad command line load nothing that takes long

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Any

import click

from simvehicle.cli.command import cli, reported, run_argv
from simvehicle.cli.vehicle import LAST_SYSID, prepare
from simvehicle.sitl.secret import hand_over
from skytender.fork_server import Child, serve
from skytender.loading import uncollected

COMMAND = "fork-server"
ENDS_WITHIN_S = 10.0
"""[choice] For a session that has lost the program that began it, to save what was flown."""
OWN_PROCESS = {"-h", "--help", "--version", "--state"}
"""Options that a vehicle's own process reads: those that print, and the one that opens a file to write."""


@click.command(COMMAND, short_help="Fork many vehicles, one per JSON line on stdin.")
def fork_server() -> None:
    """Fork many vehicles: one JSON line on stdin each, {"argv": [...], "log": PATH}; ends with stdin.

    Modules are loaded once; every vehicle is then a fork of this process.
    """
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # threads would be missing in a fork
    with uncollected(for_good=True):
        from simvehicle.sitl import block, link, storage, traffic  # noqa: F401 - once, for all vehicles

    status = serve(child_of)
    sys.stderr.flush()
    os._exit(status)  # a parent that waits for it need not wait for an interpreter's end


def child_of(order: Mapping[str, Any], descriptors: Sequence[int]) -> Child:
    """The process that a line orders. The command `fork-server` with a socket makes another fork server, which has
    loaded all that this one has: of one session, where this one lasts."""
    argv = list(map(str, order["argv"]))
    if argv == [COMMAND]:
        (socket,) = descriptors
        run = partial(serve, child_of)
        about = {"sysid": order.get("sysid", 0)}
        return Child(about, f"simvehicle {COMMAND}", None, run, socket, socket, patience_s=ENDS_WITHIN_S)
    log = Path(order["log"])
    flight, secret = _flight(argv), order.get("secret")

    def fly() -> int:
        hand_over(secret)
        return flight()

    return Child({"sysid": sysid_of(argv)}, title_of(argv), log, fly)


def _flight(argv: Sequence[str]) -> Callable[[], int]:
    """Load what a vehicle needs beyond what all need, and read its command line and its files: the function that its
    process is to call. Each process would pay for the same with memory of its own.

    A command line that is refused is left to the process itself, which says so in its log.
    """
    real = argv[0] if argv and argv[0] in ("ardupilot", "px4") else None
    if real:
        import_module(f"simvehicle.sitl.{real}")  # loaded here, once, for all autopilots of its kind
    alone = partial(run_argv, argv)
    if argv[:1] != ["--sysid"] or any(word.partition("=")[0] in OWN_PROCESS for word in argv):
        return alone
    try:
        with cli.make_context("simvehicle", list(argv)) as context:
            return partial(reported, prepare(**context.params))
    except (click.ClickException, OSError):
        return alone


def sysid_of(argv: Sequence[str]) -> int:
    """The system id that an argv stands for; 255 for traffic, 0 where it names none."""
    if argv and argv[0] == "traffic":
        return 255
    for word, following in pairwise(argv):
        if word == "--sysid" and following.isdecimal():
            return int(following)
    return 0


def title_of(argv: Sequence[str]) -> str:
    """Process title of this argv: `simvehicle 3`, a block `simvehicle 3-27`, or `simvehicle traffic`."""
    first = sysid_of(argv)
    if not 0 < first <= LAST_SYSID:
        return "simvehicle traffic" if first else "simvehicle"
    counts = [int(following) for word, following in pairwise(argv) if word == "--count" and following.isdecimal()]
    last = first + (counts[-1] if counts else 1) - 1
    return f"simvehicle {first}" if last == first else f"simvehicle {first}-{last}"
