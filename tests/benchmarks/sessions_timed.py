"""Figures 3, 4 and 5: whole sessions, the start of many vehicles, and the full fleet in real time."""

from __future__ import annotations

import json
import os
import select
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import laws
import yaml
from measure import ROOT, Figure, Scale, children_cpu_s
from pymavlink.dialects.v20 import common

from gcs.mavlink import codec
from gcs.processes.fork_server import ForkServer, ProcessSpec

SESSIONS = 5
FLEET_S = 60.0
STARTED = 50
KIB = 1024.0


def example_1(vehicles: int, duration_s: float, per_process: int) -> dict[str, Any]:
    """The paper's Example 1 with its obstacles and way points, for this many vehicles and this long."""
    content: dict[str, Any] = yaml.safe_load((ROOT / "configs/paper/example1.yaml").read_text(encoding="utf-8"))
    content["goal"]["duration_s"] = duration_s
    content["vehicles_per_process"] = per_process
    content["vehicles"]["defaults"]["battery"]["capacity_j"] *= 10.0  # so that everyone flies to the end
    own = content["vehicles"]["pursuers"]
    content["vehicles"]["pursuers"] = [own[i % len(own)] | {"sysid": i + 1} for i in range(vehicles)]
    return content


def weathered(content: dict[str, Any]) -> dict[str, Any]:
    """The same with every vehicle on rotors, in 8 m/s of wind with light turbulence, with sensors that err."""
    content["vehicles"]["defaults"] |= {"plant": "rotors", "sensors": {}}
    content["wind"] = {"speed_m_s": 8.0, "from_deg": 250.0, "turbulence_m_s": 7.7}
    return content


def fleet(duration_s: float) -> dict[str, Any]:
    """`gcs run fleet` for this long, whatever comes of it."""
    content: dict[str, Any] = yaml.safe_load((ROOT / "configs/fleet.yaml").read_text(encoding="utf-8"))
    content["goal"] = {"duration_s": duration_s}
    longer = max(4.0, duration_s / 60.0)  # everyone flies to the end
    for vehicles in (content["vehicles"]["defaults"], *content["vehicles"]["tankers"]):
        vehicles["battery"]["capacity_j"] *= longer
    return content


def fly(content: dict[str, Any], folder: Path) -> tuple[float, float]:
    """Fly a session in lockstep into folder/session: times real time, and CPU seconds of all its processes."""
    path, out = folder / "scenario.yaml", folder / "session"
    path.write_text(yaml.safe_dump(content), encoding="utf-8")
    before_s = children_cpu_s()
    run_gcs("run", str(path), "--lockstep", "--plain", "--out", str(out))
    summary = json.loads((out / "summary.json").read_text(encoding="utf-8"))
    return summary["speed_achieved"], children_cpu_s() - before_s


def run_gcs(*arguments: str) -> None:
    """`gcs` with these arguments. Raises RuntimeError with what it said unless it ends well."""
    command = [sys.executable, "-m", "gcs", *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        said = "\n".join((done.stderr or done.stdout).splitlines()[-12:])
        raise RuntimeError(f"gcs {arguments[0]} ended with {done.returncode}: {said}")


def lockstep() -> list[Figure]:
    rows = [
        ("5 processes", 5, 200.0, 1, 0.20),
        ("50 processes", 50, 40.0, 1, 0.18),
        ("2 processes of 25", 50, 40.0, 25, 0.35),
    ]
    flown: dict[str, list[tuple[float, float]]] = {name: [] for name, *_ in rows}
    in_weather: list[tuple[float, float]] = []
    for _ in range(SESSIONS):
        for name, vehicles, duration_s, per_process, _ in rows:
            with tempfile.TemporaryDirectory() as folder:
                flown[name].append(fly(example_1(vehicles, duration_s, per_process), Path(folder)))
        with tempfile.TemporaryDirectory() as folder:
            in_weather.append(fly(weathered(example_1(5, 200.0, 1)), Path(folder)))
    cores = len(os.sched_getaffinity(0))
    law_alone = laws.vehicle_seconds() * cores
    weathered_speed, weathered_cpu_s = (statistics.median(column) for column in zip(*in_weather, strict=True))
    return [
        Figure(
            3, f"Example 1 in lockstep, {name}", statistics.median(speed for speed, _ in flown[name]), "x real time",
            goal, goal_is_ratio=True, peer=f"the law alone on {cores} cores", peer_value=law_alone / vehicles,
            cpu_s=statistics.median(cpu_s for _, cpu_s in flown[name]),
        )
        for name, vehicles, _, _, goal in rows
    ] + [
        Figure(
            3, "  5 processes on rotors, in gusts and with sensors", weathered_speed, "x real time", 0.5,
            goal_is_ratio=True, peer="the same on the paper's plant",
            peer_value=statistics.median(speed for speed, _ in flown["5 processes"]), cpu_s=weathered_cpu_s,
        )
    ]  # fmt: skip


def starting(scale: Scale) -> list[Figure]:
    """From the fork server's start until every vehicle's SYS_STATUS says that it may be armed."""
    with tempfile.TemporaryDirectory() as name, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as ground:
        ground.bind(("127.0.0.1", 0))
        ground.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4 << 20)
        ground.setblocking(False)
        address = f"udpout:127.0.0.1:{ground.getsockname()[1]}"
        begun_s, before = time.perf_counter(), children_cpu_s()
        with ForkServer.of_vehicles() as server:
            server.start(
                [
                    ProcessSpec((i,), ("--sysid", str(i), "--connect", address), Path(name) / f"{i}.log").order()
                    for i in range(1, STARTED + 1)
                ]
            )
            ready: set[int] = set()
            while len(ready) < STARTED and time.perf_counter() - begun_s < 60.0:
                select.select([ground], [], [], 0.5)
                ready |= _ready_to_arm(ground)
            took_s = time.perf_counter() - begun_s
            server.events()
            alone_mib = _pss_of_one(address, ground)
            pss_mib = statistics.mean(_pss_kib(pid) for pid in server.pids) / KIB
        cpu_s = children_cpu_s() - before
    if len(ready) < STARTED:
        raise RuntimeError(f"only {len(ready)} of {STARTED} vehicles came up")
    return [
        Figure(4, f"start of {STARTED} processes, all ready to arm", took_s, "s", 5.0 / scale.wall, True, cpu_s=cpu_s),
        Figure(4, "  memory of each (PSS)", pss_mib, "MiB", 10.0, True, peer="started by itself", peer_value=alone_mib),
    ]  # fmt: skip


