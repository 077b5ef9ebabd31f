"""Faults of the radio link."""

from typing import Annotated

from pydantic import Field

from gcs.scenario.types import Fraction, Part, Seconds, SysId


class Blackout(Part):
    """From when to when no frame from or to a vehicle arrives."""

    sysid: SysId
    """system id of the vehicle"""
    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class GroundBlackout(Part):
    """From when to when the ground station's own radio is dead: it neither sends nor receives."""

    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class RadioSplit(Part):
    """From when to when some vehicles and all others do not receive each other; the ground station receives all."""

    sysids: Annotated[tuple[SysId, ...], Field(min_length=1)]
    """system ids of the vehicles on one side"""
    from_s: Seconds
    """begin, s of session time"""
    to_s: Seconds
    """end, s of session time; after `from_s`"""


class Radio(Part):
    """Faults of the radio link, each way: shares of all frames, and seconds
    (docs/protocol/radio.md#radio-impairment)."""

    loss: Fraction = 0.0
    """share of frames lost, 0 to 1"""
    delay_s: Seconds = 0.0
    """delay of every frame, s"""
    jitter_s: Seconds = 0.0
    """additional random delay, uniform from 0 to this, s"""
    duplicate: Fraction = 0.0
    """share of frames that arrive twice, 0 to 1"""
    reorder: Fraction = 0.0
    """share of frames that arrive after the one sent next, 0 to 1"""
    blackouts: tuple[Blackout, ...] = ()
    """times at which nothing from or to a vehicle arrives"""
    ground_blackouts: tuple[GroundBlackout, ...] = ()
    """times at which the ground station's own radio is dead; launched vehicles go on receiving each other"""
    splits: tuple[RadioSplit, ...] = ()
    """times at which a part of the vehicles and the rest do not receive each other"""

    @property
    def random(self) -> bool:
        """Whether the seed decides what happens to frames."""
        return any((self.loss, self.jitter_s, self.duplicate, self.reorder))


PERFECT = Radio.model_construct()
