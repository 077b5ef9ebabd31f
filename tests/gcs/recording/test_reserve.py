"""Room that is kept is taken from the disk, given back when it is needed, and left behind by nobody."""

import os
from pathlib import Path

from gcs.recording.reserve import PER_SESSION_BYTES, PER_VEHICLE_BYTES, Reserve


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
