"""A user's planner and policy in a process of their own, as the supervisor starts, asks and ends it.

    with plugin_process.started(scenario, modules, folder) as plugins:
        Supervisor(scenario, link, recorder, plugins=plugins)

A call that Python can interrupt is cut off there (gcs/scenario/guard.py). Where nothing comes back for PATIENCE_S, as
from compiled code that hangs, or where the process dies, it is over: it is ended, that is said once with the line where
it was, and the session flies on without answers. The process ends with the supervisor, however that ends.
"""

from __future__ import annotations

import contextlib
import json
import os
import pickle
import re
import select
import signal
import socket
import struct
import subprocess
import sysconfig
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from gcs.processes.plugin_channel import PluginChannel, question, read_answer
from gcs.processes.plugin_host import DUMPS
from gcs.processes.python import start_python
from gcs.scenario import plugins
from gcs.scenario.document import Problem, ScenarioError
from gcs.scenario.guard import LATE, PROCESS, PluginFault
from gcs.scenario.model import Scenario
from gcs.scenario.plugins import PluginClient

HOST = "gcs.processes.plugin_host"
PATIENCE_S = 3.0
"""[choice] Of a call that is to be cut off after 1 s, nothing came for so long: it cannot be."""
IMPORTED_WITHIN_S = 60.0
"""[choice] For modules of a planner and policy: a large library takes 10 s from a slow disk."""
ENDS_WITHIN_S = 2.0
OUTPUT = "policies.log"
STOPPED = "was ended with the session"
_OURS = str(Path(__file__).resolve().parents[1])
_LIBRARY = sysconfig.get_path("stdlib")
_FRAME = re.compile(r'^  File "(.*)", line (\d+) in (.*)$')


@contextlib.contextmanager
def started(
    scenario: Scenario, modules: Sequence[str], folder: Path | None, parent: int | None = None
) -> Iterator[PluginProcess | None]:
    """The process of what a scenario names; None where that is nothing. It ends with this context.

    folder: whose policies.log takes what the user's code prints; None: our standard error. parent: a descriptor that is
    readable when the session's parent no longer waits for it. Raises OSError.
    """
    if not any(plugins.named(scenario)):
        yield None
        return
    with contextlib.ExitStack() as stack:
        output = 2 if folder is None else stack.enter_context((folder / OUTPUT).open("wb"))
        process = PluginProcess(scenario, modules, output, parent)
        try:
            yield process
        finally:
            process.close()


def check(scenario: Scenario, file: Path | None, folders: Sequence[Path]) -> None:
    """See that every implementation that a scenario, read from `file`, names can be imported, in a process that ends
    with that; `folders` are looked into after the places where Python looks.

    Old names of ours that it imports are warned of. Raises ScenarioError, at the lines that name them, OSError.
    """
    if not any(plugins.named(scenario)):
        return
    process = PluginProcess(scenario, [str(folder) for folder in folders], 2, makes=False)
    try:
        plugins.refuse(scenario, file, process.missing(IMPORTED_WITHIN_S))
    finally:
        process.close()


