"""The arming sequences of a fleet: which a tick has to ask, and what follows from the states of all of them.

A sequence need not be asked while three things hold: of its vehicle nothing but figures has changed, which the stamp
says (gcs/telemetry/columns.py); nothing has been requested of it since; and it `rests`. Then it would command nothing
and change nothing. In flight that is nearly every vehicle in nearly every tick.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from gcs.mavlink.autopilots import End
from gcs.supervisor.arming import ArmingSequence, Stage
from gcs.telemetry.columns import FleetColumns
from gcs.telemetry.stamps import StampWatch
from gcs.telemetry.state import VehicleView


class ArmingState(NamedTuple):
    """Part of an arming sequence that others go by."""

    stage: Stage
    sends_set_points: bool
    ordered: End | None
    grounded: bool
    left_out: str


class FleetArming:
    """Sequences to ask at a tick (`due`, and `asked` for each of them), and sets that depend on all of them."""

    def __init__(self, sequences: Mapping[int, ArmingSequence]) -> None:
        self.sequences = sequences
        self._restless = set(sequences)
        self._touched: set[int] = set()
        """vehicles of which something was requested since they were looked at"""
        self._stamps = StampWatch()
        self._states = {sysid: _state_of(sequence) for sysid, sequence in sequences.items()}
        self._steered = frozenset(sysid for sysid, state in self._states.items() if state.sends_set_points)
        self._yielded = frozenset(sysid for sysid, state in self._states.items() if state.stage is Stage.YIELDED)
        self._ordered = {sysid: state.ordered for sysid, state in self._states.items() if state.ordered is not None}
        self._listeners: list[set[int]] = []
        for sequence in sequences.values():
            sequence.touched = self._touched

    def due(self, columns: FleetColumns) -> list[int]:
        """System ids, in order, of those that have to be asked now; `columns` are of the views they will be shown."""
        self._look_at_touched()
        if new := self._stamps.new(columns):
            self._restless.update(new)
        return sorted(self._restless) if self._restless else []

    def asked(self, sysid: int, view: VehicleView) -> None:
        """A sequence has just decided on this view."""
        sequence = self.sequences[sysid]
        if sequence.rests(view):
            self._restless.discard(sysid)
        self._look_at(sysid, sequence)

    def ground(self, sysids: frozenset[int]) -> None:
        """From now on these, and no others, are to be on the ground."""
        for sysid, sequence in self.sequences.items():
            if sequence.grounded is not (sysid in sysids):
                sequence.grounded = sysid in sysids
                self._touched.add(sysid)

    @property
    def steered(self) -> frozenset[int]:
        """Vehicles that set points should be sent to; the same object while they are the same."""
        self._look_at_touched()
        return self._steered

    @property
    def yielded(self) -> frozenset[int]:
        """Vehicles under other control: another ground station's or a pilot's."""
        self._look_at_touched()
        return self._yielded

    @property
    def ordered(self) -> dict[int, End]:
        """Mode of each vehicle that an operator has taken over."""
        self._look_at_touched()
        return self._ordered

    def listen(self) -> set[int]:
        """A set that gets each vehicle whose `ArmingState` changes from now on; the reader empties it."""
        changed: set[int] = set()
        self._listeners.append(changed)
        return changed

    def _look_at_touched(self) -> None:
        if not self._touched:
            return
        self._restless |= self._touched
        for sysid in self._touched:
            self._look_at(sysid, self.sequences[sysid])
        self._touched.clear()

    def _look_at(self, sysid: int, sequence: ArmingSequence) -> None:
        state, before = _state_of(sequence), self._states[sysid]
        if state == before:
            return
        self._states[sysid] = state
        if state.sends_set_points is not before.sends_set_points:
            self._steered ^= {sysid}
        if (state.stage is Stage.YIELDED) is not (before.stage is Stage.YIELDED):
            self._yielded ^= {sysid}
        if state.ordered != before.ordered:
            self._ordered = {one: s.ordered for one, s in self._states.items() if s.ordered is not None}
        for changed in self._listeners:
            changed.add(sysid)


def _state_of(sequence: ArmingSequence) -> ArmingState:
    return ArmingState(
        sequence.stage, sequence.sends_set_points, sequence.ordered, sequence.grounded, sequence.left_out
    )
