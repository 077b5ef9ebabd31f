"""Signing of a vehicle's plain links (`skytender.signing`), whose key a ground station may set.

Rules:
1. Without a key nothing is signed, and a signed frame is refused: it cannot be checked.
2. With one everything is signed, and only frames count that the key signed, or that need no signature.
3. SETUP_SIGNING sets the key while there is none; later only a signed one does, and 32 zero bytes remove the key. It is
   acted on here and goes no further. While the vehicle is armed nothing of this happens, as with PX4 and ArduPilot.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from simvehicle.mavlink.codec import ReceivedFrame, decode, schema
from skytender.signing import LAST_STAMP, SETUP_SIGNING, SignatureVerdict, Signing, Stream, without_key

MOST_STREAMS = 256


class VehicleSigning:
    """One vehicle's key, for all its plain links, and the time stamps used and seen with it."""

    def __init__(
        self,
        sysid: int,
        key: bytes | None = None,
        *,
        latest: int = 0,
        streams: Mapping[Stream, int] | None = None,
        on_key: Callable[[bytes | None], object] = lambda _: None,
    ) -> None:
        """`latest` and `streams`: the time stamps of an earlier run; `on_key` is called with a key that was set."""
        self._sysid = sysid
        self._on_key = on_key
        self._latest = latest
        self._use(key, streams)

    @property
    def has_key(self) -> bool:
        """Whether frames are signed."""
        return self._signing is not None

    @property
    def current(self) -> Signing | None:
        """The key with its time stamps; None while there is none."""
        return self._signing

    def sign(self, raw: bytes, link_id: int, now_ticks: int) -> bytes:
        """A frame as it is sent."""
        if self._signing is None:
            return raw
        row = schema(int.from_bytes(raw[7:10], "little"))
        assert row is not None
        return self._signing.sign(raw, bytes((row.seed,)), link_id, now_ticks)

    def judge(self, frame: ReceivedFrame, now_ticks: int) -> SignatureVerdict:
        """Whether a received frame counts."""
        if self._signing is None:
            return without_key(frame.raw)
        return self._signing.judge(frame.raw, frame.msgid, now_ticks)

    def take_setup(self, frame: ReceivedFrame, *, armed: bool = False) -> bool:
        """Act on a SETUP_SIGNING that was judged good; whether the frame was one, for this vehicle or another."""
        if frame.msgid != SETUP_SIGNING:
            return False
        content = decode(frame)
        assert content is not None
        if content.target_system in (0, self._sysid) and not armed:
            key = bytes(content.secret_key)
            latest = self._latest if self._signing is None else self._signing.latest
            self._latest = max(latest, min(content.initial_timestamp, LAST_STAMP - 1))
            self._use(key if any(key) else None)
            self._on_key(key if any(key) else None)
        return True

    def _use(self, key: bytes | None, streams: Mapping[Stream, int] | None = None) -> None:
        self._signing: Signing | None = None
        if key is not None:
            self._signing = Signing(key, latest=self._latest, streams=streams, most_streams=MOST_STREAMS)
