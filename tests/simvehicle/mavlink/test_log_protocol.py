"""Logs of a vehicle as pymavlink downloads them, against the bytes that the test wrote itself."""

import random
from typing import Any

import pytest
from pymavlink.dialects.v20 import common as mav

from simvehicle.mavlink.log_protocol import PIECES_A_TICK

CONTENT = random.Random(3).randbytes(90 * 100 + 17)


class WrittenLog:
    """A log of these bytes."""

    def __init__(self, content: bytes = CONTENT) -> None:
        self.content, self.number, self.unix_s = content, 4, 1_700_000_000
        self.broken = False

    @property
    def size_bytes(self) -> int:
        return len(self.content)

    def read(self, offset: int, count: int) -> bytes:
        if self.broken:
            raise OSError(5, "Input/output error")
        return self.content[offset : offset + count]

    def erase(self) -> None:
        self.content, self.number = b"", self.number + 1


def entry(bench: Any, first: int = 0, last: int = 0xFFFF) -> tuple[int, ...]:
    (answer,) = bench.send(mav.MAVLink_log_request_list_message(bench.sysid, 1, first, last))
    assert answer.get_type() == "LOG_ENTRY"
    return answer.id, answer.num_logs, answer.last_log_num, answer.time_utc, answer.size


def pieces(bench: Any, offset: int = 0, count: int = 0xFFFFFFFF, number: int = 4) -> list[tuple[int, int, bytes]]:
    """LOG_DATA after a request, as (tick, offset, data)."""
    bench.send(mav.MAVLink_log_request_data_message(bench.sysid, 1, number, offset, count))
    got = []
    for tick in range(20):
        for message in bench.tick():
            if message.get_type() == "LOG_DATA":
                assert message.id == number
                got.append((tick, message.ofs, bytes(message.data[: message.count])))
    return got


def test_a_log_is_listed_where_it_is_in_the_range_asked_for(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog())
    assert entry(bench) == (4, 1, 4, 1_700_000_000, len(CONTENT))
    assert entry(bench, 4, 4) == entry(bench)
    assert entry(bench, 5, 9) == (0, 0, 4, 0, 0)
    assert entry(vehicle_bench()) == (0, 0, 0, 0, 0)


@pytest.mark.parametrize(
    ("offset", "count"), [(0, 0xFFFFFFFF), (0, len(CONTENT)), (180, 91), (90, 90), (9017, 90), (10_000, 5), (0, 0)]
)
def test_any_range_comes_in_order_and_a_short_piece_ends_the_log(vehicle_bench: Any, offset: int, count: int) -> None:
    got = pieces(vehicle_bench(log=WrittenLog()), offset, count)
    assert b"".join(data for _, _, data in got) == CONTENT[offset : offset + count]
    assert [at for _, at, _ in got] == [offset + 90 * i for i in range(len(got))]
    assert all(len(data) == 90 for _, _, data in got[:-1])
    assert max(sum(t == tick for t, _, _ in got) for tick in range(20)) <= PIECES_A_TICK


def test_a_new_request_replaces_the_old_one_and_end_ends_it(vehicle_bench: Any) -> None:
    bench = vehicle_bench(log=WrittenLog())
    bench.send(mav.MAVLink_log_request_data_message(1, 1, 4, 0, 0xFFFFFFFF))
    assert [at for _, at, _ in pieces(bench, 900, 90)] == [900]
    bench.send(mav.MAVLink_log_request_data_message(1, 1, 4, 0, 0xFFFFFFFF))
    bench.send(mav.MAVLink_log_request_end_message(1, 1))
    assert "LOG_DATA" not in {message.get_type() for message in bench.tick()}
    assert pieces(bench, number=3) == []


def test_erased_is_erased_and_a_log_that_cannot_be_read_stops_nothing(vehicle_bench: Any) -> None:
    log = WrittenLog()
    bench = vehicle_bench(log=log)
    bench.send(mav.MAVLink_log_erase_message(1, 1))
    assert entry(bench) == (5, 1, 5, 1_700_000_000, 0)
    log.broken = True
    assert pieces(bench, number=5) == [(0, 0, b"")]
    for message in (mav.MAVLink_log_request_data_message(1, 1, 5, 0, 90), mav.MAVLink_log_erase_message(1, 1)):
        assert vehicle_bench().send(message) == []  # without a log
