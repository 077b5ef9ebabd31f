"""The id by which external vehicles know this ground station, and other stations that a session speaks to."""

from collections.abc import Collection, Iterator
from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from gcs.scenario.document import Conflict
from gcs.scenario.endpoint import EXAMPLE, FORM, address, beyond_this_machine
from gcs.scenario.parts.reach import Asks
from gcs.scenario.types import Exact, Flag, Part

TRAFFIC = (255, 156)
MOST_FORWARDED = 8


class Station(Part):
    """Our system and component id, on every link to an external vehicle; launched ones are always commanded by
    255/190."""

    sysid: Annotated[int, Exact(ge=1, le=255)] = 255
    """system id; ArduPilot accepts stick input only from its SYSID_MYGCS (MAV_GCS_SYSID); QGroundControl and MAVProxy
    are 255 too"""
    compid: Annotated[int, Exact(ge=2, le=255)] = 190
    """component id; 1 is an autopilot's"""
    takeover: Literal["ask", "allow"] = "ask"
    """when another ground station asks for control of a vehicle that reports its owner (CONTROL_STATUS): `ask` refuses,
    and says so, until the operator's `release`; `allow` lets it have the vehicle at once"""

    @property
    def ids(self) -> tuple[int, int]:
        """(system, component)."""
        return self.sysid, self.compid


def station_conflicts(station: Station, sysids: Collection[int]) -> Iterator[Conflict]:
    """An id that a vehicle or the traffic has."""
    if station.sysid in sysids:
        yield Conflict(("station", "sysid"), f"{station.sysid} is the sysid of a vehicle: the station needs its own")
    if station.ids == TRAFFIC:
        yield Conflict(("station",), f"{TRAFFIC[0]}/{TRAFFIC[1]} is the traffic's: take another compid")


def _is_address(text: str) -> str:
    if address(text) is None:
        raise ValueError(f"must be {FORM}, {EXAMPLE}")
    return text


class Forward(Part):
    """Other ground stations beside this one (docs/protocol/external.md#forwarding)."""

    to: Annotated[
        tuple[Annotated[str, Asks("address", beyond_this_machine), AfterValidator(_is_address)], ...],
        Field(max_length=MOST_FORWARDED),
    ] = ()
    """addresses that get everything that vehicles send, such as udpout:127.0.0.1:14550 for QGroundControl"""
    control: Annotated[Flag, Asks("control")] = False
    """allow control from these ground stations; a vehicle that one of them flies is left to it"""
