"""A program that is talked to: typed lines in, and what it says read from its pipe as it comes."""

from __future__ import annotations

import os
import select
import subprocess
import time

from patience import PATIENCE_S


class Conversation:
    """A program that is typed to and read from, until it says what is waited for."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdout is not None
        self._process = process
        self._out = process.stdout.fileno()
        self._read = 0
        self._heard = ""

    @property
    def said(self) -> str:
        """Everything so far, up to now."""
        while self._listen(0.0):
            pass
        return self._heard

    def type(self, line: str) -> None:
        """One line of input."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{line}\n".encode())
        self._process.stdin.flush()

    def ask(self, line: str, word: str, within_s: float = PATIENCE_S) -> None:
        """Type a line once a second until it is answered with a word."""
        deadline_s = time.monotonic() + within_s
        while self.said.find(word, self._read) < 0:
            assert time.monotonic() < deadline_s, f"'{line}' not answered by '{word}': {self.said[self._read :]}"
            self.type(line)
            again_s = time.monotonic() + 1.0
            while self.said.find(word, self._read) < 0 and self._listen(again_s):
                pass
        self.hear(word)

    def hear(self, *words: str, within_s: float = PATIENCE_S) -> None:
        """Wait until all of some words have been said since what was waited for last, in any order: it prints late."""
        deadline_s = time.monotonic() + within_s
        while min(found := [self.said.find(word, self._read) for word in words]) < 0:
            if not self._listen(deadline_s):
                raise AssertionError(f"not all of {words} in {within_s} s: {self.said[self._read :]}")
        self._read = max(at + len(word) for at, word in zip(found, words, strict=True))

    def _listen(self, until_s: float) -> bool:
        """Take in what it says next; False where it has ended or says nothing until then."""
        ready, _, _ = select.select([self._out], [], [], max(until_s - time.monotonic(), 0.0))
        chunk = os.read(self._out, 65536) if ready else b""
        self._heard += chunk.decode("utf-8", "replace")
        return bool(chunk)
