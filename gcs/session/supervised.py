"""`gcs run`: a session's folder, and its supervisor from start to end."""

from __future__ import annotations

import contextlib
import json
import os
import selectors
import shutil
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import IO, Any, Self

import click

from gcs.processes.fork_server import ForkServer
from gcs.processes.forked import ForkedProcess, end
from gcs.processes.forks import close_in_forks
from gcs.processes.python import current_folders, start_python
from gcs.processes.spawned import SpawnedProcess
from gcs.scenario.file import dump, load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.scenario.pydantic_plugins import without_plugins
from gcs.session.client import SOCKET, Client, EarlierEvents, Lines
from gcs.session.plain_text import View, clean, farewell, mute, mute_gone, shortfalls
from skytender.exit import BAD_INPUT, INTERNAL_ERROR, Terminated, ending, terminate
from skytender.loading import uncollected

SUPERVISOR = "gcs.session.process"
POLL_S = 0.125
RECONNECT_S = 0.5
PATIENCE_S = (30.0, 10.0)
"""Wall time that the supervisor has for its end after `stop`, and then after its pipe has closed; then it is killed."""
SAVES_WITHIN_S = 3.0
"""However often it is asked to stop, it is not killed sooner: it may be writing what the session amounts to."""


class RunError(click.ClickException):
    """Why nothing could be started: one sentence for a person."""

    exit_code = BAD_INPUT


class Signals:
    """The signals that ask this program to end as something to select on, while in its context."""

    def __enter__(self) -> Self:
        self._read, self._write = socket.socketpair()
        self._read.setblocking(False)
        self._write.setblocking(False)
        self._wakeup = signal.set_wakeup_fd(self._write.fileno(), warn_on_full_buffer=False)
        self._handlers = {number: signal.signal(number, _ignore) for number in ending()}
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._handlers.items():
            signal.signal(number, handler)
        signal.set_wakeup_fd(self._wakeup)
        self._read.close()
        self._write.close()

    def fileno(self) -> int:
        """Readable when a signal has come."""
        return self._read.fileno()

    def pop(self) -> list[int]:
        """The signals that have come, in order."""
        try:
            return [number for number in self._read.recv(256) if number in self._handlers]
        except BlockingIOError:
            return []


def _ignore(*_: object) -> None:
    """The wake-up descriptor reports signals; Python needs a handler for it to do so."""


def make_folder(out: Path | None, name: str) -> Path:
    """A new session folder with `vehicles/` in it, for a scenario of this name; raises RunError."""
    stamp = datetime.now().astimezone().strftime("%Y%m%d-%H%M%S")
    folder = out or Path("sessions") / f"{name}-{stamp}"
    suffix = 1
    while True:
        try:
            folder.mkdir(mode=0o700, parents=True)  # no other user may read, or connect to, anything in it
            break
        except FileExistsError:
            if out is not None or not folder.is_dir():
                raise RunError(f"{folder} exists already and is left as it is; give another folder") from None
            suffix += 1
            folder = folder.with_name(f"{name}-{stamp}-{suffix}")
        except OSError as error:
            homeless = not (folder.is_absolute() or current_folders())
            why = "the current folder is gone" if homeless else error.strerror
            raise RunError(f"cannot make the folder {folder}: {why}; give a place to write") from None
    try:
        (folder / "vehicles").mkdir()
    except OSError as error:
        folder.rmdir()
        raise RunError(f"cannot write in {folder}: {error.strerror}; give --out another place") from None
    return folder


