"""A recording in several files: `session.0001.tlog`, `session.0002.tlog`, … and `session.tlog`, which is being written.

Readers of a recording read them as one file, the oldest first; of those that were not kept nothing is left.
"""

from __future__ import annotations

import bisect
import io
import re
from pathlib import Path
from typing import cast

ROTATED = ("session.tlog", "decisions.jsonl")
"""Files of a session that may be in parts; any other stands for itself."""


def part(path: Path, number: int) -> Path:
    """The file that a part of a recording is kept in, from 1."""
    return path.with_name(f"{path.stem}.{number:04d}{path.suffix}")


def parts(path: Path) -> list[Path]:
    """Every file of a recording, in order; the path itself comes last."""
    if path.name not in ROTATED:
        return [path]
    name = re.compile(rf"{re.escape(path.stem)}\.(\d{{4,}}){re.escape(path.suffix)}")
    found = [(int(match[1]), one) for one in path.parent.glob(f"{path.stem}.*") if (match := name.fullmatch(one.name))]
    earlier = [one for _, one in sorted(found)]
    return [*earlier, path] if path.exists() or not earlier else earlier  # killed while it began a new one


def exists(path: Path) -> bool:
    """Whether there is any of a recording."""
    return parts(path)[-1].is_file()


def begins(path: Path) -> bool:
    """Whether the recording's beginning is there: its first parts have not been removed."""
    first, *later = parts(path)
    return not later or first == part(path, 1)


def size(path: Path) -> int:
    """Bytes of a recording in all. Raises OSError."""
    return sum(one.stat().st_size for one in parts(path))


def open_parts(path: Path) -> io.BufferedReader:
    """A recording to be read, as one file. Raises OSError."""
    files = parts(path)
    return files[0].open("rb") if len(files) == 1 else io.BufferedReader(_Joined(files), 1 << 16)


class _Joined(io.RawIOBase):
    """Files one behind the other."""

    def __init__(self, files: list[Path]) -> None:
        self._files = [one.open("rb", buffering=0) for one in files]
        self._ends: list[int] = []
        for one in files:
            self._ends.append((self._ends[-1] if self._ends else 0) + one.stat().st_size)
        self._at = 0

    def readable(self) -> bool:
        return True

    def seekable(self) -> bool:
        return True

    def seek(self, offset: int, whence: int = io.SEEK_SET) -> int:
        base = {io.SEEK_SET: 0, io.SEEK_CUR: self._at, io.SEEK_END: self._ends[-1]}[whence]
        self._at = max(base + offset, 0)
        return self._at

    def readinto(self, buffer: object) -> int:
        k = bisect.bisect_right(self._ends, self._at)
        if k >= len(self._files):
            return 0
        view = memoryview(cast(bytearray, buffer))
        self._files[k].seek(self._at - (self._ends[k - 1] if k else 0))
        count = self._files[k].readinto(view[: self._ends[k] - self._at]) or 0
        self._at += count
        return count

    def close(self) -> None:
        for file in self._files:
            file.close()
        super().close()
