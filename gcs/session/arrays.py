"""A session's snapshot as arrays, one row per vehicle in order of system id, for numpy and pandas."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np
from numpy.typing import NDArray

from gcs.extras import missing

_PLAIN: dict[str, type[np.generic]] = {
    "sysid": np.int64,
    "role": np.str_,
    "mode": np.str_,
    "alive": np.bool_,
    "armed": np.bool_,
}
_VECTORS = ("p_ned", "v_ned")
_NUMBERS = ("target_m", "battery", "remaining_j", "endurance_s", "v", "tau")
"""Columns of a snapshot, by what they hold; numbers may be unknown."""


@dataclass(frozen=True, slots=True)
class Happening:
    """Something that a person should know."""

    t_s: float
    sysid: int
    """0: the ground station itself"""
    level: str
    """info, warning or critical"""
    text: str
    kind: str = "session"
    """text, mode, failsafe, ack, decision, operator, link, death or session"""


@dataclass(frozen=True, slots=True)
class Serving:
    """One tanker, or one base, serving one receiver at the moment."""

    receiver: int
    tanker: int | None
    phase: str
    energy_j: int
    by: str
    base: str | None = None


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The fleet at one instant of session time, as its messages report it. n vehicles; NaN: not known, or not
    competing.

    Positions (m) and velocities (m/s) are in the common NED frame, whose zero is the scenario's origin.
    """

    time_s: float
    sysid: NDArray[np.int64]
    """(n,)"""
    role: NDArray[np.str_]
    """(n,) pursuer, target or tanker"""
    mode: NDArray[np.str_]
    """(n,) flight mode"""
    alive: NDArray[np.bool_]
    """(n,)"""
    armed: NDArray[np.bool_]
    """(n,)"""
    p_ned: NDArray[np.float64]
    """(n, 3) m"""
    v_ned: NDArray[np.float64]
    """(n, 3) m/s"""
    target_m: NDArray[np.float64]
    """(n,) distance to what it pursues"""
    battery: NDArray[np.float64]
    """(n,) share of the capacity that is left"""
    remaining_j: NDArray[np.float64]
    """(n,)"""
    endurance_s: NDArray[np.float64]
    """(n,) at the present draw"""
    v: NDArray[np.float64]
    """(n,) state in the competition"""
    tau: NDArray[np.float64]
    """(n,) bid in it"""
    services: tuple[Serving, ...]
    refuelled: int
    """services that have ended with energy on board"""
    events: tuple[Happening, ...]
    """since the snapshot before"""

    def row(self, sysid: int) -> int:
        """The row of a vehicle. KeyError where there is none of that id."""
        rows = np.flatnonzero(self.sysid == sysid)
        if not len(rows):
            raise KeyError(sysid)
        return int(rows[0])

    def table(self) -> dict[str, NDArray[Any]]:
        """Columns of length n by name, vectors taken apart: what `pandas.DataFrame` and `numpy.savez` take as it is."""
        columns: dict[str, NDArray[Any]] = {"time_s": np.full(len(self.sysid), self.time_s)}
        columns |= {name: getattr(self, name) for name in _PLAIN}
        for name in _VECTORS:
            columns |= {f"{name[0]}_{axis}": values for axis, values in zip("ned", getattr(self, name).T, strict=True)}
        return columns | {name: getattr(self, name) for name in _NUMBERS}

    def frame(self) -> Any:
        """`table()` as a pandas.DataFrame. Raises MissingExtra without pandas."""
        try:
            import pandas as pd  # type: ignore[import-untyped, import-not-found, unused-ignore]  # noqa: PLC0415 - an extra
        except ModuleNotFoundError:
            raise missing("frame()", "pandas", "pandas") from None
        return pd.DataFrame(self.table())


def from_message(message: Mapping[str, Any]) -> Snapshot:
    """The snapshot in a message of type "snapshot" (gcs/session/messages.py)."""
    vehicles = message["vehicles"]

    def known(key: str, unknown: Any) -> list[Any]:
        return [unknown if vehicle[key] is None else vehicle[key] for vehicle in vehicles]

    columns: dict[str, Any] = {
        **{key: np.array([vehicle[key] for vehicle in vehicles], dtype=kind) for key, kind in _PLAIN.items()},
        **{key: np.array(known(key, (np.nan,) * 3), dtype=np.float64).reshape(-1, 3) for key in _VECTORS},
        **{key: np.array(known(key, np.nan), dtype=np.float64) for key in _NUMBERS},
    }
    return Snapshot(
        time_s=float(message["t_s"]),
        **columns,
        services=msgspec.convert(message["services"], tuple[Serving, ...]),
        refuelled=int(message["refuelled"]),
        events=msgspec.convert(message["events"], tuple[Happening, ...]),
    )