@contextlib.contextmanager
def new_folder(out: Path | None, name: str) -> Iterator[Path]:
    """A folder that `make_folder` makes; it is removed where the session ends before anything is written to it, by
    Ctrl-C, SIGTERM or SIGHUP, or on a full disk."""
    handlers = {number: signal.getsignal(number) for number in (signal.SIGTERM, signal.SIGHUP)}
    for number, handler in handlers.items():
        if handler is signal.SIG_DFL:  # else the caller ignores it, as nohup does
            signal.signal(number, terminate)
    try:
        folder = make_folder(out, name)
        try:
            yield folder
        except (KeyboardInterrupt, Terminated):
            stands = f"interrupted; what was written by then stands in {folder}"
            removed = f"interrupted before the session began; its folder {folder} is removed"
            _say(stands if _has_content(folder) else removed)
            raise
        finally:
            if not _has_content(folder):  # else the same command would be refused, with room on the disk or not
                shutil.rmtree(folder, ignore_errors=True)
    finally:
        for number, handler in handlers.items():
            signal.signal(number, handler)


def _has_content(folder: Path) -> bool:
    return any(path.is_file() and path.stat().st_size for path in folder.rglob("*"))


def write_scenario(folder: Path, scenario: Scenario) -> None:
    """Write the resolved scenario into a session's folder; raises RunError."""
    try:
        (folder / "scenario.yaml").write_text(dump(scenario), encoding="utf-8")
    except OSError as error:
        raise RunError(f"cannot write in {folder}: {error.strerror}; give --out another place") from None


@dataclass(frozen=True)
class SupervisorFork:
    """The supervisor of the session prepared in `folder`, to be run in a fork of this process, with the vehicles' fork
    server that has been started already, if there is one."""

    folder: Path
    scenario: Scenario
    drop: float
    server: ForkServer | None = None

    def start(self, stderr: IO[bytes] | None) -> ForkedProcess:
        """Fork; the fork server is the fork's from now on."""
        keep = () if self.server is None else (self.server.fileno(),)
        process = ForkedProcess(self._fly, f"{SUPERVISOR} {self.folder}", stderr, keep)
        if self.server is not None:
            self.server.hand_over()
        return process

    def _fly(self) -> int:
        if not sys.flags.safe_path and sys.path[:1] in ([""], [str(folder) for folder in current_folders()]):
            del sys.path[0]  # as -P does for the command
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # nothing here is worth threads
        with without_plugins():
            with uncollected(for_good=True):
                from gcs.session import process  # noqa: PLC0415 - only a supervisor needs it

            server = None if self.server is None else self.server.adopted()
            return process.fly(self.folder, drop=self.drop, scenario=self.scenario, server=server)


