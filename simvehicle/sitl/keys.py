"""A vehicle's signing key on disk, and its time stamps beside it: what a restart must not forget.

A key is 64 hexadecimal digits in a file that only its user can read. The stamps of vehicle N stand in KEYFILE.N.stamps;
they are written every few seconds, some time ahead, and at the end.
"""

from __future__ import annotations

import contextlib
import json
import math
import os
import stat
import time
from collections.abc import Callable
from pathlib import Path

from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.signing import VehicleSigning
from skytender.signing import KEY_BYTES, TICKS_PER_S, SignatureVerdict, ticks

SAVE_EVERY_S = 5.0
AHEAD_TICKS = 2 * int(SAVE_EVERY_S) * TICKS_PER_S
SAY_AGAIN_S = 10.0
MOST_BYTES = 1 << 16


class KeyFileError(ValueError):
    """A key file that cannot be used; the text says which, why, and what to do."""


class Keyring:
    """One vehicle's key with its file: judges what plain links receive, signs what they send."""

    def __init__(
        self,
        sysid: int,
        given: Path | None = None,
        state: Path | None = None,
        clock: Callable[[], float] = time.time,
        armed: Callable[[], bool] = lambda: False,
    ) -> None:
        """`given`: the key file of the command line; `state`: a folder where a key set by SETUP_SIGNING outlives the
        process, and counts more than the given one. `armed`: whether the vehicle is. Raises KeyFileError."""
        self._sysid, self._clock, self._armed = sysid, clock, armed
        self._own = None if state is None else state / f"{sysid}.key"
        path = self._own if self._own is not None and self._own.exists() else given
        self._stamps = None if path is None else path.with_name(f"{path.name}.{sysid}.stamps")
        latest, streams = self._read_stamps()
        key = None if path is None else read_key(path)
        self._signing = VehicleSigning(sysid, key, latest=latest, streams=streams, on_key=self._keep)
        self._saved_s = -math.inf
        self._refused = 0
        self._said_s = -math.inf

    def accepted(self, frames: list[ReceivedFrame]) -> list[ReceivedFrame]:
        """The frames that count, those that set up the signing acted on."""
        now = ticks(self._clock())
        passed = []
        for frame in frames:
            why = self._signing.judge(frame, now)
            if why is not SignatureVerdict.GOOD:
                self._refuse(why, frame.sysid)
            elif not self._signing.take_setup(frame, armed=self._armed()):
                passed.append(frame)
        return passed

    def signed(self, raw: bytes, link_id: int) -> bytes:
        """A frame as it is sent on a link."""
        if not self._signing.has_key:
            return raw
        now_s = self._clock()
        if now_s - self._saved_s >= SAVE_EVERY_S or now_s < self._saved_s:
            self._saved_s = now_s
            self._save(max(ticks(now_s) + AHEAD_TICKS, self._signing.latest + TICKS_PER_S))
        return self._signing.sign(raw, link_id, ticks(now_s))

    @property
    def has_key(self) -> bool:
        """Whether a key is set."""
        return self._signing.has_key

    def close(self) -> None:
        """Leave the stamps as they are now."""
        if self._signing.has_key:
            self._save(self._signing.latest)

    def _refuse(self, why: str, sender: int) -> None:
        """Say in the log that frames are refused, at once and then from time to time."""
        self._refused += 1
        now_s = self._clock()
        if now_s - self._said_s >= SAY_AGAIN_S or now_s < self._said_s:
            frames = "1 message" if self._refused == 1 else f"{self._refused} messages"
            with contextlib.suppress(OSError):
                print(f"vehicle {self._sysid}: {frames} refused, the last of system {sender}: {why}", flush=True)
            self._said_s, self._refused = now_s, 0

    def _keep(self, key: bytes | None) -> None:
        """Write a key that was set to the state folder, or take the one there away; without a folder it is not kept."""
        if self._own is None:
            self._stamps = None
            return
        self._stamps = self._own.with_name(f"{self._own.name}.{self._sysid}.stamps")
        with contextlib.suppress(OSError):
            if key is None:
                self._own.unlink(missing_ok=True)
            else:
                _write(self._own, key.hex() + "\n")

    def _read_stamps(self) -> tuple[int, dict[tuple[int, int, int], int]]:
        if self._stamps is None:
            return 0, {}
        try:
            with self._stamps.open("rb") as file:
                content = json.loads(file.read(MOST_BYTES))
            streams = {(int(s), int(c), int(link)): int(stamp) for s, c, link, stamp in content["streams"]}
            return int(content["latest"]), streams
        except FileNotFoundError:
            return 0, {}
        except (OSError, ValueError, KeyError, TypeError, OverflowError, RecursionError):
            raise KeyFileError(f"{self._stamps} holds no time stamps: mend it, or delete it to begin anew") from None

    def _save(self, latest: int) -> None:
        if self._stamps is None:
            return
        rows = [[*stream, stamp] for stream, stamp in sorted(self._signing.streams.items())]
        with contextlib.suppress(OSError):  # a full disk ends no flight
            _write(self._stamps, json.dumps({"latest": latest, "streams": rows}))


def read_key(path: Path) -> bytes:
    """The key in a file that no other user can read. Raises KeyFileError."""
    try:
        with path.open("rb") as file:
            mode = os.fstat(file.fileno()).st_mode
            content = file.read(4 * KEY_BYTES)
    except OSError as error:
        raise KeyFileError(f"{path}: {error.strerror}") from None
    if not stat.S_ISREG(mode) or stat.S_IMODE(mode) & 0o077:
        raise KeyFileError(f"{path} can be read by others: chmod 600 {path}")
    with contextlib.suppress(ValueError):
        key = bytes.fromhex(content.decode("ascii"))
        if len(key) == KEY_BYTES:
            return key
    raise KeyFileError(f"{path} holds no key of {2 * KEY_BYTES} hexadecimal digits; `gcs key new` writes one")


def _write(path: Path, text: str) -> None:
    new = path.with_name(f"{path.name}.new")
    descriptor = os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC, 0o600)
    with os.fdopen(descriptor, "w", encoding="ascii") as file:
        file.write(text)
    os.replace(new, path)
