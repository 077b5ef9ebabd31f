"""The supervisor as a process: `python -m gcs.supervise FOLDER`, started by `gcs run` (contract.md, Processes).

Reads FOLDER/scenario.yaml, starts the vehicles, runs the session and leaves its files in FOLDER. It ends when its stdin
closes. stdout carries two JSON lines: {"listening": true}, and {"exit", "outcome", "error"} at the end.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import time
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from gcs.clock import Pace
from gcs.launch import Ended, Hatch, LaunchError, traffic_order, vehicle_order
from gcs.link import BUFFER_BYTES, REPEAT_S, FleetLink
from gcs.picture import picture
from gcs.publish import Publisher
from gcs.recorder import Recorder, RecorderError
from gcs.scenario import Scenario, ScenarioError, load
from gcs.summary import summarise
from gcs.supervisor import AUTOPILOT, TRAFFIC, Event, Supervisor

MET, NOT_MET, BAD_INPUT, INTERNAL, INTERRUPTED = 0, 1, 2, 70, 130
PUBLISH_EVERY_S = 0.1
WATCH_EVERY_S = 0.05
FLUSH_EVERY_S = 1.0
"""What a killed supervisor can lose of its recording, at most, in wall time."""
HELLO_WITHIN_S = 60.0


class _Stopped(Exception):
    """Someone asked for the session's end."""


class SessionError(Exception):
    """The session cannot go on; the text is for the person who started it."""


class Session:
    """One session, from the first process to the summary."""

    def __init__(self, folder: Path, scenario: Scenario, *, drop: float) -> None:
        self._folder = folder
        self._scenario = scenario
        self._link = FleetLink(drop=drop, seed=scenario.seed)
        self._recorder = Recorder(folder)
        self._publisher = Publisher(folder)
        self._supervisor = Supervisor(scenario, self._link, self._recorder)
        self._hatch: Hatch | None = None
        clock = scenario.clock
        self._pace = Pace(None if clock.mode == "lockstep" else clock.speed, time.monotonic)
        self._labels = {v.sysid: v.label for v in scenario.vehicles.all} | {255: "traffic"}
        self._lost: list[int] = []
        self._told_refused: set[tuple[int, int]] = set()
        self._published_s = 0.0
        self._watched_s = 0.0
        self._flushed_s = 0.0
        self._phase = "starting"
        self._begun = False
        self._wall_time_s = 0.0

    def run(self) -> tuple[int, str]:
        """Fly the session; exit status and outcome. Raises SessionError, LaunchError, RecorderError, OSError."""
        try:
            with self._recorder:
                _say({"listening": True})
                interrupted = self._fly_fleet()
            outcome = "interrupted" if interrupted else self._outcome()
            summarise(
                self._supervisor,
                self._link,
                outcome=outcome,
                completed=not interrupted,
                wall_time_s=self._wall_time_s,
                lag_s=self._pace.lag_s,
            ).write(self._folder)
            self._phase = "ended"
            status = INTERRUPTED if interrupted else MET if outcome == "met" else NOT_MET
            self._publisher.publish(self._picture())
            self._publisher.publish({"type": "end", "outcome": outcome, "exit": status})
            return status, outcome
        finally:
            self._link.close()
            self._publisher.close()

    def _fly_fleet(self) -> bool:
        """The session from its first process to its last; True where it was interrupted."""
        with Hatch() as self._hatch:
            try:
                self._start_fleet()
                self._fly()
            except _Stopped:
                return True
            finally:
                self._wall_time_s = self._pace.running_wall_s if self._begun else 0.0
        return False

    # start

    def _start_fleet(self) -> None:
        assert self._hatch is not None
        if self._link.buffer_bytes < BUFFER_BYTES:
            granted = f"{self._link.buffer_bytes >> 10} KiB"
            self._event(0, "warning", f"The kernel grants a receive buffer of {granted}, not 4 MiB: raise rmem_max")
        connection = ("--supervised", f"udpout:{self._link.host}:{self._link.port}")
        vehicles = self._scenario.vehicles.all
        orders = [vehicle_order(vehicle, self._scenario, self._folder, connection) for vehicle in vehicles]
        keys = [(vehicle.sysid, AUTOPILOT) for vehicle in vehicles]
        if self._scenario.traffic:
            orders.append(traffic_order(self._scenario, self._folder, connection))
            keys.append(TRAFFIC)
        self._link.expect(keys)
        self._hatch.start(orders)
        deadline_s = time.monotonic() + HELLO_WITHIN_S
        while missing := self._link.listen(WATCH_EVERY_S):
            self._watch()
            if time.monotonic() > deadline_s:
                names = ", ".join(self._labels[sysid] for sysid, _ in sorted(missing))
                raise SessionError(f"no word from {names} within {HELLO_WITHIN_S:.0f} s of their start")

    # fly

    def _fly(self) -> None:
        supervisor, pace = self._supervisor, self._pace
        self._phase = "flying"
        self._begun = True
        pace.start()
        supervisor.begin()
        end_ms = round(1e3 * self._scenario.goal.duration_s)
        while supervisor.time_ms < end_ms and self._link.joined:
            pace.next(self._scenario.clock.period_s)
            supervisor.tick(self._watch)
            self._look_around()
            self._wait()
        supervisor.finish(self._watch)

    def _wait(self) -> None:
        """Until the next tick is due, or while the session is paused, see who wants something."""
        repeat_s = time.monotonic() + REPEAT_S
        while self._pace.paused or (left_s := self._pace.wait_s()) > 0.0:
            time.sleep(min(WATCH_EVERY_S, WATCH_EVERY_S if self._pace.paused else left_s))
            self._watch()
            if time.monotonic() >= repeat_s:
                self._link.repeat()
                repeat_s = time.monotonic() + REPEAT_S

    def _look_around(self) -> None:
        """At most every 50 ms of wall time: the rest of the world."""
        if time.monotonic() - self._watched_s >= WATCH_EVERY_S:
            self._watch()

    def _watch(self) -> None:
        """Deaths, operators, the parent's pipe; and a fresh picture for those who look."""
        assert self._hatch is not None
        self._watched_s = now_s = time.monotonic()
        _, ended = self._hatch.events()
        for end in ended:
            self._lose(end)
        if not self._hatch.alive:
            raise SessionError("the process that makes the vehicles (simvehicle hatch) has died, and they with it")
        for command in self._publisher.poll():
            self._obey(command["command"])
        if _stdin_closed():
            raise _Stopped
        for key in self._link.refused.keys() - self._told_refused:
            self._told_refused.add(key)
            host, port = self._link.refused[key]
            self._event(key[0], "warning", f"Another vehicle says that it is {key[0]}, from {host}:{port}: ignored")
        if now_s - self._published_s >= PUBLISH_EVERY_S:
            self._published_s = now_s
            self._publisher.publish(self._picture())
        if now_s - self._flushed_s >= FLUSH_EVERY_S:
            self._flushed_s = now_s
            self._recorder.flush()

    def _lose(self, end: Ended) -> None:
        key = TRAFFIC if end.sysid == TRAFFIC[0] else (end.sysid, AUTOPILOT)
        sentence = end.sentence(self._labels.get(end.sysid, f"vehicle {end.sysid}"))
        if self._phase == "starting":
            raise SessionError(sentence)
        self._lost.append(end.sysid)
        self._supervisor.lose(key, sentence)

    def _obey(self, command: str) -> None:
        if command == "stop":
            raise _Stopped
        if command == "pause":
            self._pace.pause()
        elif command == "resume":
            self._pace.resume()
        else:
            return
        self._event(0, "info", f"Operator: {command}")

    def _event(self, sysid: int, level: str, text: str) -> None:
        self._supervisor.events.append(Event(self._supervisor.time_s, sysid, level, text))

    # tell

    def _outcome(self) -> str:
        """`met`, or the first part of the goal that was not."""
        goal, supervisor = self._scenario.goal, self._supervisor
        if self._lost:
            return "vehicle_lost"
        if supervisor.time_ms < round(1e3 * goal.duration_s):
            return "duration_s"
        if goal.pursue is not None and supervisor.metrics.pursuit_held_s < goal.pursue.for_s:
            return "pursue"
        if len(supervisor.schedule.refuelled) < goal.refuelled_at_least:
            return "refuelled_at_least"
        return "met"

    def _picture(self) -> dict[str, Any]:
        """The snapshot that clients see, with the events since the last one."""
        supervisor = self._supervisor
        events, supervisor.events = supervisor.events, []
        wall_s = self._pace.running_wall_s if self._begun else 0.0
        return picture(
            supervisor,
            phase="paused" if self._pace.paused else self._phase,
            speed=supervisor.time_s / wall_s if wall_s > 0.0 else 0.0,
            refuelled=len(supervisor.schedule.refuelled),
            events=events,
        )