def _pss_of_one(address: str, ground: socket.socket) -> float:
    """What a vehicle takes that was started by itself."""
    program = "from simvehicle.cli import main; main()"
    command = [sys.executable, "-c", program, "--sysid", "200", "--connect", address]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        deadline_s = time.perf_counter() + 60.0
        while 200 not in _ready_to_arm(ground) and time.perf_counter() < deadline_s:
            select.select([ground], [], [], 0.5)
        pss_mib = _pss_kib(process.pid) / KIB
        process.kill()
    return pss_mib


def _ready_to_arm(ground: socket.socket) -> set[int]:
    ready = set()
    while True:
        try:
            datagram = ground.recv(65535)
        except BlockingIOError:
            return ready
        for frame in codec.split(datagram).frames:
            if frame.msgid == common.MAVLINK_MSG_ID_SYS_STATUS:
                health = codec.fields(frame).onboard_control_sensors_health
                if health & common.MAV_SYS_STATUS_PREARM_CHECK:
                    ready.add(frame.sysid)


def _pss_kib(pid: int) -> float:
    lines = Path(f"/proc/{pid}/smaps_rollup").read_text(encoding="ascii").splitlines()
    return next(float(line.split()[1]) for line in lines if line.startswith("Pss:"))


def full_fleet(scale: Scale) -> list[Figure]:
    """`gcs run fleet` in real time, shortened to a minute, every vehicle asked for the six hot messages at 10 Hz."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "vehicles").mkdir()
        (folder / "scenario.yaml").write_text(yaml.safe_dump(fleet(FLEET_S)), encoding="utf-8")
        script = Path(__file__).with_name("fleet_in_real_time.py")
        reading, writing = os.pipe()  # the supervisor lives as long as its standard input is open
        done = subprocess.run(
            [sys.executable, str(script), name], stdin=reading, stdout=subprocess.PIPE, text=True, check=False
        )
        os.close(reading)
        os.close(writing)
        if done.returncode != 0:
            raise RuntimeError(f"the fleet's session ended with {done.returncode}: {done.stdout}")
        told = json.loads(done.stdout.splitlines()[-1])
        link = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["link"]
    lost = link["lost"] + link["malformed"] + link["overflowed"]
    what = f"254 vehicles in real time, {FLEET_S:.0f} s"
    return [
        Figure(5, f"{what}: latest tick", 1e3 * told["latest_s"], "ms late", 20.0 / scale.wall, True),
        Figure(5, "  frames received", told["frames_s"], "1/s", 254 * 60.0, peer="six messages at 10 Hz",
               peer_value=254 * 60.0),
        Figure(5, "  frames and datagrams lost", lost, "", 0.0, True),
        Figure(5, "  supervisor", told["supervisor"], "of a core", cpu_s=told["supervisor_cpu_s"]),
        Figure(5, "  all vehicles", told["vehicles"], "of a core", cpu_s=told["vehicles_cpu_s"]),
        Figure(5, "  both", told["supervisor"] + told["vehicles"], "of a core", 0.35 / scale.cpu, True),
    ]  # fmt: skip
