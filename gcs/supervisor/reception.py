"""A tick's answers on their way in: through the radio to the fleet's state, counted, and shown to inspectors."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import NamedTuple

from gcs.link.link import Answers, Key
from gcs.link.quality import LinkQuality
from gcs.mavlink import codec
from gcs.mavlink.codec import Frame
from gcs.mavlink.datagram import AnswerRuns, raws_of
from gcs.mavlink.gaps import GapCounter
from gcs.refuelling.watched_schedule import WatchedSchedule
from gcs.supervisor.radios import Radios
from gcs.telemetry.fleet import Fleet
from gcs.telemetry.message_inspector import MessageInspector

_SYSTEM_TIME = codec.msgid("SYSTEM_TIME")
_DEBUG_FLOAT_ARRAY = codec.msgid("DEBUG_FLOAT_ARRAY")


class Received(NamedTuple):
    """Frames that came through in one tick."""

    frames: Sequence[bytes]
    """at the tick's time, in order of system id"""
    late_frames: Sequence[bytes]
    """of external vehicles in a late tick, at the time of the wall clock"""
    by_system: Mapping[int, Sequence[Frame]]


class Reception:
    """Everything that reads each frame of each vehicle."""

    def __init__(
        self,
        fleet: Fleet,
        radios: Radios,
        watched: WatchedSchedule | None,
        external: Collection[int],
    ) -> None:
        """`watched`: a schedule that hears vehicles compete on board. `external`: system ids of the vehicles that
        fly on the real clock."""
        self._fleet, self._watched, self._external = fleet, watched, external
        self._radio, self._peer_radio, self._place_radio = radios
        self._sent: dict[int, Sequence[Frame]] = {}
        self.gaps = GapCounter()
        """in the vehicles' sequence numbers, after the radio"""
        self.quality = LinkQuality(self.gaps)
        self.inspection = MessageInspector()

    def receive(self, answers: Iterable[Answers], now_s: float, late_s: Callable[[], float] = lambda: 0.0) -> Received:
        """Let the radio deliver what came, and the fleet read it, each vehicle's as it comes.

        Nothing that is read of one depends on another, so whose answer came first shows nowhere: what is given back is
        in order of system id, as are the texts, acknowledgements and facts that the fleet keeps. A tick that comes
        late_s after its time, asked when answers are in, finds what external vehicles have said until then.
        """
        received_from: dict[Key, Sequence[Frame]] = {}
        together: tuple[Sequence[Key], AnswerRuns] | None = None
        self._sent = {}
        for keys, frames in answers:
            if isinstance(frames, AnswerRuns) and self._reads_as_it_comes:
                self.gaps.feed_runs(frames)
                self._fleet.ingest_runs(frames, now_s)
                self.quality.count_runs(frames, now_s)
                together = keys, frames
            else:
                for key, sent in zip(keys, frames, strict=True):
                    received_from[key] = self._receive_from(key[0], sent, now_s, late_s)
        arrived: Sequence[bytes]
        delivered: Mapping[int, Sequence[Frame]]
        late: Sequence[bytes] = ()
        if together is not None and not received_from:
            arrived, delivered = together[1].frames, together[1].by_system()
        else:
            received_from |= zip(*together, strict=True) if together is not None else ()
            in_order = sorted(received_from.items())
            of_late = self._external if late_s() else ()
            arrived = [raw for key, received in in_order if key[0] not in of_late for raw in raws_of(received)]
            late = [raw for key, received in in_order if key[0] in of_late for raw in raws_of(received)]
            delivered = {key[0]: received for key, received in in_order}
        if self._place_radio is not None:
            at_once: Mapping[int, Sequence[Frame]] = together[1].by_system() if together is not None else {}
            self._place_radio.send({**at_once, **self._sent} if self._sent else at_once)
        for sysid in self.inspection.wanted & delivered.keys() if self.inspection.wanted else ():
            self.inspection.add(delivered[sysid], now_s)
        return Received(arrived, late, delivered)

    @property
    def _reads_as_it_comes(self) -> bool:
        """Whether nothing stands between what vehicles send and what reads it by compiled code."""
        return self._peer_radio is None and self._radio.clear and self._watched is None

    def _receive_from(
        self, sysid: int, frames: Sequence[Frame], now_s: float, late_s: Callable[[], float]
    ) -> Sequence[Frame]:
        """Let the radio deliver one vehicle's frames, and the fleet read them; those that came through."""
        received = self._sent[sysid] = frames
        exempt = 0
        if self._peer_radio is not None:
            self._peer_radio.send(sysid, frames)
        if not self._radio.clear:
            impaired = [frame for frame in frames if frame.msgid != _SYSTEM_TIME]
            grants = [frame for frame in frames if frame.msgid == _SYSTEM_TIME]
            received = [*self._radio.apply(sysid, "in", now_s, impaired), *grants]
            exempt = len(grants)  # they are never lost, and say nothing of the radio
        self.gaps.feed_all(received)
        self._fleet.ingest_all(received, now_s + late_s() if sysid in self._external else now_s)
        if self._watched is not None:
            for frame in received:
                if frame.msgid == _DEBUG_FLOAT_ARRAY:
                    self._watched.receive(frame.sysid, codec.fields(frame), now_s)
        self.quality.count(sysid, len(received) - exempt, now_s)
        return received