class PluginProcess(PluginClient):
    """The process, from its start to its end. See `PluginClient` for the methods."""

    def __init__(
        self, scenario: Scenario, modules: Sequence[str], output: Any, parent: int | None = None, *, makes: bool = True
    ) -> None:
        """Begin to make what the scenario names, and `made` waits for it; or only look for it, and `missing` does.
        Raises OSError."""
        self._scenario = scenario
        self._policies = {key: plugins.policy_of(key, name) for key, name, _ in plugins.named(scenario)}
        self._trace = os.memfd_create("trace")
        ours, theirs = socket.socketpair()
        with theirs:
            words = (HOST, str(theirs.fileno()), str(self._trace), str(os.getpid()))
            self._process = start_python(
                *words,
                stdin=subprocess.DEVNULL,
                stdout=output,
                pass_fds=(theirs.fileno(), self._trace),
                start_new_session=True,
            )
        ours.settimeout(PATIENCE_S)
        self._socket, self._channel = ours, PluginChannel(ours)
        self._death = os.pidfd_open(self._process.pid)
        self._parent = parent
        self._reply: dict[str, Any] | None = None
        self._faults: list[PluginFault] = []
        self._ended = False
        self._send(pickle.dumps((scenario, list(modules), makes), pickle.HIGHEST_PROTOCOL))

    @property
    def pid(self) -> int:
        """The process."""
        return self._process.pid

    @property
    def ended(self) -> bool:
        return self._ended

    def missing(self, within_s: float) -> list[tuple[str, str]]:
        """(key, sentence) of each implementation that cannot be used: all of them where they are not imported in this
        time, or their process dies."""
        frame = self._receive(within_s)
        if frame is None:
            problem = self._faults[0].problem
            return [(key, f"{policy} {problem}") for key, policy in self._policies.items()]
        return [(str(key), str(sentence)) for key, sentence in json.loads(frame)["missing"]]

    def made(self, key: str) -> bool:
        if self._reply is None:
            frame = self._receive(None)
            if frame is None:
                self._reply = {"error": f"{key}: {', '.join(self._policies.values())} {self._faults[0].problem}"}
                if self._faults[0].problem == STOPPED:  # the session, which is about to notice
                    self._reply = {"made": {}}
            else:
                self._reply = json.loads(frame)
        if "error" in self._reply:
            raise ScenarioError([Problem(self._scenario.name, None, None, str(self._reply["error"]))])
        return bool(self._reply["made"].get(key))

    def ask(self, key: str, asked: Any) -> None:
        if not self._ended:
            self._send(question(key, asked, self._scenario))

    def answers(self, key: str) -> list[Any]:
        rows: list[Any] = []
        while (frame := self._receive(PATIENCE_S)) is not None:
            try:
                last, more, faults = read_answer(key, self._policies, frame)
            except (ValueError, TypeError, struct.error):
                self._end("sent what is no answer and was ended")
                break
            rows += more
            self._faults += faults
            if last:
                return rows
        return []  # also of the vehicles that were planned for before it ended: which they are is chance

    def pop_faults(self) -> list[PluginFault]:
        taken, self._faults = self._faults, []
        return taken

    def close(self) -> None:
        """End the process; returns when it is gone."""
        self._socket.close()
        self._wait(0.0 if self._ended else ENDS_WITHIN_S)
        for descriptor in (self._death, self._trace):
            os.close(descriptor)

    def _send(self, content: bytes) -> None:
        try:
            self._channel.send(content)
        except TimeoutError:
            self._end_late(PATIENCE_S)
        except OSError:
            self._end_dead()

    def _receive(self, patience_s: float | None) -> bytes | None:
        """The next frame; None where the process has ended, or has to."""
        if self._ended:
            return None
        poll = select.poll()
        watched = [self._socket.fileno(), self._death]
        if patience_s is None and self._parent is not None:
            watched.append(self._parent)
        for descriptor in watched:
            poll.register(descriptor, select.POLLIN)
        while (frame := self._channel.pop()) is None:
            asked_s = time.monotonic()
            ready = dict(poll.poll(None if patience_s is None else 1e3 * patience_s) or poll.poll(0))
            if self._socket.fileno() in ready:
                with contextlib.suppress(OSError):
                    if self._channel.read():
                        continue
                self._end_dead()
            elif self._death in ready:
                self._end_dead()
            elif ready:
                self._end(STOPPED)
            elif patience_s is not None and time.monotonic() - asked_s < 2.0 * patience_s:  # else we were suspended
                self._end_late(patience_s)
            if self._ended:
                return None
        return frame

    def _end_late(self, patience_s: float) -> None:
        """It has been waited for long enough: let it say where it is, and end it."""
        with contextlib.suppress(ProcessLookupError):
            os.kill(self._process.pid, DUMPS)
        select.select([self._death], [], [], ENDS_WITHIN_S)
        self._end(f"{LATE} {patience_s:g} s{self._place()} and was ended")

    def _end_dead(self) -> None:
        """It has died, or has closed its end and is about to."""
        select.select([self._death], [], [], ENDS_WITHIN_S)
        status = self._process.poll()
        if status is None:
            self._end("closed its connection and was ended")
        else:
            how = f"was killed by signal {-status}" if status < 0 else f"ended with status {status}"
            self._end(f"{how}{self._place()}")

    def _end(self, problem: str) -> None:
        if self._ended:
            return
        self._ended = True
        self._wait(0.0)
        self._faults += [PluginFault(PROCESS, policy, problem) for policy in self._policies.values()]

    def _wait(self, patience_s: float) -> None:
        """Wait until it has ended, and end it, with what it has started, where that takes longer."""
        select.select([self._death], [], [], patience_s)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(self._process.pid, signal.SIGKILL)
        self._process.wait()

    def _place(self) -> str:
        """` at FILE:LINE in FUNCTION`, the innermost place in the user's code where it crashed or was ended; empty
        where that is not known."""
        text = os.pread(self._trace, 1 << 20, 0).decode(errors="replace")
        for thread in text.split("(most recent call first):\n")[1:]:
            frames = [found.groups() for line in thread.splitlines() if (found := _FRAME.match(line))]
            if not any(file.endswith("plugin_host.py") for file, _, _ in frames):
                continue
            theirs = [frame for frame in frames if not frame[0].startswith((_OURS, "<frozen"))]
            if theirs:
                file, line, function = min(theirs, key=_distance)
                return f" at {Path(file).name}:{line} in {function}"
        return ""


def _distance(frame: Sequence[str]) -> int:
    """0 for a frame in the user's own file, 1 in an installed package, 2 in Python's library."""
    if "site-packages" in frame[0]:
        return 1
    return 2 if frame[0].startswith(_LIBRARY) else 0
