"""One refuelling service: how far it is, what is known of it, what a tick decides; and the desk where services ask."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from gcs.pilot import Wish


class Phase(StrEnum):
    """How far one service is."""

    JOIN = "join"
    START_RECEIVER = "start receiver"
    START_GIVER = "start giver"
    TRANSFER = "transfer"
    STOP_GIVER = "stop giver"
    CATCH_UP = "catch up"
    STOP_RECEIVER = "stop receiver"
    DONE = "done"


@dataclass
class Service:
    """One tanker serving one receiver, from the decision to the end."""

    number: int
    receiver: int
    tanker: int
    by: str
    bids: dict[int, float]
    decided_at_s: float
    phase: Phase = Phase.JOIN
    phase_since_s: float = 0.0
    near_since_s: float | None = None
    joined_at_s: float | None = None
    start_s: float | None = None
    end_s: float | None = None
    out_at_start_j: int = 0
    in_at_begin_j: int = 0
    breaks: int = 0
    in_at_start_j: int = 0
    energy_j: int = 0
    seen_refuel: bool = False
    seen_giving: bool = False
    ordered_j: int = 0
    refusals: int = 0
    broken_off: bool = False
    ended_by: str = ""
    need: float = 0.0
    need_is_largest: bool = True
    share: float = 0.0
    meets_in_s: float | None = None
    """as was known at the decision: who needed what, and how long the tanker's way was"""

    def record(self) -> dict[str, Any]:
        """The service as the summary tells it."""
        return {
            "receiver": self.receiver,
            "tanker": self.tanker,
            "by": self.by,
            "decided_at_s": self.decided_at_s,
            "joined_at_s": self.joined_at_s,
            "start_s": self.start_s,
            "end_s": self.end_s,
            "energy_j": self.energy_j,
            "bids": by_text(self.bids),
        }


@dataclass(frozen=True)
class Decision:
    """What the schedule wants now: whom each tanker is to stand above, commands, and records of what happened."""

    rendezvous: dict[int, int] = field(default_factory=dict)
    """receiver by tanker"""
    wishes: tuple[Wish, ...] = ()
    relays: tuple[tuple[int, int], ...] = ()
    """(giver, receiver) pairs between which frames are relayed"""
    partners: tuple[tuple[int, int], ...] = ()
    """(tanker, receiver) pairs that need not keep their distance from each other"""
    records: tuple[dict[str, Any], ...] = ()


class Desk:
    """What services want of vehicles in this tick, what they tell of themselves, and the answers to earlier wishes."""

    def __init__(self) -> None:
        self.wishes: list[Wish] = []
        self.records: list[dict[str, Any]] = []
        self._results: dict[str, bool] = {}

    def clear(self) -> None:
        """Begin a tick; answers stay."""
        self.wishes, self.records = [], []

    def ask(self, sysid: int, command: int, token: str, *params: float) -> None:
        """Want a command of a vehicle; an answer to an earlier one with the same token counts no more."""
        self._results.pop(token, None)
        filled = (*params, *(0.0 for _ in range(7 - len(params))))
        self.wishes.append(Wish(sysid, command, filled, token))  # type: ignore[arg-type]

    def hear(self, token: str, accepted: bool) -> None:
        """The result of a command whose wish carried this token."""
        self._results[token] = accepted

    def answer(self, token: str) -> bool | None:
        """Whether the command of this token was accepted; None while there is no result."""
        return self._results.get(token)


def token(service: Service, what: str) -> str:
    """The mark by which a service knows the result of one of its commands."""
    return f"refuel {service.number} {what}"


def by_text(numbers: Mapping[int, float]) -> dict[str, float]:
    """JSON's keys are text."""
    return {str(sysid): number for sysid, number in sorted(numbers.items())}
