"""summary.json: how a session ended and what it amounts to (docs/protocol/result.md#summary)."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from gcs.html_table import html_table
from gcs.scenario.described import Described

FILE = "summary.json"


class SummaryPart(Described, BaseModel):
    """A part of summary.json."""

    model_config = ConfigDict(extra="forbid", allow_inf_nan=False, defer_build=True)


class EnergySummary(SummaryPart):
    """One vehicle's ledger, as its messages report it."""

    initial_j: float
    drawn_j: float
    received_j: float
    """of a tanker: what came back to it, having been on the way when a transfer ended"""
    given_j: float
    lost_j: float
    """given, never credited by a receiver, and not come back"""
    remaining_j: float
    source: str
    """the message field that `drawn_j` was read from"""


Role = Literal["pursuer", "target", "tanker"]


class CheckedItem(SummaryPart):
    """An entry of a vehicle's check list before the flight."""

    key: str
    """fence, rally or clock"""
    passed: bool
    text: str


class VehicleLinkSummary(SummaryPart):
    """One of several links to an external vehicle, at the session's end."""

    connect: str
    used: bool
    """whether it was the one in use"""
    fresh: bool
    received: int
    """frames, also those that came over another link too"""
    lost_share: float | None
    """of the frames of the last 10 s, 0 to 1"""


class MissionSummary(SummaryPart):
    """A vehicle's own mission."""

    items: int
    reached: int
    """items that are behind it"""
    flown_at_s: float | None
    """when it reached its last item; null where it has not"""
    holds: int
    """how often it was held, to keep apart"""
    held_s: float


class VehicleSummary(SummaryPart):
    """One vehicle's session."""

    sysid: int
    role: Role
    final_mode: str
    """takeoff, offboard, hold, land, return, refuel, mission, manual, other or dead"""
    final_mode_name: str = ""
    """the same as its autopilot's people call it; empty in older sessions"""
    max_tracking_error_m: float | None
    """greatest distance from the planned path; null where there was none"""
    path_length_m: float
    control_effort: float
    energy: EnergySummary
    missing_streams: list[str] = []
    """messages that an external vehicle was asked for and did not send at the end, or at less than half the rate"""
    check_list: list[CheckedItem] = []
    """what was checked before it was armed; empty where nothing was"""
    refused_messages: int = 0
    """messages with its id that were refused: not signed, signed with another key, repeated, or without a key here"""
    mission: MissionSummary | None = None
    """null where it has none"""
    links: list[VehicleLinkSummary] = []
    """of an external vehicle with several links, in the scenario's order; empty where it has one"""


class RefuellingSummary(SummaryPart):
    """One service, in the order of decision; times are null for steps that were not reached."""

    receiver: int
    tanker: int | None
    """null: a base served it"""
    base: str | None = None
    by: Literal["competition", "unopposed", "timeout", "urgency", "policy", "operator"]
    decided_at_s: float
    joined_at_s: float | None
    start_s: float | None
    end_s: float | None
    energy_j: float
    bids: dict[str, float]
    """normalised need of each competitor at the decision, by system id"""


class BaseSummary(SummaryPart):
    """A base's ledger: initial = given + remaining."""

    name: str
    initial_j: float
    given_j: float
    lost_j: float
    """given, and never credited by a receiver"""
    remaining_j: float


class LinkSummary(SummaryPart):
    """Frames over the supervised links; `overflowed` are datagrams that the kernel dropped."""

    received: int
    sent: int
    lost: int
    malformed: int
    overflowed: int
    command_retries: int


class GoalPartSummary(SummaryPart):
    """Result of one part of the goal (docs/protocol/result.md#goal)."""

    part: str
    """`lost`, `duration`, `separation`, `clearance`, `traffic`, `ground`, `waypoints`, `pursue` or `refuelled`"""
    wanted: str
    reached: str
    met: bool
    value: float | None
    """null where there was nothing to measure"""
    limit: float
    unit: str
    sysids: list[int]
    """system ids; of `separation` the pair"""
    what: str
    """the obstacle or aircraft; empty otherwise"""
    t_s: float | None
    """when, s of session time; null of what has no one time"""


Nearness = Literal["separation", "clearance", "traffic"]


class ClosestSummary(SummaryPart):
    """The nearest approach: vehicles, object and time."""

    distance_m: float
    sysids: list[int]
    what: str
    """the obstacle or aircraft; empty between vehicles"""
    t_s: float


class FaultSummary(SummaryPart):
    """A fault that was injected."""

    fault: str
    sysid: int | None
    """null: it befell all"""
    begin_s: float
    end_s: float | None
    """null: it stayed"""
    survived: bool
    """whether every vehicle that it befell is still there at the end"""
    text: str


class Summary(SummaryPart):
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
    """`met`, the name of the first part of the goal that was not met, or `interrupted`"""
    outcome_text: str = ""
    """the same as a sentence, with every part that was not met; empty in sessions of earlier versions"""
    goal: list[GoalPartSummary] = []
    """each part of the goal, in the order in which an outcome names them"""
    unmet: list[GoalPartSummary] = []
    """those of them that were not met"""
    judged_by: Literal["truth", "reports"] = "reports"
    """whether the distances are those that launched vehicles themselves knew, or those that vehicles reported"""
    digest: str | None
    """null with external vehicles and real PX4s: their flight never repeats"""
    versions: dict[str, str]
    min_separation_m: float | None
    """least distance of two vehicles in flight, except during a transfer, between ticks too; null without a pair"""
    min_clearance_m: float | None
    """least distance to an obstacle's surface (a point's is its centre); null without obstacles"""
    min_traffic_m: float | None = None
    """least distance to traffic that is to be kept away from; null without any"""
    closest: dict[Nearness, ClosestSummary] = {}
    """which vehicles and when"""
    believed_min_separation_m: float | None = None
    """the same by what vehicles reported"""
    believed_min_clearance_m: float | None = None
    believed_min_traffic_m: float | None = None
    vehicles: list[VehicleSummary]
    refuelling: list[RefuellingSummary]
    refuel_order: list[int]
    tanker_idle_s: float = 0.0
    """tankers' time, summed, in which they stood free although a vehicle waited for energy"""
    link: LinkSummary
    faults: list[FaultSummary] = []
    """those of the scenario that happened"""
    bases: list[BaseSummary] = []

    def _repr_html_(self) -> str:
        distances = {
            "separation": self.min_separation_m,
            "clearance": self.min_clearance_m,
            "traffic": self.min_traffic_m,
        }
        return html_table(
            [
                ("outcome", self.outcome_text),
                ("flown", f"{self.sim_time_s:.1f} s"),
                *((f"least {name}", f"{least_m:.2f} m") for name, least_m in distances.items() if least_m is not None),
                ("vehicles", len(self.vehicles)),
                ("refuelled", " ".join(map(str, self.refuel_order)) or "none"),
                ("digest", self.digest),
            ]
        )

    def write(self, folder: Path) -> None:
        """Write summary.json into a session's folder, whole or not at all; raises OSError."""
        text = self.model_dump_json(indent=2, by_alias=True) + "\n"
        beside = folder / f".{FILE}.{os.getpid()}"
        try:
            beside.write_text(text, encoding="utf-8")
            beside.replace(folder / FILE)
        except OSError as error:
            beside.unlink(missing_ok=True)
            raise OSError(error.errno, error.strerror, str(folder / FILE)) from None
