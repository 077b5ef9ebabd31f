"""Plan B of vehicles whose autopilots are not ours: set, read back, put back; and flown when gcs is killed."""

from __future__ import annotations

import contextlib
import itertools
import os
import signal
import time
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import psutil
import pytest
from listener import Listener
from ports import free_port
from sessions import Outcome, Running, fly, read_truth
from strangers import ARDUCOPTER, SIMVEHICLE, strangers
from ways import between, nearest_m, of_truths

HOME = "47.397742,8.545594,488"
SEPARATION_M = 0.8
OLD, NEW, PX4 = 1, 2, 3
"""ArduCopter before 4.7, since 4.7, and a vehicle that speaks as a PX4."""
OWN = {
    OLD: {"RTL_ALT": 1500.0, "RTL_CONE_SLOPE": 3.0, "RTL_LOIT_TIME": 5000.0, "FS_GCS_ENABLE": 0.0, "GUID_TIMEOUT": 3.0},
    NEW: {"RTL_ALT_M": 15.0, "RTL_CONE_SLOPE": 3.0, "RTL_LOIT_TIME": 5000.0, "FS_GCS_TIMEOUT": 5.0},
    PX4: {"RTL_RETURN_ALT": 5.0, "RTL_LAND_DELAY": 0.0, "COM_DL_LOSS_T": 5.0, "COM_OF_LOSS_T": 1.0},
}
"""What each has before the session."""


def scenario(blocks: list[dict[str, Any]], port: int, duration_s: float, **changed: Any) -> dict[str, Any]:
    lat, lon, alt = map(float, HOME.split(","))
    external = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": 200_000}
    pursuers = [{"takeoff_m": 3.0, "external": {"sysid": i, **external}, **one} for i, one in enumerate(blocks, 1)]
    return {
        "schema": 1, "name": "home", "axes": "ned", "origin": {"lat_deg": lat, "lon_deg": lon, "alt_m": alt},
        "goal": {"duration_s": duration_s}, "vehicles": {"pursuers": pursuers},
        "planner": {"separation_m": SEPARATION_M, "cruise_m_s": 3.0},
    } | changed  # fmt: skip


def copter(sysid: int, port: int, east_m: float, *more: str) -> list[str]:
    place = ["--origin", HOME, "--start", f"0,{east_m:g},0"]
    return [*ARDUCOPTER, "--sysid", str(sysid), "--connect", f"udpout:127.0.0.1:{port}", *place, *more]


def three(port: int, *more: str) -> list[list[str]]:
    """Commands of one vehicle of each generation, 4 m apart; `more` options of the first."""
    px4 = [*SIMVEHICLE, "--sysid", str(PX4), "--connect", f"udpout:127.0.0.1:{port}", "--home", HOME]
    return [copter(OLD, port, 0.0, *more), copter(NEW, port, 4.0, "--si-names"), [*px4, "--position", "0,8,0"]]


BLOCKS = [{"waypoints_m": [[4.0, 4.0 * i, -3.0]]} for i in range(3)]


def checked(outcome: Outcome) -> dict[int, dict[str, Any]]:
    """Entry of each vehicle's check list about its return, by system id."""
    return {
        v["sysid"]: item for v in outcome.summary["vehicles"] for item in v["check_list"] if item["key"] == "return"
    }


def last_values(outcome: Outcome, sysid: int) -> list[dict[str, float]]:
    """Values of its parameters when it is armed for the first time, and at the end, by its own PARAM_VALUEs."""
    now: dict[str, float] = {}
    armed: dict[str, float] | None = None
    for _, m in outcome.messages("PARAM_VALUE", "HEARTBEAT"):
        if m.get_srcSystem() != sysid:
            continue
        if m.get_type() == "PARAM_VALUE":
            now[m.param_id] = m.param_value
        elif armed is None and m.base_mode & 128:
            armed = dict(now)
    return [armed or {}, now]


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> tuple[Outcome, dict[int, dict[str, float]]]:
    """A session that ends as it should, and what the vehicles say afterwards."""
    folder, port = tmp_path_factory.mktemp("three"), free_port()
    with strangers(folder / "said", *three(port)):
        outcome = fly(scenario(BLOCKS, port, 14.0), folder)
        with Listener(port) as ear:
            return outcome, {i: {name: ear.parameter(i, name) for name in own} for i, own in OWN.items()}


