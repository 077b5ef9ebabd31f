"""Writer of session.tlog and decisions.jsonl, and the digest (SHA-256) of a session.

`session.tlog` is the format of every MAVLink tool: per frame the time in µs since the Unix epoch, 8 bytes, high byte
first, then the frame. `decisions.jsonl` is one JSON object per line. Both are written in batches, so that recording
costs the tick an append; what `flush` has written outlives this process.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import struct
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Self

from gcs.recording.changes import ChangeFilter
from gcs.recording.rotation import ROTATED, part

TLOG, DECISIONS = ROTATED
BATCH_BYTES = 1 << 16

_TIME = struct.Struct(">Q").pack
_DIGEST_PREFIX = struct.Struct("<QB").pack
_IN, _OUT, _DECISION = range(3)
SET_POINT_KEYS = 5
_float = float.__repr__  # as json writes one, also of numpy
_encode = json.JSONEncoder(sort_keys=True, allow_nan=False, separators=(",", ":")).encode


class RecorderError(Exception):
    """The recording cannot go on; the message is a sentence that names the file."""


class _File:
    """Append-only, in batches that are written whole or not at all."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.batch = bytearray()
        self.size = 0
        try:
            self._fd = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_CLOEXEC, 0o666)
        except OSError as error:
            raise RecorderError(f"{path} cannot be created: {_reason(error)}.") from None

    def write(self) -> None:
        """Write the batch. Raises OSError, with the file cut back to whole records and closed."""
        batch, self.batch = self.batch, bytearray()
        try:
            with memoryview(batch) as view:
                at = 0
                while at < len(batch):
                    at += os.write(self._fd, view[at:])
        except OSError:
            with contextlib.suppress(OSError):
                os.ftruncate(self._fd, self.size)
            self.close()
            raise
        self.size += len(batch)

    def close(self) -> None:
        if self._fd >= 0:
            fd, self._fd = self._fd, -1
            os.close(fd)


class Recorder:
    """Records into `folder`, which must exist and hold no recording. Raises RecorderError where a file cannot be made.

    When a disk is full or fails, the call that notices raises RecorderError; what the files then hold is whole records,
    and they are closed: later calls raise the same, `close` does nothing.
    """

    def __init__(
        self, folder: Path, *, rotate_bytes: int | None = None, keep: int | None = None, changes_only: bool = False
    ) -> None:
        """rotate_bytes: with so many, both files go on in new ones; keep: how many pairs of full ones stay.
        changes_only: decisions as `ChangeFilter` has them."""
        self._rotate_bytes, self._keep = rotate_bytes, keep
        self._full = 0
        self._changes = ChangeFilter() if changes_only else None
        self._end: RecorderError | None = None
        self._tlog = _File(folder / TLOG)
        try:
            self._decisions = _File(folder / DECISIONS)
        except RecorderError:
            self._tlog.close()
            raise

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def frames(self, t_us: int, raws: Sequence[bytes]) -> None:
        """Record frames in order, received or sent at `t_us` µs since the Unix epoch (session epoch + session time)."""
        if raws:
            time = _TIME(t_us)
            batch = self._tlog.batch
            batch += time
            batch += time.join(raws)
            if len(batch) >= BATCH_BYTES or self._end is not None:
                self._write()

    def decision(self, decision: Mapping[str, Any]) -> bytes:
        """Record a decision, if it is to be written; its line, for `Digest.decision`.

        Raises ValueError for NaN or infinity in it, TypeError for what JSON has no form for.
        """
        line = decision_line(decision)
        if self._changes is None or self._changes.is_change(decision):
            self._decisions.batch += line
        if len(self._decisions.batch) >= BATCH_BYTES or self._end is not None:
            self._write()
        return line

    def flush(self) -> None:
        """Hand everything recorded so far to the system, at a tick's end. Raises RecorderError."""
        self._write()
        if self._rotate_bytes is not None and self._tlog.size + self._decisions.size >= self._rotate_bytes:
            try:
                self._rotate()
            except OSError as error:
                failure = RecorderError(f"{self._tlog.path} cannot be rotated: {_reason(error)}; recording has ended.")
                self._shut(failure)
                raise failure from None

    def _rotate(self) -> None:
        """Put the full files aside under a number of their own, and go on in new ones."""
        self._full += 1
        paths = [file.path for file in (self._tlog, self._decisions)]
        for file, path in zip((self._tlog, self._decisions), paths, strict=True):
            file.close()
            path.rename(part(path, self._full))
            if self._keep is not None:
                part(path, self._full - self._keep).unlink(missing_ok=True)
        self._tlog, self._decisions = _File(paths[0]), _File(paths[1])

    def _write(self) -> None:
        if self._end is not None:
            raise self._end
        failure: RecorderError | None = None
        for file in (self._tlog, self._decisions):  # a full disk for one may still have room for the other
            try:
                file.write()
            except OSError as error:
                failure = failure or RecorderError(
                    f"{file.path} cannot be written: {_reason(error)}; recording has ended."
                )
        if failure is not None:
            self._shut(failure)
            raise failure

    def close(self) -> None:
        """Write what is left and close; a second call does nothing. Raises RecorderError."""
        if self._end is None:
            self.flush()
            self._shut(RecorderError(f"{self._tlog.path} is closed: nothing more can be recorded."))

    def _shut(self, end: RecorderError) -> None:
        self._end = end
        self._tlog.close()
        self._decisions.close()


