"""The arming sequences of a fleet: which a tick has to ask, and what follows from the states of all of them.

A sequence need not be asked while three things hold: of its vehicle nothing but figures has changed, which columns
say (gcs/telemetry/columns.py); nothing has been requested of it since; and it `rests`. Then it would command nothing
and change nothing. In flight that is nearly every vehicle in nearly every tick.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple, Self

from gcs.mavlink.autopilots import End
from gcs.supervisor.arming import ArmingSequence, Stage
from gcs.telemetry.changes import GOING_DOWN
from gcs.telemetry.columns import FleetColumns
from gcs.telemetry.events import Event
from gcs.telemetry.state import VehicleView


class Groups(NamedTuple):
    """Vehicles by the states of their arming sequences."""

    steered: frozenset[int]
    """to which set points should be sent"""
    takes_off: frozenset[int]
    """on their way into the air, from before they are armed"""
    yielded: frozenset[int]
    """under other control: another ground station's or a pilot's"""
    ordered: dict[int, End]
    """mode of each that an operator has taken over"""

    @classmethod
    def of(cls, sequences: Mapping[int, ArmingSequence]) -> Self:
        """The groups of all sequences as they are."""
        each = sequences.items()
        return cls(
            frozenset([sysid for sysid, one in each if one.sends_set_points]),
            frozenset([sysid for sysid, one in each if one.stage in (Stage.ARM, Stage.TAKEOFF)]),
            frozenset([sysid for sysid, one in each if one.stage is Stage.YIELDED]),
            {sysid: one.ordered for sysid, one in each if one.ordered is not None},
        )


class FleetArming:
    """Sequences to ask at a tick (`due`, and `asked` for each of them), and sets that depend on all of them."""

    def __init__(self, sequences: Mapping[int, ArmingSequence]) -> None:
        self.sequences = sequences
        self._restless = set(sequences)
        self._due: list[int] = []
        self._touched: set[int] = set()
        """vehicles of which something was requested since they were asked"""
        self._number = -1
        """of the last snapshot"""
        self._groups: Groups | None = None
        """None where a sequence has decided or was requested something since they were found"""
        for sequence in sequences.values():
            sequence.touched = self._touched

    def due(self, columns: FleetColumns) -> list[int]:
        """System ids, in order, of those that have to be asked now; `columns` are of the views they will be shown."""
        if self._touched:
            self._groups = None
        self._restless.update(self._touched, columns.changed_since(self._number))
        self._touched.clear()
        self._number = columns.number
        self._due = sorted(self._restless)
        return self._due

    def asked(self, sysid: int, view: VehicleView) -> None:
        """A sequence has just decided on this view."""
        self._groups = None
        if self.sequences[sysid].rests(view):
            self._restless.discard(sysid)

    def ground(self, sysids: frozenset[int]) -> None:
        """From now on these, and no others, are to be on the ground."""
        for sysid, sequence in self.sequences.items():
            if sequence.grounded is not (sysid in sysids):
                sequence.grounded = sysid in sysids
                self._touched.add(sysid)

    @property
    def moved(self) -> set[int]:
        """Vehicles whose sequences alone can have changed in this tick."""
        return self._touched.union(self._due)

    @property
    def groups(self) -> Groups:
        """Vehicles by what their sequences make of them now."""
        if self._groups is None or self._touched:
            self._groups = Groups.of(self.sequences)
        return self._groups


def stage_event(view: VehicleView, arming: ArmingSequence, before: Stage, now_s: float) -> Event | None:
    """The event of a new stage with which the control of a vehicle changes; None for other stages.

    before: the stage that the sequence has left.
    """
    if arming.stage is Stage.DOWN and view.alive:
        does = "Lands" if view.mode in GOING_DOWN else "Has booted in flight" if arming.booted else "Is down"
        why = arming.left_out or f"{does}, and takes no more part"
        return Event(now_s, view.sysid, "warning", why, "session" if arming.left_out else "decision")
    if arming.stage is Stage.YIELDED:
        pilot, back = "Its failsafe" if view.failsafe else "A pilot or another station", view.profile.offboard_name
        if arming.unheard_lately(now_s) and not view.failsafe:
            pilot = "Its link was out, and its failsafe, a pilot or another station"
        why = f"{pilot} flies it ({view.mode_name}): it takes part again by rejoin, or when it is put into {back}"
        return Event(now_s, view.sysid, "warning", why)
    if arming.stage is Stage.FLY and before is Stage.YIELDED:
        return Event(now_s, view.sysid, "info", "Takes part again")
    return None