def test_each_generation_has_a_height_of_its_own_that_reads_back(flown: tuple[Outcome, Any]) -> None:
    outcome = flown[0]
    assert outcome.status == 0, outcome.stdout + outcome.stderr
    for sysid, item in checked(outcome).items():
        assert item["passed"]
        assert "set and read back" in item["text"], sysid
    at_arming = {sysid: last_values(outcome, sysid)[0] for sysid in OWN}
    heights_m = [at_arming[OLD]["RTL_ALT"] / 100.0, at_arming[NEW]["RTL_ALT_M"], at_arming[PX4]["RTL_RETURN_ALT"]]
    assert min(heights_m) >= 3.0 + 1.0
    assert all(abs(a - b) >= SEPARATION_M + 0.2 for a, b in itertools.combinations(heights_m, 2))
    for sysid in (OLD, NEW):
        values = at_arming[sysid]
        assert (values["FS_GCS_ENABLE"], values["RTL_CONE_SLOPE"], values["GUID_TIMEOUT"]) == (1.0, 0.0, 0.5)
    begins_s = [at_arming[OLD]["FS_GCS_TIMEOUT"], at_arming[NEW]["FS_GCS_TIMEOUT"], at_arming[PX4]["COM_DL_LOSS_T"]]
    waits_s = [
        0.001 * at_arming[OLD]["RTL_LOIT_TIME"],
        0.001 * at_arming[NEW]["RTL_LOIT_TIME"],
        at_arming[PX4]["RTL_LAND_DELAY"],
    ]
    assert sorted(heights_m, reverse=True) == [height for _, height in sorted(zip(begins_s, heights_m, strict=True))]
    assert len({a + b for a, b in zip(begins_s, waits_s, strict=True)}) == 1  # they come down together
    assert at_arming[PX4]["COM_OF_LOSS_T"] == 0.5


def test_after_the_session_each_has_what_it_had(flown: tuple[Outcome, dict[int, dict[str, float]]]) -> None:
    outcome, after = flown
    assert after == OWN
    said = (outcome.folder / "session.log").read_text(encoding="utf-8")
    assert said.count("Has its own return parameters again") == 3


def test_what_they_had_stands_in_the_folder(flown: tuple[Outcome, Any]) -> None:
    text = (flown[0].folder / "parameters-before.param").read_text(encoding="utf-8")
    rows = {(int(a), name): float(number) for a, _, name, number, _ in map(str.split, text.splitlines()[1:])}
    for sysid, own in OWN.items():
        assert {name: rows[sysid, name] for name in own} == own


def test_ctrl_c_puts_them_back_and_a_refusal_keeps_its_vehicle_on_the_ground(tmp_path: Path) -> None:
    port = free_port()
    with strangers(tmp_path / "said", *three(port, "--locked", "RTL_ALT")):
        running = Running(scenario(BLOCKS, port, 60.0), tmp_path, "--json")
        try:
            running.wait_for(lambda seen: sum(v["armed"] for v in seen["vehicles"]) == 2)
            running.process.send_signal(signal.SIGINT)
            outcome = running.finish()
        finally:
            running.stop()
        with Listener(port) as ear:
            assert {i: {name: ear.parameter(i, name) for name in own} for i, own in OWN.items()} == OWN
    items = checked(outcome)
    assert [items[i]["passed"] for i in (OLD, NEW, PX4)] == [False, True, True]
    assert items[OLD]["text"] == "return parameter RTL_ALT refused: it keeps 1500"
    said = (outcome.folder / "session.log").read_text(encoding="utf-8")
    assert "Fails its check list and is not armed: return parameter RTL_ALT refused" in said


class Killed(NamedTuple):
    """A fleet after `kill -9` of gcs: places (vehicles, times, 3) from the first time that all have on, their times,
    when it was killed on the same clock, and the places where they started."""

    ways: np.ndarray
    times: np.ndarray
    killed_s: float
    starts: np.ndarray


COUNT = 5
FIVE = [{"waypoints_m": [[12.0, 14.0 - 2.0 * i, -3.0]]} for i in range(COUNT)]
"""They start in a row, 2 m apart, and change places twelve metres away: the ways home cross."""


def kill_in_flight(running: Running, within_m: float = 0.8) -> None:
    """Kill gcs with all its processes when every vehicle has come to its place. Until then one may hang over another,
    which would climb through it: docs/limits.md."""
    ends = np.array([one["waypoints_m"][0] for one in FIVE])

    def there(seen: dict[str, Any]) -> bool:
        places = [one["p_ned"] for one in seen["vehicles"]]
        return None not in places and float(np.linalg.norm(np.array(places) - ends, axis=1).max()) < within_m

    try:
        running.wait_for(there)
        for process in running.family():
            with contextlib.suppress(psutil.NoSuchProcess):
                process.kill()
    finally:
        running.stop()


def kill_copters(folder: Path) -> Killed:
    """ArduCopters, every other one of today's, at three times real time."""
    port, speed = free_port(), 3.0
    ways = [folder / f"{i}.way" for i in range(1, COUNT + 1)]
    commands = [
        copter(i, port, 2.0 * (i - 1), "--speedup", f"{speed:g}", "--way", str(ways[i - 1]), *["--si-names"] * (i % 2))
        for i in range(1, COUNT + 1)
    ]
    made = scenario(FIVE, port, 200.0, clock={"mode": "real", "speed": speed})
    with strangers(folder / "said", *commands):
        kill_in_flight(Running(made, folder, "--json"))
        killed_s = time.monotonic()
        with Listener(port) as ear:
            ear.until_disarmed(range(1, COUNT + 1), 200.0)
        read = [np.loadtxt(way.read_text(encoding="utf-8").splitlines()[:-1]) for way in ways]
    times, places = between([(one[:, 0], one[:, 1:]) for one in read])
    return Killed(places, times, killed_s, np.array([[0.0, 2.0 * i, 0.0] for i in range(COUNT)]))


