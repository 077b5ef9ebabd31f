"""Sessions with vehicles that somebody else has started: a mixed fleet on the real clock, its end, and nobody there."""

from __future__ import annotations

import contextlib
import json
import math
import os
import signal
import socket
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pymap3d
import pytest
import yaml
from patience import PATIENCE_S
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import Outcome, Running, fly
from strangers import ARDUCOPTER, SIMVEHICLE, strangers
from websockets.sync.client import connect as websocket
from websockets.typing import Origin, Subprotocol

LAT, LON, ALT = 47.397742, 8.545594, 488.0
RING_M = 2.0
FLOWN_S = 19.0
AWAY_S = 0.7


def scenario(vehicles: dict[str, Any], **changed: Any) -> dict[str, Any]:
    return {
        "schema": 1, "name": "strangers", "axes": "ned", "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
        "goal": {"duration_s": 16.0}, "vehicles": vehicles,
    } | changed  # fmt: skip


def home(north: float, east: float, height: float) -> str:
    lat, lon, alt = pymap3d.ned2geodetic(north, east, -height, LAT, LON, ALT)
    return f"{lat:.7f},{lon:.7f},{alt:.2f}"


def _place(position: Any) -> tuple[float, float, float]:
    """By GLOBAL_POSITION_INT, in the session's frame."""
    n, e, d = pymap3d.geodetic2ned(1e-7 * position.lat, 1e-7 * position.lon, 1e-3 * position.alt, LAT, LON, ALT)
    return float(n), float(e), float(d)


@dataclass
class Flown:
    outcome: Outcome
    logs: list[Path]
    twin: str

    @property
    def said(self) -> str:
        return (self.outcome.folder / "session.log").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """A PX4 and two ArduCopters of strangers, each with an origin of its own, and a pursuer and a target of ours.

    While they fly a fourth vehicle claims the first one's id, and the supervisor is stopped for a while.
    """
    folder = tmp_path_factory.mktemp("strangers")
    shared, listens = free_port(), free_port()
    at = {"connect": f"udpin:127.0.0.1:{shared}", "capacity_j": 200_000}
    there = {"connect": f"udpout:127.0.0.1:{listens}", "capacity_j": 200_000, "autopilot": "ardupilot"}
    vehicles = {
        "pursuers": [
            {"external": {"sysid": 1, **at}},
            {"external": {"sysid": 2, **there}},
            {"external": {"sysid": 3, **at}},
            {"sysid": 4, "start_m": [-2.5, 0, 0], "battery": {"capacity_j": 150_000}},
        ],
        "targets": [
            {"sysid": 101, "start_m": [0, 0, 0], "battery": {"capacity_j": 150_000}, "speed_m_s": 0.7,
             "path_m": [[0, 0, -2.5], [14, 0, -2.5]]},
        ],
    }  # fmt: skip
    said = scenario(
        vehicles,
        goal={"duration_s": FLOWN_S, "pursue": {"within_m": 3.0, "for_s": 3.0}},
        formation={"ring_m": RING_M},
        obstacles=[{"sphere_m": [3.5, 0.2, -2.5], "radius_m": 0.4}],
    )
    one = [*SIMVEHICLE, "--sysid", "1", "--connect", f"udpout:127.0.0.1:{shared}", "--home", home(3.0, 2.0, 1.0)]
    two = [*SIMVEHICLE, "--sysid", "2", "--connect", f"udpin:127.0.0.1:{listens}", "--autopilot", "ardupilot",
           "--home", home(-2.0, -3.0, -0.5)]  # fmt: skip
    three = [*ARDUCOPTER, "--sysid", "3", "--connect", f"udpout:127.0.0.1:{shared}", "--origin", home(0.0, 5.0, 0.0),
             "--refuse-arming-s", "5", "--refuse-intervals", "--battery-told", "energy"]  # fmt: skip
    with contextlib.ExitStack() as stack:
        logs = stack.enter_context(strangers(folder, one, two))
        running = Running(said, folder, "--json")
        try:
            missing = {1, 2}
            running.wait_for(lambda seen: not missing.difference_update(_there(seen)) and not missing)
            stack.enter_context(strangers(folder / "late", three))  # so that it refuses to be armed for a while
            running.wait_for(lambda seen: all(v["stage"] == "fly" for v in seen["vehicles"]))
            with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as twin:
                heartbeat = mav.MAVLink_heartbeat_message(2, 12, 0x81, 0, 4, 3).pack(mav.MAVLink(None, 1, 1))
                twin.sendto(bytes(heartbeat), ("127.0.0.1", shared))
                name = f"{twin.getsockname()[1]}"
            supervisor = running.named("gcs.session.process").pid
            os.kill(supervisor, signal.SIGSTOP)
            time.sleep(AWAY_S)  # this is how late its next tick is
            os.kill(supervisor, signal.SIGCONT)
            yield Flown(running.finish(), logs, name)
        finally:
            running.stop()


