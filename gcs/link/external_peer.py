"""One external vehicle: over one link, or over several, of which the better one is used.

1. What is sent goes over the link in use; our HEARTBEAT, and requests of streams, go over all, so that each is ready.
2. What comes over the link in use is taken, each frame once. What comes over another is taken where both carry one
   stream (a router's), for then it is the same frames, or such as the first one lost; else it only shows that this
   link lives: an autopilot's own second port has numbers and times of its own.
3. A link is left when it is silent for unusually long while another one receives: SILENT_S, or SILENCES of its
   average time from frame to frame; at once, when its stream has ended.
4. A link is left for one that loses BETTER_SHARE less, and for one that the scenario names before it once that has been
   received for RETURN_S and loses no more; at most every DWELL_S.
Times are of the monotonic clock, s.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from gcs.link.link import Key, LinkState
from gcs.link.open_address import OpenAddress
from gcs.link.quality import LinkQuality
from gcs.link.socket import Where
from gcs.mavlink.boot_clock import BootClock
from gcs.mavlink.codec import Frame, Message, fields
from gcs.mavlink.gaps import GapCounter
from gcs.mavlink.recent_frames import RecentFrames, Relation
from gcs.mavlink.services.lateness import LATE_S, SHORT_S, RoundTrips
from skytender import mavlink as mav

SILENT_S = 0.4
"""[choice] A PX4 leaves offboard half a second to a second after the last set point."""
SILENCES = 4.0
SMOOTHING = 0.1
"""Weight of the newest time from frame to frame in the average."""
BETTER_SHARE = 0.1
EQUAL_SHARE = 0.02
RETURN_S, DWELL_S = 5.0, 5.0
ONE_STREAM = 8
"""So many frames that came over two links, none of another content with its number in between, and no more than
ONE_STREAM_S from one to the next: both carry one stream."""
ONE_STREAM_S = 3.0
AHEAD_S = 1.0
"""[choice] What a link brought longer ago does not show that another one is late: no autopilot boots so quickly."""


@dataclass(eq=False)
class PeerLink:
    """A vehicle over one address."""

    opened: OpenAddress
    connect: str
    address: Where | None = None
    cut_off: bool = False
    """whether the stream from that address has ended"""
    found_s: float = 0.0
    received_s: float = 0.0
    fresh_since_s: float = math.inf
    """since when it has not been silent"""
    usual_s: float = 1.0
    """from frame to frame"""
    gaps: GapCounter = field(default_factory=GapCounter)
    received: int = 0
    matched: int = 0
    """how many of its frames in a row came over another link too"""
    matched_s: float = -math.inf
    trips: RoundTrips = field(default_factory=RoundTrips)
    late_s: float = 0.0
    """how late what comes is; 0: in time"""
    offset_s: float | None = None
    """from the vehicle's time to the session's at the last short round trip"""
    newest: dict[int, tuple[float, float]] = field(default_factory=dict)
    """the vehicle's time in its last message of each kind, and when that came"""

    def __post_init__(self) -> None:
        self.quality = LinkQuality(self.gaps)

    @property
    def patience_s(self) -> float:
        """A silence so long is none that it usually has."""
        return max(SILENT_S, SILENCES * self.usual_s)

    def fresh(self, now_s: float) -> bool:
        """Whether it is there."""
        return self.address is not None and not self.cut_off and now_s - self.received_s < self.patience_s

    def lost_share(self, sysid: int) -> float:
        """Share of frames lost in the last seconds, 0..1."""
        return self.quality.lost_share(sysid) or 0.0

    def is_ahead(self, msgid: int, boot_s: float, now_s: float) -> bool:
        """Whether it has lately brought a newer message of that kind; what came before a silence may be of an earlier
        boot."""
        newest_s, came_s = self.newest.get(msgid, (-math.inf, -math.inf))
        return not self.cut_off and newest_s > boot_s and now_s - came_s < AHEAD_S

    def count(self, frame: Frame, now_s: float) -> bool:
        """Take note of a frame, `received_s` being still that of the one before; whether it ends a silence."""
        since_s = now_s - self.received_s
        self.received += 1
        self.gaps.feed(frame.sysid, frame.compid, frame.seq)
        self.quality.count(frame.sysid, 1, now_s)
        if since_s >= self.patience_s or self.fresh_since_s == math.inf:
            self.fresh_since_s = now_s
            return True
        self.usual_s += SMOOTHING * (since_s - self.usual_s)
        return False

    def find_late(self, late_s: float) -> str:
        """Take note of how late it delivers, 0 for in time; words where it does or no longer does, else none."""
        before_s, self.late_s = self.late_s, late_s
        if late_s and not before_s:
            return f"Delivers {late_s:.1f} s late over {self.connect}: nothing from there is taken until it is in time"
        return f"Delivers in time again over {self.connect}" if before_s and not late_s else ""

    def compare(self, relation: Relation, now_s: float) -> None:
        """Take note of what another link brought with the same number."""
        if relation == "copy":
            self.matched = self.matched + 1 if now_s - self.matched_s <= ONE_STREAM_S else 1
            self.matched_s = now_s
        elif relation == "other":
            self.matched = 0

    def carries_stream_of_others(self, now_s: float) -> bool:
        """Whether its frames are those that others carry."""
        return self.matched >= ONE_STREAM and now_s - self.matched_s <= ONE_STREAM_S