def _stdin_closed() -> bool:
    """Whether the parent has gone: its end of our stdin is closed."""
    try:
        return os.read(0, 1) == b""
    except BlockingIOError:
        return False


def _say(content: Mapping[str, Any]) -> None:
    with contextlib.suppress(BrokenPipeError):
        print(json.dumps(content), flush=True)


@click.command()
@click.argument("folder", type=click.Path(path_type=Path, file_okay=False, exists=True))
@click.option("--drop-datagrams", type=click.FloatRange(0.0, 0.9), default=0.0)
def main(folder: Path, drop_datagrams: float) -> None:
    """Run the session in FOLDER (scenario.yaml is there); started by `gcs run`."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    os.set_blocking(0, False)
    status, outcome, error = INTERNAL, "", None
    try:
        status, outcome = Session(folder, load(folder / "scenario.yaml"), drop=drop_datagrams).run()
    except ScenarioError as problem:
        status, error = BAD_INPUT, str(problem)
    except (SessionError, LaunchError, RecorderError) as problem:
        status, error = NOT_MET, str(problem)
    except OSError as problem:
        status, error = NOT_MET, f"{problem.filename or folder}: {problem.strerror}"
    except Exception:
        log = folder / "supervisor.log"
        with contextlib.suppress(OSError):
            log.write_text(traceback.format_exc(), encoding="utf-8")
        error = f"this is a bug of the supervisor: please report it with {log}"
    _say({"exit": status, "outcome": outcome, "error": error})
    sys.exit(status)


if __name__ == "__main__":
    main()