def _there(seen: dict[str, Any]) -> set[int]:
    return {event["sysid"] for event in seen["events"] if event["text"].endswith(" is there")}


def test_strangers_and_ours_follow_the_target_together_and_meet_the_goal(flown: Flown) -> None:
    summary = flown.outcome.summary
    assert (flown.outcome.status, summary["outcome"], summary["completed"]) == (0, "met", True)
    assert (summary["clock"], summary["speed"], summary["digest"]) == ("real", 1.0, None)
    assert summary["min_clearance_m"] > 0.0
    assert summary["min_separation_m"] > 0.6


def test_a_late_tick_is_caught_up_so_that_the_sessions_time_stays_the_walls(flown: Flown) -> None:
    summary = flown.outcome.summary
    assert summary["lag_s"] >= AWAY_S - 0.2
    assert summary["sim_time_s"] == pytest.approx(summary["wall_time_s"], abs=0.3)


def test_a_late_tick_takes_vehicles_to_be_where_they_are_and_carries_them_no_further(flown: Flown) -> None:
    """They have flown on while the supervisor was away: what it believes of their distance is what they reported."""
    (obstacle,) = yaml.safe_load((flown.outcome.folder / "scenario.yaml").read_text(encoding="utf-8"))["obstacles"]
    reported = min(
        math.dist(_place(m), obstacle["sphere_m"]) - obstacle["radius_m"]
        for _, m in flown.outcome.messages("GLOBAL_POSITION_INT")
    )
    assert flown.outcome.summary["min_clearance_m"] == pytest.approx(reported, abs=0.1)


def test_frames_of_their_own_are_brought_together_by_their_origins(flown: Flown) -> None:
    """Judged by GLOBAL_POSITION_INT, which the supervisor does not read: at the end all stand on the target's ring."""
    last: dict[int, Any] = {}
    for t_s, message in flown.outcome.messages("GLOBAL_POSITION_INT"):
        if t_s <= FLOWN_S:  # then the target stands, and the others are told to hold
            last[message.get_srcSystem()] = message
    assert set(last) == {1, 2, 3, 4, 101}
    place = {sysid: _place(m) for sysid, m in last.items()}
    for sysid in (1, 2, 3, 4):
        assert math.dist(place[sysid], place[101]) == pytest.approx(RING_M, abs=0.5), sysid


def test_energy_is_collected_of_everyone(flown: Flown) -> None:
    for sysid in (1, 2, 3, 4, 101):
        energy = flown.outcome.vehicle(sysid)["energy"]
        assert energy["drawn_j"] > 0.0, sysid
        assert energy["source"] != "none"


def test_refusals_missing_streams_and_an_impostor_are_told(flown: Flown) -> None:
    for wanted in (
        "Waiting for pursuer 3 at udpin:127.0.0.1:",
        "Arm: Need Position Estimate",
        "EXTENDED_SYS_STATE does not come",
        f"Another vehicle says that it is 1, from 127.0.0.1:{flown.twin}: ignored",
        "Ordered to hold",
    ):
        assert wanted in flown.said, wanted
    missing = {v["sysid"]: v["missing_streams"] for v in flown.outcome.summary["vehicles"]}
    assert "EXTENDED_SYS_STATE" in missing[3]
    assert missing[4] == missing[101] == []


