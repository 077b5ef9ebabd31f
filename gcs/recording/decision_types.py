"""Decision records as a report reads them, typed by kind: a line that does not hold that is foreign.

Other keys of a decision (gcs/schemas/decisions.schema.json) are for whoever wants them. Times s, energies J.
"""

from __future__ import annotations

from typing import Annotated

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


class _BrokenOff(msgspec.Struct, gc=False):
    receiver: SysId
    tanker: SysId | None


class _Pursuit(msgspec.Struct, gc=False):
    target: SysId
    pursuer: SysId


class _PolicyFailed(msgspec.Struct, gc=False):
    policy: str
    problem: str


class _Death(msgspec.Struct, gc=False):
    text: str


class _Violation(msgspec.Struct, gc=False):
    part: str
    at_s: float
    sysids: list[SysId]
    text: str


class _Unable(msgspec.Struct, gc=False):
    receiver: SysId
    reason: str


class _OperatorCommand(msgspec.Struct, gc=False):
    command: str
    taken: bool
    text: str


class _Fault(msgspec.Struct, gc=False):
    sysid: Annotated[int, msgspec.Meta(ge=0, le=255)]
    state: str
    text: str


_DECODERS: dict[str, msgspec.json.Decoder[msgspec.Struct]] = {
    "competition": msgspec.json.Decoder(_Competition),
    "decided": msgspec.json.Decoder(_Decided),
    "served": msgspec.json.Decoder(_Served),
    "broken off": msgspec.json.Decoder(_BrokenOff),
    "pursuit": msgspec.json.Decoder(_Pursuit),
    "policy failed": msgspec.json.Decoder(_PolicyFailed),
    "death": msgspec.json.Decoder(_Death),
    "violation": msgspec.json.Decoder(_Violation),
    "unable": msgspec.json.Decoder(_Unable),
    "operator": msgspec.json.Decoder(_OperatorCommand),
    "fault": msgspec.json.Decoder(_Fault),
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
