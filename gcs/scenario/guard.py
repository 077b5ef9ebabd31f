"""Guard of calls of a planner or policy: each may raise, never return, or answer nonsense, and the session goes on.

A call is cut off after LIMIT_S of wall time by an interval timer, which also ends endless loops and sleeps. A call into
compiled code that never comes back cannot be cut: a user's code therefore runs in a process of its own
(gcs/processes/plugin_process.py). A vehicle that has been cut off is not asked again: ten of them in a row would end
the patience that vehicles have with a silent supervisor.
"""

from __future__ import annotations

import math
import re
import signal
import threading
import time
import traceback
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import Any, TypeVar

LIMIT_S = 1.0
AGAIN_S = 0.05
"""A call that swallows the cut is cut again."""
MAX_TEXT = 200
MAX_SHOWN = 60
_ADDRESS = re.compile(r" at 0x[0-9a-fA-F]+")
"""As in `<object at 0x7fcd0>`: another in each run."""
LATE = "did not answer within"
PROCESS = 0
"""System id of a fault that befalls all that a planner or policy decides: its process has ended."""
T = TypeVar("T")


@dataclass(frozen=True)
class PluginFault:
    """Fault of a user's code, and the vehicle that is held for it."""

    sysid: int
    policy: str
    problem: str

    @property
    def sentence(self) -> str:
        """For a person."""
        held = "the vehicle is held"
        if self.sysid == PROCESS:
            held = "its pursuers are held" if self.policy.startswith("planner ") else "only urgent vehicles are served"
        return f"{self.policy} {self.problem}; {held}"

    @property
    def is_late(self) -> bool:
        """Whether an answer never came, by a wall clock: the session would go another way in the next flight."""
        return self.sysid == PROCESS or self.problem.startswith(LATE)

    def record(self) -> dict[str, Any]:
        """For decisions.jsonl."""
        return {"kind": "policy failed", "sysid": self.sysid, "policy": self.policy, "problem": self.problem}


class Nonsense(Exception):
    """An answer that cannot be used; the text goes on where a sentence begins with the policy's name."""


class Guard:
    """Calls one implementation on behalf of vehicles, and remembers which are held, and why."""

    def __init__(self, policy: str, limit_s: float = LIMIT_S) -> None:
        """limit_s: of wall time, after which a call is cut off; inf: none is."""
        self.policy = policy
        self.raised: BaseException | None = None
        """by the last call that failed; for its caller to take"""
        self._limit_s = limit_s
        self._reported: dict[int, str] = {}
        self._cut: set[int] = set()
        self._new: list[PluginFault] = []
        self._cut_now = False
        self._time_s = math.nan

    def begin_tick(self, time_s: float) -> None:
        """Calls from now on are of the tick at this session time: one at most is cut off in each."""
        if time_s != self._time_s:
            self._time_s, self._cut_now = time_s, False

    def call(self, sysid: int, function: Callable[[], T]) -> T | None:
        """Result of `function` for this vehicle; None where it failed, now or for good, and the vehicle is held.

        `function` raises Nonsense where what it was answered cannot be used.
        """
        if sysid in self._cut or self._cut_now:
            return None
        try:
            with _cut_off_after(self._limit_s):
                answer = function()
        except _Overrun:
            self._cut.add(sysid)
            self._cut_now = True
            self._blame(sysid, f"{LATE} {self._limit_s:g} s and is not asked again")
        except Nonsense as problem:
            self._blame(sysid, str(problem))
        except (Exception, SystemExit, KeyboardInterrupt) as error:
            if isinstance(error, KeyboardInterrupt) and signal.getsignal(signal.SIGINT) is not signal.SIG_IGN:
                raise  # a person's, not the code's own
            self.raised = error
            self._blame(sysid, f"raised {_described(error)}")
        else:
            self._reported.pop(sysid, None)
            return answer
        return None

    def _blame(self, sysid: int, problem: str) -> None:
        """A vehicle is held for this; said once until it gets a good answer or something else is wrong."""
        if self._reported.get(sysid) != problem:
            self._reported[sysid] = problem
            self._new.append(PluginFault(sysid, self.policy, problem))

    def pop_faults(self) -> list[PluginFault]:
        """The problems since the last call."""
        taken, self._new = self._new, []
        return taken


def shown(answer: Any) -> str:
    """An answer for a problem's text, the same in every run: a number or a text as it is, else its type."""
    value = plain(answer)
    if type(value) not in (bool, int, float, complex, str, bytes):
        return type(answer).__name__
    return "NaN" if value != value else _one_line(repr(value), MAX_SHOWN)  # noqa: PLR0124 - NaN alone differs


def plain(answer: Any) -> Any:
    """An answer, as Python's own number where it is one of numpy's or of a library like it."""
    return answer.item() if getattr(answer, "ndim", None) == 0 else answer


def _one_line(text: str, longest: int) -> str:
    """Text of somebody else's code, without addresses: by those each run would have another problem."""
    return _ADDRESS.sub("", " ".join(text.split()))[:longest]


def _described(error: BaseException) -> str:
    """`ValueError at planner.py:12: text`, on one line."""
    frames = traceback.extract_tb(error.__traceback__)
    where = next((f for f in reversed(frames) if "site-packages" not in f.filename), frames[-1])
    text = _one_line(str(error), MAX_TEXT)
    return f"{type(error).__name__} at {Path(where.filename).name}:{where.lineno}" + (f": {text}" if text else "")


class _Overrun(BaseException):
    """No Exception: a policy's own `except Exception` must not swallow it."""


def _cut(_: int, __: FrameType | None) -> None:
    raise _Overrun


@contextmanager
def _cut_off_after(limit_s: float) -> Iterator[None]:
    """Raise _Overrun in the body once the time is up. Without effect outside the main thread, which has the signals."""
    if math.isinf(limit_s) or threading.current_thread() is not threading.main_thread():
        yield
        return
    handler = signal.signal(signal.SIGALRM, _cut)
    begun_s = time.monotonic()
    left_s, every_s = signal.setitimer(signal.ITIMER_REAL, limit_s, AGAIN_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, handler)
        if left_s:
            signal.setitimer(signal.ITIMER_REAL, max(left_s - (time.monotonic() - begun_s), 1e-3), every_s)
