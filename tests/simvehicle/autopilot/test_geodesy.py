"""A vehicle's local frame against pymap3d, also across the 180th meridian."""

from __future__ import annotations

import pymap3d
import pytest

from simvehicle.autopilot.geodesy import LocalFrame

ORIGINS = [
    (47.397742, 8.545594, 488.0),
    (-16.8, 179.99999, 3.0),
    (0.0, 180.0, 3.0),
    (-1e-5, -180.0, -410.5),
    (88.5, -179.9999, 20.0),
]


@pytest.mark.parametrize("origin", ORIGINS)
@pytest.mark.parametrize("p_ned", [(0.0, 20.0, -3.0), (0.0, -20.0, -3.0), (-12.0, 7.0, 0.0), (5.0, -8.0, -30.0)])
def test_places_agree_with_pymap3d(origin: tuple[float, float, float], p_ned: tuple[float, float, float]) -> None:
    frame = LocalFrame(*origin)
    theirs = [float(x) for x in pymap3d.ned2geodetic(*p_ned, *origin)]
    assert frame.to_local(*theirs) == pytest.approx(p_ned, abs=2e-3)
    lat_deg, lon_deg, alt_m = frame.to_global(*p_ned)
    assert abs(lon_deg) <= 180.0
    assert pymap3d.geodetic2ned(lat_deg, lon_deg, alt_m, *origin) == pytest.approx(p_ned, abs=2e-3)
