"""Real `simvehicle` processes on the wall clock, flown over loopback with pymavlink as the ground station."""

from __future__ import annotations

import math
import os
import random
import select
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest
import yaml
from patience import PATIENCE_S
from pymavlink import mavutil
from pymavlink.dialects.v20 import common as mav

PROGRAM = [sys.executable, "-c", "from simvehicle.cli import main; main()"]
PX4_HOLD, PX4_LAND, PX4_OFFBOARD = 4 << 16 | 3 << 24, 4 << 16 | 6 << 24, 6 << 16
ACCEPTED = 0
QUICK = {"MPC_TKO_SPEED": 3.0, "MPC_LAND_SPEED": 1.5, "RTL_RETURN_ALT": 1.0, "MIS_TAKEOFF_ALT": 1.5}


@contextmanager
def flying(folder: Path, sysid: int, connect: str, *argv: str) -> Iterator[subprocess.Popen[str]]:
    """A vehicle's process, ended with its context."""
    params = folder / f"{sysid}.yaml"
    params.write_text(yaml.safe_dump(QUICK))
    command = [*PROGRAM, "--sysid", str(sysid), "--connect", connect, "--params", str(params), *argv]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()


def port_of(process: subprocess.Popen[str]) -> int:
    """The port that a vehicle on udpin says it got."""
    assert process.stdout is not None
    assert select.select([process.stdout], [], [], PATIENCE_S)[0]
    return int(process.stdout.readline().rsplit(" ", 1)[1].strip(")\n"))


class Ground:
    """A ground station for one vehicle on a mavutil connection; set points and heartbeats go out while it waits."""

    def __init__(self, link: Any, sysid: int) -> None:
        self.link = link
        self.sysid = sysid
        self.set_point: tuple[float, float, float] | None = None
        self.disturb: Callable[[], None] = lambda: None
        self.others: tuple[Ground, ...] = ()
        self._beat_s = self._point_s = -math.inf

    def keep_alive(self) -> None:
        """What must not fall silent while something is waited for, for this vehicle and the others on the link."""
        for ground in (self, *self.others):
            ground.speak()

    def speak(self) -> None:
        """Heartbeat and set point of this vehicle, when they are due."""
        now_s = time.monotonic()
        if now_s - self._beat_s > 0.5:
            self._beat_s = now_s
            self.link.mav.heartbeat_send(mav.MAV_TYPE_GCS, mav.MAV_AUTOPILOT_INVALID, 0, 0, 0)
        if self.set_point is not None and now_s - self._point_s > 0.1:
            self._point_s = now_s
            self.disturb()
            self.send_point(self.set_point)

    def send_point(self, p_ned: tuple[float, float, float]) -> None:
        self.link.mav.set_position_target_local_ned_send(0, self.sysid, 1, 1, 3576, *p_ned, 0, 0, 0, 0, 0, 0, 0, 0)

    def wait(self, kind: str, holds: Callable[[Any], bool] = lambda _: True, within_s: float = PATIENCE_S) -> Any:
        """The next message of this vehicle and kind for which `holds` holds."""
        deadline_s = time.monotonic() + within_s
        last = None
        while time.monotonic() < deadline_s:
            self.keep_alive()
            message = self.link.recv_match(type=kind, blocking=True, timeout=0.05)
            if message is not None and message.get_srcSystem() == self.sysid:
                last = message
                if holds(message):
                    return message
        raise AssertionError(f"no such {kind} of vehicle {self.sysid} within {within_s} s; last: {last}")

    def command(self, command: int, *params: float) -> int:
        filled = (*params, *(0.0 for _ in range(7 - len(params))))
        self.link.mav.command_long_send(self.sysid, 1, command, 0, *filled)
        return int(self.wait("COMMAND_ACK", lambda m: m.command == command).result)

    def near(self, p_ned: tuple[float, float, float], within_s: float = PATIENCE_S) -> None:
        self.wait("LOCAL_POSITION_NED", lambda m: math.dist((m.x, m.y, m.z), p_ned) < 0.3, within_s)


