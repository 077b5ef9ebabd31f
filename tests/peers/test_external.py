"""`gcs run` with nothing but strangers: a PX4 made of MAVSDK's server plugins, and scripted ArduCopters."""

from __future__ import annotations

import contextlib
import math
import os
import signal
import time
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pymap3d
import pytest
from ports import free_port
from pymavlink.dialects.v20 import ardupilotmega as mav
from sessions import Outcome, Running, fly
from strangers import ARDUCOPTER, strangers

ORIGIN = (47.397742, 8.545594, 488.0)
PX4, COPTER, TARGET = 5, 6, 8
RING_M, HEIGHT_M = 2.0, 2.5
CAPACITY_J = 250_000.0
PX4_REFUSES_S, COPTERS_REFUSE_S = "12", "8"
"""MAVSDK takes seconds to come up on a busy machine: the others begin when it is there, and all still refuse then."""
AWAY_S = 2.4
"""The PX4 leaves offboard after a second of it, and tells so in the next."""


OWN_ORIGIN_M = {PX4: (-3.0, -2.0, -1.0), COPTER: (1.0, 5.0, -0.5), TARGET: (2.0, 0.0, 0.0)}
"""Where each vehicle's own origin lies, and it stands at the start, in the scenario's frame: north, east, down."""


def own_origin(sysid: int) -> list[str]:
    """The origin as an option of its program."""
    lat, lon, alt = pymap3d.ned2geodetic(*OWN_ORIGIN_M[sysid], *ORIGIN)
    return ["--origin", f"{lat:.7f},{lon:.7f},{alt:.2f}"]


@pytest.fixture(scope="module")
def flown(peers: Path, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Outcome]:
    """Three strangers on one port, each with an origin of its own: two pursue the third, which flies a path."""
    folder = tmp_path_factory.mktemp("nobody-of-ours")
    port = free_port()
    external = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": CAPACITY_J}
    path = [[0, 0, -HEIGHT_M], [10, 0, -HEIGHT_M]]
    vehicles: dict[str, Any] = {
        "pursuers": [
            {"external": {"sysid": PX4, "at_end": "land", **external}},
            {"external": {"sysid": COPTER, **external}},
        ],
        "targets": [{"external": {"sysid": TARGET, **external}, "path_m": path, "speed_m_s": 0.5}],
    }
    scenario = {
        "schema": 1,
        "name": "strangers",
        "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "vehicles": vehicles,
        "formation": {"ring_m": RING_M},
        "goal": {"duration_s": 34.0, "pursue": {"within_m": 3.0, "for_s": 3.0}},
    }
    to = ["--connect", f"udpout:127.0.0.1:{port}"]
    px4 = [str(peers / "python"), str(Path(__file__).with_name("mavsdk_vehicle.py")), "--sysid", str(PX4), *to]
    px4 += [*own_origin(PX4), "--refuse-arming-s", PX4_REFUSES_S]
    copter = [*ARDUCOPTER, "--sysid", str(COPTER), *to, *own_origin(COPTER), "--refuse-arming-s", COPTERS_REFUSE_S]
    target = [*ARDUCOPTER, "--sysid", str(TARGET), *to, *own_origin(TARGET), "--refuse-intervals"]
    running = Running(scenario, folder, "--json")
    with contextlib.ExitStack() as stack:
        stack.callback(running.stop)
        running.wait_for(lambda seen: any("Waiting for" in event["text"] for event in seen["events"]))
        stack.enter_context(strangers(folder / "px4", px4))
        running.wait_for(lambda seen: any(event["text"].endswith(" is there") for event in seen["events"]))
        stack.enter_context(strangers(folder / "copters", copter, target))
        running.wait_for(lambda seen: all(v["stage"] == "fly" for v in seen["vehicles"]))
        supervisor = running.named("gcs.session.process").pid
        os.kill(supervisor, signal.SIGSTOP)
        time.sleep(AWAY_S)  # this is how long no set points flow
        os.kill(supervisor, signal.SIGCONT)
        yield running.finish()


def test_the_whole_job_is_done_by_strangers(flown: Outcome) -> None:
    summary = flown.summary
    assert (flown.status, summary["outcome"], summary["completed"]) == (0, "met", True), flown.stdout + flown.stderr
    assert (summary["clock"], summary["digest"]) == ("real", None)
    assert summary["min_separation_m"] > 0.6
    assert summary["link"]["lost"] == 0


def test_each_is_where_its_own_origin_says(flown: Outcome) -> None:
    """Judged by what each says and where its origin was put: at the end both stand on the target's ring."""
    last = {message.get_srcSystem(): message for _, message in flown.messages("LOCAL_POSITION_NED")}
    assert set(last) == set(OWN_ORIGIN_M)
    place = {
        sysid: [at + start for at, start in zip((m.x, m.y, m.z), OWN_ORIGIN_M[sysid], strict=True)]
        for sysid, m in last.items()
    }
    for sysid in (PX4, COPTER):
        assert math.dist(place[sysid], place[TARGET]) == pytest.approx(RING_M, abs=0.6), sysid
    assert -place[TARGET][2] == pytest.approx(HEIGHT_M, abs=0.3)


