"""The dialogue about parameters with a scripted vehicle that pymavlink speaks for, over a link that loses."""

import random
from typing import Any

import pytest
from dialogue import converse, deliver, heard
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink.autopilots import ARDUCOPTER, PX4, Profile
from gcs.mavlink.parameters.client import IN_FLIGHT, MOST_PARAMETERS, TRIES, ParameterClient
from gcs.mavlink.parameters.value import to_wire, typed

INT32, REAL32 = mav.MAV_PARAM_TYPE_INT32, mav.MAV_PARAM_TYPE_REAL32


class Vehicle:
    """Its parameters by name, as (number, type); `stubborn` ones keep their value."""

    def __init__(self, profile: Profile, parameters: dict[str, tuple[float, int]], lose: float = 0.0) -> None:
        self.profile, self.parameters, self.lose = profile, dict(parameters), lose
        self.stubborn: set[str] = set()
        self.random = random.Random(5)
        self.asked: list[str] = []

    def value(self, name: str, index: int = 65535) -> Any:
        number, kind = self.parameters[name]
        raw = to_wire(typed(number, kind), bytewise=self.profile.integers_bytewise)
        return mav.MAVLink_param_value_message(name.encode(), raw, kind, len(self.parameters), index)

    def hear(self, heard: Any) -> list[Any]:
        self.asked.append(heard.get_type())
        names = list(self.parameters)
        match heard.get_type():
            case "PARAM_REQUEST_LIST":
                return [self.value(name, index) for index, name in enumerate(names)]
            case "PARAM_REQUEST_READ" if heard.param_index >= 0:
                return [self.value(names[heard.param_index], heard.param_index)]
            case "PARAM_REQUEST_READ" if heard.param_id in names:
                return [self.value(heard.param_id)]
            case "PARAM_SET" if heard.param_id in names:
                if heard.param_id not in self.stubborn:
                    number = float(self.profile.parameter(heard.param_value, heard.param_type).number)
                    self.parameters[heard.param_id] = (number, heard.param_type)
                return [self.value(heard.param_id)]
        return []


MANY = {f"P{i:03d}": (float(i * 3 - 100), INT32 if i % 2 else REAL32) for i in range(200)}


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
@pytest.mark.parametrize("lose", [0.0, 0.3])
def test_a_list_comes_whole_whatever_the_link_loses(profile: Profile, lose: float) -> None:
    client, vehicle = ParameterClient(3, 1, profile), Vehicle(profile, MANY, lose)
    client.read_all()
    converse(client, vehicle)
    assert not client.incomplete
    assert {name: tuple(parameter) for name, parameter in client.known.items()} == MANY


@pytest.mark.parametrize("profile", [PX4, ARDUCOPTER])
def test_what_is_written_is_read_back_and_what_has_its_value_is_not_written(profile: Profile) -> None:
    client, vehicle = ParameterClient(3, 1, profile), Vehicle(profile, MANY, lose=0.2)
    vehicle.stubborn = {"P010"}
    client.write({"P001": -7.0, "P002": 0.1, "P003": -91.0, "P010": 4.0, "P005": 1.5, "NONE": 1.0})
    converse(client, vehicle)
    results = {result.name: result for result in client.results}
    assert {name: result.outcome for name, result in results.items()} == {
        "P001": "set", "P002": "set", "P003": "kept", "P010": "refused", "P005": "refused", "NONE": "unknown",
    }  # fmt: skip
    assert vehicle.parameters["P001"] == (-7.0, INT32)
    assert vehicle.parameters["P002"][0] == pytest.approx(0.1)
    assert results["P010"].why == "it keeps -70"
    assert results["P005"].why == "1.5 is no whole number, and its type is INT32"


