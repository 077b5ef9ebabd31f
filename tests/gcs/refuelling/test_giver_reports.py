"""What a base says on the wire, read by pymavlink."""

from __future__ import annotations

import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.refuelling import base_service
from gcs.refuelling.service import GiverReport
from gcs.scenario.model import Origin


def test_a_base_tells_where_it_stands_and_what_it_has_given() -> None:
    """A degree of latitude is 111 132 m at 45°, one of longitude 78 847 m (WGS 84)."""
    said = base_service.giver_messages(
        GiverReport(2, (100.0, -50.0, 0.0), 13_600), Origin(lat_deg=45.0, lon_deg=8.0, alt_m=400.0), 4200
    )
    reader = mav.MAVLink(None)
    raw = b"".join(codec.frame(message, seq, 255, 190) for seq, message in enumerate(said))
    place, counter = reader.parse_buffer(raw)
    assert (place.get_type(), place.get_srcSystem(), place.timestamp) == ("FOLLOW_TARGET", 255, 4200)
    assert (1e-7 * place.lat - 45.0) * 111_132 == pytest.approx(100.0, abs=0.02)
    assert (1e-7 * place.lon - 8.0) * 78_847 == pytest.approx(-50.0, abs=0.02)
    assert place.alt == pytest.approx(400.0, abs=0.01)
    assert list(place.vel) == [0.0, 0.0, 0.0]
    assert (counter.name, counter.value, counter.time_boot_ms) == ("XferOut", 13_600, 4200)
