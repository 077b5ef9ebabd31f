"""Mission, fence and rally points of a DataFlash log as the transfers in which a vehicle would have sent them.

CMD, FNCE and RALY (libraries/AP_Mission, AC_Fence and AP_Rally) list them when logging begins; MISE is the item that
the vehicle goes on to. CMD also stands where an item is begun: of a mission that has come since, that is all there is.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from gcs.mavlink.ids import STATION
from skytender import mavlink as mav

ROWS = frozenset({"FNCE", "RALY", "MISE"})
_TO = {"target_system": STATION[0], "target_component": STATION[1]}
_VERTICES = {
    98: mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION,
    97: mav.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION,
    95: mav.MAV_CMD_NAV_FENCE_RETURN_POINT,
    96: mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION,
    94: mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION,
    93: mav.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION,
    92: mav.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION,
}
"""Commands by FNCE's Type, AC_PolyFenceType; 96 and 94 have their radius as a whole number."""


class ListedMission:
    """The mission as a log's CMD rows have listed it so far."""

    def __init__(self) -> None:
        self._count = 0
        self._items: dict[int, dict[str, Any]] = {}

    def messages(self, row: Any) -> Iterator[tuple[str, dict[str, Any]]]:
        """Names and fields of the messages that a CMD row gives; a changed mission begins with its count again."""
        of_old = mav.MAV_FRAME_GLOBAL_RELATIVE_ALT if row.CNum else mav.MAV_FRAME_GLOBAL
        frame = getattr(row, "Frame", of_old)
        params = tuple(getattr(row, f"Prm{k}", 0.0) for k in range(1, 5))
        item = _item(mav.MAV_MISSION_TYPE_MISSION, row.CNum, row.CId, frame, params, row)
        anew = row.CNum == 0 or row.CTot != self._count or self._items.get(row.CNum, item) != item
        if row.CTot != self._count:  # home is no part of what was sent
            self._items = {seq: known for seq, known in self._items.items() if seq == 0}
        self._count, self._items[row.CNum] = row.CTot, item
        if anew:
            yield "MISSION_COUNT", _count(mav.MAV_MISSION_TYPE_MISSION, row.CTot)
        for seq in sorted(self._items) if anew else [row.CNum]:
            yield "MISSION_ITEM_INT", self._items[seq]


def messages(row: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Names and fields of the messages that a row of ROWS gives."""
    name = row.get_type()
    if name == "FNCE" and row.Type in _VERTICES:
        kind, command = mav.MAV_MISSION_TYPE_FENCE, _VERTICES[row.Type]
        size = row.Count if row.Type in (98, 97) else row.Radius
        yield from _listed(kind, row.Tot, row.Seq, command, mav.MAV_FRAME_GLOBAL, (size, 0.0, 0.0, 0.0), row)
    elif name == "RALY":
        kind, command, frame = (
            mav.MAV_MISSION_TYPE_RALLY,
            mav.MAV_CMD_NAV_RALLY_POINT,
            mav.MAV_FRAME_GLOBAL_RELATIVE_ALT,
        )
        yield from _listed(kind, row.Tot, row.Seq, command, frame, (0.0, 0.0, 0.0, 0.0), row)
    elif name == "MISE":
        yield "MISSION_CURRENT", {"seq": row.CNum}


def _listed(
    kind: int, count: int, seq: int, command: int, frame: int, params: tuple[float, ...], row: Any
) -> Iterator[tuple[str, dict[str, Any]]]:
    if seq == 0:
        yield "MISSION_COUNT", _count(kind, count)
    yield "MISSION_ITEM_INT", _item(kind, seq, command, frame, params, row)


def _count(kind: int, count: int) -> dict[str, Any]:
    return {**_TO, "count": count, "mission_type": kind}


def _item(kind: int, seq: int, command: int, frame: int, params: tuple[float, ...], row: Any) -> dict[str, Any]:
    return {
        **_TO,
        "seq": seq,
        "frame": frame,
        "command": command,
        "current": 0,
        "autocontinue": 1,
        **{f"param{k}": value for k, value in enumerate(params, 1)},
        "x": round(1e7 * row.Lat),
        "y": round(1e7 * row.Lng),
        "z": getattr(row, "Alt", 0.0),
        "mission_type": kind,
    }
