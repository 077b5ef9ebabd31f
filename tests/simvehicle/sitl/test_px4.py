"""A PX4 with its simulation in one process, here the stand-in: how it boots, what it says, how it fails."""

from __future__ import annotations

import math
import subprocess
import sys
from pathlib import Path

import psutil
import pymap3d
import pytest
from autopilot_units import fixes_around_an_outage, launched, said_in_flight, stand_in
from pymavlink.dialects.v20 import common

from simvehicle.sitl import autopilot_unit, px4_link, px4_process
from simvehicle.sitl.autopilot_process import AutopilotError
from simvehicle.sitl.px4 import Px4Unit
from simvehicle.sitl.px4_process import program_of, simulation_port

HOME, START_NED, YAW_DEG = (47.4, 8.5, 488.0), (1.0, 2.0, 0.0), 70.0


@pytest.fixture
def build(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """The stand-in as a build of PX4's, of the version that a test asks for by its parameter."""
    program = tmp_path / "build" / "bin" / "px4"
    scripts = tmp_path / "build" / "etc" / "init.d-posix"
    for made in (program.parent, scripts):
        made.mkdir(parents=True)
    (scripts / "rcS").touch()
    stand_in(program, "hil_px4.py", getattr(request, "param", "1.18"))
    return tmp_path / "build"


@pytest.mark.parametrize("build", ["1.15", "1.17", "1.18"], indirect=True)
def test_it_boots_before_the_session_and_its_battery_is_ours(build: Path) -> None:
    booted, connection = launched(Px4Unit, build, build.parent)
    with booted:
        said = said_in_flight(booted, connection, common.MAVLINK_MSG_ID_ATTITUDE, within_mv=30)
    assert {(m.autopilot, m.custom_mode) for m in said["HEARTBEAT"]} == {(12, 0x03040000)}
    attitudes, place = said["ATTITUDE"], said["LOCAL_POSITION_NED"][-1]
    assert len(attitudes) == pytest.approx(30, abs=1)
    heading = pytest.approx(YAW_DEG - 3.55, abs=0.5)  # by its compass, which points so far east of north there
    assert math.degrees(attitudes[-1].yaw) == heading
    assert (place.x, place.y, place.z) == pytest.approx((0.0, 0.0, 0.0), abs=0.05)


@pytest.mark.parametrize(("sigma_m", "least_m", "most_m"), [(0.0, 0.0, 0.1), (20.0, 2.0, 80.0)])
def test_its_sensors_err_as_the_scenario_says(build: Path, sigma_m: float, least_m: float, most_m: float) -> None:
    sensors = {"position_m": sigma_m, "velocity_m_s": 0.0, "accel_m_s2": 0.0}
    booted, connection = launched(Px4Unit, build, build.parent, sensors=sensors)
    with booted:
        booted.start_clock(0, 0)
        booted.advance(1000)
        said = common.MAVLink(None).parse_buffer(b"".join(connection.frames())) or []
    *_, place = (m for m in said if m.get_type() == "GLOBAL_POSITION_INT")
    north, east, _ = pymap3d.geodetic2ned(1e-7 * place.lat, 1e-7 * place.lon, 488.0, *HOME)
    assert least_m <= math.hypot(north - START_NED[0], east - START_NED[1]) <= most_m


def test_its_receiver_has_no_fix_while_gnss_fails(build: Path) -> None:
    booted, connection = launched(Px4Unit, build, build.parent)
    with booted:
        booted.start_clock(0, 0)
        assert fixes_around_an_outage(booted, connection) == [1, 6]


@pytest.mark.parametrize(
    ("parameters", "said"),
    [
        ({"CRASH": 1.0}, "ended with status 3; its last lines: ERROR [init] a parameter that it cannot bear"),
        ({"KIND": 1.0}, "is no PX4 with four rotors: its HEARTBEAT has type 1 and autopilot 12, not 2 and 12"),
        ({"READY_S": 1e6}, "was not ready in 3 s of its time; its last lines: INFO  [px4] instance: "),
        ({"LOCKSTEP": 0.0}, "does not wait for its simulation: build px4_sitl_default, not px4_sitl_nolockstep"),
        ({"KILLED_AT_S": 1.0}, "was killed by signal 9"),
        ({"NO_SUCH_PARAM": 5.0}, "has not taken its params: NO_SUCH_PARAM: it does not know it"),
    ],
)
def test_one_that_cannot_be_had_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, build: Path, parameters: dict[str, float], said: str
) -> None:
    monkeypatch.setattr(autopilot_unit, "BOOTS_WITHIN_S", 3.0)
    with pytest.raises(AutopilotError) as refused:
        launched(Px4Unit, build, build.parent, **parameters)
    assert said in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("build", ["1.15", "1.17", "1.18"], indirect=True)
def test_one_that_did_not_take_its_parameters_is_one_sentence_that_names_its_id(build: Path) -> None:
    program = build / "bin" / "px4"
    as_ever = program.read_text()
    forgets = "sed -i s/MAV_SYS_ID/NOTHING/ px4-rc.simulator; exec"
    program.write_text(as_ever.replace("exec", forgets))
    with pytest.raises(AutopilotError, match=r"it says that its system id is [1-9][0-9]*, not 200$"):
        launched(Px4Unit, build, build.parent, sysid=200)


def test_one_that_asks_for_no_simulation_is_one_sentence_and_is_ended(
    monkeypatch: pytest.MonkeyPatch, build: Path
) -> None:
    for name in ("READY_WITHIN_S", "LOOK_EVERY_S"):
        monkeypatch.setattr(px4_link, name, 0.2)
    (build / "bin" / "px4").write_text("#!/bin/sh\necho INFO starting\nexec sleep 99\n")
    with pytest.raises(AutopilotError, match=r"asked for no simulation within 0 s; its last lines: INFO starting$"):
        launched(Px4Unit, build, build.parent)
    assert not [child for child in psutil.Process().children() if "sleep" in child.name()]


def test_its_build_is_named_by_its_folder_or_its_program_and_what_is_none_is_one_sentence(build: Path) -> None:
    assert program_of(build) == program_of(build / "bin" / "px4") == (build / "bin" / "px4", build / "etc")
    with pytest.raises(AutopilotError, match=r"cannot be started: there is no .*none"):
        program_of(build / "none")
    with pytest.raises(AutopilotError, match="is no build of PX4's for simulation: there is no "):
        program_of(Path("/bin/true"))


def test_ports_that_others_have_and_instances_that_run_are_passed_over(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    first, instance = simulation_port()
    with first:
        second, after = simulation_port()
        second.close()
        assert after > instance
        monkeypatch.setattr(px4_process, "MOST_INSTANCES", instance + 1)
        with pytest.raises(AutopilotError, match="no ports are free for an autopilot: TCP 4560, UDP 18570"):
            simulation_port()
        monkeypatch.undo()
    monkeypatch.setattr(px4_process, "LOCK", str(tmp_path / "lock"))
    (tmp_path / f"lock-{instance}").touch()
    third, free = simulation_port()  # a lock that nobody holds
    third.close()
    assert free == instance
    hold = "import fcntl, sys; f = open(sys.argv[1], 'r+b'); fcntl.lockf(f, fcntl.LOCK_EX); print(flush=True); input()"
    argv = [sys.executable, "-c", hold, str(tmp_path / f"lock-{instance}")]
    with subprocess.Popen(argv, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as holder:
        assert holder.stdout is not None
        holder.stdout.readline()
        fourth, later = simulation_port()
        fourth.close()
        holder.communicate(b"\n")
    assert later > instance
