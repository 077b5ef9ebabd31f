"""The mission protocol without a socket or a clock: uploads, downloads and clearing of the three kinds of plan.

The rules of an upload:
1. MISSION_COUNT opens it; items are asked for one after the other by MISSION_REQUEST_INT, and taken only in that order.
   An item with another number is not taken; the one that is missing is asked for again.
2. The plan in force stays until the last item has come and the whole is accepted; what is refused changes nothing.
   An item that no plan can have is refused when it comes, so that the sender knows which one it is.
3. A request without an answer is repeated every 0.5 s; after five of them the upload is given up, and said so.
4. The last item, repeated because the acknowledgement was lost, is acknowledged again.
5. One upload at a time: a count from the same sender begins it again; a count or a clearing from another sender is
   refused. Clearing another kind of plan leaves it as it is.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from simvehicle.mavlink.codec import message
from simvehicle.mavlink.plan_items import MOST_ITEMS, Item, PlanError, item_from
from skytender import mavlink as mav

RETRY_S = 0.5
MOST_RETRIES = 5
ACCEPTED: int = mav.MAV_MISSION_ACCEPTED
KINDS = (mav.MAV_MISSION_TYPE_MISSION, mav.MAV_MISSION_TYPE_FENCE, mav.MAV_MISSION_TYPE_RALLY)

Peer = tuple[int, int]
AcceptPlan = Callable[[int, tuple[Item, ...]], None]
"""Puts a plan of a kind (MAV_MISSION_TYPE) in force, or raises PlanError."""
CheckItem = Callable[[int, int, Item], None]
"""Raises PlanError for an item, by its kind of plan and its number, that cannot be taken."""


class Post(NamedTuple):
    """A message and the peer's channel that it goes to."""

    channel: Any
    content: Any


class _Upload:
    def __init__(self, peer: Peer, channel: Any, kind: int, total: int, now_s: float) -> None:
        self.peer, self.channel, self.kind, self.total = peer, channel, kind, total
        self.items: list[Item] = []
        self.asked_s = now_s
        self.retries = 0

    def request(self, now_s: float) -> Post:
        self.asked_s = now_s
        content = message("MISSION_REQUEST_INT")(
            target_system=self.peer[0],
            target_component=self.peer[1],
            seq=len(self.items),
            mission_type=self.kind,
        )
        return Post(self.channel, content)


