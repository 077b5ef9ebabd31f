"""Whether a link delivers seconds late: what a vehicle said seconds ago must not steer decisions.

By a vehicle's clock alone a link that holds everything back cannot be distinguished from a simulated autopilot that
stood still: both are followed within seconds. TIMESYNC can: its answer returns our own time, and has gone both ways
(https://mavlink.io/en/services/timesync.html). A message is late that comes LATE_S or more after others with its time
did, on a link whose round trip takes as long, or has not ended for as long; or while another link brings newer ones.
Where the first round trip is already so long, that is how late all is. Times are of the monotonic clock, s.
"""

from __future__ import annotations

import math

from gcs.mavlink import codec
from gcs.mavlink.codec import Frame, Message

LATE_S = 2.0
"""[choice] Half a second more than a position may be old to be believed."""
SHORT_S = 0.5
"""[choice] After a round trip so short what comes is as good as in time: lateness is counted from there."""
ASK_EVERY_S = 1.0
UNANSWERED = 10
"""A vehicle that has answered none of so many does not speak TIMESYNC."""
MOST_OPEN = 60
TIMESYNC = codec.msgid("TIMESYNC")


class RoundTrips:
    """The round trips over one link to one vehicle."""

    def __init__(self) -> None:
        self._open: dict[int, float] = {}
        """when each question that is not answered yet was asked, by its own time in it"""
        self._asked_s = math.nan
        self.last_s: float | None = None
        """what the last one took; None: none has ended"""
        self.been_short = False

    def ask(self, now_s: float) -> Message | None:
        """A question that is due now."""
        if math.isnan(self._asked_s):
            self._asked_s = now_s
        silent = self.last_s is None and len(self._open) >= UNANSWERED
        if now_s - self._asked_s < ASK_EVERY_S or silent or len(self._open) >= MOST_OPEN:
            return None
        self._asked_s, stamp = now_s, round(1e9 * now_s)
        self._open[stamp] = now_s
        return codec.message("TIMESYNC", tc1=0, ts1=stamp)

    def receive(self, frame: Frame, now_s: float) -> None:
        """Take a TIMESYNC; questions asked before one that is answered are forgotten."""
        content = codec.fields(frame)
        asked_s = self._open.get(content.ts1)
        if content.tc1 == 0 or asked_s is None:
            return
        self._open = {stamp: at_s for stamp, at_s in self._open.items() if at_s > asked_s}
        self.last_s = now_s - asked_s
        self.been_short = self.been_short or self.last_s < LATE_S

    def takes_s(self, now_s: float) -> float:
        """How long a round trip takes, or has taken so far; 0 where none has ever ended."""
        if self.last_s is None:
            return 0.0
        return max(self.last_s, now_s - min(self._open.values(), default=now_s))

    def late_s(self, behind_s: float, now_s: float, *, outrun: bool) -> float:
        """How late a message is, 0 for one in time, that came `behind_s` after others with its time would have.
        `outrun`: another link brings newer ones."""
        if self.last_s is not None and not self.been_short:
            return self.last_s
        return behind_s if behind_s >= LATE_S and (outrun or self.takes_s(now_s) >= LATE_S) else 0.0