def kill_px4s(folder: Path) -> Killed:
    port = free_port()
    truths = [folder / f"{i}.truth" for i in range(1, COUNT + 1)]
    command = [
        *SIMVEHICLE,
        "--sysid",
        "1",
        "--count",
        str(COUNT),
        "--home",
        HOME,
        "--connect",
        f"udpout:127.0.0.1:{port}",
    ]
    for i, truth in enumerate(truths):
        command += ["--position", f"0,{2 * i},0", "--truth", str(truth)]
    with strangers(folder / "said", command):
        kill_in_flight(Running(scenario(FIVE, port, 200.0), folder, "--json"))
        killed_s = float(read_truth(truths[0]).time_s[-1])
        with Listener(port) as ear:
            ear.until_disarmed(range(1, COUNT + 1), 300.0)
        read = [read_truth(truth) for truth in truths]
    times, places = of_truths(read)
    return Killed(places, times, killed_s, np.array([[0.0, 2.0 * i, 0.0] for i in range(COUNT)]))


FLEETS = {"ArduCopters": kill_copters, "PX4s": kill_px4s}


@pytest.fixture(scope="module")
def killed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Future[Killed]]:
    """Both at once: what they take is real time, and little else."""
    with ThreadPoolExecutor(len(FLEETS)) as pool:
        return {name: pool.submit(one, tmp_path_factory.mktemp("killed")) for name, one in FLEETS.items()}


@pytest.mark.slow
@pytest.mark.parametrize("kind", FLEETS)
def test_when_gcs_is_killed_five_come_home_one_by_one_and_land_apart(
    killed: dict[str, Future[Killed]], kind: str
) -> None:
    """By their true places none comes nearer to another than separation_m, from the kill to the ground."""
    ways, times, killed_s, starts = killed[kind].result()
    after = ways[:, times >= killed_s]
    assert nearest_m(after) > SEPARATION_M
    assert np.linalg.norm(after[:, -1, :2] - starts[:, :2], axis=1).max() < 0.5
    assert after[:, -1, 2].min() > -0.2
    tops_m = np.sort(-after[:, :, 2].min(axis=1))
    assert np.diff(tops_m).min() > SEPARATION_M


STOPPED_S = (1.0, 3.0, 10.0)


@pytest.mark.timeout(600)
def test_a_station_that_stops_for_a_while_brings_no_two_together(tmp_path: Path) -> None:
    """Four fly to and fro through each other; gcs is stopped for 1, 3 and 10 s in flight."""
    port = free_port()
    across = [[7.0, 0.0], [0.0, 7.0], [-7.0, 0.0], [0.0, -7.0]]
    blocks = [{"waypoints_m": [[n * sign, e * sign, -3.0] for _ in range(60) for sign in (-1, 1)]} for n, e in across]
    truths = [tmp_path / f"{i}.truth" for i in range(1, 5)]
    command = [*SIMVEHICLE, "--sysid", "1", "--count", "4", "--home", HOME, "--connect", f"udpout:127.0.0.1:{port}"]
    for (n, e), truth in zip(across, truths, strict=True):
        command += ["--position", f"{n:g},{e:g},0", "--truth", str(truth)]
    crossing = scenario(blocks, port, 500.0)
    for pursuer in crossing["vehicles"]["pursuers"]:
        pursuer["external"]["rejoins"] = True  # on a busy machine the station is away for longer, and they return
    running = Running(crossing, tmp_path, "--json")
    with strangers(tmp_path / "said", command):
        try:
            for stopped_s in STOPPED_S:
                on_the_way = running.wait_for(
                    lambda seen: sum(v["stage"] == "fly" and v["speed_m_s"] > 1.5 for v in seen["vehicles"]) >= 3
                )
                supervisor = running.named("gcs.session.process").pid
                os.kill(supervisor, signal.SIGSTOP)
                time.sleep(stopped_s)  # this is how long nothing is sent
                os.kill(supervisor, signal.SIGCONT)
                until_s = on_the_way["t_s"] + stopped_s + 6.0
                running.wait_for(lambda seen, until_s=until_s: seen["t_s"] >= until_s)  # type: ignore[misc]
            running.process.send_signal(signal.SIGINT)
            running.finish()
        finally:
            running.stop()
    read = [read_truth(truth) for truth in truths]
    _, ways = of_truths(read)
    up = ways[:, (ways[:, :, 2] < -1.0).all(axis=0)]
    assert nearest_m(up) > SEPARATION_M
