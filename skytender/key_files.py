"""Signing keys on disk, and the time stamps beside them, for the station and for vehicles.

A key is 64 hexadecimal digits in a file that only its user can read. Its time stamps stand in a second file, so that a
frame of an earlier run cannot be sent again: the latest stamp, and that of every stream.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import stat
from pathlib import Path

from skytender.signing import KEY_BYTES, TICKS_PER_S, Signing, Stream, ticks

SAVE_EVERY_S = 5.0
AHEAD_TICKS = 2 * int(SAVE_EVERY_S) * TICKS_PER_S
"""Saved stamps are later than the clock's by this much: a run that is killed has used none beyond that."""
MOST_BYTES = 1 << 18


class KeyRefused(Exception):
    """A key file that cannot be used; one sentence: which, why, and what to do."""


def read_key(path: Path) -> bytes:
    """The key in a file that only its user can read. Raises KeyRefused."""
    try:
        with path.open("rb") as file:
            mode = os.fstat(file.fileno()).st_mode
            content = file.read(4 * KEY_BYTES)
    except OSError as error:
        raise KeyRefused(f"the key file {path} cannot be read: {error.strerror}; `gcs key new` writes one") from None
    if not stat.S_ISREG(mode) or stat.S_IMODE(mode) & 0o077:
        raise KeyRefused(f"the key file {path} can be read by others: chmod 600 {path}")
    with contextlib.suppress(ValueError):
        key = bytes.fromhex(content.decode("ascii"))
        if len(key) == KEY_BYTES:
            return key
    raise KeyRefused(
        f"the key file {path} holds no key of {2 * KEY_BYTES} hexadecimal digits; `gcs key new` writes one"
    )


def write_private(path: Path, text: str) -> None:
    """Write a file that only its user can read, whole or not at all. Raises OSError."""
    new = path.with_name(f"{path.name}.{os.getpid()}")
    descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o600)
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        file.write(text)
    os.replace(new, path)


class StampFile:
    """The time stamps of one key on disk. They are written every few seconds, some time ahead, and at the end."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._saved_s = -math.inf

    def read(self) -> tuple[int, dict[Stream, int]]:
        """The latest stamp, and that of each stream; (0, {}) where there is no file yet. Raises KeyRefused."""
        try:
            with self._path.open("rb") as file:
                content = json.loads(file.read(MOST_BYTES))
            streams = {(int(s), int(c), int(link)): int(stamp) for s, c, link, stamp in content["streams"]}
            return int(content["latest"]), streams
        except FileNotFoundError:
            return 0, {}
        except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
            raise KeyRefused(f"{self._path} holds no time stamps: mend it, or delete it to begin anew") from None

    def save_ahead(self, signing: Signing, now_s: float) -> None:
        """Write stamps that hold until the next call that is due, if one is due at this Unix time."""
        if now_s - self._saved_s >= SAVE_EVERY_S or now_s < self._saved_s:
            self._saved_s = now_s
            self.save(signing, max(ticks(now_s) + AHEAD_TICKS, signing.latest + TICKS_PER_S))

    def save(self, signing: Signing, latest: int | None = None) -> None:
        """Write the stamps; the latest is that of `signing` unless one is given."""
        rows = [[*stream, stamp] for stream, stamp in sorted(signing.streams.items())]
        text = json.dumps({"latest": signing.latest if latest is None else latest, "streams": rows})
        with contextlib.suppress(OSError):  # a full disk ends no flight
            write_private(self._path, text)
