"""Vehicles that are expected rather than launched: where they are received, and what of a vehicle's keys is theirs.

    - external: {connect: "udpin:127.0.0.1:14550", sysid: 3, capacity_j: 250000}
    - external: {connect: ["serial:/dev/ttyUSB0:57600", "udpin:0.0.0.0:14550"], sysid: 4, capacity_j: 250000}

`sysid` and the battery's `capacity_j` may stand in the block or beside it. Such a vehicle is where it is, flies with
the parameters that it has and on its own clock: what only a launch could give it is refused.
"""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import AfterValidator, Field, WithJsonSchema

from gcs.scenario.document import Conflict, KeyPath
from gcs.scenario.endpoint import EXAMPLE, address, beyond_this_machine
from gcs.scenario.parts.reach import Asks
from gcs.scenario.types import Exact, Joules, Part, SysId

RealKind = Literal["ardupilot", "px4"]
REAL_KINDS: tuple[RealKind, ...] = ("ardupilot", "px4")
"""Autopilots that a session starts, which are not ours."""
LAUNCH_ONLY = ("airborne", "velocity_m_s", "attitude_deg", "params")
NOT_INHERITED = (*LAUNCH_ONLY, "start_m", "plant", "airframe", "sensors", "autopilot")
"""Keys that `vehicles.defaults` gives to launched vehicles alone."""
MOST_LINKS = 4
NOWHERE = (0.0, 0.0, 0.0)
_FORM = (
    "must be udpin:HOST:PORT or tcpin:HOST:PORT, where the vehicle speaks to, udpout:HOST:PORT or tcp:HOST:PORT, where "
    f"it listens, or serial:DEVICE:BAUD, {EXAMPLE}"
)


def _checked(connect: Any) -> Any:
    """One address, or a list of several, as a tuple."""
    given = connect if isinstance(connect, list | tuple) else [connect]
    if not 1 <= len(given) <= MOST_LINKS:
        raise ValueError(f"must be one address, or a list of 1 to {MOST_LINKS}")
    for one in given:
        at = address(one) if isinstance(one, str) else None
        if at is None or not at.port:
            raise ValueError(_FORM)
    if len(set(given)) < len(given):
        raise ValueError("names an address twice: each link of a vehicle has its own")
    return connect if isinstance(connect, str) else tuple(given)


if TYPE_CHECKING:
    Connect = str | tuple[str, ...]
else:
    _LIST = {"type": "array", "items": {"type": "string"}, "minItems": 1, "maxItems": MOST_LINKS}
    Connect = Annotated[
        Any,
        Asks("address", beyond_this_machine),
        AfterValidator(_checked),
        WithJsonSchema({"anyOf": [{"type": "string"}, _LIST]}),
    ]
Wait = Annotated[float, Exact(gt=0, le=3600)]


class SigningKey(Part):
    """Signs what goes to a vehicle, and takes from it only what is signed with the same key."""

    key_file: Annotated[str, Asks("key file"), Field(min_length=1, max_length=4096)]
    """file with the key, as `gcs key new` writes it; a relative path counts from the scenario's folder"""


class External(Part):
    """A vehicle that another program has started; `gcs run` waits for it, arms it and flies it."""

    connect: Connect
    """`udpin:HOST:PORT`, `tcpin:HOST:PORT`: the vehicle speaks to us there; `udpout:HOST:PORT`, `tcp:HOST:PORT`: it
    listens there; `serial:DEVICE:BAUD`: a cable or a radio. Several may share one. A list: it has as many links, of
    which the better one is used, of equals the first"""
    sysid: SysId | None = None
    """MAVLink system id; may stand beside the block instead"""
    autopilot: Literal["auto", "px4", "ardupilot", "generic"] = "auto"
    """whose habits it has; `auto`: as its HEARTBEAT says"""
    capacity_j: Joules
    """what its battery holds when full"""
    found_within_s: Wait = 30.0
    """wall time to wait for its first HEARTBEAT before the session is called off"""
    arm_within_s: Wait = 90.0
    """session time in which it must have found its place and let itself be armed, or it is left out"""
    at_end: Literal["hold", "return", "land"] = "hold"
    """order to it at the session's end, however that comes"""
    rejoins: bool = False
    """whether it is flown again when its link was out, the session stood still or it has booted, whatever its failsafe
    did meanwhile; without it a return or a landing is left alone, for a pilot may have wanted it, until the operator's
    `rejoin`"""
    signing: SigningKey | None = None
    """MAVLink 2 signing; every vehicle at one address has the same key"""

    @property
    def addresses(self) -> tuple[str, ...]:
        """Every address that it may be received at."""
        return (self.connect,) if isinstance(self.connect, str) else self.connect

    @property
    def where(self) -> str:
        """The same, for a person."""
        return " or ".join(self.addresses)


