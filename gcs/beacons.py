"""What a base tells the vehicle that it charges, as the ground station's own messages (contract.md, Energy)."""

from __future__ import annotations

import pymap3d

from gcs.mavlink.codec import Message, message
from gcs.scenario.model import Origin
from gcs.service import Beacon

POSITION_AND_VELOCITY = 0b11
STANDS = (0.0, 0.0, 0.0)


def messages(beacon: Beacon, origin: Origin, time_ms: int) -> list[Message]:
    """Its FOLLOW_TARGET and its XferOut at a session time; `origin` is the common frame's."""
    north, east, down = beacon.p_ned
    lat_deg, lon_deg, alt_m = pymap3d.ned2geodetic(north, east, down, origin.lat_deg, origin.lon_deg, origin.alt_m)
    place = message(
        "FOLLOW_TARGET",
        timestamp=time_ms,
        est_capabilities=POSITION_AND_VELOCITY,
        lat=round(1e7 * float(lat_deg)),
        lon=round(1e7 * float(lon_deg)),
        alt=float(alt_m),
        vel=STANDS,
        acc=STANDS,
        attitude_q=(1.0, 0.0, 0.0, 0.0),
        rates=STANDS,
        position_cov=STANDS,
        custom_state=0,
    )
    return [place, message("NAMED_VALUE_INT", time_boot_ms=time_ms, name="XferOut", value=beacon.given_j)]
