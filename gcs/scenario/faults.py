"""Faults that a scenario injects, at a time or with a chance that its seed draws (docs/protocol/radio.md#faults).

faults:
  - {fault: blackout, sysid: 2, at_s: 20, for_s: 10}
  - {fault: loss, share: 0.4, between_s: [30, 60], for_s: 5, chance: 0.5}
"""

from __future__ import annotations

import hashlib
import math
import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Annotated, Any, Literal, NamedTuple

from pydantic import ValidationError

from gcs.scenario.document import Conflict, KeyPath
from gcs.scenario.parts.vehicles import VehicleBase
from gcs.scenario.types import Coordinate, Exact, Fraction, Part, Seconds, SysId, explained

FaultKind = Literal[
    "kill", "hang", "blackout", "loss", "delay", "gcs_silent", "battery", "tanker_out", "motor", "gps_off", "gps_jump"
]
LAUNCHED_ONLY = frozenset({"kill", "hang", "battery", "gps_jump"})
"""Faults that only a vehicle which the session launches can have: nothing carries them to another's."""
RADIO = frozenset({"blackout", "loss", "delay", "gcs_silent"})
"""Faults of the radio: frames are lost or late."""
COMMANDED = frozenset({"battery", "motor", "gps_off", "gps_jump"})
"""Faults that a vehicle is commanded to have, by MAV_CMD_INJECT_FAILURE."""
OF_ALL = frozenset({"loss", "delay", "gcs_silent"})
"""Faults that befall all vehicles where none is named."""
_NEEDS: Mapping[str, tuple[str, ...]] = {
    "blackout": ("for_s",),
    "loss": ("for_s", "share"),
    "delay": ("for_s", "delay_s"),
    "gcs_silent": ("for_s",),
    "battery": ("share",),
    "gps_jump": ("jump_m",),
}
_MAY = {"tanker_out": ("for_s",), "gps_off": ("for_s",), "gps_jump": ("for_s",)}
ROUNDING_S = 1e-6
_KEYS = ("for_s", "share", "delay_s", "jump_m")


class Fault(Part):
    """Something that goes wrong; what it does is under Faults in the protocol."""

    fault: FaultKind
    """`kill`, `hang`: the vehicle's process; `blackout`, `loss`, `delay`: its radio; `gcs_silent`: nothing is sent;
    `battery`: charge is gone at once; `tanker_out`: gives no energy; `motor`: all motors stop; `gps_off`, `gps_jump`"""
    sysid: SysId | None = None
    """system id of the vehicle that it befalls; `loss`, `delay` and `gcs_silent` befall all without it"""
    at_s: Seconds | None = None
    """begin, s of session time; or give `between_s`"""
    between_s: tuple[Seconds, Seconds] | None = None
    """the begin is drawn evenly from this time to that, s of session time, by the scenario's seed"""
    chance: Fraction = 1.0
    """how likely it happens at all, 0 to 1, drawn by the scenario's seed"""
    for_s: Annotated[float, Exact(gt=0, le=604_800)] | None = None
    """how long it lasts, s of session time; `tanker_out`, `gps_off` and `gps_jump` stay without it"""
    share: Fraction | None = None
    """`loss`: share of frames lost; `battery`: share of the capacity that is gone"""
    delay_s: Annotated[float, Exact(gt=0, le=60)] | None = None
    """`delay`: how much later every frame comes, s"""
    jump_m: tuple[Coordinate, Coordinate] | None = None
    """`gps_jump`: how far off the vehicle takes its place to be, to the north and to the east, m"""

    @property
    def random(self) -> bool:
        """Whether the seed decides whether, when or to which frames it happens."""
        drawn_time = self.between_s is not None and self.between_s[0] < self.between_s[1]
        return self.chance > 0.0 and (self.chance < 1.0 or drawn_time or self.fault == "loss")


class Injection(NamedTuple):
    """A fault as the seed has drawn it."""

    number: int
    """its place in the scenario, from 1; faults injected in flight are counted on from the last"""
    fault: Fault
    begin_s: float
    end_s: float
    """inf: it stays"""

    def befalls(self, sysid: int) -> bool:
        """Whether this vehicle has it."""
        return self.fault.sysid is None or self.fault.sysid == sysid


