"""A vehicle with two links, a cable as slow as a radio and a network port; the first is cut in flight."""

from __future__ import annotations

import contextlib
import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import pytest
from ports import free_port
from radios import Cable
from sessions import Outcome, Running
from strangers import SIMVEHICLE, strangers

from gcs.recording import session_folder

BAUD = 57_600
FLOWN_S = 16.0
PX4_OFFBOARD = 6 << 16
POINTS_M = [[4, 0, -3], [-4, 0, -3]]


@dataclass
class Flown:
    outcome: Outcome
    events: list[dict[str, Any]]
    links: list[str]
    device: str
    udp: str
    cut_s: float


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """It goes back and forth; the cable is pulled when it has begun."""
    folder = tmp_path_factory.mktemp("links")
    device, port = folder / "ttyRadio", free_port()
    events: list[dict[str, Any]] = []
    links: list[str] = []
    with contextlib.ExitStack() as stack:
        cable = stack.enter_context(Cable(device, BAUD))
        connects = [f"serial:{device}:{BAUD}", f"udpin:127.0.0.1:{port}"]
        both = ["--connect", f"udpout:127.0.0.1:{cable.port}", "--connect", f"udpout:127.0.0.1:{port}"]
        stack.enter_context(strangers(folder, [*SIMVEHICLE, "--sysid", "7", *both]))
        said = {
            "schema": 1, "name": "links", "axes": "ned",
            "origin": {"lat_deg": 47.397742, "lon_deg": 8.545594, "alt_m": 488.0},
            "goal": {"duration_s": FLOWN_S}, "station": {"sysid": 240, "compid": 191},
            "vehicles": {"pursuers": [
                {"external": {"connect": connects, "sysid": 7, "capacity_j": 250_000}, "waypoints_m": POINTS_M},
            ]},
        }  # fmt: skip
        running = Running(said, folder, "--json")
        stack.callback(running.stop)

        def looked_at(snapshot: dict[str, Any]) -> bool:
            events.extend(snapshot["events"])
            links.extend(row["link"] for row in snapshot["vehicles"])
            return all(vehicle["stage"] == "fly" for vehicle in snapshot["vehicles"])

        cut_s = running.wait_for(looked_at)["t_s"]
        cable.pull()
        with contextlib.suppress(AssertionError):
            running.wait_for(lambda snapshot: looked_at(snapshot) and False)  # to the end
        yield Flown(running.finish(), events, links, connects[0], connects[1], cut_s)


def test_the_mission_goes_on_as_if_nothing_had_been(flown: Flown) -> None:
    """By what the vehicle reported: it was never out of offboard from the first time on, and met its way points."""
    modes = [
        (t_s, message.custom_mode)
        for t_s, message in flown.outcome.messages("HEARTBEAT")
        if message.get_srcSystem() == 7
    ]
    begun_s = next(t_s for t_s, mode in modes if mode == PX4_OFFBOARD)
    assert {mode for t_s, mode in modes if begun_s <= t_s < FLOWN_S} == {PX4_OFFBOARD}
    assert (flown.outcome.status, flown.outcome.summary["outcome"]) == (0, "met")
    positions = [(t_s, m) for t_s, m in flown.outcome.messages("LOCAL_POSITION_NED") if m.get_srcSystem() == 7]
    for point in POINTS_M:
        assert min(math.dist((m.x, m.y, m.z), point) for _, m in positions) < 0.6
    times = [t_s for t_s, _ in positions if flown.cut_s - 1.0 <= t_s < FLOWN_S]
    assert max(b - a for a, b in itertools.pairwise(times)) <= 1.0
    assert len({bytes(m.get_msgbuf()) for _, m in positions}) == len(positions)  # none is taken twice
    assert len({m.time_boot_ms for _, m in positions}) >= len(positions) - 2  # where the links change, one may overlap


def test_the_change_is_an_event_and_the_link_in_use_is_shown(flown: Flown) -> None:
    told = [event["text"] for event in flown.events if event["sysid"] == 7 and event["text"].startswith("Flown over")]
    assert told[-1] == f"Flown over {flown.udp} now: {flown.device} is silent"
    assert set(told[:-1]) <= {f"Flown over {flown.device} now: it is as good, and preferred"}  # if it was heard second
    assert any(text["text"].startswith(f"{flown.device} is lost: ") for text in flown.events)
    assert flown.device in flown.links
    assert flown.links[-1] == flown.udp
    (vehicle,) = flown.outcome.summary["vehicles"]
    assert [(one["connect"], one["used"], one["fresh"]) for one in vehicle["links"]] == [
        (flown.device, False, False), (flown.udp, True, True),
    ]  # fmt: skip
    assert flown.outcome.summary["link"]["lost"] < 20


def test_nobody_but_the_session_had_it(flown: Flown) -> None:
    (vehicle,) = flown.outcome.summary["vehicles"]
    assert vehicle["missing_streams"] == []
    assert not [event for event in flown.events if "takes part again" in event["text"].lower()]


def test_the_vehicle_knows_us_by_the_scenarios_id_alone(flown: Flown) -> None:
    sent = [m for name in ("SET_POSITION_TARGET_LOCAL_NED", "COMMAND_LONG") for _, m in flown.outcome.messages(name)]
    senders = {(m.get_srcSystem(), m.get_srcComponent()) for m in sent}
    assert senders == {(240, 191)}
    answered = {(m.target_system, m.target_component) for _, m in flown.outcome.messages("COMMAND_ACK")}
    assert answered == {(240, 191)}
    assert session_folder.read(flown.outcome.folder).traffic_count.keys() == {7}
