"""A file read by MAVFTP, and ArduPilot's packed parameters: a scripted vehicle with ArduPilot's habits over a link that
loses, and pymavlink's own reader of the pack."""

from __future__ import annotations

import random
import struct
from typing import Any

import pytest
from arducopter_files import BURST, OPEN, PIECE_BYTES, READ, RESET, TERMINATE, Files, packed
from dialogue import converse
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav
from pymavlink.mavftp import MAVFTP

from gcs.mavlink.autopilots import ARDUCOPTER, PX4, Profile
from gcs.mavlink.ftp import file_client
from gcs.mavlink.ftp.file_client import FileClient
from gcs.mavlink.ftp.requests import FIRST_TRIES, FileRequests
from gcs.mavlink.parameters import pack
from gcs.mavlink.parameters.client import ParameterClient

PARAMETERS = {
    "ACRO_BAL_PITCH": (1.0, 4), "ACRO_BAL_ROLL": (0.0, 4), "ARMING_CHECK": (-1.0, 3), "BATT_LOW_TIMER": (10.0, 1),
    "COMPASS_OFS_X": (5.25, 4), "COMPASS_OFS_Y": (-3.0, 4), "RTL_ALT": (1500.0, 2), "SYSID_THISMAV": (3.0, 2),
}  # fmt: skip


@pytest.mark.parametrize("lose", [0.0, 0.2])
@pytest.mark.parametrize("size", [0, 1, PIECE_BYTES - 1, PIECE_BYTES, 30_000])
def test_a_file_comes_whole_whatever_the_link_loses(size: int, lose: float) -> None:
    content = random.Random(size).randbytes(size)
    server = Files({"@PARAM/param.pck": content}, lose=lose)
    client = FileClient(FileRequests(3, 1), "@PARAM/param.pck")
    took_s = converse(client, server)
    assert (client.content, client.problem) == (content, "")
    assert server.asked[:2] == [RESET, OPEN]
    if not lose:
        assert took_s < 0.5
        assert READ not in server.asked
        assert server.asked[-1] == TERMINATE


def test_a_number_that_another_reader_has_used_is_left() -> None:
    """A vehicle answers it with what it answered then, as PX4s do."""
    server = Files({"@PARAM/param.pck": b"whole"})
    one_more = struct.pack("<HBBBBBxI", 1, 0, OPEN, 4, 0, 0, 0) + b"none"
    server.hear(mav.MAVLink_file_transfer_protocol_message(0, 3, 1, list(one_more.ljust(251, b"\0"))))
    client = FileClient(FileRequests(3, 1), "@PARAM/param.pck")
    converse(client, server)
    assert (client.content, client.problem) == (b"whole", "")


@pytest.mark.parametrize(
    ("server", "why"),
    [
        (Files({}), "@PARAM/param.pck: it has no such file"),
        (Files({}, knows=False), "@PARAM/param.pck: it knows no such request"),
        (Files({}, lose=1.0), f"no answer to a request for @PARAM/param.pck, though it was asked {FIRST_TRIES} times"),
        (Files({"@PARAM/param.pck": bytes(20_001)}, burst=1 << 20), "has more than 20000 bytes"),
    ],
)
def test_what_does_not_come_is_said(server: Files, why: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(file_client, "LARGEST_BYTES", 20_000)
    client = FileClient(FileRequests(3, 1), "@PARAM/param.pck")
    converse(client, server)
    assert client.content is None
    assert client.problem.endswith(why)


def test_packed_parameters_are_read_as_pymavlink_reads_them() -> None:
    raw = packed(PARAMETERS)
    theirs = {name.decode(): number for name, number, _ in MAVFTP.ftp_param_decode(raw).params}
    assert {name: number for name, (number, _) in pack.unpack(raw).items()} == theirs
    assert theirs == {name: number for name, (number, _) in PARAMETERS.items()}
    kinds = {name: kind for name, (_, kind) in pack.unpack(raw).items()}
    assert kinds["RTL_ALT"] == mav.MAV_PARAM_TYPE_INT16
    assert kinds["ACRO_BAL_ROLL"] == mav.MAV_PARAM_TYPE_REAL32


@settings(derandomize=True, deadline=None, max_examples=60, database=None)
@given(st.binary(max_size=60), st.integers(0, 120), st.integers(0, 255))
def test_a_pack_that_is_no_pack_is_refused_as_such(noise: bytes, at: int, value: int) -> None:
    whole = packed(PARAMETERS)
    hurt = bytearray(whole)
    hurt[at % len(whole)] = value
    for raw in (noise, whole[: at % len(whole)], bytes(hurt), whole + noise):
        try:
            found = pack.unpack(raw)
        except ValueError:
            continue
        assert len(found) == struct.unpack_from("<H", raw, 2)[0]


class Copter(Files):
    """One that also answers the list."""

    def hear(self, heard: Any) -> list[Any]:
        if heard.get_type() == "PARAM_REQUEST_LIST":
            self.asked.append(-1)
            return [
                mav.MAVLink_param_value_message(name.encode(), number, 9, len(PARAMETERS), k)
                for k, (name, (number, _)) in enumerate(PARAMETERS.items())
            ]
        return super().hear(heard)


@pytest.mark.parametrize(
    ("profile", "files", "asked"),
    [
        (ARDUCOPTER, {"@PARAM/param.pck": packed(PARAMETERS)}, [RESET, OPEN, BURST, TERMINATE]),
        (ARDUCOPTER, {}, [RESET, OPEN, -1]),
        (ARDUCOPTER, {"@PARAM/param.pck": packed(PARAMETERS)[:-3]}, [RESET, OPEN, BURST, TERMINATE, -1]),
        (PX4, {}, [-1]),
    ],
)
def test_all_parameters_come_by_the_file_where_there_is_one_else_by_the_list(
    profile: Profile, files: dict[str, bytes], asked: list[int]
) -> None:
    client = ParameterClient(3, 1, profile)
    client.read_all()
    copter = Copter(files)
    converse(client, copter)
    assert copter.asked == asked
    assert {name: one.number for name, one in client.known.items()}.keys() == PARAMETERS.keys()
    assert client.incomplete == ""
    if profile is ARDUCOPTER:
        assert {name: one.number for name, one in client.known.items()} == {n: v for n, (v, _) in PARAMETERS.items()}


def test_what_a_float_cannot_tell_apart_is_read_from_the_file_before_it_is_written() -> None:
    """A list says 16777216 for both; the file has them whole."""
    int32 = mav.MAV_PARAM_TYPE_INT32
    client = ParameterClient(3, 1, ARDUCOPTER, dry_run=True)
    client.write({"A": 2**24 + 1, "B": 2**24 + 1, "C": 2**24})
    copter = Copter({"@PARAM/param.pck": packed({"A": (2**24 + 1, 3), "B": (2**24, 3), "C": (2**24 + 1, 3)})})

    class Rounding(Copter):
        def hear(self, heard: Any) -> list[Any]:
            if heard.get_type() == "PARAM_REQUEST_READ":
                return [mav.MAVLink_param_value_message(heard.param_id.encode(), 2.0**24, int32, 3, 65535)]
            return super().hear(heard)

    converse(client, Rounding(copter.files))
    outcomes = {result.name: result.outcome for result in client.results}
    assert outcomes == {"A": "kept", "B": "refused", "C": "would"}