def test_the_recording_holds_both_ways_with_the_sessions_time(flown: Flown) -> None:
    times: list[float] = []
    told: dict[int, int] = {}
    led: set[int] = set()
    for t_s, message in flown.outcome.messages():
        times.append(t_s)
        if message.get_type() == "LOCAL_POSITION_NED":
            told[message.get_srcSystem()] = told.get(message.get_srcSystem(), 0) + 1
        elif message.get_type() == "SET_POSITION_TARGET_LOCAL_NED":
            led.add(message.target_system)
    assert times == sorted(times)
    assert times[-1] >= FLOWN_S
    assert led == {1, 2, 3, 4, 101}
    assert all(told[sysid] >= 8 * 16 for sysid in (1, 2, 4, 101))
    assert flown.outcome.summary["link"]["lost"] == 0


def test_at_the_end_they_hold(flown: Flown) -> None:
    for log in flown.logs[:2]:
        lines = log.read_text(encoding="utf-8").splitlines()
        lines = [line for line in lines if "ground station lost" not in line]  # it is gone, and the machine may be slow
        assert lines[-1].endswith("info: Hold")
    for sysid in (1, 2, 3):
        assert flown.outcome.vehicle(sysid)["final_mode"] == "hold"


def test_ctrl_c_leaves_nobody_in_offboard_without_a_pilot(tmp_path: Path) -> None:
    port = free_port()
    block = {"connect": f"udpin:127.0.0.1:{port}", "sysid": 7, "capacity_j": 1e5, "at_end": "land"}
    said = scenario({"pursuers": [{"external": block, "waypoints_m": [[2, 0, -2.5]]}]}, goal={"duration_s": 60.0})
    with strangers(tmp_path, [*SIMVEHICLE, "--sysid", "7", "--connect", f"udpout:127.0.0.1:{port}"]) as (log,):
        running = Running(said, tmp_path, "--json")
        try:
            running.wait_for(lambda seen: seen["vehicles"][0]["stage"] == "fly")
            running.process.send_signal(signal.SIGINT)
            outcome = running.finish()
        finally:
            running.stop()
        assert (outcome.status, outcome.summary["outcome"]) == (130, "interrupted")
        assert log.read_text(encoding="utf-8").splitlines()[-1].endswith("info: Land")


def test_whom_a_killed_supervisor_leaves_in_the_air_is_named(tmp_path: Path) -> None:
    port = free_port()
    block = {"connect": f"udpin:127.0.0.1:{port}", "sysid": 7, "capacity_j": 1e5}
    said = scenario({"pursuers": [{"external": block, "waypoints_m": [[2, 0, -2.5]]}]}, goal={"duration_s": 60.0})
    with strangers(tmp_path, [*SIMVEHICLE, "--sysid", "7", "--connect", f"udpout:127.0.0.1:{port}"]):
        running = Running(said, tmp_path, "--json")
        try:
            running.wait_for(lambda seen: seen["vehicles"][0]["stage"] == "fly")
            running.named("gcs.session.process").kill()
            outcome = running.finish()
        finally:
            running.stop()
    assert outcome.status == 70
    assert f"gcs: pursuer 7 at udpin:127.0.0.1:{port} may still be flying without control" in outcome.stderr


def test_a_vehicle_that_never_comes_ends_the_session_with_a_sentence(tmp_path: Path) -> None:
    connect = f"udpin:127.0.0.1:{free_port()}"
    block = {"connect": connect, "sysid": 7, "capacity_j": 1e5, "found_within_s": 3.0}
    running = Running(scenario({"pursuers": [{"external": block}]}), tmp_path, "--web")
    try:
        link = urlsplit(next(line for line in running.lines() if line.startswith("page:")).split()[-1])
        tokens = [Subprotocol("skytender"), Subprotocol(link.fragment.replace("=", "."))]
        at, own = f"ws://{link.netloc}/stream", Origin(f"http://{link.netloc}")
        with websocket(at, origin=own, subprotocols=tokens, proxy=None) as page:
            assert any(f"Waiting for pursuer 7 at {connect}" in line for line in running.lines())
            texts = iter(lambda: page.recv(timeout=PATIENCE_S), None)
            end = next(told for told in map(json.loads, texts) if isinstance(told, dict) and told["type"] == "end")
        assert running.process.stderr is not None
        said: list[str] = []
        for line in running.process.stderr:
            said.append(line)
            if "Ctrl-C ends it" in line:
                break
        running.process.send_signal(signal.SIGINT)
        outcome = running.finish()
    finally:
        running.stop()
    assert outcome.status == 1
    why = f"no HEARTBEAT of pursuer 7 at {connect} within 3 s"
    assert end["text"].startswith(why)
    assert end == {"type": "end", "outcome": None, "text": end["text"], "exit": 1}
    assert f"gcs: {end['text']}\n" in said, "the page learns what the terminal says"
    assert said[-1] == "gcs: the page stays; Ctrl-C ends it\n", "no report is promised: there is none"
    assert not (outcome.folder / "summary.json").exists()


