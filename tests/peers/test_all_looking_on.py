"""A mission over TCP or radios while MAVSDK, MAVProxy and pymavlink look on together, and one of them lands one."""

from __future__ import annotations

import contextlib
import math
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from conversation import Conversation
from lanes import lanes, start
from onlookers import PymavlinkStation, mavproxy, mavsdk, pymavlink_station
from ports import free_port
from pymavlink.dialects.v20 import common as mav
from radios import Cable, Tcp
from sessions import Outcome, Running

FLEET = (1, 2, 3)
BAUD = 57_600
FLOWN_S = 14.0
REACH_M = 2.0
LEFT_ALONE_S = 0.2
"""So long after a vehicle was taken a set point may still be on its way to it."""


class Fleet(NamedTuple):
    """Of each vehicle the address in the scenario, and the one that its program gets."""

    connects: dict[int, str]
    programs: dict[int, str]


def tcp(stack: contextlib.ExitStack, _: Path) -> Fleet:
    """One listens, as a simulator does; two connect to where the session listens."""
    listens = free_port()
    there = ("127.0.0.1", listens)
    one, two, three = (stack.enter_context(Tcp(to)) for to in (None, there, there))
    at = [f"tcp:127.0.0.1:{one.far_port}", f"tcpin:127.0.0.1:{listens}"]
    return Fleet({1: at[0], 2: at[1], 3: at[1]}, {1: spoken_to(one), 2: spoken_to(two), 3: spoken_to(three)})


def serial(stack: contextlib.ExitStack, folder: Path) -> Fleet:
    """Two behind one radio, which has no room for a third one's telemetry, and one on a radio of its own."""
    devices = [folder / "ttyRadio1", folder / "ttyRadio2"]
    shared, own = (stack.enter_context(Cable(device, BAUD)) for device in devices)
    at = [f"serial:{device}:{BAUD}" for device in devices]
    return Fleet({1: at[0], 2: at[0], 3: at[1]}, {1: spoken_to(shared), 2: spoken_to(shared), 3: spoken_to(own)})


def spoken_to(way: Cable | Tcp) -> str:
    return f"udpout:127.0.0.1:{way.port}"


class Onlookers(NamedTuple):
    """Who looks on, and may command."""

    sdk: Conversation
    proxy: Conversation
    station: PymavlinkStation

    def see_all(self) -> None:
        """MAVSDK and MAVProxy have said of every vehicle that it is there, and where."""
        self.proxy.hear(*(f"Detected vehicle {sysid}:1" for sysid in FLEET))
        self.proxy.type("watch --verbose LOCAL_POSITION_NED")
        for sysid in FLEET:
            self.proxy.type(f"vehicle {sysid}")
            self.proxy.hear(f"Set vehicle {sysid}", f"(src={sysid}/1)")
        self.proxy.type("watch")
        self.sdk.hear(*(f"sees {sysid}" for sysid in FLEET))


def by_mavsdk(onlookers: Onlookers, sysid: int) -> None:
    onlookers.sdk.type(str(sysid))
    onlookers.sdk.hear(f"landed {sysid}")


def by_mavproxy(onlookers: Onlookers, sysid: int) -> None:
    """By what heartbeats tell it: a radio may lose an acknowledgement."""
    talk = onlookers.proxy
    talk.type(f"vehicle {sysid}")
    talk.hear(f"Set vehicle {sysid}")
    talk.type("long MAV_CMD_NAV_LAND")
    talk.hear("DISARMED")


class Lander(NamedTuple):
    """One of who looks on: how it lands a vehicle, and its ids."""

    land: Callable[[Onlookers, int], None]
    ids: str


MAVSDK = Lander(by_mavsdk, "245/190")
MAVPROXY = Lander(by_mavproxy, "255/230")


def mission(fleet: Fleet, landed: int) -> dict[str, Any]:
    """Back and forth on their lines; who is to be landed waits above its start, so that its part is done by then."""
    said = lanes(fleet.connects, {"duration_s": FLOWN_S}, REACH_M)
    hovers = next(p for p in said["vehicles"]["pursuers"] if p["external"]["sysid"] == landed)
    hovers["waypoints_m"] = [[0, 4 * landed, -3]]
    return said


