"""Signing keys on disk, and the time stamps beside them: 64 hexadecimal digits in a file that only its user can read.

The stamps of a key stand in KEYFILE.stamps, so that a frame of an earlier run cannot be sent again: the latest, and
that of every stream. They are written every few seconds, some time ahead, and at the end.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import secrets
import stat
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from skytender.signing import KEY_BYTES, SETUP_SIGNING, TICKS_PER_S, SignatureVerdict, Signing, ticks, without_key

SAVE_EVERY_S = 5.0
AHEAD_TICKS = 2 * int(SAVE_EVERY_S) * TICKS_PER_S
"""So much later than the clock's are the saved ones: a run that is killed has used none beyond that."""
MOST_BYTES = 1 << 18
SAY_AGAIN_S = 10.0


class KeyRefused(Exception):
    """A key file that cannot be used; one sentence: which, why, and what to do."""


def new_key(path: Path, key: bytes | None = None) -> None:
    """Write a new random key, or this one, to a file that must not exist yet. Raises KeyRefused."""
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o600)
    except FileExistsError:
        raise KeyRefused(f"{path} exists already and is left as it is; give another name") from None
    except OSError as error:
        raise KeyRefused(f"{path} cannot be written: {error.strerror}") from None
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        os.fchmod(descriptor, 0o600)
        file.write((key or secrets.token_bytes(KEY_BYTES)).hex() + "\n")


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


class LinkSigning:
    """The signing of one link with a key of a file: judges, signs, counts refusals, and keeps the stamps on disk."""

    def __init__(self, path: Path, link_id: int = 0, clock: Callable[[], float] = time.time) -> None:
        """Read the key and its stamps. Raises KeyRefused."""
        self._path = path.with_name(path.name + ".stamps")
        self._clock = clock
        latest, streams = self._read_stamps()
        self._signing, self._link_id = Signing(read_key(path), latest=latest, streams=streams), link_id
        self._saved_s = -math.inf

    def sign(self, raw: bytes) -> bytes:
        """A frame, signed."""
        now_s = self._clock()
        if now_s - self._saved_s >= SAVE_EVERY_S or now_s < self._saved_s:
            self._saved_s = now_s
            self._save(max(ticks(now_s) + AHEAD_TICKS, self._signing.latest + TICKS_PER_S))
        return self._signing.sign(raw, codec.seed_of(raw), self._link_id, ticks(now_s))

    def judge(self, frame: Frame) -> SignatureVerdict:
        """Whether a received frame counts."""
        return self._signing.judge(frame.raw, frame.msgid, ticks(self._clock()))

    def close(self) -> None:
        """Leave the stamps as they are now."""
        self._save(self._signing.latest)

    def _read_stamps(self) -> tuple[int, dict[tuple[int, int, int], int]]:
        try:
            with self._path.open("rb") as file:
                content = json.loads(file.read(MOST_BYTES))
            streams = {(int(s), int(c), int(link)): int(stamp) for s, c, link, stamp in content["streams"]}
            return int(content["latest"]), streams
        except FileNotFoundError:
            return 0, {}
        except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
            raise KeyRefused(f"{self._path} holds no time stamps: mend it, or delete it to begin anew") from None

    def _save(self, latest: int) -> None:
        rows = [[*stream, stamp] for stream, stamp in sorted(self._signing.streams.items())]
        text = json.dumps({"latest": latest, "streams": rows})
        new = self._path.with_name(f"{self._path.name}.{os.getpid()}")
        with contextlib.suppress(OSError):  # a full disk ends no flight
            descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o600)
            with os.fdopen(descriptor, "w", encoding="ascii") as file:
                file.write(text)
            os.replace(new, self._path)


class SignatureGate:
    """Lets frames to and from one address pass by their signatures: with a key only those signed with it, and a short
    list of messages; without a key only those that are not signed. A message that carries a key never passes."""

    def __init__(self, key_file: Path | None, link_id: int = 0) -> None:
        """Raises KeyRefused."""
        self._signing = None if key_file is None else LinkSigning(key_file, link_id)
        self.refused: Counter[int] = Counter()
        """frames refused, by system id"""
        self.reasons: dict[int, SignatureVerdict] = {}
        """why the last of them was"""

    @property
    def has_key(self) -> bool:
        """Whether only what is signed passes."""
        return self._signing is not None

    def accepted(self, frames: Sequence[Frame]) -> list[Frame]:
        """The frames that pass."""
        passed = []
        for frame in frames:
            verdict = without_key(frame.raw) if self._signing is None else self._signing.judge(frame)
            if verdict is not SignatureVerdict.GOOD:
                self.refused[frame.sysid] += 1
                self.reasons[frame.sysid] = verdict
            elif frame.msgid != SETUP_SIGNING:
                passed.append(frame)
        return passed

    def signed(self, raw: bytes) -> bytes:
        """A frame as it is sent; one that is signed already stays as it is."""
        return raw if self._signing is None or raw[2] & codec.SIGNED else self._signing.sign(raw)

    def close(self) -> None:
        """Leave the time stamps for the next run."""
        if self._signing is not None:
            self._signing.close()


class RefusalNotices:
    """Says what is refused for its signature: at once, and again every SAY_AGAIN_S while there is more."""

    def __init__(self) -> None:
        self._said: dict[int, tuple[float, int]] = {}

    def poll(
        self, refused: Mapping[int, int], reasons: Mapping[int, SignatureVerdict], now_s: float
    ) -> list[tuple[int, str]]:
        """(system id, words) of what is to be said at a time."""
        notices = []
        for sysid, count in refused.items():
            said_s, before = self._said.get(sysid, (-math.inf, 0))
            if count > before and now_s - said_s >= SAY_AGAIN_S:
                self._said[sysid] = (now_s, count)
                frames = "1 message is" if count - before == 1 else f"{count - before} messages are"
                notices.append((sysid, f"{frames} refused: {reasons[sysid]}"))
        return notices
