"""A vehicle's log as its only file by MAVFTP, read by pymavlink's frames, against the bytes that the test wrote."""

from __future__ import annotations

import random
import struct
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.log_protocol import PIECES_A_TICK
from tests.simvehicle.mavlink.test_log_protocol import WrittenLog

CONTENT = random.Random(3).randbytes(239 * 100 + 17)
TERMINATE, RESET, LIST, OPEN, READ, CREATE, WRITE, REMOVE, RENAME, BURST, ACK, NAK = (
    1, 2, 3, 4, 5, 6, 7, 8, 13, 15, 128, 129,
)  # fmt: skip
INVALID_SESSION, END_OF_FILE, UNKNOWN_COMMAND, NOT_FOUND = 4, 6, 7, 10


Answer = tuple[int, int, int, bytes]
"""(opcode, number, offset, data)"""


def read(messages: list[Any], asked: int | None = None, in_session: int = 0) -> list[Answer]:
    """MAVFTP's answers; those to a request name it and its session."""
    found = []
    for message in messages:
        if message.get_type() == "FILE_TRANSFER_PROTOCOL":
            assert (message.target_system, message.target_component) == (255, 190)
            raw = bytes(message.payload)
            number, session, opcode, size, of, _, offset = struct.unpack_from("<HBBBBBxI", raw)
            assert asked is None or (session, of) == (in_session, asked)
            found.append((opcode, number, offset, raw[12 : 12 + size]))
    return found


def ask(
    bench: Any, opcode: int, data: bytes = b"", *, session: int = 0, offset: int = 0, size: int = 0, number: int = 70
) -> list[Answer]:
    head = struct.pack("<HBBBBBxI", number, session, opcode, size or len(data), 0, 0, offset)
    payload = (head + data).ljust(251, b"\0")
    answers = bench.send(mav.MAVLink_file_transfer_protocol_message(0, bench.sysid, 1, list(payload)))
    return read(answers, opcode, session)