def filled(value: Any) -> Any:
    """A vehicle's keys, those that the block and its vehicle share being in both places."""
    block = value.get("external") if isinstance(value, dict) else None
    if not isinstance(block, dict):
        return value
    value, block = dict(value), dict(block)
    value["external"] = block
    value.setdefault("start_m", NOWHERE)
    for beside, inside in ((value, block), (block, value)):
        if beside.get("sysid") is not None and inside.get("sysid") is None:
            inside["sysid"] = beside["sysid"]
    battery = value.setdefault("battery", {})
    if isinstance(battery, dict):
        battery = value["battery"] = dict(battery)
        for beside, inside in ((battery, block), (block, battery)):
            if beside.get("capacity_j") is not None and inside.get("capacity_j") is None:
                inside["capacity_j"] = beside["capacity_j"]
        battery.setdefault("capacity_j", 1.0)  # it is the block that lacks it, and that says so once
    return value


def inherited(vehicle: dict[str, Any], own: Iterable[str]) -> None:
    """Take from an external vehicle what defaults gave it and only a launch can use; `own` are its own keys."""
    block = vehicle.get("external")
    if isinstance(block, dict):
        unused = {*NOT_INHERITED, *(("battery",) if "capacity_j" in block else ())}
        for key in unused - set(own):
            vehicle.pop(key, None)


def absolute_paths(vehicles: Iterable[dict[str, Any]], folder: Path) -> None:
    """Let key files and programs that a scenario's vehicles name count from its folder, in its data as read."""
    for vehicle in vehicles:
        real = vehicle.get("autopilot")
        programs = real if isinstance(real, dict) else {}
        for kind in REAL_KINDS:
            if isinstance(programs.get(kind), str):
                programs[kind] = str(folder.resolve() / Path(programs[kind]).expanduser())
        block = vehicle.get("external")
        signing = block.get("signing") if isinstance(block, dict) else None
        if isinstance(signing, dict) and isinstance(signing.get("key_file"), str):
            signing["key_file"] = str(folder.resolve() / signing["key_file"])


def give_key(vehicles: Mapping[str, Any], key_file: str) -> None:
    """Let all external vehicles of a scenario's data sign with the key of a file."""
    for group in vehicles.values():
        for vehicle in group:
            if vehicle.get("external"):
                vehicle["external"]["signing"] = {"key_file": key_file}


def key_conflicts(vehicles: Iterable[tuple[KeyPath, Any]]) -> Iterator[Conflict]:
    """Conflicts among the keys of vehicles that share an address."""
    keys: dict[str, str | None] = {}
    for path, vehicle in vehicles:
        block: External | None = vehicle.external
        if block is None:
            continue
        key = block.signing.key_file if block.signing else None
        for connect in block.addresses:
            if keys.setdefault(connect, key) != key:
                text = f"{vehicle.label} has another key than the vehicle before it at {connect}: they share one"
                yield Conflict((*path, "external"), text)


def conflicts(path: KeyPath, vehicle: Any) -> Iterator[Conflict]:
    """Conflicts among an external vehicle's keys."""
    block: External | None = vehicle.external
    if block is None:
        return
    launched = {key: getattr(vehicle, key) for key in LAUNCH_ONLY}
    for key, given in {**launched, "autopilot": vehicle.real, "plant": vehicle.plant != "paper"}.items():
        if any(given) if isinstance(given, tuple) else given:
            yield Conflict((*path, key), f"{vehicle.label} is external: {key} is for launched vehicles; leave it out")
    if block.sysid != vehicle.sysid:
        yield Conflict((*path, "external", "sysid"), f"{vehicle.label} is given another sysid here: {block.sysid}")
    if block.capacity_j != vehicle.battery.capacity_j:
        yield Conflict((*path, "external", "capacity_j"), f"{vehicle.label} is given two values of capacity_j")
    if vehicle.role == "tanker" and vehicle.home_m is None:
        yield Conflict(path, f"{vehicle.label} is external: say where it waits, home_m")


def clock_refusal(vehicles: Iterable[Any], mode: str) -> str | None:
    """Why this clock cannot be had with these vehicles; None where it can."""
    labels = [vehicle.label for vehicle in vehicles if vehicle.external is not None]
    if not labels or mode == "real":
        return None
    who = labels[0] if len(labels) == 1 else f"{labels[0]} and {len(labels) - 1} more"
    lives = "lives on its own clock, which waits" if len(labels) == 1 else "live on their own clocks, which wait"
    return f"{who} (external) {lives} for no supervisor: leave out lockstep"
