"""Samples as a .tlog."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from itertools import count
from pathlib import Path

from gcs.mavlink import codec
from gcs.mavlink.ids import AUTOPILOT
from gcs.recording.importing.sample import Sample
from gcs.recording.tlog_walk import TIME_BYTES

PERIOD_US = 100_000
"""[choice] Motion is written ten times a second at most, as vehicles of ours send it: logs hold up to 400."""
SLACK_US = PERIOD_US // 4
"""[choice] A sample may come so early: all of a log's ten a second are written, though they jitter."""
THINNED = frozenset({"LOCAL_POSITION_NED", "GLOBAL_POSITION_INT", "ATTITUDE", "GPS_GLOBAL_ORIGIN"})


def write(path: Path, samples: Iterator[Sample]) -> int:
    """Write samples in their order; how many there were. Raises OSError, and whatever reading them raises."""
    numbers: dict[int, count[int]] = defaultdict(count)
    due_us: dict[tuple[int, str], int] = {}
    written = 0
    with path.open("wb") as file:
        for t_us, sysid, message, fields in samples:
            if message in THINNED:
                key = (sysid, message)
                due = due_us.get(key, t_us)
                if due - PERIOD_US - SLACK_US <= t_us < due - SLACK_US:
                    continue
                due_us[key] = PERIOD_US + (due if abs(t_us - due) < PERIOD_US else t_us)
            seq = next(numbers[sysid]) % 256
            frame = codec.encode(message, seq, sysid, AUTOPILOT, **fields)
            file.write(max(t_us, 0).to_bytes(TIME_BYTES, "big") + frame)
            written += 1
    return written
