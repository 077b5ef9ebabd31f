"""`gcs check` of values: what comes, but with another number than was written, none at all, or another index."""

from __future__ import annotations

import struct
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav
from scripted_vehicle import Scripted, examine

from gcs.cli.check.report import passed

NAN, INF = float("nan"), float("inf")
MINUS_ONE = struct.unpack("<f", struct.pack("<i", -1))[0]
"""What the bytes of the integer -1 are as a float: a NaN."""


def with_parameters(
    values: dict[bytes, float], *, kind: int = mav.MAV_PARAM_TYPE_REAL32, step: float = 0.0, index: int | None = None
) -> Scripted:
    """A vehicle that adds `step` to what is written; `index` is that of each of its parameters."""
    vehicle, names = Scripted(), list(values)

    def value(name: bytes, number: float) -> Any:
        at = names.index(name) if index is None else index
        return mav.MAVLink_param_value_message(name, number, kind, len(names), at)

    vehicle.answers["PARAM_REQUEST_LIST"] = lambda _: [value(name, number) for name, number in values.items()]
    vehicle.answers["PARAM_REQUEST_READ"] = lambda asked: [value(names[asked.param_index], 1.0)]
    vehicle.answers["PARAM_SET"] = lambda asked: [value(asked.param_id.encode(), asked.param_value + step)]
    return vehicle


@pytest.mark.parametrize(
    ("number", "step", "outcome", "text"),
    [
        (1.5, 0.0, "ok", ""),
        (1.5, 1.0, "wrong", "A was set to 1.5 and came back as 2.5"),
        (0.0, NAN, "wrong", "A was set to 0 and came back as nan"),
    ],
)
def test_a_written_parameter_must_come_back_as_it_was_written(
    number: float, step: float, outcome: str, text: str
) -> None:
    found = examine(with_parameters({b"A": number}, step=step), "parameter-list", "parameter-set")
    assert found["parameter-list"].outcome == "ok"
    assert (found["parameter-set"].outcome, found["parameter-set"].text) == (outcome, text)


def test_an_integer_whose_bytes_are_a_nan_comes_back_as_it_was_written() -> None:
    vehicle = with_parameters({b"N": MINUS_ONE}, kind=mav.MAV_PARAM_TYPE_INT32)
    assert examine(vehicle, "parameter-list", "parameter-set")["parameter-set"].outcome == "ok"


def test_parameters_that_all_have_one_index_are_wrong() -> None:
    """Peers keep what is missing by its index, and would wait for 1 and 2."""
    finding = examine(with_parameters(dict.fromkeys((b"A", b"B", b"C"), 1.0), index=0), "parameter-list")[
        "parameter-list"
    ]
    assert (finding.outcome, finding.text) == ("wrong", "3 of 3 came, but none with param_index 1")


@pytest.mark.parametrize("every_s", [0.1, 3.0])
@pytest.mark.parametrize(
    ("stream", "message", "text"),
    [
        ("attitude", mav.MAVLink_attitude_message(0, NAN, 0, INF, 0, 0, 0), "roll is nan, yaw is inf"),
        ("local-position-ned", mav.MAVLink_local_position_ned_message(0, 0, 0, 0, 0, 0, -INF), "vz is -inf"),
    ],
)
def test_a_stream_without_numbers_is_wrong_however_often_it_comes(
    every_s: float, stream: str, message: Any, text: str
) -> None:
    vehicle = Scripted()
    vehicle.streams.append((every_s, lambda _: message))
    finding = examine(vehicle, f"stream-{stream}")[f"stream-{stream}"]
    assert (finding.outcome, finding.text, passed([finding])) == ("wrong", text, False)