class MissionProtocol:
    """The plans in force, as items, and the upload under way; `channel` is whatever its answers are to be put on."""

    def __init__(self, accept: AcceptPlan, check: CheckItem) -> None:
        self.plans: dict[int, tuple[Item, ...]] = dict.fromkeys(KINDS, ())
        self._accept, self._check = accept, check
        self._upload: _Upload | None = None
        self._finished: tuple[Peer, int, int] | None = None

    def count(self, content: Any, peer: Peer, channel: Any, now_s: float) -> list[Post]:
        """MISSION_COUNT: begin an upload; an empty one clears."""
        kind, upload = content.mission_type, self._upload
        if upload is not None and upload.peer != peer:
            return [_ack(peer, channel, kind, mav.MAV_MISSION_ERROR)]
        if kind not in KINDS:
            return [_ack(peer, channel, kind, mav.MAV_MISSION_UNSUPPORTED)]
        if content.count > MOST_ITEMS:
            return [_ack(peer, channel, kind, mav.MAV_MISSION_NO_SPACE)]
        if content.count == 0:
            return self._finish(peer, channel, kind, ())
        self._upload = _Upload(peer, channel, kind, content.count, now_s)
        return [self._upload.request(now_s)]

    def item(self, content: Any, peer: Peer, channel: Any, now_s: float) -> list[Post]:
        """MISSION_ITEM_INT or MISSION_ITEM: the one that was asked for, or none that counts."""
        upload = self._upload
        if upload is None or upload.peer != peer or upload.kind != content.mission_type:
            repeated = self._finished == (peer, content.mission_type, content.seq)
            return [_ack(peer, channel, content.mission_type, ACCEPTED)] if repeated else []
        if content.seq < len(upload.items):
            return []
        if content.seq > len(upload.items):
            return [upload.request(now_s)]
        try:
            item = item_from(content)
            self._check(upload.kind, content.seq, item)
        except PlanError as error:
            self._upload = None
            return [_ack(peer, channel, upload.kind, error.result)]
        upload.items.append(item)
        upload.retries = 0
        if len(upload.items) < upload.total:
            return [upload.request(now_s)]
        return self._finish(peer, channel, upload.kind, tuple(upload.items))

    def clear(self, content: Any, peer: Peer, channel: Any) -> list[Post]:
        """MISSION_CLEAR_ALL of one kind, or of all."""
        kind = content.mission_type
        if kind != mav.MAV_MISSION_TYPE_ALL and kind not in KINDS:
            return [_ack(peer, channel, kind, mav.MAV_MISSION_UNSUPPORTED)]
        if self._upload is not None and self._upload.peer != peer:
            return [_ack(peer, channel, kind, mav.MAV_MISSION_ERROR)]
        result = ACCEPTED
        for each in KINDS if kind == mav.MAV_MISSION_TYPE_ALL else (kind,):
            result = self._put_in_force(each, ()) or result
        return [_ack(peer, channel, kind, result)]

    def send_count(self, content: Any, peer: Peer, channel: Any) -> list[Post]:
        """MISSION_REQUEST_LIST: how many items there are to download."""
        plan = self.plans.get(content.mission_type)
        if plan is None:
            return [_ack(peer, channel, content.mission_type, mav.MAV_MISSION_UNSUPPORTED)]
        count = message("MISSION_COUNT")(
            target_system=peer[0], target_component=peer[1], count=len(plan), mission_type=content.mission_type
        )
        return [Post(channel, count)]

    def request(self, content: Any, peer: Peer, channel: Any, *, current: int, home: Item | None) -> list[Post]:
        """MISSION_REQUEST_INT or MISSION_REQUEST: one item of a download; `current` is the mission's leg in flight, and
        `home` reads as its item 0, where missions begin with home."""
        kind, seq = content.mission_type, content.seq
        plan = self.plans.get(kind, ())
        if kind == mav.MAV_MISSION_TYPE_MISSION and home is not None:
            plan = (home, *plan[1:])
        if seq >= len(plan):
            return [_ack(peer, channel, kind, mav.MAV_MISSION_INVALID_SEQUENCE)]
        item = plan[seq]
        reply = message("MISSION_ITEM_INT")(
            target_system=peer[0],
            target_component=peer[1],
            seq=seq,
            frame=item.frame,
            command=item.command,
            current=int(kind == mav.MAV_MISSION_TYPE_MISSION and seq == current),
            autocontinue=item.autocontinue,
            param1=item.params[0],
            param2=item.params[1],
            param3=item.params[2],
            param4=item.params[3],
            x=item.x,
            y=item.y,
            z=item.z,
            mission_type=kind,
        )
        return [Post(channel, reply)]

    def partial(self, content: Any, peer: Peer, channel: Any) -> list[Post]:
        """MISSION_WRITE_PARTIAL_LIST: plans are taken whole only."""
        return [_ack(peer, channel, content.mission_type, mav.MAV_MISSION_UNSUPPORTED)]

    def cancel(self, content: Any, peer: Peer) -> None:
        """MISSION_ACK of the other side: the end of a download, or of an upload that it gives up."""
        if self._upload is not None and self._upload.peer == peer and content.type != ACCEPTED:
            self._upload = None

    @property
    def at_work(self) -> bool:
        """Whether an upload is under way."""
        return self._upload is not None

    def due(self, now_s: float) -> list[Post]:
        """Repeat what has to be asked for again, or give up."""
        upload = self._upload
        if upload is None or now_s - upload.asked_s < RETRY_S:
            return []
        upload.retries += 1
        if upload.retries <= MOST_RETRIES:
            return [upload.request(now_s)]
        self._upload = None
        return [_ack(upload.peer, upload.channel, upload.kind, mav.MAV_MISSION_OPERATION_CANCELLED)]

    def forget(self) -> None:
        """Have no plans and no upload, as after a reboot."""
        self.plans = dict.fromkeys(KINDS, ())
        self._upload = None

    def _finish(self, peer: Peer, channel: Any, kind: int, items: tuple[Item, ...]) -> list[Post]:
        result = self._put_in_force(kind, items)
        if result == ACCEPTED:
            self._finished = (peer, kind, len(items) - 1)
        return [_ack(peer, channel, kind, result)]

    def _put_in_force(self, kind: int, items: tuple[Item, ...]) -> int:
        """Put a plan in force, and end the upload of its kind; a MAV_MISSION_RESULT."""
        if self._upload is not None and self._upload.kind == kind:
            self._upload = None
        try:
            self._accept(kind, items)
        except PlanError as error:
            return error.result
        self.plans[kind] = items
        return ACCEPTED


def _ack(peer: Peer, channel: Any, kind: int, result: int) -> Post:
    content = message("MISSION_ACK")(target_system=peer[0], target_component=peer[1], type=result, mission_type=kind)
    return Post(channel, content)
