"""External vehicles under the safety filter, in real time, judged by the truth that they wrote themselves."""

from __future__ import annotations

import select
import socket
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from sessions import Outcome, fly_apart, read_truth
from strangers import SIMVEHICLE, strangers
from ways import between, nearest_m, of_truths

HOME = "47.397742,8.545594,488"
ACROSS_M = 7.0
OFF_M = 1.0
OFFSETS = [(-OFF_M, 0.0), (0.0, -OFF_M), (OFF_M, 0.0), (0.0, OFF_M)]
COLUMNS = [(9.0, 4.0), (12.0, -4.5), (16.0, 0.5)]
SET_POINT = "SET_POSITION_TARGET_LOCAL_NED"


def scenario(pursuers: list[dict[str, Any]], duration_s: float, **changed: Any) -> dict[str, Any]:
    lat, lon, alt = map(float, HOME.split(","))
    return {
        "schema": 1, "name": "outside", "axes": "ned", "origin": {"lat_deg": lat, "lon_deg": lon, "alt_m": alt},
        "goal": {"duration_s": duration_s}, "vehicles": {"pursuers": pursuers},
    } | changed  # fmt: skip


def fleet(folder: Path, starts: list[list[float]], port: int) -> tuple[list[str], list[Path]]:
    """The command of vehicles 1, 2, … on the ground in one frame, and the files of their truth."""
    truths = [folder / f"{i + 1}.truth" for i in range(len(starts))]
    places = [word for n, e, d in starts for word in ("--position", f"{n:g},{e:g},{d:g}")]
    files = [word for truth in truths for word in ("--truth", str(truth))]
    command = [*SIMVEHICLE, "--sysid", "1", "--count", str(len(starts)), "--home", HOME]
    return [*command, "--connect", f"udpout:127.0.0.1:{port}", *places, *files], truths


def crossing() -> tuple[list[list[float]], list[dict[str, Any]], list[list[float]]]:
    """Starts, blocks and ends of four vehicles that change places across a circle."""
    out = [[ACROSS_M, 0.0], [0.0, ACROSS_M], [-ACROSS_M, 0.0], [0.0, -ACROSS_M]]
    ends = [[-n, -e, -3.0] for n, e in out]
    blocks = [{"takeoff_m": 3.0, "waypoints_m": [end]} for end in ends]
    return [[n, e, 0.0] for n, e in out], blocks, ends


class Flown(NamedTuple):
    """A flight that has ended, and the truth that its external vehicles wrote."""

    outcome: Outcome
    truths: list[Path]


def fly_across(folder: Path) -> Flown:
    port = free_port()
    starts, blocks, _ = crossing()
    for i, block in enumerate(blocks):
        block["external"] = {"sysid": i + 1, "connect": f"udpin:127.0.0.1:{port}", "capacity_j": 200_000}
    command, truths = fleet(folder, starts, port)
    planner = {"cruise_m_s": 4.0, "separation_m": 2.0}
    with strangers(folder / "logs", command):
        return Flown(fly_apart(scenario(blocks, 24.0, planner=planner), folder), truths)


def fly_on_a_ring(folder: Path) -> Flown:
    port = free_port()
    starts = [[5.0, 0.0, 0.0], [-2.5, 4.3, 0.0], [-2.5, -4.3, 0.0]]
    blocks = [
        {"takeoff_m": 3.0, "external": {"sysid": i + 1, "connect": f"udpin:127.0.0.1:{port}", "capacity_j": 200_000}}
        for i in range(3)
    ]
    content = scenario(
        blocks, 28.0, planner={"cruise_m_s": 2.0, "separation_m": 2.0}, formation={"ring_m": 5.0},
        obstacles=[{"cylinder_m": list(at), "radius_m": 0.5, "bottom_m": 0.0, "top_m": -6.0} for at in COLUMNS],
    )  # fmt: skip
    content["vehicles"]["targets"] = [
        {"sysid": 101, "start_m": [0, 0, 0], "takeoff_m": 3.0, "speed_m_s": 1.0, "path_m": [[0, 0, -3], [18, -2, -3]],
         "battery": {"capacity_j": 150_000}},
    ]  # fmt: skip
    command, truths = fleet(folder, starts, port)
    with strangers(folder / "logs", command):
        return Flown(fly_apart(content, folder), truths)


def shift(data: bytes, off_ned: tuple[float, float]) -> bytes:
    """The frames of a datagram, with set points moved."""
    parser = mav.MAVLink(None, 255, 190)
    parser.robust_parsing = True
    out = b""
    for message in parser.parse_buffer(data) or []:
        if message.get_type() == SET_POINT:
            message.x, message.y = message.x + off_ned[0], message.y + off_ned[1]
            sender = mav.MAVLink(None, message.get_srcSystem(), message.get_srcComponent())
            sender.seq = message.get_seq()
            out += message.pack(sender)
        else:
            out += bytes(message.get_msgbuf())
    return out


