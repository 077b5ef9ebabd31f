"""Checks of `gcs doctor`: Python, packages, sockets, ports, folder, cache, terminal; each with advice."""

from __future__ import annotations

import contextlib
import os
import platform
import re
import shutil
import socket
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from importlib.metadata import PackageNotFoundError, requires, version
from pathlib import Path
from typing import Literal

from gcs.cli.autopilot_programs import REAL_AUTOPILOTS
from gcs.link.socket import BUFFER_BYTES
from gcs.processes.fork_server import vehicle_program
from gcs.processes.python import current_folders

PACKAGE = "skytender"
OLDEST_PYTHON = (3, 11)
COMMON_PORT = 14550
ROOM_BYTES = 200 << 20
COLUMNS, LINES = 80, 24
_REQUIREMENT = re.compile(r"^([A-Za-z0-9._-]+)\s*([^;]*)(?:;.*extra\s*==\s*['\"]([^'\"]+)['\"])?")
_COMMIT = re.compile(r"-g([0-9a-f]{7,40})$")
"""what `git describe` ends with, after the nearest tag that it knows and the commits since"""


@dataclass(frozen=True)
class MachineFinding:
    """One thing looked at: `ok`; `note`, sessions run but less well; `problem`, they do not."""

    level: Literal["ok", "note", "problem"]
    what: str
    found: str
    advice: str = ""


def examine() -> Iterator[MachineFinding]:
    """Every finding, in the order in which a person would want to know.

    A check that cannot even be made, as when a package is missing, is a finding and not the end.
    """
    for check in CHECKS:
        try:
            yield from check()
        except Exception as error:
            what = check.__name__.strip("_").replace("_", " ")
            yield MachineFinding("problem", what, f"{type(error).__name__}: {error}", "see the problems above, if any")


def _python() -> Iterator[MachineFinding]:
    here = f"{platform.python_version()} at {sys.executable}"
    if sys.version_info[:2] < OLDEST_PYTHON:
        yield MachineFinding("problem", "Python", here, "install Python 3.11 or newer, and Skytender there")
    else:
        yield MachineFinding("ok", "Python", here)


def _system() -> Iterator[MachineFinding]:
    here = f"{platform.system()} {platform.release()}, {len(os.sched_getaffinity(0))} processors"
    if not sys.platform.startswith("linux"):
        yield MachineFinding(
            "problem", "system", here, "sessions need Linux; elsewhere use a container or a virtual machine"
        )
        return
    yield MachineFinding("ok", "system", here)
    try:
        os.close(os.pidfd_open(os.getpid()))
    except OSError as error:
        advice = "sessions need Linux 5.3 or newer, and a container that allows pidfd_open"
        yield MachineFinding("problem", "processes", f"pidfd_open: {error.strerror}", advice)


def _versions() -> Iterator[MachineFinding]:
    try:
        own = version(PACKAGE)
        wanted = requires(PACKAGE) or []
    except PackageNotFoundError:
        advice = "install it: pip install . in its checkout"
        yield MachineFinding("problem", PACKAGE, "not installed, only on the path", advice)
        return
    yield MachineFinding("ok", PACKAGE, own)
    for package in _wanted(wanted):
        yield _package(package)


@dataclass
class _Wanted:
    """A package that Skytender needs, or that extras of it want."""

    name: str
    limits: str
    extras: list[str] = field(default_factory=list)
    """empty for what it always needs"""


def _wanted(requirements: Iterable[str]) -> list[_Wanted]:
    """Each package once, without the extra `dev`, which is for Skytender's own developers."""
    found: dict[str, _Wanted] = {}
    for line in requirements:
        match = _REQUIREMENT.match(line)
        if match is None or match[3] == "dev":
            continue
        name, limits, extra = match[1], match[2].strip(), match[3]
        package = found.setdefault(name, _Wanted(name, limits, [extra] if extra else []))
        both = filter(None, [*package.limits.split(","), *limits.split(",")])
        package.limits = ",".join(dict.fromkeys(both))
        if not extra:
            package.extras = []
        elif package.extras and extra not in package.extras:
            package.extras.append(extra)
    return list(found.values())


