"""The folder of downloaded logs: what stays there of a log that did not come whole, against the log's own bytes."""

from __future__ import annotations

import itertools
import os
import random
import tempfile
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pymavlink.dialects.v20 import common as mav

from gcs.link.log_folder import KeptPart, LogFolder
from gcs.mavlink.log_client import LogClient

PIECES = 12
LOG = b"\xa3\x95" + random.Random(4).randbytes(90 * PIECES - 2)
PART = "vehicle-3-log-1-partial.bin"
STOPPED = " until now"


def begun(folder: Path, content: bytes = LOG, unix_s: int = 0) -> tuple[LogClient, LogFolder]:
    """A download into a folder of vehicle 3's log 1."""
    client = LogClient(3, 1, None)
    client.list_logs()
    client.poll(0.0)
    client.receive("LOG_ENTRY", mav.MAVLink_log_entry_message(1, 1, 1, unix_s, len(content)), 0.0)
    kept = LogFolder(folder, [client])
    client.download(kept.missing(client, [client.entries[1]]))
    client.poll(0.0)
    return client, kept


def send(client: LogClient, pieces: Iterable[int], content: bytes = LOG) -> None:
    for n in pieces:
        data = content[90 * n : 90 * n + 90]
        client.receive("LOG_DATA", mav.MAVLink_log_data_message(1, 90 * n, len(data), list(data.ljust(90, b"\0"))), 0.0)


def stopped(folder: Path, pieces: Iterable[int], content: bytes = LOG) -> tuple[str, list[KeptPart]]:
    """What is said of a download that these pieces came of, and the parts that it left."""
    client, kept = begun(folder, content)
    send(client, pieces, content)
    client.stop(STOPPED)
    kept.close()
    kept.close()
    return client.failed.get(1, ""), kept.parts


def only(pieces: Iterable[int]) -> bytes:
    """The log with zeros where no piece came, as far as any did."""
    there = set(pieces)
    whole = b"".join(LOG[90 * n : 90 * n + 90] if n in there else bytes(90) for n in range(PIECES))
    return whole[: 90 * (max(there) + 1)]


@settings(max_examples=60)
@given(st.lists(st.integers(0, PIECES - 1), max_size=PIECES - 1), st.integers(0, PIECES), st.booleans())
def test_what_came_stays_and_the_whole_log_takes_its_place(pieces: list[int], saved: int, stale: bool) -> None:
    """Whatever came, in whatever order and written when; also where a download that was killed has left its file."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if stale:
            (folder / ".vehicle-3-log-1.part").write_bytes(b"old" * 500)
        client, kept = begun(folder)
        send(client, pieces[:saved])
        kept.save()
        send(client, pieces[saved:])
        client.stop(STOPPED)
        kept.close()
        there = {path.name: path.read_bytes() for path in folder.iterdir()}
        if not pieces:
            assert (there, kept.parts) == ({}, [])
            assert client.failed == {1: f"0 of {len(LOG)} bytes came until now"}
        else:
            file = folder / (PART if 0 in pieces else "vehicle-3-log-1-partial.log")
            assert there == {file.name: only(pieces)}
            (row,) = kept.parts
            assert row[:5] == (3, 1, str(file), 90 * len(set(pieces)), len(LOG))
            missing = [n for n in range(PIECES) if n not in pieces]
            stop = next(n for n in range(missing[0], PIECES + 1) if n not in missing)
            assert row.first_gap == (90 * missing[0], 90 * stop)
            assert client.failed[1].endswith(f"are the first that are missing; what came is in {file}")

        client, kept = begun(folder)
        send(client, range(PIECES))
        kept.close()
        assert {path.name: path.read_bytes() for path in folder.iterdir()} == {"vehicle-3-log-1.bin": LOG}
        assert (client.failed, kept.parts) == ({}, [])


def test_a_shorter_part_does_not_replace_a_longer_one(tmp_path: Path) -> None:
    stopped(tmp_path, range(9))
    said, parts = stopped(tmp_path, range(2))
    assert said.endswith(f"; a longer part, which came earlier, is in {tmp_path / PART}")
    assert parts == []
    assert [path.read_bytes() for path in tmp_path.iterdir()] == [only(range(9))]
    stopped(tmp_path, range(10))
    assert [path.read_bytes() for path in tmp_path.iterdir()] == [only(range(10))]


def test_a_part_of_another_log_of_that_number_is_left_as_it_is(tmp_path: Path) -> None:
    """An autopilot that has forgotten its logs begins with number 1 again, without a time where it has none."""
    other = b"\xa3\x95" + random.Random(5).randbytes(len(LOG) - 2)
    stopped(tmp_path, range(3), other)
    said, parts = stopped(tmp_path, range(5))
    assert said.endswith(f"; {tmp_path / PART} holds a part of another log and is left as it is; give another --out")
    assert parts == []
    client, kept = begun(tmp_path)
    send(client, range(PIECES))
    kept.close()
    there = {path.name: path.read_bytes() for path in tmp_path.iterdir()}
    assert there == {PART: other[:270], "vehicle-3-log-1.bin": LOG}
    assert client.failed == {}


def test_what_cannot_be_written_is_named_once_and_leaves_nothing(tmp_path: Path) -> None:
    """A name in the folder's place of the file, which no user, root neither, can write through."""
    (tmp_path / ".vehicle-3-log-1.part").symlink_to(tmp_path / "elsewhere")
    said, parts = stopped(tmp_path, range(3))
    assert said.startswith(f"{tmp_path}/.vehicle-3-log-1.part cannot be written: ")
    assert parts == []
    assert list(tmp_path.iterdir()) == []


def test_a_copy_that_cannot_be_made_is_named(tmp_path: Path) -> None:
    (tmp_path / ".vehicle-3-log-1.copy").mkdir()
    said, parts = stopped(tmp_path, range(3))
    assert said.endswith(f"missing; what came cannot be kept in {tmp_path}: Is a directory")
    assert parts == []


def test_ctrl_c_while_it_is_written_loses_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It comes at any write; what had come then is in the part."""
    client, kept = begun(tmp_path)
    send(client, range(6))
    real, calls = os.pwrite, itertools.count()

    def interrupted(*arguments: Any) -> int:
        if next(calls) == 3:
            raise KeyboardInterrupt
        return real(*arguments)

    monkeypatch.setattr(os, "pwrite", interrupted)
    with pytest.raises(KeyboardInterrupt):
        kept.save()
    client.stop(STOPPED)
    kept.close()
    assert [path.read_bytes() for path in tmp_path.iterdir()] == [only(range(6))]