@contextmanager
def off_by(offsets: list[tuple[float, float]], gcs_ports: list[int]) -> Iterator[list[int]]:
    """Ports for vehicles whose set points are moved on the way from the ground station's ports."""
    vehicle_side = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in offsets]
    gcs_side = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in offsets]
    stopped = threading.Event()
    for one in vehicle_side:
        one.bind(("127.0.0.1", 0))

    def relay() -> None:
        peers: dict[int, Any] = {}
        while not stopped.is_set():
            for one in select.select([*vehicle_side, *gcs_side], [], [], 0.1)[0]:
                data, address = one.recvfrom(2048)
                if one in vehicle_side:
                    i = vehicle_side.index(one)
                    peers[i] = address
                    gcs_side[i].sendto(data, ("127.0.0.1", gcs_ports[i]))
                elif (i := gcs_side.index(one)) in peers:
                    vehicle_side[i].sendto(shift(data, offsets[i]), peers[i])

    thread = threading.Thread(target=relay)
    thread.start()
    with ExitStack() as stack:
        for one in (*vehicle_side, *gcs_side):
            stack.enter_context(one)
        try:
            yield [one.getsockname()[1] for one in vehicle_side]
        finally:
            stopped.set()
            thread.join()


def fly_off(folder: Path) -> Flown:
    """Each is off towards the circle's middle, where all of them cross."""
    starts, blocks, _ = crossing()
    ports = [free_port() for _ in starts]
    for i, block in enumerate(blocks):
        block["external"] = {"sysid": i + 1, "connect": f"udpin:127.0.0.1:{ports[i]}", "capacity_j": 200_000}
    with ExitStack() as stack:
        listens = stack.enter_context(off_by(OFFSETS, ports))
        truths = [folder / f"{i + 1}.truth" for i in range(len(starts))]
        commands = [
            [*SIMVEHICLE, "--sysid", str(i + 1), "--home", HOME, "--connect", f"udpout:127.0.0.1:{listens[i]}",
             "--position", ",".join(f"{x:g}" for x in start), "--truth", str(truths[i])]
            for i, start in enumerate(starts)
        ]  # fmt: skip
        stack.enter_context(strangers(folder / "logs", *commands))
        content = scenario(blocks, 26.0, planner={"cruise_m_s": 2.0, "separation_m": 1.0})
        return Flown(fly_apart(content, folder), truths)


FLIGHTS: dict[str, Callable[[Path], Flown]] = {
    "across": fly_across,
    "on a ring": fly_on_a_ring,
    "off": fly_off,
}


@pytest.fixture(scope="module")
def flights(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Future[Flown]]:
    """All at once: what they take is real time, and little else."""
    with ThreadPoolExecutor(len(FLIGHTS)) as pool:
        return {name: pool.submit(one, tmp_path_factory.mktemp("flight")) for name, one in FLIGHTS.items()}


@pytest.mark.slow
def test_external_vehicles_that_cross_keep_two_metres_apart_and_arrive(flights: dict[str, Future[Flown]]) -> None:
    outcome, truths = flights["across"].result()
    assert outcome.status == 0, outcome.stdout + outcome.stderr
    ways = of_truths([read_truth(truth) for truth in truths])[1]
    assert nearest_m(ways) > 2.0
    assert np.linalg.norm(ways[:, -1] - crossing()[2], axis=1).max() < 0.5
    assert outcome.summary["outcome"] == "met"


@pytest.mark.slow
def test_on_a_ring_among_obstacles_external_vehicles_have_clearance_to_spare(flights: dict[str, Future[Flown]]) -> None:
    ways = of_truths([read_truth(truth) for truth in flights["on a ring"].result().truths])[1]
    assert nearest_m(ways) > 2.0
    clear_m = min(float(np.linalg.norm(ways[:, :, :2] - at, axis=2).min()) - 0.5 for at in COLUMNS)
    assert clear_m > 0.3
    assert ways[:, -1, 0].min() > 5.0  # they followed their target past the obstacles


@pytest.mark.slow
def test_autopilots_that_fly_a_metre_off_their_set_points_keep_apart(flights: dict[str, Future[Flown]]) -> None:
    outcome = flights["off"].result().outcome
    told: dict[int, list[Any]] = {i: [] for i in range(1, 5)}
    for t_s, m in outcome.messages("LOCAL_POSITION_NED"):
        if t_s >= 1.0:
            told[m.get_srcSystem()].append((t_s, m.x, m.y, m.z))
    _, at = between([(rows[:, 0], rows[:, 1:]) for rows in map(np.array, told.values())])
    assert nearest_m(at) > 1.0
    planned = {m.target_system: m for _, m in outcome.messages(SET_POINT)}
    for i, off in enumerate(OFFSETS):
        m = planned[i + 1]
        assert np.linalg.norm(at[i, -1, :2] - (m.x, m.y)) == pytest.approx(OFF_M, abs=0.2), off
