"""The dialogue about logs with a scripted vehicle that pymavlink speaks for, over a link that loses."""

import itertools
import random
import tracemalloc
from typing import Any

import pytest
from arducopter_files import BURST, FAIL, NAK, OPEN, READ, RESET, TERMINATE, Files
from dialogue import converse
from hypothesis import given
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import ARDUCOPTER, PX4
from gcs.mavlink.ftp.received_ranges import MOST_RANGES, ReceivedRanges
from gcs.mavlink.log_client import TRIES, LogClient, LogEntry

PIECES_A_TICK = 20


class Vehicle:
    """Its logs by number. It sends as ArduPilot does: one range at a time, some pieces of 90 bytes a tick."""

    def __init__(self, logs: dict[int, bytes], lose: float = 0.0, files: Files | None = None) -> None:
        """`files`: its MAVFTP; None: it answers that it knows no file."""
        self.logs, self.lose = logs, lose
        self.files = files or Files({})
        self.random = random.Random(8)
        self.asked: list[str] = []
        self.announced: dict[int, int] = {}
        """sizes by number that are not those of the logs"""
        self.pieces = 0
        self._sending: tuple[int, int, int] | None = None

    def hear(self, heard: Any) -> list[Any]:
        """What it answers at once."""
        if heard.get_type() == "FILE_TRANSFER_PROTOCOL":
            return self.files.hear(heard)
        self.asked.append(heard.get_type())
        match heard.get_type():
            case "LOG_REQUEST_LIST":
                sizes = {number: self.announced.get(number, len(log)) for number, log in self.logs.items()}
                entries = [(number, len(sizes), max(sizes), 1000 + number, size) for number, size in sizes.items()]
                return [mav.MAVLink_log_entry_message(*entry) for entry in entries or [(0, 0, 0, 0, 0)]]
            case "LOG_REQUEST_DATA":
                self._sending = (heard.id, heard.ofs, heard.ofs + heard.count)
            case "LOG_REQUEST_END":
                self._sending = None
        return []

    def tick(self, _: float) -> list[Any]:
        out: list[Any] = []
        while self._sending is not None and len(out) < PIECES_A_TICK:
            number, at, stop = self._sending
            data = self.logs[number][at : min(at + 90, stop)]
            out.append(mav.MAVLink_log_data_message(number, at, len(data), [*data, *[0] * (90 - len(data))]))
            self._sending = (number, at + 90, stop) if at + 90 < stop and len(data) == 90 else None
        self.pieces += len(out)
        return out


def came(client: LogClient) -> dict[int, bytes]:
    """Whole logs, from their pieces in the order in which these came."""
    logs = {number: bytearray(entry.size_bytes) for number, entry in client.whole.items()}
    for number, offset, data in client.pieces:
        if number in logs:
            logs[number][offset : offset + len(data)] = data
    return {number: bytes(content) for number, content in logs.items()}


def log(size: int) -> bytes:
    return random.Random(size).randbytes(size)


LOGS = {0: b"", 3: log(89), 4: log(90), 5: log(90 * 700), 9: log(100_001)}