def test_energy_comes_from_what_each_reports(flown: Outcome) -> None:
    """All hover at 350 W by their scripts, for most of the time; a PX4 of MAVSDK tells only percent."""
    assert flown.vehicle(PX4)["energy"]["source"] == "battery_remaining"
    least_s, most_s = flown.summary["sim_time_s"] - 14.0, flown.summary["sim_time_s"]
    for sysid in OWN_ORIGIN_M:
        drawn_j = flown.vehicle(sysid)["energy"]["drawn_j"]
        assert 350.0 * least_s - 0.01 * CAPACITY_J < drawn_j < 400.0 * most_s + 0.01 * CAPACITY_J, sysid


def test_refusals_of_both_kinds_were_shown_and_overcome(flown: Outcome) -> None:
    said = (flown.folder / "session.log").read_text(encoding="utf-8")
    assert "Arm: Need Position Estimate" in said
    assert "Preflight Fail: ekf2 missing data" in said
    assert {sysid: flown.vehicle(sysid)["final_mode"] for sysid in OWN_ORIGIN_M} == {
        PX4: "land", COPTER: "hold", TARGET: "hold",
    }  # fmt: skip


def test_a_px4_that_returns_for_want_of_set_points_takes_part_again_when_they_flow(flown: Outcome) -> None:
    said = (flown.folder / "session.log").read_text(encoding="utf-8")
    assert "Its failsafe flies it (Return): it takes part again " in said
    assert "Takes part again" in said or "Brought back" in said  # where a busy machine kept it away for 3 s
    assert "it has booted" not in said


PAD_M = (3.0, 2.0, -0.5)
"""In the scenario's frame, on the ground of the ArduCopter, whose own origin lies half a metre higher."""
SMALL_J, STOCK_J, RATE_W = 10_000.0, 60_000.0, 2000.0


@pytest.fixture(scope="module")
def charged(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    """An ArduCopter that is soon at four fifths of what it is said to hold, and a base; nobody else flies."""
    folder = tmp_path_factory.mktemp("by-the-book")
    port = free_port()
    pursuer = {
        "external": {"connect": f"udpin:127.0.0.1:{port}", "sysid": COPTER, "capacity_j": SMALL_J},
        "transfer": False,
        "waypoints_m": [[1.0, 6.0, -HEIGHT_M]],
    }
    scenario = {
        "schema": 1,
        "name": "by-the-book",
        "axes": "ned",
        "origin": dict(zip(("lat_deg", "lon_deg", "alt_m"), ORIGIN, strict=True)),
        "vehicles": {"pursuers": [pursuer]},
        "bases": [{"name": "pad", "position_m": list(PAD_M), "stock_j": STOCK_J, "rate_w": RATE_W}],
        "competition": {"bids": "need", "need_from": 0.15, "dwell_s": 1.0},
        "goal": {"duration_s": 28.0, "refuelled_at_least": 1},  # between the end of its charging and its next landing
    }
    copter = [*ARDUCOPTER, "--sysid", str(COPTER), "--connect", f"udpout:127.0.0.1:{port}", *own_origin(COPTER)]
    with strangers(folder, [*copter, "--refuse-arming-s", "0.5", "--param", "LAND_SPEED=100"]):
        return fly(scenario, folder, "--plain")


def test_an_arducopter_is_charged_at_a_base_by_the_book_and_flies_on(charged: Outcome) -> None:
    assert (charged.status, charged.summary["outcome"]) == (0, "met"), charged.stdout + charged.stderr
    service = charged.summary["refuelling"][0]
    (base,) = charged.summary["bases"]
    assert (service["receiver"], service["tanker"], service["base"]) == (COPTER, None, "pad")
    received_j = charged.vehicle(COPTER)["energy"]["received_j"]
    assert base["initial_j"] - base["remaining_j"] == base["given_j"] == service["energy_j"] == received_j > 0.0
    assert base["lost_j"] == 0.0
    armed = [bool(m.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED) for _, m in charged.messages("HEARTBEAT") if ours(m)]
    assert [armed[0], armed[-1]] == [False, True]
    assert sum(before and not after for before, after in pairwise(armed)) == 1  # once it landed, and no more


def test_it_stood_on_the_pad_with_its_motors_off_while_it_was_charged(charged: Outcome) -> None:
    """Judged by what it says in its own frame, and by where its origin was put."""
    service = charged.summary["refuelling"][0]
    charging = (service["start_s"] + 0.5, service["start_s"] + service["energy_j"] / RATE_W)
    places = [
        [at + start for at, start in zip((m.x, m.y, m.z), OWN_ORIGIN_M[COPTER], strict=True)]
        for t_s, m in charged.messages("LOCAL_POSITION_NED")
        if charging[0] <= t_s <= charging[1]
    ]
    assert len(places) > 5
    assert max(math.dist(place[:2], PAD_M[:2]) for place in places) < 1.0
    assert all(place[2] == pytest.approx(PAD_M[2], abs=0.1) for place in places)
    after = [OWN_ORIGIN_M[COPTER][2] + m.z for t_s, m in charged.messages("LOCAL_POSITION_NED") if t_s > charging[1]]
    assert min(abs(z + HEIGHT_M) for z in after) < 0.5


def ours(message: Any) -> bool:
    """Whether the ArduCopter said it."""
    return bool(message.get_srcSystem() == COPTER)
