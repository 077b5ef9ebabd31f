"""A real PX4, where somebody has built one: SKYTENDER_PX4=/path/to/PX4-Autopilot/build/px4_sitl_default.

It flies in its own simulator (SIH) on this machine; everything else of it is what flies on hardware, and nothing of its
parameters is changed.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import socket
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
import survey_plans
from commands import gcs
from pymavlink.dialects.v20 import common as mav
from sessions import GCS, Outcome, fly

BUILD = os.environ.get("SKYTENDER_PX4", "")
LAT, LON, ALT = 47.397742, 8.545594, 489.4
LAST_M = (8.0, 0.0, -4.0)
CAPACITY_J = 250_000.0
STATION = 255
NOISE_M = 2.0
"""How far off its simulated GPS has it fly, at most: it wandered by 0.9 m in a hold of 20 s."""
pytestmark = pytest.mark.skipif(not BUILD, reason="no PX4: SKYTENDER_PX4 names no build/px4_sitl_default")


@dataclass(frozen=True)
class Px4:
    """One that runs: its system id, and where it speaks to."""

    sysid: int
    connect: str


def free_instance() -> int:
    """A PX4's ports follow from its number, and from 10 on they all speak to one."""
    for number in range(10):
        with contextlib.ExitStack() as stack, contextlib.suppress(OSError):
            for port in (14540, 14580, 18570, 14280, 13030, 19450):
                stack.enter_context(socket.socket(type=socket.SOCK_DGRAM)).bind(("127.0.0.1", port + number))
            return number
    pytest.fail("the ports of PX4's instances 0 to 9 are all taken")


@pytest.fixture(scope="module")
def px4(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Px4]:
    number = free_instance()
    folder = tmp_path_factory.mktemp("px4")
    home = {"PX4_HOME_LAT": LAT, "PX4_HOME_LON": LON, "PX4_HOME_ALT": ALT}
    named = {"PX4_SIM_MODEL": "sihsim_quadx", **{key: str(value) for key, value in home.items()}}
    program = [f"{BUILD}/bin/px4", "-d", "-i", str(number), f"{BUILD}/etc"]
    with (folder / "px4.log").open("wb") as said:
        running = subprocess.Popen(
            program, cwd=folder, env={**os.environ, **named}, stdin=subprocess.DEVNULL, stdout=said, stderr=said
        )
        with running:
            yield Px4(number + 1, f"udpin:127.0.0.1:{14540 + number}")
            alive = running.poll() is None
            running.kill()
    assert alive, (folder / "px4.log").read_text(errors="replace")


def test_a_plan_of_twenty_items_is_written_read_back_and_cleared(px4: Px4, tmp_path: Path) -> None:
    file = tmp_path / "survey.plan"
    file.write_text(json.dumps(survey_plans.plan()))
    at = ("--connect", px4.connect, "--wait", "60")
    done = gcs("mission", "set", str(file), *at)
    assert done.returncode == 0, done.stdout + done.stderr
    assert done.stdout.count("uploaded, read back equal") == 3
    assert gcs("mission", "diff", str(file), *at).stdout == f"vehicle {px4.sysid}: no difference\n"
    cleared = gcs("mission", "clear", *at)
    assert (cleared.returncode, cleared.stdout.count("cleared, read back")) == (0, 3), cleared.stdout


@pytest.fixture(scope="module")
def flown(px4: Px4, tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    pursuer = {
        "external": {"connect": px4.connect, "sysid": px4.sysid, "capacity_j": CAPACITY_J, "at_end": "land"},
        "transfer": False,
        "waypoints_m": [[0.0, 0.0, -3.0], list(LAST_M)],
    }
    scenario: dict[str, Any] = {
        "schema": 1,
        "name": "px4",
        "axes": "ned",
        "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
        "vehicles": {"pursuers": [pursuer]},
        "goal": {"duration_s": 40.0},
    }
    return fly(scenario, tmp_path_factory.mktemp("flown"), "--plain")


def test_it_is_armed_takes_off_and_follows_set_points_to_where_it_is_sent(flown: Outcome, px4: Px4) -> None:
    assert (flown.status, flown.summary["outcome"]) == (0, "met"), flown.stdout + flown.stderr
    assert flown.vehicle(px4.sysid)["missing_streams"] == []
    assert flown.summary["link"]["lost"] == 0
    *_, (_, last) = flown.messages("LOCAL_POSITION_NED")
    assert math.dist((last.x, last.y, last.z), LAST_M) < NOISE_M
    flown_in = {message.custom_mode for _, message in flown.messages("HEARTBEAT") if message.get_srcComponent() == 1}
    assert 6 << 16 in flown_in  # offboard, by PX4's own numbers


def test_its_energy_is_the_share_that_it_tells_for_its_simulator_measures_no_current(flown: Outcome, px4: Px4) -> None:
    told = [m for _, m in flown.messages("BATTERY_STATUS")]
    unmeasured = {m.current_battery for m in told}
    assert unmeasured in ({-1}, {-100})  # today's, and up to 1.17 that of -1 A
    energy = flown.vehicle(px4.sysid)["energy"]
    fallen_j = 0.01 * (told[0].battery_remaining - told[-1].battery_remaining) * CAPACITY_J
    assert energy["source"] == "battery_remaining"
    assert energy["drawn_j"] == pytest.approx(fallen_j, abs=0.02 * CAPACITY_J)
    assert energy["drawn_j"] > 0.1 * CAPACITY_J


def test_it_lands_when_the_session_ends(flown: Outcome) -> None:
    orders = [m.command for _, m in flown.messages("COMMAND_LONG") if m.get_srcSystem() == STATION]
    assert orders[-1] == mav.MAV_CMD_NAV_LAND


@pytest.mark.usefixtures("flown")
def test_its_peers_miss_nothing_in_it(px4: Px4) -> None:
    done = subprocess.run(
        [*GCS, "check", "--connect", px4.connect, "--json"], capture_output=True, text=True, check=False
    )
    findings = json.loads(done.stdout)["findings"]
    assert [f for f in findings if f["outcome"] in ("missing", "wrong")] == [], done.stderr
    assert done.returncode == 0