class Supervised:
    """A session's supervisor from start to end: its pipes, its socket, and how it is asked to stop.

    The asking gets firmer with each call of `interrupt`, and by itself when patience ends: the command, the closed
    pipe, the kill.
    """

    def __init__(
        self,
        folder: Path,
        arguments: Sequence[str],
        pass_fds: Sequence[int] = (),
        stderr: IO[bytes] | None = None,
        start: Callable[[IO[bytes] | None], ForkedProcess | SpawnedProcess] | None = None,
        supervisor: str = SUPERVISOR,
    ) -> None:
        """`start` makes the process, with this standard error, instead of the module `supervisor` where it is given."""
        self._folder = folder
        self._process: subprocess.Popen[bytes] | ForkedProcess | SpawnedProcess = (
            start(stderr)
            if start is not None
            else start_python(
                *(supervisor, str(folder), *arguments),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=stderr,
                start_new_session=True,
                pass_fds=pass_fds,
            )
        )
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        self._in, self._out = self._process.stdin, self._process.stdout
        os.set_blocking(self._out.fileno(), False)
        try:
            self.death = os.pidfd_open(self._process.pid)
        except ProcessLookupError:  # ended already, and waited for by its fork server
            self.death = os.eventfd(1)
        self._lines = Lines()
        self._listening = False
        self._connect_at_s = 0.0
        self._insistence = 0
        self._asked_s = self._firmer_at_s = float("inf")
        self.client: Client | None = None
        self.verdict: dict[str, Any] | None = None
        self.last: Mapping[str, Any] = {}
        """the newest snapshot shown, for the case that the supervisor dies"""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        with contextlib.suppress(BrokenPipeError):
            self._in.close()
        end(self._process, PATIENCE_S[1])
        if self.client is not None:
            self.client.close()
        self._out.close()
        os.close(self.death)

    def close_in_forks(self) -> None:
        """Keep its standard input from processes that are forked from this one: it ends with this process alone."""
        close_in_forks(self._in)

    def fileno(self) -> int:
        """Its standard output."""
        return self._out.fileno()

    @property
    def ended(self) -> bool:
        """Whether the process is no more."""
        return self._process.poll() is not None

    @property
    def status(self) -> int | None:
        """Exit status of the process; negative for a signal."""
        return self._process.poll()

    def read(self) -> bool:
        """Take what it has said on its standard output; whether that is still open."""
        while True:
            try:
                chunk = os.read(self._out.fileno(), 65536)
            except BlockingIOError:
                return True
            if not chunk:
                return False
            for content in self._lines.feed(chunk):
                self._listening = self._listening or bool(content.get("listening"))
                if "exit" in content:
                    self.verdict = dict(content)

    def connect(self, now_s: float) -> bool:
        """Connect once it listens, again when it has dropped us; whether that has happened now."""
        if self.client is not None and not self.client.connected:
            self.client.close()
            self.client = None
        if not self._listening or self.client is not None or now_s < self._connect_at_s or self.verdict:
            return False
        self._connect_at_s = now_s + RECONNECT_S
        try:
            self.client = Client(self._folder)
        except OSError:
            return False
        if self._insistence:
            self.client.say("stop")
        return True

    def interrupt(self, now_s: float) -> None:
        """Ask it to stop; more firmly each time, but never so that a session is lost which is being saved."""
        self._asked_s = min(self._asked_s, now_s)
        if self._insistence >= 2 and now_s < self._asked_s + SAVES_WITHIN_S:
            return
        self._insistence += 1
        if self._insistence == 1 and not self._listening:
            self._insistence = 2
        if self._insistence == 1:
            if self.client is not None:
                self.client.say("stop")
        elif self._insistence == 2:
            with contextlib.suppress(BrokenPipeError):
                self._in.close()
        else:
            self._process.kill()
        self._firmer_at_s = now_s + PATIENCE_S[min(self._insistence, len(PATIENCE_S)) - 1]

    def insist(self, now_s: float) -> None:
        """Ask more firmly if patience has ended at wall time `now_s`."""
        if now_s >= self._firmer_at_s:
            self.interrupt(now_s)

    def keeps_waiting(self, now_s: float) -> bool:
        """Whether it takes so long to stop that a person should know."""
        return now_s >= self._asked_s + SAVES_WITHIN_S