@pytest.mark.slow
@pytest.mark.parametrize(("link", "lander", "landed"), [(tcp, MAVSDK, 1), (serial, MAVPROXY, 2)], ids=["tcp", "serial"])
def test_all_look_on_and_one_lands_one_while_the_others_fly_their_mission(
    peers: Path, fly: Any, tmp_path: Path, link: Callable[..., Fleet], lander: Lander, landed: int
) -> None:
    sdk, proxy = free_port(), free_port()
    with contextlib.ExitStack() as stack:
        fleet = link(stack, tmp_path)
        station = stack.enter_context(pymavlink_station())
        at = {MAVSDK: f"udpout:127.0.0.1:{sdk}", MAVPROXY: f"udpin:127.0.0.1:{proxy}"}
        options = [word for address in (*at.values(), station.address) for word in ("--forward", address)]
        running = Running(mission(fleet, landed), tmp_path, "--json", "--forward-control", *options)
        stack.callback(running.stop)
        onlookers = Onlookers(
            stack.enter_context(mavsdk(peers, sdk, "looks_on", *FLEET)),
            stack.enter_context(mavproxy(peers, f"udpout:127.0.0.1:{proxy}", tmp_path)),
            station,
        )
        onlookers.sdk.hear("listens")
        onlookers.proxy.hear("Waiting for heartbeat")  # and so does the session, whose time begins with the vehicles
        for sysid, where in fleet.programs.items():
            fly(where, sysid, "--home", start(sysid))
        onlookers.see_all()
        lander.land(onlookers, landed)
        outcome = running.finish()
    assert (outcome.status, outcome.summary["outcome"]) == (0, "met"), outcome.stdout[-1500:] + outcome.stderr
    taken_s = taken(outcome, landed, f"NAV_LAND to pursuer {landed} by {lander.ids} at {at[lander]}")
    judge_landed(outcome, landed, taken_s)
    for sysid in set(FLEET) - {landed}:
        judge_flown(outcome, sysid)
    judge_heard(outcome, station)


def taken(outcome: Outcome, landed: int, text: str) -> float:
    """When the session left it to who landed it, s: that one alone, and the recording says who it was."""
    orders = [line for line in outcome.decisions if line["kind"] == "operator"]
    assert [(line["sysid"], line["taken"]) for line in orders if line["command"] == "release"] == [(landed, True)]
    assert text in {line["text"] for line in orders if line["command"] == "forward"}
    assert {line["sysid"] for line in orders if "NAV_LAND" in line["text"]} == {landed}
    return next(line["t_s"] for line in orders if line["command"] == "release")


def judge_landed(outcome: Outcome, sysid: int, taken_s: float) -> None:
    """It came down where it had hovered, and was sent no set point any more."""
    places = reported(outcome, sysid)
    assert min(down for _, _, down in places) < -2.0
    assert math.dist(places[-1], (0.0, 0.0, 0.0)) < 0.6
    last = [m for _, m in outcome.messages("HEARTBEAT") if m.get_srcSystem() == sysid][-1]
    assert not last.base_mode & mav.MAV_MODE_FLAG_SAFETY_ARMED
    assert outcome.vehicle(sysid)["final_mode"] == "land"
    times = [t_s for t_s, m in outcome.messages("SET_POSITION_TARGET_LOCAL_NED") if m.target_system == sysid]
    assert max(times) <= taken_s + LEFT_ALONE_S


def judge_flown(outcome: Outcome, sysid: int) -> None:
    """By what it reported: it came to both ends of its line, and was led to the end."""
    for north in (REACH_M, -REACH_M):
        assert min(math.dist(place, (north, 0.0, -3.0)) for place in reported(outcome, sysid)) < 0.6
    times = [t_s for t_s, m in outcome.messages("SET_POSITION_TARGET_LOCAL_NED") if m.target_system == sysid]
    assert max(times) > FLOWN_S - 1.0


def reported(outcome: Outcome, sysid: int) -> list[tuple[float, float, float]]:
    """Its places from its own origin: north, east, down, m."""
    return [(m.x, m.y, m.z) for _, m in outcome.messages("LOCAL_POSITION_NED") if m.get_srcSystem() == sysid]


def judge_heard(outcome: Outcome, station: PymavlinkStation) -> None:
    """What was recorded of the vehicles went out, each message once."""
    recorded = Counter(
        (m.get_srcSystem(), m.get_type()) for _, m in outcome.messages("HEARTBEAT", "LOCAL_POSITION_NED", "ATTITUDE")
    )
    for sysid in FLEET:
        for name in ("HEARTBEAT", "LOCAL_POSITION_NED", "ATTITUDE"):
            assert station.heard[sysid, name] == recorded[sysid, name] > FLOWN_S - 3.0, (sysid, name)