def _package(package: _Wanted) -> MachineFinding:
    name, limits, extras = package.name, package.limits, package.extras
    of_extras = f" (for the extra{'s' * (len(extras) > 1)} {', '.join(extras)})" if extras else ""
    try:
        have = version(name)
    except PackageNotFoundError:
        if extras:
            advice = f"if you want {' or '.join(extras)}: pip install '.[{extras[0]}]' in Skytender's checkout"
            return MachineFinding("note", name, f"not installed{of_extras}", advice)
        return MachineFinding("problem", name, "not installed", f"install it: pip install '{name}{limits}'")
    if satisfies(have, limits):
        return MachineFinding("ok", name, f"{have}{of_extras}")
    advice = f"install another: pip install '{name}{limits}'"
    return MachineFinding("problem", name, f"{have}, not {limits}{of_extras}", advice)


def satisfies(have: str, limits: str) -> bool:
    """Whether a version lies within limits such as `>=1.2,<3`; only the numbers count."""
    for limit in filter(None, re.split(r"\s*,\s*", limits)):
        match = re.match(r"(>=|<=|==|<|>|!=)\s*([0-9.]+)", limit)
        if match is None:
            continue
        here, there = _numbers(have), _numbers(match[2])
        size = max(len(here), len(there))
        a, b = here + (0,) * (size - len(here)), there + (0,) * (size - len(there))
        holds = {">=": a >= b, "<=": a <= b, "==": a == b, "<": a < b, ">": a > b, "!=": a != b}
        if not holds[match[1]]:
            return False
    return True


def _numbers(text: str) -> tuple[int, ...]:
    head = re.match(r"[0-9.]+", text)
    return tuple(int(part) for part in (head[0] if head else "0").split(".") if part)


def _programs() -> Iterator[MachineFinding]:
    program = vehicle_program()
    if program is None:
        yield MachineFinding(
            "problem", "simvehicle", "not found", "it comes with Skytender: install that again with pip"
        )
        return
    try:
        done = subprocess.run([program, "--version"], capture_output=True, text=True, timeout=60, check=False)
    except (OSError, subprocess.TimeoutExpired) as error:
        yield MachineFinding(
            "problem", "simvehicle", f"{program} cannot be run: {error}", "install Skytender again with pip"
        )
        return
    said = (done.stdout or done.stderr).strip().split("\n")[-1]
    if done.returncode:
        yield MachineFinding("problem", "simvehicle", f"{program}: {said}", "install Skytender again with pip")
    else:
        yield MachineFinding("ok", "simvehicle", f"{said} at {program}")


def _sockets() -> Iterator[MachineFinding]:
    try:
        with (
            socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as here,
            socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as there,
        ):
            here.bind(("127.0.0.1", 0))
            here.settimeout(2.0)
            there.sendto(b"?", here.getsockname())
            here.recv(1)
            here.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, BUFFER_BYTES)
            granted = here.getsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF) // 2  # Linux reports twice what it grants
    except OSError as error:
        yield MachineFinding("problem", "UDP on 127.0.0.1", str(error), "allow UDP on the loopback interface")
        return
    yield MachineFinding("ok", "UDP on 127.0.0.1", "works")
    if granted < BUFFER_BYTES:
        advice = f"for more than about 50 vehicles: sudo sysctl -w net.core.rmem_max={BUFFER_BYTES}"
        yield MachineFinding("note", "receive buffer", f"{granted >> 10} KiB of {BUFFER_BYTES >> 10}", advice)
    else:
        yield MachineFinding("ok", "receive buffer", f"{granted >> 10} KiB")


def _session_socket() -> Iterator[MachineFinding]:
    try:
        with tempfile.TemporaryDirectory(prefix="gcs-doctor-") as folder:
            directory = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
            try:
                with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as server:
                    server.bind(f"/proc/self/fd/{directory}/s")
            finally:
                os.close(directory)
    except OSError as error:
        advice = "sessions need /proc mounted, and a folder for temporary files (TMPDIR) that can hold a socket"
        yield MachineFinding("problem", "session socket", str(error), advice)
    else:
        yield MachineFinding("ok", "session socket", "works")


def _port() -> Iterator[MachineFinding]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.bind(("127.0.0.1", COMMON_PORT))
        except OSError as error:
            advice = "another ground station listens there; sessions are not affected"
            yield MachineFinding("note", f"port {COMMON_PORT}", str(error.strerror).lower(), advice)
        else:
            yield MachineFinding("ok", f"port {COMMON_PORT}", "free for another ground station")


