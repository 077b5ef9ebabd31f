"""Other ground stations that a session speaks to."""

from typing import Annotated

from pydantic import AfterValidator, Field

from gcs.scenario.endpoint import EXAMPLE, FORM, address
from gcs.scenario.types import Flag, Part

MOST = 8


def _is_address(text: str) -> str:
    if address(text) is None:
        raise ValueError(f"must be {FORM}, {EXAMPLE}")
    return text


class Forward(Part):
    """Other ground stations beside this one (docs/protocol.md#forwarding)."""

    to: Annotated[tuple[Annotated[str, AfterValidator(_is_address)], ...], Field(max_length=MOST)] = ()
    """addresses to which everything goes that vehicles say, such as udpout:127.0.0.1:14550 for QGroundControl"""
    control: Flag = False
    """whether what is said there reaches the vehicles; a vehicle that somebody flies there is left to them"""
