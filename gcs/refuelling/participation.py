"""Which vehicles take part in refuelling, after all orders, faults and missions: a session's scheduler goes by it, and
a replay works it out again from what was recorded."""

from __future__ import annotations

from collections.abc import Collection, Iterable

TAKEN, RELEASED = "taken by the operator", "taken by another ground station"
SKIPPED, OUT_OF_ORDER, ON_MISSION = "skipped by the operator", "out of order", "on its mission"
_PRECEDENCE = (TAKEN, RELEASED, SKIPPED, OUT_OF_ORDER, ON_MISSION)
_LEAVE = {
    **dict.fromkeys(("hold", "return", "land"), TAKEN), "release": RELEASED, "tanker_out begins": OUT_OF_ORDER,
    "mission": ON_MISSION,
}  # fmt: skip
_COME_BACK = {"tanker_out ends": OUT_OF_ORDER, "mission flown": ON_MISSION}


class Participation:
    """Vehicles to be served next, and vehicles that take no part."""

    def __init__(self, on_missions: Iterable[int] = ()) -> None:
        self.asked: list[int] = []
        """vehicles that are served before all others, in this order"""
        self.out: dict[int, str] = {}
        """vehicles that neither compete, are served nor serve, and why; their services are broken off"""
        self.reasons: dict[int, set[str]] = {}
        """all that keeps each vehicle out, of which `out` has the first"""
        for sysid in on_missions:
            self.change("mission", sysid)

    def change(self, what: str, sysid: int) -> None:
        """Take in what befell a vehicle: an operator's command, `tanker_out begins` and `ends`, `mission` and `mission
        flown`, `decided` (it is served), `death`. Nothing else changes who takes part."""
        reasons = self.reasons.setdefault(sysid, set())
        if what in _LEAVE:
            if _LEAVE[what] in (TAKEN, RELEASED):
                reasons -= {TAKEN, RELEASED}
            reasons.add(_LEAVE[what])
        elif what in _COME_BACK:
            reasons.discard(_COME_BACK[what])
        elif what == "rejoin":
            reasons -= {TAKEN, RELEASED}
        elif what == "skip":
            reasons ^= {SKIPPED}
        elif what == "refuel":
            self.asked.append(sysid)
        elif what in ("decided", "death"):
            self.withdraw({sysid})
        self.out.pop(sysid, None)
        self.out.update([(sysid, reason) for reason in _PRECEDENCE if reason in reasons][:1])
        self.withdraw(self.out.keys())

    def skips(self, sysid: int) -> bool:
        """Whether the operator skips a vehicle, whatever else keeps it out."""
        return SKIPPED in self.reasons.get(sysid, ())

    def withdraw(self, sysids: Collection[int]) -> None:
        """Ask for these no more."""
        self.asked = [sysid for sysid in self.asked if sysid not in sysids]
