"""summary.json: how a session ended and what it amounts to (contract.md, A session's folder)."""

from __future__ import annotations

import math
import os
import platform
from collections import defaultdict
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Literal, cast

from pydantic import BaseModel, ConfigDict, Field

if TYPE_CHECKING:  # who only reads a summary need not load the supervisor
    from gcs.link.fleet import MixedLink
    from gcs.link.lockstep import FleetLink
    from gcs.supervisor import Supervisor
    from gcs.telemetry.state import VehicleView

FILE = "summary.json"


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, use_attribute_docstrings=True)


class Energy(_Part):
    """One vehicle's ledger, as its messages tell it."""

    initial_j: float
    drawn_j: float
    received_j: float
    given_j: float
    lost_j: float
    """given, and never credited by a receiver"""
    remaining_j: float
    source: str
    """the message field that `drawn_j` was read from"""


Role = Literal["pursuer", "target", "tanker"]


class Vehicle(_Part):
    """One vehicle's session."""

    sysid: int
    role: Role
    final_mode: str
    max_tracking_error_m: float | None
    """greatest distance from the planned path; null where there was none"""
    path_length_m: float
    control_effort: float
    energy: Energy
    missing_streams: list[str] = []
    """messages that an external vehicle was asked for and did not send at the end, or at less than half the rate"""


class Refuelling(_Part):
    """One service, in the order of decision; times are null for steps that were not reached."""

    receiver: int
    tanker: int | None
    """null: a base served it"""
    base: str | None = None
    by: Literal["competition", "timeout", "urgency", "policy", "operator"]
    decided_at_s: float
    joined_at_s: float | None
    start_s: float | None
    end_s: float | None
    energy_j: float
    bids: dict[str, float]
    """normalised need of each competitor at the decision, by system id"""


class Base(_Part):
    """A base's ledger: initial = given + remaining."""

    name: str
    initial_j: float
    given_j: float
    lost_j: float
    """given, and never credited by a receiver"""
    remaining_j: float


class Link(_Part):
    """Frames over the supervised links; `overflowed` are datagrams that the kernel dropped."""

    received: int
    sent: int
    lost: int
    malformed: int
    overflowed: int
    command_retries: int


class Summary(_Part):
    """The session."""

    schema_version: Literal[1] = Field(1, alias="schema")
    scenario: str
    seed: int
    clock: Literal["lockstep", "real"]
    speed: float | None
    """the pace that was asked for, in session time over wall time; null in lockstep, which has none"""
    sim_time_s: float
    wall_time_s: float
    speed_achieved: float
    lag_s: float
    """how much the session's clock fell behind its pace; with external vehicles, what late ticks had to catch up"""
    completed: bool
    outcome: str
    """`met`, the first part of the goal that was not met, `vehicle_lost` or `interrupted`"""
    digest: str | None
    """null with external vehicles: their flight never repeats"""
    versions: dict[str, str]
    min_separation_m: float | None
    min_clearance_m: float | None
    vehicles: list[Vehicle]
    refuelling: list[Refuelling]
    refuel_order: list[int]
    link: Link
    bases: list[Base] = []

    def write(self, folder: Path) -> None:
        """Write summary.json into a session's folder, whole or not at all; raises OSError."""
        text = self.model_dump_json(indent=2, by_alias=True) + "\n"
        beside = folder / f".{FILE}.{os.getpid()}"
        try:
            beside.write_text(text, encoding="utf-8")
            beside.replace(folder / FILE)
        except OSError:
            beside.unlink(missing_ok=True)
            raise


def summarise(
    supervisor: Supervisor,
    link: FleetLink | MixedLink,
    *,
    outcome: str,
    completed: bool,
    wall_time_s: float,
    lag_s: float,
) -> Summary:
    """What a session that has ended amounts to; the link must still be open."""
    scenario, metrics, schedule = supervisor.scenario, supervisor.metrics, supervisor.schedule
    snapshot = supervisor.fleet.snapshot(supervisor.time_s)
    schedule.settle(snapshot)
    credited_j: dict[int | str | None, int] = defaultdict(int)
    for service in schedule.services:
        credited_j[service.tanker if service.base is None else service.base] += service.energy_j
    return Summary(
        schema=1,
        scenario=scenario.name,
        seed=scenario.seed,
        clock=scenario.clock.mode,
        speed=scenario.clock.speed if scenario.clock.mode == "real" else None,
        sim_time_s=supervisor.time_s,
        wall_time_s=wall_time_s,
        speed_achieved=supervisor.time_s / wall_time_s if wall_time_s > 0.0 else 0.0,
        lag_s=lag_s,
        completed=completed,
        outcome=outcome,
        digest=None if scenario.vehicles.external else supervisor.digest.hexdigest(),
        versions=_versions(),
        min_separation_m=_finite(metrics.min_separation_m),
        min_clearance_m=_finite(metrics.min_clearance_m),
        vehicles=[
            Vehicle(
                sysid=view.sysid,
                role=cast(Role, view.role),
                final_mode=str(view.mode) if view.alive else "dead",
                max_tracking_error_m=metrics.max_tracking_error_m.get(view.sysid),
                path_length_m=metrics.path_length_m.get(view.sysid, 0.0),
                control_effort=view.control_effort,
                energy=_ledger(view, view.given_j - credited_j[view.sysid]),
                missing_streams=supervisor.externals.missing_streams(view.sysid),
            )
            for view in snapshot.vehicles
        ],
        refuelling=[Refuelling(**service.record()) for service in schedule.services],
        refuel_order=[service.receiver for service in schedule.refuelled],
        bases=[
            Base(
                name=stock.base.name,
                initial_j=stock.base.stock_j,
                given_j=stock.given_j,
                lost_j=stock.given_j - credited_j[stock.base.name],
                remaining_j=stock.remaining_j,
            )
            for stock in schedule.stocks
        ],
        link=Link(
            received=supervisor.received,
            sent=supervisor.sent,
            lost=supervisor.lost_frames,
            malformed=link.malformed,
            overflowed=link.overflowed(),
            command_retries=supervisor.command_retries,
        ),
    )


def _ledger(view: VehicleView, lost_j: int) -> Energy:
    return Energy(
        initial_j=view.initial_j,
        drawn_j=view.drawn_j,
        received_j=view.received_j,
        given_j=view.given_j,
        lost_j=lost_j,
        remaining_j=view.remaining_j,
        source=view.energy_source,
    )


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _versions() -> dict[str, str]:
    names = ("skytender", "pymavlink", "numpy", "scipy", "numba")
    return {"python": platform.python_version(), **{name: version(name) for name in names}}
