"""Who is brought back after the supervisor was away, and who is not."""

from dataclasses import dataclass
from typing import Any

import pytest
from views import snapshot, view

from gcs.mavlink.autopilots import FlightMode
from gcs.scenario.external import External
from gcs.supervisor.arming import Stage
from gcs.supervisor.arming_external import ExternalArmingSequence
from gcs.supervisor.recovery import WATCHED_S, Recovery
from gcs.telemetry.state import VehicleView


@dataclass
class Pilot:
    stage: Stage = Stage.FLY
    left_out: str = ""
    ordered: str | None = None
    rejoins: bool = False
    back: int = 0

    def rejoin(self) -> None:
        self.back += 1

    def back_from(self, seen: VehicleView) -> bool:
        external = External(connect="udpin:127.0.0.1:14550", capacity_j=1e5, rejoins=self.rejoins)
        return ExternalArmingSequence(1, 2.5, external).back_from(seen)


@pytest.mark.parametrize(
    ("stage", "changed", "back", "words"),
    [
        (Stage.YIELDED, {"mode": FlightMode.HOLD}, 1, "Brought back"),
        (Stage.YIELDED, {"mode": FlightMode.RETURN, "failsafe": True}, 1, "Brought back"),
        (Stage.DOWN, {"mode": FlightMode.LAND, "failsafe": True}, 1, "Brought back"),
        (Stage.YIELDED, {"mode": FlightMode.RETURN}, 0, "A pilot or another station may control it"),
        (Stage.YIELDED, {"mode": FlightMode.OTHER}, 0, "A pilot or another station may control it"),
        (Stage.YIELDED, {"mode": FlightMode.HOLD, "drawn_j": 1e9}, 0, "no energy left"),
        (Stage.FLY, {}, 0, ""),
    ],
)
def test_failsafes_are_ended_and_pilots_left_alone(stage: Stage, changed: Any, back: int, words: str) -> None:
    pilot = Pilot()
    recovery = Recovery({1: pilot})  # type: ignore[dict-item]
    recovery.returned(10.0)
    pilot.stage = stage
    events = recovery.look(snapshot(view(sysid=1, **changed), time_s=11.0))
    assert pilot.back == back
    assert [words in event.text for event in events] == ([True] if words else [])
    assert recovery.look(snapshot(view(sysid=1, **changed), time_s=11.1)) == []


@pytest.mark.parametrize(
    "pilot", [Pilot(left_out="why"), Pilot(ordered="hold"), Pilot(stage=Stage.TAKEN), Pilot(stage=Stage.YIELDED)]
)
def test_whom_the_supervisor_did_not_fly_is_nobody_to_bring_back(pilot: Pilot) -> None:
    recovery = Recovery({1: pilot})  # type: ignore[dict-item]
    recovery.returned(10.0)
    pilot.stage = Stage.YIELDED
    assert recovery.look(snapshot(view(sysid=1, mode=FlightMode.HOLD), time_s=11.0)) == []
    assert pilot.back == 0


def test_an_external_vehicle_that_rejoins_is_brought_back_from_a_return_that_may_be_a_pilots() -> None:
    pilot = Pilot(rejoins=True)
    recovery = Recovery({1: pilot})  # type: ignore[dict-item]
    recovery.returned(10.0)
    pilot.stage = Stage.YIELDED
    (event,) = recovery.look(snapshot(view(sysid=1, mode=FlightMode.RETURN), time_s=11.0))
    assert (pilot.back, event.level) == (1, "info")


def test_a_failsafe_that_the_tick_has_read_in_which_the_supervisor_woke_is_ended_too() -> None:
    pilot = Pilot()
    recovery = Recovery({1: pilot})  # type: ignore[dict-item]
    falls = view(sysid=1, mode=FlightMode.RETURN, failsafe=True)
    recovery.look(snapshot(view(sysid=1), time_s=9.9))
    pilot.stage = Stage.YIELDED
    recovery.look(snapshot(falls, time_s=10.0))
    recovery.returned(10.1)
    recovery.look(snapshot(falls, time_s=10.1))
    assert pilot.back == 1
    pilot.back = 0
    recovery.look(snapshot(falls, time_s=10.2))
    recovery.returned(10.3)  # it has flown its failsafe for longer
    recovery.look(snapshot(falls, time_s=10.3))
    assert pilot.back == 0


def test_a_failsafe_much_later_has_another_cause() -> None:
    pilot = Pilot()
    recovery = Recovery({1: pilot})  # type: ignore[dict-item]
    recovery.returned(10.0)
    recovery.look(snapshot(view(sysid=1), time_s=10.1 + WATCHED_S))
    pilot.stage = Stage.YIELDED
    assert recovery.look(snapshot(view(sysid=1, mode=FlightMode.HOLD), time_s=10.2 + WATCHED_S)) == []
