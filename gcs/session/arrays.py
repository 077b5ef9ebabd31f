"""A session's snapshot as arrays, one row per vehicle in order of system id, for numpy and pandas."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from gcs.extras import missing
from gcs.html_table import html_table
from gcs.session.program.messages import FleetMessage

_PLAIN: dict[str, type[np.generic]] = {
    "sysid": np.int64,
    "role": np.str_,
    "mode": np.str_,
    "mode_name": np.str_,
    "alive": np.bool_,
    "armed": np.bool_,
}
_VECTORS = {
    "p_ned": ("p_n", "p_e", "p_d"),
    "v_ned": ("v_n", "v_e", "v_d"),
    "attitude_rad": ("roll_rad", "pitch_rad", "yaw_rad"),
    "set_point_p_ned": ("set_point_p_n", "set_point_p_e", "set_point_p_d"),
    "set_point_v_ned": ("set_point_v_n", "set_point_v_e", "set_point_v_d"),
}
_NUMBERS = (
    "target_m", "battery", "remaining_j", "endurance_s", "v", "tau", "age_s", "heard_s", "lost_share",
)  # fmt: skip
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


@dataclass(slots=True)
class SentCommand:
    """A command of a program's, and what its vehicle has said to it so far."""

    number: int
    """from 1, in the order of the program's commands"""
    sysid: int
    command: str
    """an order, as `hold`, or a MAV_CMD's name"""
    text: str
    """what the session says it does with it"""
    outcome: Literal["accepted", "rejected", "timeout"] | None = None
    """by COMMAND_ACK; None: nothing has come yet, or nothing was sent, as for an order to a vehicle on the ground"""
    result: str | None = None
    """of MAV_RESULT, such as `TEMPORARILY_REJECTED`; None: no outcome yet, or a time-out"""


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
    """(n,) flight mode in words that are the same of every autopilot: takeoff, offboard, hold, land, return, refuel,
    mission, manual or other"""
    mode_name: NDArray[np.str_]
    """(n,) the same as the autopilot's people call it: `AUTO` of an ArduPilot, `Mission` of a PX4"""
    alive: NDArray[np.bool_]
    """(n,)"""
    armed: NDArray[np.bool_]
    """(n,)"""
    p_ned: NDArray[np.float64]
    """(n, 3) m"""
    v_ned: NDArray[np.float64]
    """(n, 3) m/s"""
    attitude_rad: NDArray[np.float64]
    """(n, 3) roll, pitch and yaw, by ATTITUDE"""
    set_point_p_ned: NDArray[np.float64]
    """(n, 3) position that was sent in this tick, after the safety filter, m; NaN: none was"""
    set_point_v_ned: NDArray[np.float64]
    """(n, 3) velocity that was sent with it, m/s"""
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
    age_s: NDArray[np.float64]
    """(n,) of the position"""
    heard_s: NDArray[np.float64]
    """(n,) since anything came from its autopilot"""
    lost_share: NDArray[np.float64]
    """(n,) of its frames in the last 10 s, 0 to 1"""
    trouble: tuple[tuple[str, ...], ...]
    """n: what is wrong with each, in a few words, the worst first"""
    services: tuple[Serving, ...]
    refuelled: int
    """services that have ended with energy on board"""
    events: tuple[Happening, ...]
    """since the snapshot before"""
    acknowledged: tuple[SentCommand, ...] = ()
    """the program's commands that have ended since the snapshot before"""

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
        for name, parts in _VECTORS.items():
            columns |= dict(zip(parts, getattr(self, name).T, strict=True))
        columns |= {name: getattr(self, name) for name in _NUMBERS}
        return columns | {"trouble": np.array(["; ".join(texts) for texts in self.trouble], dtype=np.str_)}

    def frame(self) -> Any:
        """`table()` as a pandas.DataFrame. Raises MissingExtra without pandas."""
        try:
            import pandas as pd  # type: ignore[import-untyped, import-not-found, unused-ignore]  # noqa: PLC0415 - an extra
        except ModuleNotFoundError:
            raise missing("frame()", "pandas", "pandas") from None
        return pd.DataFrame(self.table())

    def _repr_html_(self) -> str:
        head = ("vehicle", "role", "mode", "armed", "height, m", "speed, m/s", "battery, %", "trouble")
        shown = zip(
            self.sysid, self.role, self.mode_name, self.armed, 0.0 - self.p_ned[:, 2],
            np.linalg.norm(self.v_ned, axis=1), 100.0 * self.battery, self.trouble, strict=True,
        )  # fmt: skip
        rows = (
            (sysid, role, mode, "yes" if armed else "no", *map(_cell, (height_m, speed_m_s, percent)), "; ".join(texts))
            for sysid, role, mode, armed, height_m, speed_m_s, percent, texts in shown
        )
        return f"<p>{self.time_s:.1f} s</p>{html_table(rows, head)}"


def _cell(number: float) -> str:
    return f"{number:.1f}" if np.isfinite(number) else ""


def from_message(message: FleetMessage, acknowledged: tuple[SentCommand, ...] = ()) -> Snapshot:
    """The snapshot that a session's message holds."""
    columns: dict[str, Any] = {
        **{key: np.array(getattr(message, key), dtype=kind) for key, kind in _PLAIN.items()},
        **{key: np.array(getattr(message, key), dtype=np.float64).reshape(-1, 3) for key in _VECTORS},
        **{key: np.array(getattr(message, key), dtype=np.float64) for key in _NUMBERS},
    }
    return Snapshot(
        time_s=message.t_s,
        **columns,
        trouble=tuple(map(tuple, message.trouble)),
        services=tuple(
            Serving(s.receiver, s.tanker, s.phase, round(s.energy_j), s.by, s.base) for s in message.services
        ),
        refuelled=message.refuelled,
        events=tuple(Happening(e.t_s, e.sysid, e.level, e.text, e.kind) for e in message.events),
        acknowledged=acknowledged,
    )
