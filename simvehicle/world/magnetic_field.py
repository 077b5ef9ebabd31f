"""The Earth's magnetic field, by the World Magnetic Model 2025 (NOAA and BGS), which pygeomag computes."""

from __future__ import annotations

from datetime import UTC, datetime

from pygeomag import GeoMag

COEFFICIENTS = "wmm/WMM_2025.COF"
TESLA_PER_NT = 1e-9


def field_ned_t(lat_deg: float, lon_deg: float, alt_m: float, unix_s: float) -> tuple[float, float, float]:
    """The field at a place, T, NED. Outside of 2025 to 2030, where the model holds, its drift is carried on."""
    day = datetime.fromtimestamp(unix_s, UTC)
    began = datetime(day.year, 1, 1, tzinfo=UTC)
    year = day.year + (day - began) / (datetime(day.year + 1, 1, 1, tzinfo=UTC) - began)
    model = GeoMag(coefficients_file=COEFFICIENTS)
    found = model.calculate(lat_deg, lon_deg, alt_m / 1e3, year, allow_date_outside_lifespan=True)
    return TESLA_PER_NT * found.x, TESLA_PER_NT * found.y, TESLA_PER_NT * found.z
