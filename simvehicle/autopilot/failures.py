"""Failures that can be injected while a vehicle flies, and their effects.

| failure | effect [choice] |
|---|---|
| GPS | no fix is reported; the vehicle cannot arm, and in the air it lands on its velocity alone |
| BATTERY | an empty battery is reported, and the vehicle lands as on an empty one; the energy ledger goes on |
| MOTOR | all motors stop, as a quadrotor's controller does when one is gone; the vehicle falls, crashes and disarms |
| LINK | the vehicle receives and sends nothing but the order that mends it |

An order may also say that a unit is WRONG: of the GPS, the vehicle takes itself to be elsewhere, by so many metres to
the north and east, until it is mended; of the battery, so many joules are gone at once, and count as drawn.
"""

from __future__ import annotations

from enum import StrEnum


class Failure(StrEnum):
    """One thing that has failed."""

    GPS = "GPS"
    BATTERY = "battery"
    MOTOR = "motor"
    LINK = "link"