class Digest:
    """A session's fingerprint (docs/protocol.md#digest): equal for equal frames delivered, frames sent and decisions.

    A frame counts as tick, direction, system, component, message id and payload as on the wire. Sequence numbers, flags
    and signatures do not. Feed it tick by tick, frames in the order (system, component, delivery).
    """

    def __init__(self) -> None:
        self._hash = hashlib.sha256()

    def frames_in(self, t_ms: int, frames: Iterable[bytes]) -> None:
        """Whole frames (MAVLink 2) that were delivered to the supervisor in the tick that ends at `t_ms`."""
        self._frames(_DIGEST_PREFIX(t_ms, _IN), frames)

    def frames_out(self, t_ms: int, frames: Iterable[bytes]) -> None:
        """Whole frames (MAVLink 2) that were sent at `t_ms`, each once however often its datagram was repeated."""
        self._frames(_DIGEST_PREFIX(t_ms, _OUT), frames)

    def decision(self, t_ms: int, decision: Mapping[str, Any] | bytes) -> None:
        """A decision made at `t_ms`, in the form in which it is recorded, or as the line that the recorder made."""
        line = decision if isinstance(decision, bytes) else decision_line(decision)
        self._hash.update(_DIGEST_PREFIX(t_ms, _DECISION) + len(line).to_bytes(4, "little") + line)

    def hexdigest(self) -> str:
        return f"sha256:{self._hash.hexdigest()}"

    def _frames(self, prefix: bytes, frames: Iterable[bytes]) -> None:
        # A frame's byte 1 is the payload's length; bytes 5 to 9 are system, component and message id, then the payload.
        self._hash.update(b"".join([prefix + raw[1:2] + raw[5 : 10 + raw[1]] for raw in frames]))


def decision_line(decision: Mapping[str, Any]) -> bytes:
    """A decision as its line of `decisions.jsonl`: keys sorted, no NaN. Raises ValueError, TypeError as `json` does."""
    line = _set_point_line(decision) if decision.get("kind") == "set_point" else None
    return line or _encode(decision).encode() + b"\n"


def _set_point_line(decision: Mapping[str, Any]) -> bytes | None:
    """The line that `json` makes of a set point, in a third of the time: nearly all decisions are set points.

    None for one that is not the usual five keys with finite floats: `json` knows what is to become of it.
    """
    try:
        (n, e, d), (v_n, v_e, v_d), t_s = decision["p_ned"], decision["v_ned"], decision["t_s"]
        if len(decision) != SET_POINT_KEYS or not math.isfinite(n + e + d + v_n + v_e + v_d + t_s):
            return None
        return (
            f'{{"kind":"set_point","p_ned":[{_float(n)},{_float(e)},{_float(d)}],"sysid":{decision["sysid"]:d},'
            f'"t_s":{_float(t_s)},"v_ned":[{_float(v_n)},{_float(v_e)},{_float(v_d)}]}}\n'
        ).encode()
    except (KeyError, TypeError, ValueError):
        return None


def _reason(error: OSError) -> str:
    """The system's words for it, lower case."""
    reason = error.strerror or str(error)
    return reason[:1].lower() + reason[1:]
