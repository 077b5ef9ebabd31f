"""Waiting for vehicles before a session begins: progress text, missing vehicles, and the time limit."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping

from gcs.scenario.endpoint import ONLY_ONCE
from gcs.scenario.external import External

HELLO_WITHIN_S = 60.0
"""Wall time that launched vehicles have for their first word."""
BOOTED_WITHIN_S = 300.0
"""[choice] The same for vehicles with a real autopilot, which boots first: one that does not boot says why, by its own
time."""
SAY_AGAIN_S = 5.0
SAY_WHY_S = 1.0
"""Nothing is made of what has not come in so short a time."""


STARTING_LINE = "still starting ..."
"""Where a session takes long to start."""


class Arrivals:
    """Waits for launched vehicles and for external ones; times are s since it began."""

    def __init__(
        self, labels: Mapping[int, str], external: Mapping[int, External], booting: Collection[int] = ()
    ) -> None:
        """`booting`: system ids of launched vehicles whose autopilot boots before their first word."""
        self._labels = labels
        self._booting = frozenset(booting)
        self._external = external
        self._awaited = set(external)
        self._said_s = -math.inf

    def look(self, missing: Collection[int], waited_s: float, seen: Mapping[int, str]) -> list[tuple[int, str]]:
        """(system id, words) of what is new about external vehicles, now that these system ids are missing.

        seen: what keeps them from being received, by system id, where that is known.
        """
        awaited = self._external.keys() & set(missing)
        notices = [(sysid, f"{self._labels[sysid]} is there") for sysid in sorted(self._awaited - awaited)]
        if waited_s - self._said_s >= SAY_AGAIN_S:
            self._said_s = waited_s
            for sysid in sorted(awaited):
                why = f": {seen[sysid]}" if sysid in seen and waited_s >= SAY_WHY_S else ""
                notices.append((sysid, f"Waiting for {self._labels[sysid]} at {self._external[sysid].where}{why}"))
        self._awaited = awaited
        return notices

    def too_late(
        self, missing: Collection[int], waited_s: float, refused: Mapping[int, str], seen: Mapping[int, str]
    ) -> str | None:
        """Why the session cannot begin, as a sentence; None while there is hope.

        refused: why messages of a vehicle were refused; seen: as of `look`.
        """
        late = [sysid for sysid in sorted(missing) if waited_s > self._patience_s(sysid)]
        awaited = [sysid for sysid in late if sysid in self._external]
        if awaited:
            names = ", ".join(f"{self._labels[sysid]} at {self._external[sysid].where}" for sysid in awaited)
            spoken_to = any("udpout" in self._external[sysid].where for sysid in awaited)
            known = sorted({seen[sysid] for sysid in awaited if sysid in seen})
            guess = (
                "is it switched on, has it that system id, and does it speak MAVLink 2 to that address? "
                "(found_within_s gives it longer)" + (ONLY_ONCE if spoken_to else "")
            )
            return (
                f"no HEARTBEAT of {names} within {self._patience_s(awaited[0]):g} s: {'; '.join(known) or guess}"
                + "".join(
                    f"; messages of {self._labels[sysid]} came and were refused: {refused[sysid]}"
                    for sysid in awaited
                    if sysid in refused
                )
            )
        if late:
            names = ", ".join(self._labels[sysid] for sysid in late)
            return f"no answer from {names} within {self._patience_s(late[0]):.0f} s of their start"
        return None

    def _patience_s(self, sysid: int) -> float:
        external = self._external.get(sysid)
        if external is not None:
            return external.found_within_s
        return BOOTED_WITHIN_S if sysid in self._booting else HELLO_WITHIN_S
