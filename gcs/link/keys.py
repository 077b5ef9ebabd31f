"""Signing of links with keys from files: new keys, frames signed and judged, and notices of what is refused."""

from __future__ import annotations

import math
import os
import secrets
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from skytender.key_files import KeyRefused, StampFile, read_key
from skytender.signing import KEY_BYTES, SETUP_SIGNING, SignatureVerdict, Signing, ticks, without_key

SAY_AGAIN_S = 10.0


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


class LinkSigning:
    """The signing of one link with a key of a file: judges, signs, and keeps the stamps in KEYFILE.stamps."""

    def __init__(self, path: Path, link_id: int = 0, clock: Callable[[], float] = time.time) -> None:
        """Read the key and its stamps. Raises KeyRefused."""
        self._stamps = StampFile(path.with_name(path.name + ".stamps"))
        self._clock = clock
        latest, streams = self._stamps.read()
        self._signing, self._link_id = Signing(read_key(path), latest=latest, streams=streams), link_id

    def sign(self, raw: bytes) -> bytes:
        """A frame, signed."""
        now_s = self._clock()
        self._stamps.save_ahead(self._signing, now_s)
        return self._signing.sign(raw, codec.seed_of(raw), self._link_id, ticks(now_s))

    def judge(self, frame: Frame) -> SignatureVerdict:
        """Whether a received frame counts."""
        return self._signing.judge(frame.raw, frame.msgid, ticks(self._clock()))

    def close(self) -> None:
        """Leave the stamps as they are now."""
        self._stamps.save(self._signing)


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