def fly_out_and_home(ground: Ground) -> None:
    """Arm, take off, offboard to a place, return, land, disarmed."""
    ground.wait("HEARTBEAT")
    assert ground.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0) == ACCEPTED
    ground.wait("HEARTBEAT", lambda m: bool(m.base_mode & 0x80))
    assert ground.command(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7) == ACCEPTED
    ground.wait("HEARTBEAT", lambda m: m.custom_mode == PX4_HOLD)
    ground.set_point = (1.5, 1.0, -2.0)
    ground.wait("ATTITUDE")
    assert ground.command(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == ACCEPTED
    ground.wait("HEARTBEAT", lambda m: m.custom_mode == PX4_OFFBOARD)
    ground.near((1.5, 1.0, -2.0))
    assert ground.command(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH) == ACCEPTED
    ground.wait("EXTENDED_SYS_STATE", lambda m: m.landed_state == mav.MAV_LANDED_STATE_ON_GROUND, 15.0)
    ground.wait("HEARTBEAT", lambda m: not m.base_mode & 0x80)
    home = ground.wait("LOCAL_POSITION_NED")
    assert math.hypot(home.x, home.y) < 0.3
    assert home.z == 0.0


@contextmanager
def station(address: str) -> Iterator[Any]:
    """A mavutil connection of system 255."""
    link = mavutil.mavlink_connection(address, source_system=255, source_component=190, dialect="common")
    try:
        yield link
    finally:
        link.close()


@contextmanager
def station_on_any_port() -> Iterator[tuple[Any, int]]:
    with station("udpin:127.0.0.1:0") as link:
        yield link, link.port.getsockname()[1]


def test_waiting_vehicle_flies_a_whole_flight_whatever_else_the_network_sends(tmp_path: Path) -> None:
    """Meanwhile: garbage, NaN set points, and messages for another vehicle."""
    noise = random.Random(1)
    with ExitStack() as stack:
        process = stack.enter_context(flying(tmp_path, 1, "udpin:127.0.0.1:0"))
        port = port_of(process)
        stranger = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        link = stack.enter_context(station(f"udpout:127.0.0.1:{port}"))
        ground = Ground(link, 1)

        def disturb() -> None:
            for size in (0, 1, 40, 1400):
                stranger.sendto(noise.randbytes(size), ("127.0.0.1", port))
                link.port.sendto(b"\xfd" + noise.randbytes(size), ("127.0.0.1", port))
            ground.send_point((math.nan, 0.0, math.inf))
            link.mav.set_position_target_local_ned_send(0, 2, 1, 1, 3576, 50, 50, -50, 0, 0, 0, 0, 0, 0, 0, 0)
            link.mav.command_long_send(2, 1, mav.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0, 21196, 0, 0, 0, 0, 0)
            link.mav.command_long_send(1, 77, mav.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0, 21196, 0, 0, 0, 0, 0)

        ground.disturb = disturb
        fly_out_and_home(ground)
        assert process.poll() is None
        process.send_signal(signal.SIGINT)
        assert process.wait(10.0) == 130
        assert process.stderr is not None
        assert process.stderr.read().strip() == ""


def test_speaking_vehicle_flies_a_whole_flight_and_tells_the_truth(tmp_path: Path) -> None:
    with station_on_any_port() as (link, port):
        truth = tmp_path / "3.truth"
        with flying(tmp_path, 3, f"udpout:127.0.0.1:{port}", "--truth", str(truth)) as process:
            fly_out_and_home(Ground(link, 3))
            assert process.poll() is None
        assert truth.stat().st_size > 250 * 4 * 8  # more than 4 s of thrusts


def test_two_vehicles_on_one_ground_stations_port_obey_only_their_own(tmp_path: Path) -> None:
    with station_on_any_port() as (link, port), ExitStack() as stack:
        for sysid, east in ((1, "0"), (2, "5")):
            stack.enter_context(
                flying(tmp_path, sysid, f"udpout:127.0.0.1:{port}", "--position", f"0,{east},0", "--airborne")
            )
        one, two = Ground(link, 1), Ground(link, 2)
        for ground in (one, two):
            ground.wait("HEARTBEAT")
        assert len(link.clients) == 2  # mavutil, as MAVSDK does, sends everything to everybody
        one.set_point, two.set_point = (2.0, 0.0, -1.0), (2.0, 5.0, 1.0)
        one.others, two.others = (two,), (one,)
        for ground in (one, two):
            ground.keep_alive()
            assert ground.command(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0, 0.0) == ACCEPTED
        two.near((2.0, 5.0, 1.0))
        one.near((2.0, 0.0, -1.0))
        assert one.command(mav.MAV_CMD_NAV_LAND) == ACCEPTED
        one.wait("HEARTBEAT", lambda m: m.custom_mode == PX4_LAND)
        assert two.wait("HEARTBEAT").custom_mode == PX4_OFFBOARD


@pytest.mark.parametrize("what", ["port", "string", "output"])
def test_bad_input_ends_a_process_at_once_with_one_sentence(tmp_path: Path, what: str) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", 0))
        connect, argv, said = {
            "port": (f"udpin:127.0.0.1:{taken.getsockname()[1]}", [], "the port is in use"),
            "string": ("udp://:14540", [], "'udp://:14540' is no connection"),
            "output": ("udpin:127.0.0.1:0", ["--truth", str(tmp_path / "no" / "x")], "No such file or directory"),
        }[what]
        with flying(tmp_path, 1, connect, *argv) as process:
            out, err = process.communicate(timeout=PATIENCE_S)
    assert process.returncode == 2
    assert out == ""
    assert said in err
    assert err.count("\n") == 1


def supervisor_socket() -> socket.socket:
    made = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    made.bind(("127.0.0.1", 0))
    made.settimeout(PATIENCE_S)
    return made


def test_supervised_vehicle_says_hello_answers_grants_and_repeats_itself() -> None:
    writer, epoch_us = mav.MAVLink(None, 255, 190), 1_700_000_000_000_000

    def numbered(content: Any) -> bytes:
        raw = bytes(content.pack(writer))
        writer.seq = (writer.seq + 1) % 256
        return raw

    with supervisor_socket() as supervisor:
        address = f"udpout:127.0.0.1:{supervisor.getsockname()[1]}"
        command = [*PROGRAM, "--sysid", "4", "--supervised", address, "--position", "0,0,-5", "--airborne"]
        with subprocess.Popen(command) as process:
            try:
                hello, vehicle = supervisor.recvfrom(2000)
                again_s = time.monotonic()
                assert supervisor.recv(2000) == hello
                assert 0.03 < time.monotonic() - again_s < 5.0
                for tick in range(40):
                    point = mav.MAVLink_set_position_target_local_ned_message(
                        0, 4, 1, 1, 3576, 2.0, 0.0, -5.0, 0, 0, 0, 0, 0, 0, 0, 0
                    )
                    bundle = numbered(point) + numbered(
                        mav.MAVLink_system_time_message(epoch_us + 100_000 * tick, 100 * tick)
                    )
                    supervisor.sendto(bundle, vehicle)
                    answer = supervisor.recv(2000)
                    while answer == hello:
                        answer = supervisor.recv(2000)
                    supervisor.sendto(bundle, vehicle)
                    assert supervisor.recv(2000) == answer
                    said = mav.MAVLink(None).parse_buffer(answer)
                    assert said[-1].get_type() == "SYSTEM_TIME"
                    assert said[-1].time_boot_ms == 100 * tick
                places = [m.x for m in said if m.get_type() == "LOCAL_POSITION_NED"]
                assert places[-1] == pytest.approx(2.0, abs=0.1)
            finally:
                process.kill()


def test_hellos_to_nobody_do_not_spin() -> None:
    """A refused hello wakes the vehicle: it still repeats it every 100 ms and not as fast as it can."""
    with supervisor_socket() as supervisor:
        port = supervisor.getsockname()[1]
        command = [*PROGRAM, "--sysid", "4", "--supervised", f"udpout:127.0.0.1:{port}"]
        with subprocess.Popen(command) as process:
            try:
                supervisor.recv(2000)
                supervisor.close()
                before = cpu_s(process.pid)
                with pytest.raises(subprocess.TimeoutExpired):
                    process.wait(1.0)
                assert cpu_s(process.pid) - before < 0.3
            finally:
                process.kill()


def cpu_s(pid: int) -> float:
    """CPU time that a process has used."""
    fields = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