def _folder() -> Iterator[MachineFinding]:
    advice = "change to a folder that you may write in, or give `gcs run` one with --out"
    for here in current_folders():
        yield _room(here, advice)
        return
    yield MachineFinding("problem", "this folder", "it is gone", advice)


def _room(here: Path, advice: str) -> MachineFinding:
    try:
        with tempfile.TemporaryFile(dir=here):
            pass
    except OSError as error:
        return MachineFinding("problem", "this folder", f"{here}: {error.strerror}", advice)
    free = shutil.disk_usage(here).free
    if free < ROOM_BYTES:
        return MachineFinding(
            "note", "this folder", f"{free >> 20} MiB free", "a long session takes 200 MiB: make room"
        )
    return MachineFinding("ok", "this folder", f"{here}, {free >> 20} MiB free")


def _terminal() -> Iterator[MachineFinding]:
    if sys.__stdout__ is None or not sys.stdout.isatty():
        yield MachineFinding("ok", "terminal", "none: `gcs run` writes lines of text")
        return
    size = shutil.get_terminal_size()
    seen = f"{size.columns} x {size.lines}, {sys.stdout.encoding}, TERM={os.environ.get('TERM', '')}"
    advice = ""
    if os.environ.get("TERM", "dumb") == "dumb":
        advice = "set TERM (such as xterm-256color) for the console; without it `gcs run` writes lines"
    elif size.columns < COLUMNS or size.lines < LINES:
        advice = f"the console needs {COLUMNS} x {LINES}: make the window larger, or use --plain"
    elif "utf" not in sys.stdout.encoding.lower():
        advice = "set a UTF-8 locale (LANG=C.UTF-8), or use --plain"
    yield MachineFinding("note" if advice else "ok", "terminal", seen, advice)


def _autopilots() -> Iterator[MachineFinding]:
    """Autopilots that a scenario's `autopilot: {…: PATH}` may name."""
    for kind in REAL_AUTOPILOTS:
        flown = f"flown so far: {', '.join(kind.flown)}"
        path, named = kind.found(), os.environ.get(kind.variable)
        release = None if path is None else kind.release(path)
        if path is None and named:
            advice = f"let {kind.variable} name {kind.program}, or unset it"
            yield MachineFinding("note", kind.name, f"{named} is no {kind.form}", advice)
        elif path is None:
            found = f"none, for 'autopilot: {{{kind.key}: PATH}}' alone ({flown}): {kind.build} makes {kind.program}"
            yield MachineFinding("ok", kind.name, found)
        elif release is None:
            advice = f"its program names no version of {kind.name}; a session needs {kind.program}"
            yield MachineFinding("note", kind.name, str(path), advice)
        elif any(_same_release(release, one) for one in kind.flown):
            yield MachineFinding("ok", kind.name, f"{release} at {path}")
        else:
            newer = all(_numbers(release)[:2] > _numbers(one)[:2] for one in kind.flown)
            said = f"newer than those {flown}" if newer else flown
            yield MachineFinding("ok", kind.name, f"{release} at {path} ({said})")


def _same_release(one: str, other: str) -> bool:
    """A commit may be described from several tags, and its hash cut to several lengths."""
    a, b = _COMMIT.search(one), _COMMIT.search(other)
    if a is None or b is None:
        return one == other
    return a[1].startswith(b[1]) or b[1].startswith(a[1])


def _own_scenarios() -> Iterator[MachineFinding]:
    from gcs.scenario.file import (  # noqa: PLC0415 - what is missing above must be reported, not raised here
        load,
        shipped_folder,
        shipped_names,
    )
    from gcs.scenario.model import ScenarioError  # noqa: PLC0415

    broken = []
    for name in shipped_names():
        with contextlib.suppress(ScenarioError):
            load(shipped_folder() / f"{name}.yaml")
            continue
        broken.append(name)
    if broken or "demo" not in shipped_names():
        advice = "install Skytender again with pip"
        yield MachineFinding("problem", "scenarios", f"unreadable: {', '.join(broken) or 'demo is missing'}", advice)
    else:
        yield MachineFinding("ok", "scenarios", ", ".join(shipped_names()))


CHECKS = (
    _python,
    _system,
    _versions,
    _programs,
    _sockets,
    _session_socket,
    _port,
    _folder,
    _terminal,
    _autopilots,
    _own_scenarios,
)
