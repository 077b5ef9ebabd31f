"""Room that is kept is taken from the disk, given back when it is needed, and left behind by nobody."""

import errno
import os
import sys
from pathlib import Path

import pytest
from small_disk import run_on_small_disk

from gcs.recording.reserve import PER_SESSION_BYTES, PER_VEHICLE_BYTES, Reserve
from gcs.recording.summary import RefuellingSummary
from gcs.refuelling.service import Service


def kept_bytes(folder: Path) -> list[int]:
    """What the files take of the disk that this process holds open below `folder` and that have no name there."""
    held = []
    for fd in map(int, os.listdir("/proc/self/fd")):
        try:
            if os.readlink(f"/proc/self/fd/{fd}").startswith(str(folder)):
                held.append(os.fstat(fd).st_blocks * 512)
        except OSError:
            continue
    return held


def test_the_room_is_taken_without_a_name_and_given_back(tmp_path: Path) -> None:
    reserve = Reserve(tmp_path, 254)
    (held,) = kept_bytes(tmp_path)
    assert held >= PER_SESSION_BYTES + 254 * PER_VEHICLE_BYTES
    assert not list(tmp_path.iterdir())
    reserve.release()
    assert not kept_bytes(tmp_path)
    reserve.release()


def served(count: int, rivals: int) -> list[Service]:
    """So many services with the longest figures that a day has."""
    bids = dict.fromkeys(range(100, 100 + rivals), 1.2345678901234568e-05)
    seconds = dict.fromkeys(("decided_at_s", "joined_at_s", "start_s", "end_s"), 86399.9001234567)
    return [Service(k, 101, 201, "competition", bids, energy_j=100_000_000, **seconds) for k in range(count)]


def written_bytes(services: list[Service]) -> int:
    """What these take as JSON that is indented as in a summary, three levels deep."""
    texts = (RefuellingSummary(**one.record()).model_dump_json(indent=2) for one in services)
    return sum(len(text) + 4 * (text.count("\n") + 1) for text in texts)


@pytest.mark.parametrize(("count", "rivals"), [(1000, 1), (100, 120)])
def test_the_room_grows_with_every_refuelling(tmp_path: Path, count: int, rivals: int) -> None:
    reserve, services = Reserve(tmp_path, 2), served(count, rivals)
    for known in range(0, count + 1, 10):
        reserve.keep_for(services[:known])
        assert sum(kept_bytes(tmp_path)) >= PER_SESSION_BYTES + written_bytes(services[:known])
    assert sum(kept_bytes(tmp_path)) < PER_SESSION_BYTES + 2 * written_bytes(services)
    reserve.release()
    assert not kept_bytes(tmp_path)


FILLED = """
from pathlib import Path
from test_reserve import Reserve, served, written_bytes
folder = Path("disk")
reserve, services = Reserve(folder, 2), served(2000, 1)
for known in range(1, 2001):
    try:
        reserve.keep_for(services[:known])
    except OSError as full:
        error = full
        break
reserve.release()
(folder / "summary").write_bytes(bytes(written_bytes(services[: known - 1])))
print(known, error.errno, error.filename)
"""


def test_a_disk_without_room_to_grow_is_full_while_what_was_kept_suffices(tmp_path: Path) -> None:
    env = {**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(__file__).parent), *sys.path])}
    done = run_on_small_disk("300k", '"$@"', [sys.executable, "-c", FILLED], tmp_path, env)
    assert done.returncode == 0, done.stderr
    known, number, place = done.stdout.split()
    assert 200 < int(known) < 800
    assert (int(number), place) == (errno.ENOSPC, "disk")
