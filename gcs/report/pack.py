"""Series as bytes for the page: 16 bits for a time, 16 for a value, so that 254 vehicles fit into a few megabytes.

Each series' least and greatest value lie on the ends of the scale and come out as they went in; all else is right to
1/65534 of the span. The page's script reads them back (page.js, `line` and `path`).
"""

from __future__ import annotations

import base64
import gzip
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.recording.series import Floats, Series

TOP, GAP = 65534, 65535
LEVEL = 5
"""gzip takes a third longer to make a page smaller by less than a hundredth (6)."""


class Pack:
    """Collects series; what it gives for each is where it lies, for the page's model."""

    def __init__(self, begin_s: float, end_s: float) -> None:
        self._begin_s, self._end_s = begin_s, end_s
        self._bytes = bytearray()

    def line(self, series: Series) -> dict[str, Any]:
        """A series: its times on the session's scale, then its values on their own."""
        place = {"at": len(self._bytes), "n": len(series.t_s)}
        self._bytes += _scaled(series.t_s, self._begin_s, self._end_s).tobytes()
        return {**place, **self._column(series.values)}

    def column(self, values: Floats) -> dict[str, Any]:
        """Values alone."""
        return {"at": len(self._bytes), "n": len(values), **self._column(values)}

    def text(self) -> str:
        """All of it, compressed, as base64."""
        return packed(bytes(self._bytes))

    def _column(self, values: Floats) -> dict[str, Any]:
        known = values[np.isfinite(values)]
        low, high = (float(known.min()), float(known.max())) if len(known) else (0.0, 0.0)
        self._bytes += _scaled(values, low, high).tobytes()
        return {"low": low, "high": high}


def packed(content: bytes) -> str:
    """Bytes compressed (gzip, the same for the same bytes) as base64."""
    return base64.b64encode(gzip.compress(content, LEVEL, mtime=0)).decode("ascii")


def _scaled(values: Floats, low: float, high: float) -> NDArray[np.uint16]:
    known = np.isfinite(values)
    span = high - low
    share = np.clip((np.where(known, values, low) - low) / span, 0.0, 1.0) if span > 0.0 else np.zeros(len(values))
    return np.where(known, np.rint(TOP * share), GAP).astype("<u2")
