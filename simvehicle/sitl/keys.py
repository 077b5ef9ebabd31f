"""A vehicle's signing key on disk, and its time stamps beside it: what a restart must not forget.

The stamps of vehicle N stand in KEYFILE.N.stamps (skytender/key_files.py).
"""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Callable
from pathlib import Path

from simvehicle.mavlink.codec import ReceivedFrame
from simvehicle.mavlink.signing import VehicleSigning
from skytender.key_files import StampFile, read_key, write_private
from skytender.signing import SignatureVerdict, ticks

SAY_AGAIN_S = 10.0


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
        process, and counts more than the given one. `armed`: whether the vehicle is. Raises KeyRefused."""
        self._sysid, self._clock, self._armed = sysid, clock, armed
        self._own = None if state is None else state / f"{sysid}.key"
        path = self._own if self._own is not None and self._own.exists() else given
        self._stamps = None if path is None else self._stamps_of(path)
        latest, streams = (0, {}) if self._stamps is None else self._stamps.read()
        key = None if path is None else read_key(path)
        self._signing = VehicleSigning(sysid, key, latest=latest, streams=streams, on_key=self._keep)
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
        signing, now_s = self._signing.current, self._clock()
        if signing is None:
            return raw
        if self._stamps is not None:
            self._stamps.save_ahead(signing, now_s)
        return self._signing.sign(raw, link_id, ticks(now_s))

    @property
    def has_key(self) -> bool:
        """Whether a key is set."""
        return self._signing.has_key

    def close(self) -> None:
        """Leave the stamps as they are now."""
        if self._signing.current is not None and self._stamps is not None:
            self._stamps.save(self._signing.current)

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
        self._stamps = self._stamps_of(self._own)
        with contextlib.suppress(OSError):
            if key is None:
                self._own.unlink(missing_ok=True)
            else:
                write_private(self._own, key.hex() + "\n")

    def _stamps_of(self, path: Path) -> StampFile:
        return StampFile(path.with_name(f"{path.name}.{self._sysid}.stamps"))
