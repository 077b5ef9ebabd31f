"""A program that is talked to: typed lines in, and what it says read from its log."""

from __future__ import annotations

import subprocess
import time
from pathlib import Path


class Conversation:
    """A program that is typed to and read from, until it says what is waited for."""

    def __init__(self, process: subprocess.Popen[str], log: Path) -> None:
        self._process = process
        self._log = log
        self._read = 0

    @property
    def said(self) -> str:
        """Everything so far."""
        return self._log.read_text(encoding="utf-8", errors="replace")

    def type(self, line: str) -> None:
        """One line of input."""
        assert self._process.stdin is not None
        self._process.stdin.write(line + "\n")
        self._process.stdin.flush()

    def ask(self, line: str, word: str, within_s: float = 10.0) -> None:
        """Type a line once a second until it is answered with a word."""
        deadline_s = time.monotonic() + within_s
        while self.said.find(word, self._read) < 0:
            assert time.monotonic() < deadline_s, f"'{line}' not answered by '{word}': {self.said[self._read :]}"
            self.type(line)
            time.sleep(1.0)
        self.hear(word)

    def hear(self, *words: str, within_s: float = 20.0) -> None:
        """Wait until all of some words have been said since what was waited for last, in any order: it prints late."""
        deadline_s = time.monotonic() + within_s
        while min(found := [self.said.find(word, self._read) for word in words]) < 0:
            assert self._process.poll() is None, f"it ended: {self.said[-2000:]}"
            assert time.monotonic() < deadline_s, f"not all of {words} in {within_s} s: {self.said[self._read :]}"
            time.sleep(0.05)
        self._read = max(at + len(word) for at, word in zip(found, words, strict=True))
