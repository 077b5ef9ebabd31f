"""Who can take energy in the air: as the scenario says, by its parameters, by its answer."""

from __future__ import annotations

import math

import pytest
from views import view

from gcs.mavlink.autopilots import FlightMode
from gcs.refuelling.capability import ReceiverCapability
from gcs.refuelling.service import ServiceRequests
from gcs.telemetry.state import FleetSnapshot


def run(
    ability: ReceiverCapability,
    requests: ServiceRequests,
    seconds: float,
    *,
    told: bool = True,
    heard: bool = True,
    at_s: float = 0.0,
) -> None:
    for k in range(round(seconds / 0.5) + 1):
        seen = view(1, mode=FlightMode.HOLD, battery_reported=told, last_received_s=0.0 if heard else -math.inf)
        ability.decide(FleetSnapshot(at_s + 0.5 * k, (seen,), ()), requests)


def test_who_is_not_asked_is_as_the_scenario_says() -> None:
    requests, ability = ServiceRequests(), ReceiverCapability({1: True, 2: False})
    run(ability, requests, 20.0)
    assert requests.requests == []
    assert ability.unable == {2: "the scenario says so"}
    assert [record["receiver"] for record in requests.records] == [2]


def test_a_vehicle_with_a_battery_model_is_asked_once_by_a_command_that_does_nothing() -> None:
    requests, ability = ServiceRequests(), ReceiverCapability({1: None})
    run(ability, requests, 5.0)
    (wish,) = requests.requests
    assert (wish.sysid, wish.command, any(wish.params)) == (1, 31010, False)
    assert (ability.unknown, ability.unable) == ({1}, {})


@pytest.mark.parametrize("accepted", [True, False])
def test_its_answer_decides(accepted: bool) -> None:
    requests, ability = ServiceRequests(), ReceiverCapability({1: None})
    run(ability, requests, 1.0)
    requests.receive_result(requests.requests[0].token, accepted)
    run(ability, requests, 1.0, at_s=2.0)
    assert ability.unknown == set()
    assert ability.unable == ({} if accepted else {1: "it does not know MAV_CMD_USER_1"})


def test_a_stranger_without_a_battery_model_is_sent_nothing_and_waited_for_ten_seconds() -> None:
    requests, ability = ServiceRequests(), ReceiverCapability({1: None})
    run(ability, requests, 30.0, heard=False)
    assert ability.unknown == {1}
    run(ability, requests, 10.0, told=False, at_s=31.0)
    assert ability.unknown == {1}
    run(ability, requests, 1.0, told=False, at_s=41.5)
    assert ability.unable == {
        1: "it takes no energy in flight: it has not SIM_BAT_CAP_J, as simulated vehicles that do have"
    }
    assert requests.requests == []
