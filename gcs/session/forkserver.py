"""Supervisors by fork from a process that has all loaded: `python -m gcs.session.forkserver [CORE]`.

stdin: one JSON line per session, {"folder": PATH, "scenario": TEXT, "modules": [...]}, in a folder with `vehicles/`,
TEXT being the pickled scenario in base64: whoever writes there has validated it and has started this process;
{"stop": true} ends the one that flies in order, {"kill": true} at once. stdout: {"ready": true, "folder": PATH} once
everything is warm, the folder being a temporary one that goes with this process; then the supervisor's own lines
(gcs/session/process.py) and {"ended": PID, "status", "cpu_s"} with the CPU time of supervisor and vehicles together.

One session flies at a time, in processes of its own: a fork of this one is its supervisor, and the one hatch that this
process keeps forks its vehicles. The end of stdin ends everything and removes the folder. `ps` shows
`gcs sessions`, and `gcs session` for the supervisor. With CORE all of them stay on that core.
"""

from __future__ import annotations

import base64
import contextlib
import gc
import json
import os
import pickle
import selectors
import shutil
import signal
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from setproctitle import setproctitle

from gcs.processes.forked import be
from gcs.processes.hatch import READY_WITHIN_S, Hatch
from gcs.processes.python import end_with
from gcs.recording.recorder import RecorderError
from gcs.scenario.file import load, shipped_folder
from gcs.scenario.model import Scenario
from gcs.session import process
from gcs.session.arrival import BadVehicleError, SessionFailed
from gcs.session.client import Lines
from gcs.session.session_process import SessionProcess
from gcs.session.supervised import Signals
from gcs.supervisor import summarise
from skytender.loading import gathered

REHEARSED, REHEARSED_S = "paper/example1", 3.0
"""Flown for so long before any other: the interpreter has then specialised the code of a tick, once for all forks."""


class SessionForks:
    """Forks supervisors one after the other, and keeps the hatch that forks their vehicles."""

    def __init__(self) -> None:
        self._hatch = Hatch(kept=True)
        self._hatch_is_good = True
        self._vehicles_cpu_s = 0.0
        self.pid = 0
        self._pidfd = self._stdin = -1

    def warm_up(self) -> None:
        """Load what a session runs, and wait until the hatch has done so too."""
        summarise.load()
        with selectors.DefaultSelector() as selector:
            selector.register(self._hatch, selectors.EVENT_READ)
            while self._hatch.alive and selector.select(READY_WITHIN_S):
                if self._hatch.events()[0]:
                    self._rehearse_session()
                    break
        gc.collect()
        gc.freeze()
        gathered()

    def _rehearse_session(self) -> None:
        """Fly a shipped scenario in this process; why it may fail, the first session that counts says as well."""
        settings = {"goal.duration_s": REHEARSED_S}
        scenario = load(shipped_folder() / f"{REHEARSED}.yaml", set=settings).flown(lockstep=True)
        os.set_blocking(0, False)  # it looks there for its end
        with tempfile.TemporaryDirectory(prefix="gcs-rehearsal-") as made:
            (Path(made) / "vehicles").mkdir()
            with contextlib.suppress(SessionFailed, BadVehicleError, RecorderError, OSError):
                SessionProcess(Path(made), scenario, hatch=self._hatch).run()
        os.set_blocking(0, True)
        self._vehicles_cpu_s = self._hatch.ended_cpu_s or 0.0

    def start(self, order: Mapping[str, Any]) -> int:
        """Fork a supervisor for a session's folder; a descriptor that is readable at its end."""
        if not (self._hatch_is_good and self._hatch.alive):
            self._hatch.close()
            self._hatch, self._hatch_is_good, self._vehicles_cpu_s = Hatch(kept=True), True, 0.0
        reading, self._stdin = os.pipe()
        parent = os.getpid()

        def run() -> int:
            gc.disable()  # until it flies
            end_with(parent)
            folder = Path(order["folder"])
            with (folder / "stderr.log").open("ab") as errors:
                os.dup2(errors.fileno(), 2)
            scenario: Scenario = pickle.loads(base64.b64decode(order["scenario"]))
            return process.fly(folder, scenario=scenario, modules=order["modules"], hatch=self._hatch)

        self.pid = os.fork()
        if not self.pid:
            be(run, "gcs session", (reading, 1, 2), self._hatch.descriptors)
        os.close(reading)
        self._pidfd = os.pidfd_open(self.pid)
        return self._pidfd

    def stop(self) -> None:
        """Let the session that flies end in order: its standard input closes."""
        if self._stdin >= 0:
            os.close(self._stdin)
            self._stdin = -1

    def end(self, *, kill: bool = False) -> dict[str, Any]:
        """Wait for the supervisor and its vehicles; its last words for the protocol."""
        if kill:
            with contextlib.suppress(ProcessLookupError):
                os.kill(self.pid, signal.SIGKILL)
        _, raw, used = os.wait4(self.pid, 0)
        os.close(self._pidfd)
        self.stop()
        pid, self.pid = self.pid, 0
        cpu_s, status = used.ru_utime + used.ru_stime, os.waitstatus_to_exitcode(raw)
        if status < 0:  # it may have read a part of what the hatch said
            self._hatch_is_good = False
            self._hatch.close()
        elif self._hatch.end_session():
            vehicles_s = self._hatch.ended_cpu_s or 0.0
            cpu_s, self._vehicles_cpu_s = cpu_s + vehicles_s - self._vehicles_cpu_s, vehicles_s
        return {"ended": pid, "status": status, "cpu_s": cpu_s}

    def close(self) -> None:
        """End what still flies, and the hatch."""
        if self.pid:
            self.end(kill=True)
        self._hatch.close()


def serve(forks: SessionForks, folder: Path) -> None:
    """Fly what stdin asks for, until it ends or a signal comes."""
    with Signals() as signals, selectors.DefaultSelector() as selector:
        forks.warm_up()
        _say({"ready": True, "folder": str(folder)})
        selector.register(0, selectors.EVENT_READ)
        selector.register(signals, selectors.EVENT_READ)
        lines = Lines()
        while True:
            for key, _ in selector.select():
                if key.fileobj is signals:
                    if signal.SIGTERM in signals.pop():  # Ctrl-C is for those who asked
                        return
                elif key.fd != 0:
                    selector.unregister(key.fileobj)
                    _say(forks.end())
                else:
                    chunk = os.read(0, 65536)
                    if not chunk:
                        return
                    for order in lines.feed(chunk):
                        if order.get("stop"):
                            forks.stop()
                        elif order.get("kill"):
                            if forks.pid:
                                os.kill(forks.pid, signal.SIGKILL)
                        else:
                            selector.register(forks.start(order), selectors.EVENT_READ)


def _say(content: Mapping[str, Any]) -> None:
    with contextlib.suppress(BrokenPipeError):
        os.write(1, json.dumps(content).encode() + b"\n")


def main() -> None:
    """Entry point."""
    setproctitle("gcs sessions")
    with contextlib.suppress(PermissionError):
        os.setsid()
    if len(sys.argv) > 1:
        with contextlib.suppress(OSError):  # it is only slower elsewhere
            os.sched_setaffinity(0, {int(sys.argv[1])})
    folder = Path(tempfile.mkdtemp(prefix="gcs-sessions-"))
    try:
        forks = SessionForks()
        try:
            serve(forks, folder)
        finally:
            forks.close()
    finally:
        shutil.rmtree(folder, ignore_errors=True)


if __name__ == "__main__":
    main()
