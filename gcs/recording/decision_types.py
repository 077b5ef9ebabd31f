"""Decision records as a report reads them, typed by kind: a line that does not hold that is foreign.

Other keys of a decision (gcs/schemas/decisions.schema.json) are optional for readers. Times s, energies J.
"""

from __future__ import annotations

from typing import Annotated, Any

import msgspec

SysId = Annotated[int, msgspec.Meta(ge=1, le=255)]
ByVehicle = dict[SysId, float]


class _Competition(msgspec.Struct, gc=False):
    v: ByVehicle
    leader: SysId | None
    share: float
    giver: str | None = None


class _Decided(msgspec.Struct, gc=False, kw_only=True):
    """By a tanker, or at a base that has a name."""

    receiver: SysId
    tanker: SysId | None
    base: str | None = None
    by: str
    bids: ByVehicle

    def __post_init__(self) -> None:
        if self.tanker is None and self.base is None:
            raise ValueError("neither a tanker nor a base")


class _Served(_Decided, gc=False, kw_only=True):
    reason: str
    decided_at_s: float
    joined_at_s: float | None
    start_s: float | None
    end_s: float
    energy_j: float


_KINDS: dict[str, type[msgspec.Struct] | dict[str, Any]] = {
    "competition": _Competition,
    "decided": _Decided,
    "served": _Served,
    "broken off": {"receiver": SysId, "tanker": SysId | None},
    "pursuit": {"target": SysId, "pursuer": SysId},
    "policy failed": {"policy": str, "problem": str},
    "death": {"text": str},
    "boot": {"sysid": SysId, "text": str},
    "event": {"sysid": SysId, "severity": int, "text": str},
    "mission": {"sysid": SysId, "state": str, "item": int, "of": int},
    "violation": {"part": str, "at_s": float, "sysids": list[SysId], "text": str},
    "unable": {"receiver": SysId, "reason": str},
    "command": {"sysid": SysId, "mav_cmd": int},
    "world": {"change": str},
    "operator": {"command": str, "taken": bool, "text": str},
    "fault": {"sysid": Annotated[int, msgspec.Meta(ge=0, le=255)], "state": str, "text": str},
}
_DECODERS: dict[str, msgspec.json.Decoder[msgspec.Struct]] = {
    kind: msgspec.json.Decoder(
        msgspec.defstruct("Decision", keys.items(), gc=False) if isinstance(keys, dict) else keys
    )
    for kind, keys in _KINDS.items()
}
COMPETITION = ("kind", *_Competition.__struct_fields__)
"""Keys that are kept of a decision that comes once a tick, with numbers of every vehicle."""


def holds_what_is_read(kind: str, line: bytes) -> bool:
    """Whether a line of decisions.jsonl holds what a report reads of its kind; of other kinds nothing is read."""
    decoder = _DECODERS.get(kind)
    if decoder is None:
        return True
    try:
        decoder.decode(line)
    except (msgspec.MsgspecError, UnicodeDecodeError):
        return False
    return True
