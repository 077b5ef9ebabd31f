"""One refuelling service: its phase and figures, the decisions of a tick, and the commands that are requested."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import IntEnum, StrEnum
from typing import Any

from gcs.mavlink.autopilots import STEERABLE
from gcs.mavlink.command_protocol import CommandRequest
from gcs.telemetry.state import Vec3, VehicleView
from skytender import mavlink as mav


class Phase(StrEnum):
    """Phase of one service."""

    JOIN = "join"
    LAND = "land at the base"
    START_RECEIVER = "start receiver"
    START_GIVER = "start giver"
    TRANSFER = "transfer"
    STOP_GIVER = "stop giver"
    CATCH_UP = "catch up"
    STOP_RECEIVER = "stop receiver"
    TAKE_OFF = "take off"
    DONE = "done"


class TransferRole(IntEnum):
    """param2 of MAV_CMD_USER_1, the command that starts and stops a transfer of energy
    (docs/protocol/energy.md#energy-transfer): what the vehicle is to do."""

    STOP = 0
    GIVE = 1
    RECEIVE = 2
    SETTLE = 3


@dataclass
class Service:
    """One tanker, or one base, serving one receiver, from the decision to the end."""

    number: int
    receiver: int
    tanker: int | None
    """None: a base serves it"""
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
    gain: float | None = None
    meets_in_s: float | None = None
    """as was known at the decision: needs, what its service gained, and how long the way to each other was"""
    base: str | None = None
    why_base: str = ""
    """why no tanker could serve it"""
    charged_s: float = 0.0
    fraction_j: float = 0.0
    reported_in_j: int = 0
    progress_s: float = 0.0
    out_at_progress_j: int = 0
    """what the receiver last counted, when that rose, and what its tanker had given then"""
    ends_early: bool = False
    """whether it is to end before its receiver is full, for vehicles that wait"""

    @property
    def giver(self) -> str:
        """For messages: the tanker's system id, or `base NAME`."""
        return str(self.tanker) if self.base is None else f"base {self.base}"

    @property
    def sides(self) -> dict[str, Any]:
        """Receiver and giver as every record of a service names them."""
        base = {} if self.base is None else {"base": self.base}
        return {"receiver": self.receiver, "tanker": self.tanker, **base}

    def go(self, phase: Phase, now_s: float) -> None:
        """Begin a phase."""
        self.phase, self.phase_since_s = phase, now_s

    def has_held(self, near: bool, now_s: float, hold_s: float) -> bool:
        """Whether the receiver has been `near` its giver for `hold_s` by now; asked in every tick of the joining."""
        if not near:
            self.near_since_s = None
        elif self.near_since_s is None:
            self.near_since_s = now_s
        return self.near_since_s is not None and now_s - self.near_since_s >= hold_s

    def record(self) -> dict[str, Any]:
        """The service as the summary holds it."""
        return {
            **self.sides,
            "by": self.by,
            "decided_at_s": self.decided_at_s,
            "joined_at_s": self.joined_at_s,
            "start_s": self.start_s,
            "end_s": self.end_s,
            "energy_j": self.energy_j,
            "bids": by_text(self.bids),
        }


@dataclass(frozen=True)
class GiverReport:
    """Report of a base to the vehicle that it charges: its place, and the joules given so far."""

    sysid: int
    p_ned: Vec3
    given_j: int


@dataclass(frozen=True)
class Decision:
    """Result of one tick of the scheduler: rendezvous, command requests, and records."""

    rendezvous: dict[int, int] = field(default_factory=dict)
    """receiver by tanker; the two need not keep their distance from each other once a service has been decided"""
    approaches: frozenset[int] = frozenset()
    """tankers of these for which none has been decided yet"""
    requests: tuple[CommandRequest, ...] = ()
    relays: tuple[tuple[int, int], ...] = ()
    """(giver, receiver) pairs between which frames are relayed"""
    stations: dict[int, Vec3] = field(default_factory=dict)
    """where a vehicle that a base serves is to be, common NED frame"""
    grounded: frozenset[int] = frozenset()
    """vehicles that are to land where they are, and to stay on the ground"""
    giver_reports: tuple[GiverReport, ...] = ()
    booked: dict[int, int] = field(default_factory=dict)
    """joules that a base gave in this tick to vehicles that cannot count them"""
    records: tuple[dict[str, Any], ...] = ()

    @property
    def partners(self) -> list[tuple[int, int]]:
        """(tanker, receiver) of each service in the air."""
        return [pair for pair in self.rendezvous.items() if pair[0] not in self.approaches]


NOTHING_DECIDED = Decision()
"""Of a tick in which no vehicle is served; only to be read, as every decision."""


class ServiceRequests:
    """Commands that services request in this tick, their records, and the results of earlier commands."""

    def __init__(self) -> None:
        self.requests: list[CommandRequest] = []
        self.records: list[dict[str, Any]] = []
        self._results: dict[str, bool] = {}

    def clear(self) -> None:
        """Begin a tick; results stay."""
        self.requests, self.records = [], []

    def request(self, command: CommandRequest) -> None:
        """Request a command; the result of an earlier one with the same token counts no more."""
        self._results.pop(command.token, None)
        self.requests.append(command)

    def order(
        self,
        service: Service,
        sysid: int,
        what: str,
        role: TransferRole,
        *,
        partner: int,
        limit_j: float,
        rate_w: float,
        given_at_start_j: int,
    ) -> None:
        """Request MAV_CMD_USER_1 of one side of a service, `what` naming it in its token.

        partner: system id of the other side. limit_j: whole joules at most; of SETTLE those that the receiver has
        credited. given_at_start_j: the giver's counter XferOut when the transfer began.
        """
        params = (partner, role, math.floor(limit_j), rate_w, service.number, given_at_start_j)
        self.request(CommandRequest(sysid, mav.MAV_CMD_USER_1, tuple(map(float, params)), token(service, what)))

    def receive_result(self, token: str, accepted: bool) -> None:
        """Store the result of the command with this token."""
        self._results[token] = accepted

    def accepted(self, token: str) -> bool | None:
        """Whether the command with this token was accepted; None while there is no result."""
        return self._results.get(token)


def unfit(view: VehicleView) -> str | None:
    """Why a vehicle cannot keep formation any more."""
    if not view.fresh:
        return f"no answer from {view.label}"
    if not view.flying or view.mode not in STEERABLE:
        return f"{view.label} left formation flight"
    return None


def token(service: Service, what: str) -> str:
    """The mark by which a service knows the result of one of its commands."""
    return f"refuel {service.number} {what}"


def by_text(numbers: Mapping[int, float]) -> dict[str, float]:
    """JSON's keys are text."""
    return {str(sysid): number for sysid, number in sorted(numbers.items())}