def run(
    folder: Path,
    view: View,
    echo: Callable[[str], object],
    *,
    arguments: Sequence[str] = (),
    supervisor: str = SUPERVISOR,
    fork: SupervisorFork | None = None,
    begun: Callable[[], object] = lambda: None,
    finish: Callable[[dict[str, Any]], object] = lambda _: None,
    complain: Callable[[str], object] = lambda _: None,
    stderr: IO[bytes] | None = None,
    hurry: Callable[[], object] = lambda: None,
) -> int:
    """Fly the session prepared in `folder`; the exit status (docs/protocol/result.md#exit-status).

    `view` shows it while it flies, `begun` is called once it is started, `finish` gets the supervisor's last word,
    `echo` prints the lines that sum it up, and `complain` those among them that say what went wrong. `fork` is the
    supervisor instead of that module. `stderr` takes what the supervisor says there; our own standard error without it.
    `hurry` is called where a person has asked more than once for the end.
    """
    start = None if fork is None else fork.start
    with (
        Signals() as signals,
        Supervised(folder, arguments, stderr=stderr, start=start, supervisor=supervisor) as process,
    ):
        begun()
        try:
            interrupted = _watch(process, signals, view, hurry)
        finally:
            with contextlib.suppress(OSError):
                view.close()
        verdict, status = process.verdict, process.status
    mute_gone()
    if verdict is None:
        (folder / SOCKET).unlink(missing_ok=True)
    if verdict is None and (process.last or not interrupted):
        how = f"was killed by signal {-status}" if status is not None and status < 0 else f"ended with status {status}"
        print(
            f"gcs: the supervisor of {folder} {how} before the session's end; what it said, if anything, stands "
            f"above, the vehicles' logs in {folder / 'vehicles'}",
            file=sys.stderr,
        )
        for line in _left_in_the_air(folder, process.last):
            print(f"gcs: {line}", file=sys.stderr)
        return 128 + interrupted if interrupted else INTERNAL_ERROR
    verdict = verdict or {"exit": BAD_INPUT, "outcome": "interrupted", "error": None}
    finish(verdict)
    if verdict.get("error"):
        print(f"gcs: {clean(verdict['error'])}", file=sys.stderr)
    with contextlib.suppress(OSError):  # the reader may be gone
        summary = _summary(folder)
        for line in farewell(summary, verdict.get("outcome"), folder):
            echo(line)
        for line in shortfalls(summary, verdict.get("outcome")):
            complain(f"gcs: {line}")
    failed = verdict["exit"] == INTERNAL_ERROR or verdict.get("error")
    return int(verdict["exit"]) if failed or not interrupted else 128 + interrupted


def _left_in_the_air(folder: Path, last: Mapping[str, Any]) -> list[str]:
    """External vehicles that a supervisor has left without control, a sentence each."""
    try:
        external = load(folder / "scenario.yaml").vehicles.external
    except (OSError, ScenarioError):
        return []
    return [
        f"{row['label']} at {external[row['sysid']].where} may still be flying without control: look after it"
        for row in last.get("vehicles", ())
        if row["sysid"] in external and row["armed"] and not row["landed"]
    ]


def _watch(process: Supervised, signals: Signals, view: View, hurry: Callable[[], object]) -> int:
    """Show the session until its supervisor has ended; the first signal that asked it to stop, or 0."""
    interrupted, notified = 0, False
    with selectors.DefaultSelector() as selector:
        for source in (process, process.death, signals):
            selector.register(source, selectors.EVENT_READ)
        watched: Client | None = None
        earlier = EarlierEvents()
        while True:
            selector.select(POLL_S)
            now_s = time.monotonic()
            ended = process.ended
            if not process.read() and process in selector.get_map():
                selector.unregister(process)
            for number in signals.pop():
                if interrupted:
                    hurry()
                if process.verdict is None:
                    interrupted = interrupted or number
                process.interrupt(now_s)
            process.insist(now_s)
            if not notified and not ended and process.keeps_waiting(now_s):
                notified = True
                _say("waiting until the session is saved; Ctrl-C twice more ends it unsaved")
            try:
                for content in earlier.joined(watched.receive()) if watched is not None else ():
                    if content.get("type") == "snapshot":
                        process.last = content
                        view.show(content)
                view.tick(now_s)
            except BrokenPipeError:  # the reader of our lines is gone, as with `| head`
                interrupted = interrupted or signal.SIGPIPE
                process.interrupt(now_s)
                view = View()
                mute(1)
            except OSError as error:  # the session goes on unseen
                _say(f"cannot show the session: {error.strerror}; it goes on")
                view = View()
                mute(1)
            if watched is not None and not watched.connected:
                selector.unregister(watched)
                watched = None
            if ended:
                return interrupted
            if process.connect(now_s):
                assert process.client is not None
                watched = process.client
                selector.register(watched, selectors.EVENT_READ)


def _say(line: str) -> None:
    with contextlib.suppress(OSError):  # the terminal may be gone
        print(f"gcs: {line}", file=sys.stderr)


def _summary(folder: Path) -> dict[str, Any] | None:
    try:
        content = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    return content if isinstance(content, dict) else None
