"""Places on the globe, against pymap3d."""

from __future__ import annotations

import numpy as np
import pymap3d
import pytest

from skytender import geodesy

ORIGINS = [(47.397742, 8.545594, 488.0), (0.0, 0.0, 0.0), (-35.363, 149.165, 584.0), (78.2, -179.9995, 20.0)]


@pytest.mark.parametrize("origin", ORIGINS)
def test_places_agree_with_pymap3d(origin: tuple[float, float, float]) -> None:
    rng = np.random.default_rng(1)
    for p_ned in rng.uniform((-2e4, -2e4, -5e3), (2e4, 2e4, 500.0), (100, 3)):
        ours = geodesy.place_of(tuple(p_ned.tolist()), origin)
        theirs = [float(x) for x in pymap3d.ned2geodetic(*p_ned, *origin)]
        assert ours[:2] == pytest.approx(theirs[:2], abs=1e-12, rel=0)
        assert ours[2] == pytest.approx(theirs[2], abs=1e-8, rel=0)
        assert geodesy.ned_of(*theirs, origin) == pytest.approx(pymap3d.geodetic2ned(*theirs, *origin), abs=1e-8, rel=0)
        assert geodesy.ned_of(*ours, origin) == pytest.approx(p_ned, abs=1e-8, rel=0)


def test_a_pole_has_a_place() -> None:
    lat_deg, _, height_m = geodesy.place_of((0.0, 0.0, -10.0), (90.0, 0.0, 0.0))
    assert (lat_deg, height_m) == pytest.approx((90.0, 10.0), abs=1e-8)


@pytest.mark.parametrize("lat_deg", [-89.0, -35.363262, 0.0, 1e-9, 47.397742, 89.0])
def test_radii_of_curvature_agree_with_pymap3d(lat_deg: float) -> None:
    expected = pymap3d.rcurve.meridian(lat_deg), pymap3d.rcurve.transverse(lat_deg)
    assert geodesy.radii_m(lat_deg) == pytest.approx(expected, rel=1e-15)