def test_of_many_questions_a_few_are_open_at_once_and_a_silent_vehicle_is_given_up() -> None:
    client = ParameterClient(3, 1, PX4)
    client.read(MANY)
    assert len(client.poll(0.0)) == IN_FLIGHT
    assert client.poll(0.1) == []
    silent = ParameterClient(3, 1, PX4)
    silent.read(["A"])
    silent.read_all()
    vehicle = Vehicle(PX4, MANY, lose=1.0)
    converse(silent, vehicle)
    assert silent.results[0].why == f"no answer, though it was asked {TRIES} times"
    assert silent.incomplete == "0 parameters came"


def test_a_vehicle_that_names_parameters_without_end_is_heard_to_a_bound() -> None:
    client = ParameterClient(1, 1, ARDUCOPTER)
    client.read(["WANTED"])
    for name in [*(f"N{number}" for number in range(2 * MOST_PARAMETERS)), "WANTED"]:
        told: Any = mav.MAVLink_param_value_message(name.encode(), 1.0, mav.MAV_PARAM_TYPE_REAL32, 65535, 65535)
        told.param_id = name
        client.receive("PARAM_VALUE", told, 0.0)
    assert len(client.known) == MOST_PARAMETERS + 1
    assert [(result.name, result.now and result.now.number) for result in client.results] == [("WANTED", 1.0)]


ERRORS = {
    1: ("unknown", "it does not know it"),
    2: ("refused", "VALUE_OUT_OF_RANGE"),
    5: ("refused", "READ_ONLY"),
    8: ("refused", "READ_FAIL"),
    99: ("refused", "it says error 99"),
}
"""MAV_PARAM_ERROR of MAVLink's common.xml of today → what comes of it."""


@pytest.mark.parametrize("error", ERRORS)
@pytest.mark.parametrize("after", [0, 1])
def test_a_parameter_error_ends_a_task_as_its_code_says(error: int, after: int) -> None:
    """To the question what it is, and to PARAM_SET."""
    client, vehicle = ParameterClient(3, 1, PX4), Vehicle(PX4, MANY)
    client.write({"P001": 5})
    if after:
        (asked,) = client.poll(0.0)
        deliver(client, *vehicle.hear(heard(asked)))
    (sent,) = client.poll(0.1)
    assert sent.msgid == (mav.MAVLINK_MSG_ID_PARAM_SET if after else mav.MAVLINK_MSG_ID_PARAM_REQUEST_READ)
    deliver(client, mav.MAVLink_param_error_message(255, 190, b"P001", -1, error), now_s=0.1)
    (result,) = client.results
    assert client.done
    outcome, words = ERRORS[error]
    assert result.outcome == outcome
    assert words in result.why


def test_an_unknown_name_is_named_with_what_other_versions_call_it() -> None:
    for profile, name, now in ((ARDUCOPTER, "RTL_ALT", "RTL_ALT_M"), (PX4, "EKF2_GPS_POS_X", "SENS_GPS0_OFFX")):
        client = ParameterClient(3, 1, profile)
        client.read([name])
        converse(client, Vehicle(profile, MANY))
        assert client.results[0].outcome == "unknown"
        assert now in client.results[0].why
        companion = ParameterClient(3, 154, profile)
        companion.read([name])
        converse(companion, Vehicle(profile, MANY))
        assert now not in companion.results[0].why


def test_a_value_whose_type_the_encoding_cannot_carry_is_named_and_not_known() -> None:
    vehicle = Vehicle(PX4, {"A": (1.0, INT32)})
    wide = mav.MAVLink_param_value_message(b"WIDE", 1.0, mav.MAV_PARAM_TYPE_UINT64, 2, 1)
    client = ParameterClient(3, 1, PX4)
    client.read_all()
    client.poll(0.0)
    deliver(client, vehicle.value("A", 0), wide, wide, now_s=0.1)
    assert client.known.keys() == {"A"}
    assert [(r.name, r.outcome) for r in client.results] == [("WIDE", "refused")]
    assert "UINT64 does not fit into the four bytes" in client.results[0].why