@dataclass(eq=False)
class ExternalPeer:
    """One vehicle."""

    key: Key
    links: list[PeerLink]
    """in the scenario's order"""
    used: PeerLink
    changed_s: float = -math.inf
    """when the link in use was changed"""
    relinked: bool = False
    """whether since it was asked for streams a link has come, or numbers go on as another's"""
    clock: BootClock = field(default_factory=BootClock)
    boots: bool = False
    """whether its last HEARTBEAT said so"""
    recent: RecentFrames = field(default_factory=RecentFrames)
    frames: list[Frame] = field(default_factory=list)
    set_point: Message | None = None

    @property
    def found(self) -> bool:
        """Whether it has been received at any of its addresses."""
        return any(link.address is not None for link in self.links)

    def link_of(self, opened: OpenAddress) -> PeerLink | None:
        """Its link over an address; None where it is not expected there."""
        return next((link for link in self.links if link.opened is opened), None)

    def takes(self, frame: Frame, link: PeerLink, now_s: float) -> bool:
        """Whether a frame that came over one of its links is to be taken."""
        if len(self.links) == 1:
            return True
        self.relinked |= link.count(frame, now_s)
        seen, relation, other = self.recent.add(frame, self.links.index(link))
        for one in (link, self.links[other]):
            one.compare(relation, now_s)
        if seen.taken or not (link is self.used or link.carries_stream_of_others(now_s)):
            return False
        seen.taken = True
        return True

    def answered(self, link: PeerLink, frame: Frame, now_s: float) -> str:
        """Take a TIMESYNC that came over one of its links; words as of `find_late`."""
        link.trips.receive(frame, now_s)
        takes_s = link.trips.takes_s(now_s)
        if takes_s <= SHORT_S:
            link.offset_s = self.clock.offset_s
        return link.find_late(0.0) if takes_s < LATE_S else ""

    def judge(self, link: PeerLink, msgid: int, boot_s: float, t_s: float, now_s: float) -> str:
        """Judge by the autopilot's time in a message that came at `t_s` of the session whether the link delivers late;
        words where that has changed, else none."""
        outrun = any(one is not link and one.is_ahead(msgid, boot_s, now_s) for one in self.links)
        link.newest[msgid] = boot_s, now_s
        if not outrun and self.clock.begins_anew(msgid, boot_s, t_s):
            self._forget_trips()  # a link brings what it is sent in its order: this is another boot
            return link.find_late(0.0)
        offset_s = self.clock.offset_s if link.offset_s is None else link.offset_s
        behind_s = 0.0 if offset_s is None else t_s - boot_s - offset_s
        return link.find_late(link.trips.late_s(behind_s, now_s, outrun=outrun))

    def begins_to_boot(self, frame: Frame) -> bool:
        """Take a HEARTBEAT; whether it is the first to say that the autopilot boots: an ArduPilot says so seconds
        before it sends a time, which it does only when it is asked to."""
        before, self.boots = self.boots, bool(fields(frame).system_status == mav.MAV_STATE_BOOT)
        if before or not self.boots:
            return False
        self.clock = BootClock()
        self._forget_trips()
        return True

    def _forget_trips(self) -> None:
        """Questions to the last boot stay open."""
        for one in self.links:
            one.offset_s, one.trips = None, RoundTrips()

    def choose(self, now_s: float) -> str:
        """Change to a better link where there is one; words about that, empty where it stays."""
        before = self.used
        others = [link for link in self.links if link is not before and link.fresh(now_s)]
        if not others:
            return ""
        sysid = self.key[0]
        best = min(others, key=lambda link: link.lost_share(sysid))  # of equals the first
        silent_s = best.received_s - before.received_s
        if before.address is None or before.cut_off or silent_s >= before.patience_s:
            why = f"{before.connect} is silent"
        elif now_s - self.changed_s < DWELL_S:
            return ""
        elif before.lost_share(sysid) - best.lost_share(sysid) >= BETTER_SHARE:
            why = f"{before.connect} has {100.0 * before.lost_share(sysid):.0f} % packet loss"
        else:
            back = next((link for link in self.links[: self.links.index(before)] if self._as_good(link, now_s)), None)
            if back is None:
                return ""
            best, why = back, "it is as good, and preferred"
        self.used, self.changed_s = best, now_s
        self.relinked |= not best.carries_stream_of_others(now_s)
        return f"Flown over {best.connect} now: {why}"

    def states(self, now_s: float) -> list[LinkState]:
        """Its links, in the scenario's order."""
        sysid = self.key[0]
        return [
            LinkState(link.connect, link is self.used, link.fresh(now_s), link.received, link.quality.lost_share(sysid))
            for link in self.links
        ]

    def _as_good(self, link: PeerLink, now_s: float) -> bool:
        worse = link.lost_share(self.key[0]) - self.used.lost_share(self.key[0])
        return link.fresh(now_s) and now_s - link.fresh_since_s >= RETURN_S and worse <= EQUAL_SHARE
