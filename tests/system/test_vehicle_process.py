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
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
import yaml
from patience import PATIENCE_S
from pymavlink.dialects.v20 import common as mav
from station import POSITION, Station

PROGRAM = [sys.executable, "-c", "from simvehicle.cli import main; main()"]
PX4_HOLD, PX4_OFFBOARD = 4 << 16 | 3 << 24, 6 << 16
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


def fly_out_and_home(station: Station) -> None:
    """Arm, take off, offboard to a place, return, land, disarmed."""
    station.hear("HEARTBEAT")
    station.command(mav.MAV_CMD_COMPONENT_ARM_DISARM, 1.0)
    station.hear("HEARTBEAT", lambda m: bool(m.base_mode & 0x80))
    station.command(mav.MAV_CMD_NAV_TAKEOFF, *[math.nan] * 7)
    station.hear("HEARTBEAT", lambda m: m.custom_mode == PX4_HOLD)
    place = (1.5, 1.0, -2.0)
    station.aim(POSITION, place)
    station.hear("ATTITUDE")
    station.command(mav.MAV_CMD_DO_SET_MODE, 129.0, 6.0)
    station.hear("HEARTBEAT", lambda m: m.custom_mode == PX4_OFFBOARD)
    station.hear("LOCAL_POSITION_NED", lambda m: math.dist((m.x, m.y, m.z), place) < 0.3)
    station.command(mav.MAV_CMD_NAV_RETURN_TO_LAUNCH)
    station.hear("EXTENDED_SYS_STATE", lambda m: m.landed_state == mav.MAV_LANDED_STATE_ON_GROUND, 15.0)
    station.hear("HEARTBEAT", lambda m: not m.base_mode & 0x80)
    home = station.hear("LOCAL_POSITION_NED")
    assert math.hypot(home.x, home.y) < 0.3
    assert home.z == 0.0


class Disturber(threading.Thread):
    """From another port and from the station's own: garbage, NaN set points, messages for another vehicle."""

    def __init__(self, station: Station, port: int) -> None:
        super().__init__()
        self._station, self._to = station, ("127.0.0.1", port)
        self.ended = threading.Event()

    def run(self) -> None:
        noise, writer = random.Random(1), mav.MAVLink(None, 255, 190)
        disarm = (mav.MAV_CMD_COMPONENT_ARM_DISARM, 0, 0, 21196, 0, 0, 0, 0, 0)
        messages = [
            mav.MAVLink_set_position_target_local_ned_message(0, 1, 1, 1, 3576, math.nan, 0, math.inf, *[0] * 8),
            mav.MAVLink_set_position_target_local_ned_message(0, 2, 1, 1, 3576, 50, 50, -50, *[0] * 8),
            mav.MAVLink_command_long_message(2, 1, *disarm),
            mav.MAVLink_command_long_message(1, 77, *disarm),
        ]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
            while not self.ended.wait(0.1):
                for size in (0, 1, 40, 1400):
                    stranger.sendto(noise.randbytes(size), self._to)
                    self._station.socket.sendto(b"\xfd" + noise.randbytes(size), self._to)
                for message in messages:
                    self._station.socket.sendto(message.pack(writer), self._to)


def test_waiting_vehicle_flies_a_whole_flight_whatever_else_the_network_sends(tmp_path: Path) -> None:
    with flying(tmp_path, 1, "udpin:127.0.0.1:0") as process, Station(1) as station:
        port = port_of(process)
        station.speaks_to("127.0.0.1", port)
        disturber = Disturber(station, port)
        disturber.start()
        try:
            fly_out_and_home(station)
        finally:
            disturber.ended.set()
            disturber.join()
        assert process.poll() is None
        process.send_signal(signal.SIGINT)
        assert process.wait(10.0) == 130
        assert process.stderr is not None
        assert process.stderr.read().strip() == ""


def test_speaking_vehicle_flies_a_whole_flight_and_tells_the_truth(tmp_path: Path) -> None:
    truth = tmp_path / "3.truth"
    with Station(3) as station:
        with flying(tmp_path, 3, f"udpout:127.0.0.1:{station.port}", "--truth", str(truth)) as process:
            fly_out_and_home(station)
            assert process.poll() is None
        assert truth.stat().st_size > 250 * 4 * 8  # more than 4 s of thrusts


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
