"""Many vehicles in one process: the same flight, the same wire, and a death that names them all."""

from __future__ import annotations

import json
import select
import signal
import socket
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from pymavlink.dialects.v20 import common
from sessions import Outcome, Running, all_gone, fly, merged, small

SIMVEHICLE = [sys.executable, "-c", "from simvehicle.cli import main; main()"]


def six(**changes: Any) -> dict[str, Any]:
    """Six vehicles with ids 101 to 106: four pursuers round a target, and a tanker with work to do."""
    places = [(2.0, 0.0), (0.0, 2.0), (-2.0, 0.0), (0.0, -2.0)]
    percents = [40, 70, 80, 90]
    content = small(goal={"duration_s": 18.0, "refuelled_at_least": 0})
    content["vehicles"]["targets"][0]["sysid"] = 105
    content["vehicles"]["tankers"][0] |= {"sysid": 106, "start_m": [-5.0, 0.0, 0.0]}
    content["vehicles"]["pursuers"] = [
        {"sysid": 101 + i, "start_m": [n, e, 0.0], "battery": {"capacity_j": 24000, "initial_percent": percents[i]}}
        for i, (n, e) in enumerate(places)
    ]
    return merged(content, changes)


def shared(folder: Path, by: int) -> Outcome:
    return fly(six(), folder / str(by), "--plain", "--vehicles-per-process", str(by))


@pytest.fixture(scope="module")
def each_alone(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """The six, each in a process of its own."""
    return shared(tmp_path_factory.mktemp("blocks"), 1)


@pytest.mark.slow
def test_digest_and_truth_do_not_depend_on_how_vehicles_share_processes(each_alone: Outcome, tmp_path: Path) -> None:
    flown = [each_alone, shared(tmp_path, 3), shared(tmp_path, 6)]
    assert len({outcome.summary["digest"] for outcome in flown}) == 1
    assert len({(outcome.folder / "session.tlog").read_bytes() for outcome in flown}) == 1
    assert flown[0].summary["refuelling"]
    for sysid in range(101, 107):
        assert len({(o.folder / "vehicles" / f"{sysid}.truth").read_bytes() for o in flown}) == 1
    assert len(list((flown[2].folder / "vehicles").glob("*.log"))) == 1


def test_a_blocks_death_names_all_its_vehicles_and_the_others_fly_on(tmp_path: Path) -> None:
    slow = six(clock={"mode": "real", "speed": 2.0}, goal={"duration_s": 120.0}, vehicles_per_process=3)
    session = Running(slow, tmp_path, "--json")
    try:
        session.wait_for(lambda s: s["t_s"] > 2.0)
        session.vehicle(101).send_signal(signal.SIGKILL)
        told = session.wait_for(lambda s: sum(not v["alive"] for v in s["vehicles"]) == 3)
        assert [v["sysid"] for v in told["vehicles"] if not v["alive"]] == [101, 102, 103]
        later = session.wait_for(lambda s: s["t_s"] > told["t_s"] + 1.0)
        assert [v["sysid"] for v in later["vehicles"] if v["alive"]] == [104, 105, 106]
        session.process.send_signal(signal.SIGINT)
        family = session.family()
        outcome = session.finish()
        lines = [json.loads(line) for line in outcome.stdout.splitlines()]
        texts = [e["text"] for line in lines if line["type"] == "snapshot" for e in line["events"]]
        assert not all_gone(family)
        assert [v["final_mode"] for v in outcome.summary["vehicles"]].count("dead") == 3
        assert all("pursuer 101, pursuer 102, pursuer 103" in t for t in texts if "signal 9" in t)
    finally:
        session.stop()


def test_a_machine_that_cannot_keep_up_slows_the_clock_for_all_and_says_by_how_much(
    each_alone: Outcome, tmp_path: Path
) -> None:
    hurried = fly(six(clock={"mode": "real", "speed": 1000.0}), tmp_path, "--plain")
    summary = hurried.summary
    assert summary["digest"] == each_alone.summary["digest"]
    assert summary["speed_achieved"] < 1000.0
    assert summary["lag_s"] == pytest.approx(summary["wall_time_s"] - 18.0 / 1000.0, abs=0.2)
    ends = {float(hurried.truth(sysid).time_s[-1]) for sysid in range(101, 107)}
    assert ends == {18.0}


def test_on_the_wire_a_block_is_as_many_vehicles_each_on_a_socket_of_its_own() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground:
        ground.bind(("127.0.0.1", 0))
        address = f"udpout:127.0.0.1:{ground.getsockname()[1]}"
        places = [word for n in range(3) for word in ("--position", f"{n},0,0")]
        command = [*SIMVEHICLE, "--sysid", "7", "--count", "3", "--connect", address, *places]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL)
        try:
            readers: dict[Any, Any] = {}
            senders: dict[Any, set[int]] = {}
            numbers: dict[Any, list[int]] = {}
            north: dict[int, float] = {}
            while len(north) < 3 or min(map(len, numbers.values())) < 40:
                assert select.select([ground], [], [], 30.0)[0]
                datagram, peer = ground.recvfrom(65535)
                (message,) = readers.setdefault(peer, common.MAVLink(None)).parse_buffer(datagram)
                senders.setdefault(peer, set()).add(message.get_srcSystem())
                numbers.setdefault(peer, []).append(message.get_seq())
                if message.get_type() == "LOCAL_POSITION_NED":
                    north[message.get_srcSystem()] = message.x
        finally:
            process.kill()
            process.wait()
    assert sorted(map(tuple, senders.values())) == [(7,), (8,), (9,)]
    assert north == {7: 0.0, 8: 1.0, 9: 2.0}
    for own in numbers.values():
        assert own == [number % 256 for number in range(len(own))]