def test_a_port_that_another_program_has_is_bad_input(tmp_path: Path) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
        other.bind(("127.0.0.1", 0))
        connect = f"udpin:127.0.0.1:{other.getsockname()[1]}"
        outcome = fly(
            scenario({"pursuers": [{"external": {"connect": connect, "sysid": 7, "capacity_j": 1e5}}]}), tmp_path
        )
    assert outcome.status == 2
    assert f"gcs: {connect} cannot be listened at: Address already in use; another program" in outcome.stderr


def test_lockstep_is_refused_before_anything_is_made(tmp_path: Path) -> None:
    block = {"connect": "udpin:127.0.0.1:14550", "sysid": 7, "capacity_j": 1e5}
    outcome = fly(scenario({"pursuers": [{"external": block}]}), tmp_path, "--lockstep")
    assert outcome.status == 2
    assert "pursuer 7 (external) lives on its own clock" in outcome.stderr
    assert not outcome.folder.exists()


def test_a_session_at_three_times_real_time_flies_who_keeps_it_and_names_who_does_not(tmp_path: Path) -> None:
    ports = free_port(), free_port()
    rules = {"capacity_j": 1e5, "arm_within_s": 30}
    made = scenario(
        {"pursuers": [
            {"external": {"connect": f"udpin:127.0.0.1:{port}", "sysid": sysid, **rules},
             "waypoints_m": [[0, 5 * sysid, -3], [4, 5 * sysid, -3]]}
            for sysid, port in enumerate(ports, 3)
        ]},
        goal={"duration_s": 33.0, "lost_at_most": 2, "waypoints": "none"},
    )  # fmt: skip
    commands = [
        [*ARDUCOPTER, "--sysid", str(sysid), "--connect", f"udpout:127.0.0.1:{port}", "--speedup", str(speed),
         "--origin", home(0.0, 5.0 * sysid, 0.0)]
        for sysid, port, speed in zip((3, 4), ports, (3, 1), strict=True)
    ]  # fmt: skip
    with strangers(tmp_path / "said", *commands):
        outcome = fly(made, tmp_path, "--speed", "3")
    summary = outcome.summary
    assert summary["speed"] == 3.0
    assert summary["speed_achieved"] == pytest.approx(3.0, rel=0.05)
    pace = {sysid: next(i for i in outcome.vehicle(sysid)["check_list"] if i["key"] == "pace") for sysid in (3, 4)}
    assert pace[3]["passed"]
    assert not pace[4]["passed"]
    assert pace[4]["text"].startswith("runs 1.0 times as fast as real time, the session 3 times: set its simulator's")
    assert "Fails its check list and is not armed: runs 1.0 times" in (outcome.folder / "session.log").read_text()
    reached = {3: math.inf, 4: math.inf}
    for _, m in outcome.messages("LOCAL_POSITION_NED"):
        sysid = m.get_srcSystem()
        reached[sysid] = min(reached[sysid], math.dist((m.x, m.y, m.z), (4.0, 0.0, -3.0)))
    assert reached[3] < 0.6
    assert reached[4] > 4.0
    boots = [m.time_boot_ms for _, m in outcome.messages("ATTITUDE") if m.get_srcSystem() == 3]
    assert (boots[-1] - boots[0]) / 1e3 == pytest.approx(summary["sim_time_s"], abs=2.0)