def test_the_log_is_opened_and_read_piece_by_piece(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    assert ask(bench, RESET) == [(ACK, 71, 0, b"")]
    assert ask(bench, OPEN, b"@LOG/4") == [(ACK, 71, 0, struct.pack("<I", len(CONTENT)))]
    for offset, size in ((0, 239), (239, 239), (100, 7), (len(CONTENT) - 5, 239)):
        assert ask(bench, READ, offset=offset, size=size) == [(ACK, 71, offset, CONTENT[offset : offset + size])]
    assert ask(bench, READ, offset=len(CONTENT), size=239)[0][::3] == (NAK, bytes([END_OF_FILE]))
    assert ask(bench, TERMINATE) == [(ACK, 71, 0, b"")]
    assert ask(bench, READ, size=239)[0][::3] == (NAK, bytes([INVALID_SESSION]))


@pytest.mark.parametrize("offset", [0, 239 * 40])
def test_a_burst_brings_the_rest_some_in_each_tick_and_then_its_end(vehicle_bench: Any, offset: int) -> None:
    log = WrittenLog(CONTENT)
    bench = vehicle_bench(log=log)
    ask(bench, OPEN, b"@LOG/4")
    log.content += b"what is written later is not of it"
    assert ask(bench, BURST, offset=offset, size=239) == []
    ticks = [read(bench.tick()) for _ in range(10)]
    answers = [answer for tick in ticks for answer in tick]
    assert b"".join(data for opcode, _, _, data in answers if opcode == ACK) == CONTENT[offset:]
    assert [at for opcode, _, at, _ in answers if opcode == ACK] == list(range(offset, len(CONTENT), 239))
    assert [number for _, number, _, _ in answers] == [71 + k for k in range(len(answers))]
    assert answers[-1][::3] == (NAK, bytes([END_OF_FILE]))
    assert max(map(len, ticks)) <= PIECES_A_TICK


def test_stations_read_their_own_files(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    ask(bench, OPEN, b"@LOG/4")
    for opcode, data in ((OPEN, b"/metadata/parameters.json.xz"), (RESET, b"")):
        head = struct.pack("<HBBBBBxI", 5, 0, opcode, len(data), 0, 0, 0)
        payload = list((head + data).ljust(251, b"\0"))
        (answer,) = bench.send(mav.MAVLink_file_transfer_protocol_message(0, bench.sysid, 1, payload), source=(9, 9))
        assert (bytes(answer.payload)[3], answer.target_system) == (ACK, 9)
        assert ask(bench, READ, offset=40, size=20) == [(ACK, 71, 40, CONTENT[40:60])]


def test_a_session_that_is_not_open_is_invalid_and_nothing_else_is_closed(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    invalid = [(NAK, 71, 0, bytes([INVALID_SESSION]))]
    assert ask(bench, TERMINATE) == invalid
    ask(bench, OPEN, b"@LOG/4")
    ask(bench, BURST, size=239)
    for opcode in (TERMINATE, READ, BURST):
        assert ask(bench, opcode, session=9) == invalid
    burst = [answer for _ in range(10) for answer in read(bench.tick())]
    assert b"".join(data for opcode, _, _, data in burst if opcode == ACK) == CONTENT
    assert ask(bench, TERMINATE) == [(ACK, 71, 0, b"")]
    assert ask(bench, TERMINATE, number=71) == [(NAK, 72, 0, bytes([INVALID_SESSION]))]


def test_a_request_that_comes_again_gets_the_same_answer_and_changes_nothing(vehicle_bench: Any) -> None:
    """https://mavlink.io/en/services/ftp.html: one with the last sequence number has lost its answer."""
    log = WrittenLog(CONTENT)
    bench = vehicle_bench(log=log)
    opened = ask(bench, OPEN, b"@LOG/4", number=1)
    piece = ask(bench, READ, offset=len(CONTENT) - 5, size=239, number=2)
    log.content += b"more"
    assert ask(bench, READ, offset=len(CONTENT) - 5, size=239, number=2) == piece
    for number, before in ((3, [(ACK, 4, 0, b"")]), (4, [(NAK, 5, 0, bytes([INVALID_SESSION]))])):
        for _ in range(3):
            assert ask(bench, TERMINATE, number=number) == before
    assert ask(bench, OPEN, b"@LOG/4", number=1) != opened  # not the last one, and the log is longer


def test_none_is_acknowledged_also_without_a_session(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    assert ask(bench, 0) == [(ACK, 71, 0, b"")]
    ask(bench, OPEN, b"@LOG/4")
    assert ask(bench, 0) == [(ACK, 71, 0, b"")]
    assert ask(bench, READ, size=239) == [(ACK, 71, 0, CONTENT[:239])]


def test_whatever_else_is_asked_ends_a_burst(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    ask(bench, OPEN, b"@LOG/4")
    ask(bench, BURST, size=239)
    assert ask(bench, TERMINATE) == [(ACK, 71, 0, b"")]
    assert read(bench.tick()) == []


@pytest.mark.parametrize(
    "path", [b"@LOG/5", b"@LOG/4/", b"/etc/passwd", b"../1.truth", b"@LOG/../4", b"", b"@LOG/4\0x", b"\xff" * 239]
)
def test_nothing_but_the_log_is_there(vehicle_bench: Any, path: bytes) -> None:
    bench = vehicle_bench(log=WrittenLog(CONTENT))
    assert ask(bench, OPEN, path)[0][::3] == (NAK, bytes([NOT_FOUND]))
    assert ask(bench, READ, size=239)[0][::3] == (NAK, bytes([INVALID_SESSION]))


@pytest.mark.parametrize("opcode", [LIST, CREATE, WRITE, REMOVE, RENAME, 9, 10, 11, 12, 14, 99, 255])
def test_nothing_is_written_or_looked_for(vehicle_bench: Any, opcode: int) -> None:
    log = WrittenLog(CONTENT)
    for bench in (vehicle_bench(log=log), vehicle_bench()):
        ask(bench, OPEN, b"@LOG/4")
        assert ask(bench, opcode, b"@LOG/4")[0][::3] == (NAK, bytes([UNKNOWN_COMMAND]))
    assert (log.content, log.number) == (CONTENT, 4)


def test_a_vehicle_without_a_log_has_none_to_open(vehicle_bench: Any) -> None:
    assert ask(vehicle_bench(), RESET) == [(ACK, 71, 0, b"")]
    assert ask(vehicle_bench(), OPEN, b"@LOG/1")[0][::3] == (NAK, bytes([NOT_FOUND]))
