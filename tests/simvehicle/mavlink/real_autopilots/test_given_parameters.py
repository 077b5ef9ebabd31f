"""Parameters that an autopilot was given, read back: every type by both encodings, with struct as the truth."""

from __future__ import annotations

import struct

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.codec import split
from simvehicle.mavlink.real_autopilots.given_parameters import ASK_EVERY_S, TRIES, GivenParameters

FORMS = dict(zip(range(1, 7), "BbHhIi", strict=True)) | {9: "f"}
OUT = mav.MAVLink(None, 7, 1)


def said(name: str, number: float, kind: int, *, bytewise: bool) -> bytes:
    raw = struct.pack("<" + (FORMS[kind] if bytewise else "f"), number if kind == 9 or not bytewise else int(number))
    (wire,) = struct.unpack("<f", raw.ljust(4, b"\0"))
    return bytes(mav.MAVLink_param_value_message(name.encode(), wire, kind, 1, 65535).pack(OUT))


def hear(given: GivenParameters, frame: bytes) -> None:
    for one in split(frame):
        given.receive(one)


@pytest.mark.parametrize("bytewise", [True, False])
@pytest.mark.parametrize("kind", FORMS)
@pytest.mark.parametrize(("held", "why"), [(7.0, {}), (5.0, {"A": "it keeps 5"})])
def test_what_it_keeps_is_compared_with_what_it_was_given(
    bytewise: bool, kind: int, held: float, why: dict[str, str]
) -> None:
    given = GivenParameters(7, {"A": 7.0}, bytewise=bytewise)
    (asked,) = given.requests(0.0)
    assert (asked.param_id, asked.param_index, asked.target_system) == ("A", -1, 7)
    hear(given, said("A", held, kind, bytewise=bytewise))
    assert given.done
    assert given.not_taken == why


def test_a_fraction_is_compared_as_a_single_holds_it() -> None:
    given = GivenParameters(7, {"A": 0.1}, bytewise=True)
    hear(given, said("A", 0.1, 9, bytewise=True))
    assert given.done
    assert not given.not_taken


def test_one_that_it_does_not_know_is_named_whether_it_says_so_or_not() -> None:
    given = GivenParameters(7, {"A": 1.0, "B": 2.0}, bytewise=True)
    assert len(given.requests(0.0)) == 2
    assert not given.requests(0.1)
    hear(given, bytes(mav.MAVLink_param_error_message(255, 190, b"A", -1, 1).pack(OUT)))
    for number in range(1, TRIES + 1):
        assert not given.done
        asked = given.requests(number * ASK_EVERY_S)
        assert [one.param_id for one in asked] == ([] if number == TRIES else ["B"])
    assert given.done
    assert given.not_taken == dict.fromkeys("AB", "it does not know it")
