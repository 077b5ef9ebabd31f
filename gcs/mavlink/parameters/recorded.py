"""Parameters in a recording: the encoding that each vehicle uses, and the numbers in its messages (value.py)."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.mavlink.autopilots import GENERIC, in_table, profile_of
from gcs.mavlink.codec import WireFloat
from gcs.mavlink.ids import AUTOPILOT
from gcs.mavlink.parameters.value import TYPE_NAMES, WIRE_BYTES, from_wire
from skytender import mavlink as mav

FIELD = "param_value"
_ADDRESSES = {"PARAM_VALUE": ("sysid", "compid"), "PARAM_SET": ("target_system", "target_component")}
"""Messages that carry a parameter in four bytes, and the component whose it is."""
CARRIERS = frozenset(_ADDRESSES)
_BYTEWISE = int(mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_BYTEWISE)
_CAST = int(mav.MAV_PROTOCOL_CAPABILITY_PARAM_ENCODE_C_CAST)


class Encodings:
    """The encoding of each component received so far: what its capabilities say, else its HEARTBEAT's autopilot's, else
    that of its vehicle's autopilot."""

    def __init__(self) -> None:
        self._said: dict[tuple[int, int], bool] = {}
        self._known: dict[tuple[int, int], bool] = {}

    def learn(self, beats: NDArray[Any], versions: NDArray[Any]) -> None:
        """Take HEARTBEAT's and AUTOPILOT_VERSION's, each as a structured array (n,) with sysid and compid."""
        for sysid, compid, autopilot in _distinct(beats["sysid"], beats["compid"], beats["autopilot"]):
            if in_table(autopilot):
                self._known[sysid, compid] = profile_of(autopilot).integers_bytewise
        bits = versions["capabilities"] & np.uint64(_BYTEWISE | _CAST)
        for sysid, compid, said in _distinct(versions["sysid"], versions["compid"], bits):
            if said in (_BYTEWISE, _CAST):
                self._said[sysid, compid] = said == _BYTEWISE

    def bytewise(self, sysid: int, compid: int) -> bool:
        """Whether the integers of this component's parameters travel as their bytes; component 0 is the autopilot."""
        for one in ((sysid, compid), (sysid, AUTOPILOT)):
            for known in (self._said, self._known):
                if one in known:
                    return known[one]
        return GENERIC.integers_bytewise

    def numbers(self, message: str, rows: NDArray[Any]) -> NDArray[np.float64]:
        """(n,) the numbers in a message of `CARRIERS`, of which `rows` has sysid, compid and the fields; NaN where the
        encoding cannot carry the type, and the float itself of a type that MAVLink lacks."""
        raw = np.ascontiguousarray(rows[FIELD]).view(np.uint32)
        sysid, compid = (rows[field] for field in _ADDRESSES[message])
        cells = np.column_stack((raw, rows["param_type"], sysid, compid)).astype(np.int64)
        distinct, at = np.unique(cells, axis=0, return_inverse=True)
        numbers = [self._number(*cell) for cell in distinct.tolist()]
        return np.array(numbers, dtype=np.float64)[at.reshape(-1)]

    def _number(self, raw: int, kind: int, sysid: int, compid: int) -> float:
        wire = WireFloat(raw.to_bytes(WIRE_BYTES, "little"))
        if kind not in TYPE_NAMES:
            return float(wire)
        try:
            return float(from_wire(wire, kind, bytewise=self.bytewise(sysid, compid)).number)
        except ValueError:
            return np.nan


def _distinct(*columns: NDArray[Any]) -> list[list[int]]:
    return np.unique(np.column_stack([column.astype(np.int64) for column in columns]), axis=0).tolist()
