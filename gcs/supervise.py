"""The supervisor as a process: `python -m gcs.supervise FOLDER`, started by `gcs run` (contract.md, Processes).

Reads FOLDER/scenario.yaml, starts the vehicles, runs the session and leaves its files in FOLDER. It ends when its stdin
closes. stdout carries two JSON lines: {"listening": true}, and {"exit", "outcome", "error"} at the end.
"""

from __future__ import annotations

import contextlib
import json
import os
import platform
import signal
import sys
import time
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any

import click

from gcs.clock import Pace
from gcs.launch import Ended, Hatch, LaunchError, traffic_order, vehicle_order
from gcs.link import REPEAT_S, FleetLink
from gcs.pilot import Stage
from gcs.publish import Publisher
from gcs.recorder import Recorder, RecorderError
from gcs.refuelling import Phase
from gcs.scenario import Scenario, ScenarioError, load
from gcs.summary import Energy, Link, Refuelling, Summary, Vehicle
from gcs.supervisor import AUTOPILOT, TRAFFIC, Supervisor

MET, NOT_MET, BAD_INPUT, INTERNAL, INTERRUPTED = 0, 1, 2, 70, 130
PUBLISH_EVERY_S = 0.1
WATCH_EVERY_S = 0.05
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
        self._published_s = 0.0
        self._watched_s = 0.0
        self._phase = "starting"
        self._begun_wall_s: float | None = None
        self._wall_time_s = 0.0
        self._said = 0

    def run(self) -> tuple[int, str]:
        """Fly the session; exit status and outcome. Raises SessionError, LaunchError, RecorderError, OSError."""
        _say({"listening": True})
        interrupted = False
        try:
            with Hatch() as self._hatch:
                try:
                    self._start_fleet()
                    self._fly()
                except _Stopped:
                    interrupted = True
                self._wall_time_s = self._pace.running_wall_s if self._begun_wall_s is not None else 0.0
            self._recorder.close()
            outcome = "interrupted" if interrupted else self._outcome()
            self._summary(outcome, completed=not interrupted).write(self._folder)
        except BaseException:
            with contextlib.suppress(RecorderError):
                self._recorder.close()
            raise
        finally:
            self._phase = "ended"
            self._link.close()
        status = INTERRUPTED if interrupted else MET if outcome == "met" else NOT_MET
        self._publisher.publish(self._picture())
        self._publisher.publish({"type": "end", "outcome": outcome, "exit": status})
        self._publisher.close()
        return status, outcome

    # start

    def _start_fleet(self) -> None:
        assert self._hatch is not None
        if self._link.buffer_bytes < 4 << 20:
            self._event(0, "warning", f"The kernel grants {self._link.buffer_bytes >> 10} KiB of receive buffer, not 4 MiB")
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
        self._begun_wall_s = time.monotonic()
        pace.start()
        supervisor.begin()
        end_ms = round(1e3 * self._scenario.goal.duration_s)
        while supervisor.time_ms < end_ms and self._link.joined:
            pace.next(self._scenario.clock.period_s)
            supervisor.tick(self._watch)
            self._look_around()
            self._wait()
        if self._link.joined:
            self._link.collect(self._watch)

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
        if now_s - self._published_s >= PUBLISH_EVERY_S:
            self._published_s = now_s
            self._publisher.publish(self._picture())

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
        from gcs.supervisor import Event

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
        if len(self._refuelled()) < goal.refuelled_at_least:
            return "refuelled_at_least"
        return "met"

    def _refuelled(self) -> list[Any]:
        return [s for s in self._supervisor.schedule.services if s.phase is Phase.DONE and s.energy_j > 0]

    def _summary(self, outcome: str, *, completed: bool) -> Summary:
        supervisor, scenario = self._supervisor, self._scenario
        metrics = supervisor.metrics
        snapshot = supervisor.fleet.snapshot(supervisor.time_s)
        services = supervisor.schedule.services
        lost_j: dict[int, int] = {}
        for service in services:
            lost_j[service.tanker] = lost_j.get(service.tanker, 0) + service.lost_j
        sim_s, wall_s = supervisor.time_s, self._wall_time_s
        return Summary(
            schema=1,
            scenario=scenario.name,
            seed=scenario.seed,
            clock=scenario.clock.mode,
            speed=scenario.clock.speed,
            sim_time_s=sim_s,
            wall_time_s=wall_s,
            speed_achieved=sim_s / wall_s if wall_s > 0.0 else 0.0,
            lag_s=self._pace.lag_s,
            completed=completed,
            outcome=outcome,
            digest=supervisor.digest.hexdigest(),
            versions=_versions(),
            min_separation_m=_finite(metrics.min_separation_m),
            min_clearance_m=_finite(metrics.min_clearance_m),
            vehicles=[
                Vehicle(
                    sysid=view.sysid,
                    role=view.role,  # type: ignore[arg-type]
                    final_mode=str(view.mode) if view.alive else "dead",
                    max_tracking_error_m=metrics.max_tracking_error_m.get(view.sysid),
                    path_length_m=metrics.path_length_m.get(view.sysid, 0.0),
                    control_effort=view.control_effort,
                    energy=Energy(
                        initial_j=view.initial_j,
                        drawn_j=view.drawn_j,
                        received_j=view.received_j,
                        given_j=view.given_j,
                        lost_j=lost_j.get(view.sysid, 0),
                        remaining_j=view.remaining_j,
                        source=view.energy_source,
                    ),
                )
                for view in snapshot.vehicles
            ],
            refuelling=[Refuelling(**service.record()) for service in services],
            refuel_order=[service.receiver for service in self._refuelled()],
            link=Link(
                received=supervisor.received,
                sent=supervisor.sent,
                lost=supervisor.lost_frames,
                malformed=self._link.malformed,
                overflowed=self._link.overflowed() if self._phase != "ended" else 0,
                command_retries=supervisor.command_retries,
            ),
        )

    def _picture(self) -> dict[str, Any]:
        """The snapshot that clients see."""
        supervisor, scenario = self._supervisor, self._scenario
        snapshot, standing = supervisor.snapshot, supervisor.schedule.standing
        metrics, goal = supervisor.metrics, scenario.goal
        at = {view.sysid: view.p_ned for view in snapshot.vehicles}
        target_of = {
            p.sysid: p.target if p.target is not None else scenario.vehicles.targets[0].sysid
            for p in scenario.vehicles.pursuers
            if scenario.vehicles.targets
        }
        open_services = supervisor.schedule.open_services
        notes = {s.receiver: f"served by {s.tanker}: {s.phase}" for s in open_services}
        notes |= {s.tanker: f"serves {s.receiver}: {s.phase}" for s in open_services}
        events, supervisor.events = supervisor.events, []
        wall_s = self._pace.running_wall_s if self._begun_wall_s is not None else 0.0
        return {
            "type": "snapshot",
            "t_s": supervisor.time_s,
            "duration_s": goal.duration_s,
            "speed": supervisor.time_s / wall_s if wall_s > 0.0 else 0.0,
            "phase": "paused" if self._pace.paused else self._phase,
            "vehicles": [
                {
                    "sysid": view.sysid,
                    "role": view.role,
                    "label": view.label,
                    "alive": view.alive,
                    "stage": str(supervisor.pilots[view.sysid].stage),
                    "mode": str(view.mode),
                    "armed": view.armed,
                    "p_ned": view.p_ned,
                    "speed_m_s": _length(view.v_ned),
                    "height_m": -view.p_ned[2] if view.p_ned is not None else None,
                    "target_m": _distance(view.p_ned, at.get(target_of.get(view.sysid, -1))),
                    "battery": view.remaining_j / view.capacity_j,
                    "remaining_j": view.remaining_j,
                    "endurance_s": _finite(view.endurance_s),
                    "v": standing.v.get(view.sysid),
                    "tau": standing.tau.get(view.sysid),
                    "note": notes.get(view.sysid, ""),
                }
                for view in snapshot.vehicles
            ],
            "traffic": [{"callsign": t.callsign, "p_ned": t.p_ned} for t in snapshot.traffic],
            "services": [
                {
                    "receiver": s.receiver,
                    "tanker": s.tanker,
                    "phase": str(s.phase),
                    "energy_j": s.energy_j,
                    "by": s.by,
                }
                for s in open_services
            ],
            "refuelled": len(self._refuelled()),
            "goal": {
                "pursue_within_m": goal.pursue.within_m if goal.pursue else None,
                "pursue_for_s": goal.pursue.for_s if goal.pursue else None,
                "pursue_held_s": metrics.pursuit_held_s,
                "refuelled_at_least": goal.refuelled_at_least,
            },
            "events": [{"t_s": e.t_s, "sysid": e.sysid, "level": e.level, "text": e.text} for e in events],
        }


def _length(v: tuple[float, float, float]) -> float:
    return float(sum(c * c for c in v) ** 0.5)


def _distance(a: tuple[float, float, float] | None, b: tuple[float, float, float] | None) -> float | None:
    return None if a is None or b is None else _length((a[0] - b[0], a[1] - b[1], a[2] - b[2]))


def _finite(value: float) -> float | None:
    return value if abs(value) < float("inf") else None


def _versions() -> dict[str, str]:
    names = ("skytender", "pymavlink", "numpy", "scipy", "numba")
    return {"python": platform.python_version(), **{name: version(name) for name in names}}


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
    _say({"exit": status, "outcome": outcome, "error": error})
    sys.exit(status)


if __name__ == "__main__":
    main()
