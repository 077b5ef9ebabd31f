"""Writer of session.tlog and decisions.jsonl.

`session.tlog` is the format of every MAVLink tool: per frame the time in µs since the Unix epoch, 8 bytes, high byte
first, then the frame. `decisions.jsonl` is one JSON object per line. Both are written in batches, so that recording
costs the tick an append; what `flush` has written outlives this process.
"""

from __future__ import annotations

import contextlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Self

from gcs.frame_spans import FrameSpans
from gcs.recording.changes import ChangeFilter
from gcs.recording.decision_lines import Decisions, decision_lines, each
from gcs.recording.rotation import ROTATED, part
from gcs.recording.tlog_frames import stamped

TLOG, DECISIONS = ROTATED
BATCH_BYTES = 1 << 16


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
            raise RecorderError(f"{path} cannot be created: {reason(error)}.") from None

    def write(self) -> None:
        """Write the batch. Raises OSError, with the file cut back to whole records and closed."""
        batch, self.batch = self.batch, bytearray()
        try:
            at = os.write(self._fd, batch) if batch else 0
            while at < len(batch):
                at += os.write(self._fd, batch[at:])
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

    def frames(self, t_us: int, received: Sequence[bytes], sent: Sequence[bytes] = ()) -> None:
        """Record frames in order, received and sent at `t_us` µs since the Unix epoch (session epoch + session
        time)."""
        self._tlog.batch += stamped(t_us, received, sent)
        if len(self._tlog.batch) >= BATCH_BYTES or self._end is not None:
            self._write()

    def decisions(self, decisions: Decisions) -> FrameSpans:
        """Record decisions, those that are to be written; the lines of all of them, for the digest.

        Raises ValueError for NaN or infinity in one, TypeError for what JSON has no form for; none is recorded then.
        """
        lines = decision_lines(decisions)
        if self._changes is None:
            self._decisions.batch += lines.data
        else:
            both = zip(lines, each(decisions), strict=True)
            self._decisions.batch += b"".join([line for line, made in both if self._changes.is_change(made)])
        if len(self._decisions.batch) >= BATCH_BYTES or self._end is not None:
            self._write()
        return lines

    def flush(self) -> None:
        """Hand everything recorded so far to the system, at a tick's end. Raises RecorderError."""
        self._write()
        if self._rotate_bytes is not None and self._tlog.size + self._decisions.size >= self._rotate_bytes:
            try:
                self._rotate()
            except OSError as error:
                failure = RecorderError(f"{self._tlog.path} cannot be rotated: {reason(error)}; recording has ended.")
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
                    f"{file.path} cannot be written: {reason(error)}; recording has ended."
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


def reason(error: OSError) -> str:
    """The system's words for it, lower case."""
    words = error.strerror or str(error)
    return words[:1].lower() + words[1:]
