"""A session whose tanker is a stranger, and in which another stranger falls silent, is lost, and is found again."""

from __future__ import annotations

import contextlib
import math
import signal
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import psutil
import pytest
import yaml
from ports import free_port
from sessions import Outcome, Running, small
from strangers import SIMVEHICLE, strangers

TANKER, LOST = 201, 2
END_S = 21.0
PX4_MODES = {4 << 16 | 3 << 24: "hold", 6 << 16: "offboard"}


@dataclass
class Flown:
    outcome: Outcome
    said: str
    tanker_log: str


@pytest.fixture(scope="module")
def flown(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Flown]:
    """Pursuer 1 and the target are ours; once pursuer 2 flies, its process is stopped until it is counted as lost."""
    folder = tmp_path_factory.mktemp("roles")
    port = free_port()
    at = {"connect": f"udpin:127.0.0.1:{port}", "capacity_j": 150_000}
    content = small(clock={"mode": "real"}, goal={"duration_s": END_S, "refuelled_at_least": 1})
    vehicles = content["vehicles"]
    vehicles["tankers"] = [{"external": {"sysid": TANKER, **at}, "home_m": [-3.0, 0.0, -2.5]}]
    vehicles["pursuers"].append({"external": {"sysid": LOST, **at}, "waypoints_m": [[0.0, 8.0, -2.5]]})
    parameters = folder / "parameters.yaml"
    patient = {"SIM_BAT_CAP_J": 150_000, "COM_DL_LOSS_T": 300.0}  # it holds, and does not land, while it hears nobody
    parameters.write_text(yaml.safe_dump(patient), encoding="utf-8")
    to = ["--connect", f"udpout:127.0.0.1:{port}", "--params", str(parameters)]
    tanker = [*SIMVEHICLE, "--sysid", str(TANKER), *to, "--position", "-3,0,0"]
    lost = [*SIMVEHICLE, "--sysid", str(LOST), *to, "--position", "0,8,0"]
    with contextlib.ExitStack() as stack:
        logs = stack.enter_context(strangers(folder, tanker, lost))
        children = psutil.Process().children()
        process = next(child for child in children if child.cmdline() == lost)
        running = Running(content, folder, "--json")
        try:
            running.wait_for(lambda seen: _row(seen, LOST)["stage"] == "fly")
            process.send_signal(signal.SIGSTOP)
            running.wait_for(lambda seen: not _row(seen, LOST)["alive"])
            process.send_signal(signal.SIGCONT)
            outcome = running.finish()
        finally:
            running.stop()
        said = (outcome.folder / "session.log").read_text(encoding="utf-8")
        yield Flown(outcome, said, logs[0].read_text(encoding="utf-8"))


def _row(seen: dict[str, Any], sysid: int) -> dict[str, Any]:
    found: dict[str, Any] = next(vehicle for vehicle in seen["vehicles"] if vehicle["sysid"] == sysid)
    return found


def test_a_strangers_tanker_serves_a_vehicle_of_ours(flown: Flown) -> None:
    summary = flown.outcome.summary
    assert (flown.outcome.status, summary["outcome"]) == (0, "met"), flown.said
    (service,) = summary["refuelling"]
    assert (service["receiver"], service["tanker"]) == (1, TANKER)
    assert service["energy_j"] > 10_000


def test_what_it_gave_and_what_was_received_agree_to_the_joule(flown: Flown) -> None:
    """By the receiver's own truth, by the tanker's words, and by both rows of the summary."""
    received_j = flown.outcome.truth(1).energy[-1, 1]
    (service,) = flown.outcome.summary["refuelling"]
    tanker = flown.outcome.vehicle(TANKER)["energy"]
    assert received_j == service["energy_j"] == flown.outcome.vehicle(1)["energy"]["received_j"]
    assert tanker["given_j"] == received_j + tanker["lost_j"]
    assert f"Gave {tanker['given_j']:.0f} J" in flown.tanker_log


def test_one_that_is_silent_is_lost_and_taken_back_when_it_is_heard(flown: Flown) -> None:
    told = [
        f"pursuer {LOST}: No telemetry for 10 s: it is counted as lost until it is heard",
        f"pursuer {LOST}: Heard again: it is not lost",
    ]
    places = [flown.said.index(text) for text in told]
    assert places == sorted(places)
    lost_s, heard_s = (float(line.split(" s ")[0]) for line in flown.said.splitlines() if line.endswith(tuple(told)))
    modes = [
        (t_s, PX4_MODES[message.custom_mode])
        for t_s, message in flown.outcome.messages("HEARTBEAT")
        if message.get_srcSystem() == LOST and t_s >= lost_s
    ]
    names = [name for t_s, name in modes if t_s < END_S]
    assert names[0] == "hold"  # its own failsafe, for want of set points
    assert names[-1] == "offboard"
    point, place = last(flown.outcome, "SET_POSITION_TARGET_LOCAL_NED"), last(flown.outcome, "LOCAL_POSITION_NED")
    assert math.dist(point, place) < 0.5
    assert heard_s - lost_s < 4.0
    assert flown.outcome.vehicle(LOST)["final_mode"] == "hold"


def last(outcome: Outcome, name: str) -> tuple[float, float, float]:
    """The last place that was said of it, or to it, in its own frame, before the end."""
    said = [
        (m.x, m.y, m.z)
        for t_s, m in outcome.messages(name)
        if LOST in (m.get_srcSystem(), getattr(m, "target_system", 0)) and END_S - 0.5 < t_s < END_S
    ]
    return said[-1]


def test_nobody_is_missing_a_stream(flown: Flown) -> None:
    assert [vehicle["missing_streams"] for vehicle in flown.outcome.summary["vehicles"]] == [[], [], [], []]