@pytest.mark.parametrize("lose", [0.0, 0.02, 0.3])
def test_every_log_comes_whole_whatever_the_link_loses(lose: float) -> None:
    client, vehicle = LogClient(3, 1), Vehicle(LOGS, lose)
    client.list_logs()
    converse(client, vehicle)
    assert client.entries == {number: LogEntry(number, len(content), 1000 + number) for number, content in LOGS.items()}
    client.download(list(client.entries.values()))
    converse(client, vehicle)
    assert came(client) == LOGS
    assert not client.failed
    if not lose:
        assert vehicle.pieces == sum(-(-len(content) // 90) for content in LOGS.values())
        assert vehicle.asked.count("LOG_REQUEST_DATA") == 4
        assert vehicle.asked[-1] == "LOG_REQUEST_END"
        assert client.bytes_so_far == sum(map(len, LOGS.values()))


@pytest.mark.parametrize("lose", [0.0, 0.1])
def test_as_files_they_come_by_mavftp_as_far_as_they_were_listed(lose: float) -> None:
    """One of them has grown since, and of one the file is another's and shorter: that comes by ranges."""
    files = Files({f"@LOG/{number}": content for number, content in LOGS.items()}, lose=lose)
    files.files["@LOG/5"] += b"more"
    vehicle = Vehicle(LOGS, lose, files)
    client = LogClient(3, 1)
    client.list_logs()
    converse(client, vehicle)
    client.download(list(client.entries.values()))
    converse(client, vehicle)
    assert came(client) == LOGS
    assert vehicle.asked.count("LOG_REQUEST_DATA") == 0
    assert client.bytes_so_far == sum(map(len, LOGS.values()))
    if not lose:
        assert files.asked[:4] == [RESET, OPEN, BURST, TERMINATE]
        assert READ not in files.asked

    files.files["@LOG/9"] = b"short"
    again = LogClient(3, 1)
    again.download([LogEntry(9, 100_001, 0)])
    converse(again, vehicle)
    assert came(again) == {9: LOGS[9]}
    assert vehicle.asked.count("LOG_REQUEST_DATA") >= 1


PX4_FOLDERS = PX4.log_folders


@pytest.mark.parametrize("lose", [0.0, 0.1])
def test_a_px4s_logs_are_found_in_its_folders_by_their_size(lose: float) -> None:
    """Its newest one, and one of the day before; the folders hold more than goes into one answer."""
    older, newer = log(90 * 700), log(100_001)
    days = {f"log/2026-10-{day:02}/11_22_33.ulg": log(day) for day in range(1, 31)}
    flights = {f"log/2026-11-22/{hour:02}_00_00.ulg": log(50 + hour) for hour in range(24)}
    paths = {"log/2026-11-22/23_59_07.ulg": older, "log/2026-11-23/00_10_11.ulg": newer}
    files = Files({**days, **flights, **paths, "log/data/x": b""}, lose=lose)
    vehicle = Vehicle({0: older, 1: newer}, lose, files)
    client = LogClient(3, 1, PX4_FOLDERS)
    client.download([LogEntry(0, len(older), 0), LogEntry(1, len(newer), 0)])
    converse(client, vehicle)
    assert came(client) == {0: older, 1: newer}
    assert "LOG_REQUEST_DATA" not in vehicle.asked


def test_a_log_of_which_two_files_have_the_size_comes_by_ranges() -> None:
    content, other = log(1000), log(999) + b"x"
    vehicle = Vehicle({0: content}, files=Files({"log/2026-11-23/1.ulg": other, "log/2026-11-23/2.ulg": content}))
    client = LogClient(3, 1, PX4_FOLDERS)
    client.download([LogEntry(0, len(content), 0)])
    converse(client, vehicle)
    assert came(client) == {0: content}
    assert vehicle.asked.count("LOG_REQUEST_DATA") == 1


class Mute(Files):
    """MAVFTP that never answers, as where there is none."""

    def hear(self, heard: Any) -> list[Any]:
        self.asked.append(heard.payload[3])
        return []


def test_where_no_mavftp_answers_folders_are_not_searched() -> None:
    vehicle = Vehicle({0: log(1000)}, files=Mute({}))
    client = LogClient(3, 1, PX4_FOLDERS)
    client.download([LogEntry(0, 1000, 0)])
    assert converse(client, vehicle) < 4.0
    assert came(client) == vehicle.logs
    assert set(vehicle.files.asked) == {RESET}


def test_files_that_are_not_there_to_be_had_are_not_asked_for() -> None:
    vehicle = Vehicle({0: log(1000)}, files=Files({"log/1.ulg": log(1000)}))
    client = LogClient(3, 1, ARDUCOPTER.log_folders)
    client.download([LogEntry(0, 1000, 0)])
    converse(client, vehicle)
    assert came(client) == vehicle.logs
    assert vehicle.files.asked == []


def test_what_does_not_come_is_a_sentence() -> None:
    silent = LogClient(3, 1)
    silent.list_logs()
    converse(silent, Vehicle(LOGS, lose=1.0))
    assert silent.list_problem.startswith("no list of its logs came, though it was asked 8 times")
    shorter = Vehicle({1: log(900)})
    shorter.announced[1] = 1800
    client = LogClient(3, 1)
    client.list_logs()
    converse(client, shorter)
    client.download([*client.entries.values(), LogEntry(2, 1 << 30, 0)])
    converse(client, shorter)
    missing = "bytes 900 to 1799 are the first that are missing"
    assert client.failed[1] == f"900 of 1800 bytes came, then nothing, though it was asked {TRIES} times; {missing}"
    assert client.failed[2].startswith("it is said to have 1073741824 bytes")
    assert not client.whole


def test_what_came_by_mavftp_is_not_asked_for_again() -> None:
    """A file whose reading fails on the way goes on by ranges from there."""
    content = log(90 * 700)

    class Failing(Files):
        def answers(self, session: int, opcode: int, size: int, offset: int, data: bytes) -> list[Any]:
            if opcode == BURST and offset >= 239 * 80:
                return [self.say(NAK, opcode, bytes([FAIL]))]
            return super().answers(session, opcode, size, offset, data)

    vehicle = Vehicle({1: content}, files=Failing({"@LOG/1": content}))
    client = LogClient(3, 1)
    client.download([LogEntry(1, len(content), 0)])
    converse(client, vehicle)
    assert came(client) == {1: content}
    assert vehicle.pieces == -(-(len(content) - 239 * 80) // 90)


def test_a_download_that_is_stopped_says_what_came_and_ends_it_on_the_vehicle() -> None:
    client = claimed(3, 900)
    assert [codec.name(message.msgid) for message in client.stop(" until now")] == ["LOG_REQUEST_END"]
    assert client.done
    assert client.failed == {1: "90 of 900 bytes came until now; bytes 0 to 809 are the first that are missing"}
    assert list(client.parts[1]) == [(810, 900)]
    assert client.stop(" again") == []


def claimed(sysid: int, size_bytes: int) -> LogClient:
    """A client that a vehicle has told of a log, and sent the last piece of it."""
    client = LogClient(sysid, 1, None)
    client.list_logs()
    client.poll(0.0)
    entry = mav.MAVLink_log_entry_message(1, 1, 1, 0, size_bytes)
    last = mav.MAVLink_log_data_message(1, size_bytes - 90, 90, [1] * 90)
    client.receive("LOG_ENTRY", entry, 0.0)
    client.download([client.entries[1]])
    client.poll(0.0)
    client.receive("LOG_DATA", last, 0.0)
    return client


def test_memory_goes_by_what_came_and_not_by_what_is_claimed() -> None:
    """200 vehicles claim 500 MB each, and send one piece from the end."""
    claimed(1, 90)
    tracemalloc.start()
    try:
        clients = [claimed(sysid, 500_000_040) for sysid in range(1, 201)]
        _, most_bytes = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert [client.bytes_so_far for client in clients] == [90] * 200
    assert most_bytes < 200 * 16_000


@given(st.lists(st.tuples(st.integers(0, 60), st.integers(1, 12)), max_size=60), st.integers(0, 8))
def test_ranges_hold_what_a_set_of_bytes_holds(added: list[tuple[int, int]], near: int) -> None:
    ranges, held = ReceivedRanges(), set[int]()
    for start, size in added:
        end = ranges.add(start, start + size)
        new = set()
        for at in range(start, start + size):
            if at in held:
                break
            new.add(at)
        assert new == set(range(start, end))
        held |= new
        assert ranges.size_bytes == len(held)
    first = next(at for at in itertools.count() if at not in held)
    assert ranges.first_missing == first
    begin, end = ranges.missing(100, near)
    assert begin == first
    runs = itertools.groupby(range(first, end), held.__contains__)
    assert all(len(list(run)) <= near for there, run in runs if there)
    assert end == 100 or (end in held and all(at in held for at in range(end, end + near + 1)))


def test_what_would_break_a_file_up_further_is_not_taken() -> None:
    ranges = ReceivedRanges()
    for n in range(MOST_RANGES):
        assert ranges.add(2 * n + 1, 2 * n + 2) == 2 * n + 2
    assert ranges.add(10**6, 10**6 + 1) == 10**6
    assert ranges.add(2, 3) == 3
    assert ranges.add(10**6, 10**6 + 1) == 10**6 + 1
