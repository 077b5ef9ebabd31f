"""`simvehicle hatch`: loads once, then makes every vehicle as a fork."""

# ruff: noqa: PLC0415 - so that help and a bad command line load nothing that takes long

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Sequence
from functools import partial
from importlib import import_module
from itertools import pairwise
from pathlib import Path

import click

from simvehicle.cli.command import cli, reported, run_argv
from simvehicle.cli.vehicle import LAST_SYSID, prepare
from skytender.loading import loaded, on_one_core, uncollected

OWN_PROCESS = {"-h", "--help", "--version", "--state"}
"""Options that a vehicle's own process reads: those that print, and the one that opens a file to write."""


@click.command(short_help="Make many vehicles, one per JSON line on stdin.")
def hatch() -> None:
    """Make many vehicles: one JSON line on stdin each, {"argv": [...], "log": PATH}; ends with stdin.

    Modules are loaded once; every vehicle is then a fork of this process.
    """
    on_one_core()
    with uncollected():
        from simvehicle.sitl import forkserver

        _rehearse_start()
    loaded()
    status = forkserver.run(sysid_of, title_of, _prepare)
    sys.stderr.flush()
    os._exit(status)  # nothing is left to be done, and who waits for it need not wait for an interpreter's end


def _prepare(argv: Sequence[str]) -> Callable[[], int]:
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


def _rehearse_start() -> None:
    """Go the way of a vehicle's process from its argv to its first hello, so that every fork finds it loaded."""
    import tempfile

    from simvehicle.autopilot.geodesy import LocalFrame
    from simvehicle.cli.files import read_parameters
    from simvehicle.sitl import block, link, storage, traffic  # noqa: F401 - loaded here, once, for all vehicles

    triples = ("--position", "0,0,-1", "--velocity", "0,0,0", "--attitude", "0,0,0", "--home", "0,0,0")
    cli.make_context("simvehicle", ["--sysid", "1", *triples, "--params", "none", "--airborne"])
    LocalFrame(0.0, 0.0, 0.0)
    with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
        file.write("SIM_BAT_CAP_J: 24000.0\n")
        file.flush()
        read_parameters(Path(file.name), {})
    link.open_socket(link.parse_supervisor("udpout:127.0.0.1:9")).close()


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