def drawn(faults: Sequence[Fault], seed: int) -> list[Injection]:
    """The faults that happen with a seed, in order of time; each draws twice from a stream of its own."""
    found = []
    for number, fault in enumerate(faults, 1):
        stream = random.Random(hashlib.sha256(f"{seed}/fault/{number}".encode()).digest())
        happens, when = stream.random(), stream.random()
        if happens >= fault.chance:
            continue
        first_s, last_s = fault.between_s or (fault.at_s or 0.0,) * 2
        begin_s = round(first_s + when * (last_s - first_s), 3)
        found.append(Injection(number, fault, begin_s, begin_s + (fault.for_s or math.inf)))
    return sorted(found, key=lambda one: (one.begin_s, one.number))


def in_flight(content: Any, vehicles: Iterable[VehicleBase], now_s: float, duration_s: float) -> Fault:
    """A fault that is given while the session flies: the keys of a scenario's, begun at once unless `at_s` says later.

    Raises ValueError: one sentence.
    """
    if not isinstance(content, Mapping):
        raise ValueError(f"a fault is a block of keys, such as {{'fault': 'motor', 'sysid': 1}}, not {content!r:.60}")
    if drawn_keys := [key for key in ("between_s", "chance") if content.get(key) is not None]:
        raise ValueError(f"a fault that is injected has no {drawn_keys[0]}: nothing is drawn in flight")
    data = {"at_s": now_s, **{key: value for key, value in content.items() if value is not None}}
    try:
        fault = Fault.model_validate(data)
    except ValidationError as error:
        raise ValueError(explained(error, Fault, data, "the fault")) from None
    if fault.at_s is not None and fault.at_s < now_s - ROUNDING_S:
        raise ValueError(f"at_s is {fault.at_s:g}, which is past: the next tick is at {now_s:g} s")
    if conflicts := list(fault_conflicts([fault], vehicles, duration_s)):
        raise ValueError(conflicts[0].message)
    return fault


def fault_conflicts(faults: Sequence[Fault], vehicles: Iterable[VehicleBase], duration_s: float) -> Iterator[Conflict]:
    """Faults that cannot happen to these vehicles, or whose keys do not go together."""
    known = {vehicle.sysid: vehicle for vehicle in vehicles}
    for i, fault in enumerate(faults):
        path: KeyPath = ("faults", i)
        yield from _key_conflicts(path, fault)
        begin_s = fault.between_s[1] if fault.between_s else fault.at_s
        if begin_s is not None and begin_s >= duration_s:
            late = f"fault {i + 1} ({fault.fault}) begins at {begin_s:g} s, which is not before duration_s"
            yield Conflict((*path, "between_s" if fault.between_s else "at_s"), late)
        if fault.sysid is None:
            if fault.fault not in OF_ALL:
                yield Conflict(path, f"{fault.fault} needs the sysid of the vehicle that it befalls")
        elif (vehicle := known.get(fault.sysid)) is None:
            yield Conflict((*path, "sysid"), f"there is no vehicle {fault.sysid}")
        else:
            yield from _vehicle_conflicts(path, fault, vehicle)


def _key_conflicts(path: KeyPath, fault: Fault) -> Iterator[Conflict]:
    if (fault.at_s is None) == (fault.between_s is None):
        yield Conflict(path, "a fault needs either at_s or between_s")
    if fault.between_s is not None and fault.between_s[0] > fault.between_s[1]:
        yield Conflict((*path, "between_s"), "between_s needs the earlier time first")
    needs = _NEEDS.get(fault.fault, ())
    for key in _KEYS:
        given = getattr(fault, key) is not None
        if key in needs and not given:
            yield Conflict(path, f"{fault.fault} needs {key}")
        elif given and key not in (*needs, *_MAY.get(fault.fault, ())):
            yield Conflict((*path, key), f"{fault.fault} has no {key}")


def _vehicle_conflicts(path: KeyPath, fault: Fault, vehicle: VehicleBase) -> Iterator[Conflict]:
    if vehicle.external is not None and fault.fault in LAUNCHED_ONLY:
        sentence = f"{vehicle.label} is external: {fault.fault} is for launched vehicles"
        yield Conflict((*path, "fault"), f"{sentence}; motor and gps_off can be asked of it")
    elif fault.fault == "motor" and vehicle.airborne:
        yield Conflict((*path, "fault"), f"{vehicle.label} starts airborne, without a ground that it could fall to")
    if fault.fault == "tanker_out" and vehicle.role != "tanker":
        yield Conflict((*path, "sysid"), f"{vehicle.label} is no tanker")
