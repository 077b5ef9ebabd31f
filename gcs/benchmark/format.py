"""Instances and schedules as JSON (docs/refuelling-benchmark.md#format): types, and the schema made of them.

Positions NED, m; times s from the start; energies J; powers W.
"""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Final, Literal, TypeVar

import msgspec
from msgspec import Meta, Struct

INSTANCE: Final = "skytender-refuelling-instance/1"
SCHEDULE: Final = "skytender-refuelling-schedule/1"
Vec3 = tuple[float, float, float]
Corner = tuple[float, float, float, float]
Positive = Annotated[float, Meta(gt=0.0)]
NotNegative = Annotated[float, Meta(ge=0.0)]
Id = Annotated[int, Meta(ge=1, le=254)]


class BenchmarkReceiver(Struct, forbid_unknown_fields=True):
    """A vehicle that flies its path whatever happens, and is lost once it holds less than `lands_at_j`."""

    id: Id
    path: Annotated[list[Corner], Meta(min_length=1)]
    """(t, n, e, d) of its corners, the first at 0 s; straight between them, and still after the last"""
    speed_m_s: Positive
    """off its path, to a base and back"""
    capacity_j: Positive
    energy_j: NotNegative
    """at 0 s"""
    power_w: NotNegative
    """drawn in flight"""
    lands_at_j: NotNegative


class BenchmarkTanker(Struct, forbid_unknown_fields=True):
    """A vehicle that gives from its own battery."""

    id: Id
    position_m: Vec3
    speed_m_s: Positive
    capacity_j: Positive
    energy_j: NotNegative
    power_w: NotNegative
    reserve_j: NotNegative
    """less than that it never holds"""


class BenchmarkBase(Struct, forbid_unknown_fields=True):
    """A giver on the ground, for one vehicle at a time."""

    name: Annotated[str, Meta(min_length=1)]
    position_m: Vec3
    stock_j: NotNegative
    rate_w: Positive


class Instance(Struct, forbid_unknown_fields=True):
    """A problem: receivers to keep in the air until the horizon."""

    format: Literal["skytender-refuelling-instance/1"]
    name: str
    kind: str
    """class of instances"""
    tightness: float
    """0 loose to 1 tight; as drawn"""
    seed: int
    horizon_s: Positive
    setup_s: NotNegative
    """from the beginning of a service to its first joule"""
    rate_w: Positive
    """greatest power of a transfer in flight"""
    receivers: list[BenchmarkReceiver]
    tankers: list[BenchmarkTanker]
    bases: list[BenchmarkBase]

    def __post_init__(self) -> None:
        """Raises ValueError, with the place, where two things have one name, or a path runs back or jumps."""
        named: dict[int | str, str] = {}
        names: list[tuple[str, str, int | str]] = [
            *((f"receivers[{k}]", "id", one.id) for k, one in enumerate(self.receivers)),
            *((f"tankers[{k}]", "id", one.id) for k, one in enumerate(self.tankers)),
            *((f"bases[{k}]", "name", one.name) for k, one in enumerate(self.bases)),
        ]
        for here, key, name in names:
            if name in named:
                raise ValueError(f"{here} has the {key} {name} of {named[name]}")
            named[name] = here
        for k, one in enumerate(self.receivers):
            for corner, ((t0, *p0), (t1, *p1)) in enumerate(pairwise(one.path), 1):
                if t1 < t0 or (t1 == t0 and p1 != p0):
                    before = f"not later than the corner before ({t0:g} s)"
                    raise ValueError(f"receivers[{k}].path[{corner}] is at {t1:g} s, {before}")


class ScheduledService(Struct, forbid_unknown_fields=True, omit_defaults=True):
    """A transfer between two of a receiver, a tanker and a base; a receiver at a base leaves its path for it."""

    start_s: float
    """both are together"""
    end_s: float
    energy_j: float
    receiver: int | None = None
    tanker: int | None = None
    base: str | None = None
    leave_s: float | None = None
    """a receiver at a base: it leaves its path, and is back on it"""
    back_s: float | None = None


class Schedule(Struct, forbid_unknown_fields=True):
    """Services of an instance, in any order."""

    format: Literal["skytender-refuelling-schedule/1"]
    instance: str
    services: list[ScheduledService]


class FormatError(ValueError):
    """A file that is none; the text names it and says why."""


One = TypeVar("One", Instance, Schedule)


def read(path: Path, kind: type[One]) -> One:
    """The instance or schedule in a file. Raises FormatError."""
    try:
        return msgspec.json.decode(path.read_bytes(), type=kind)
    except OSError as error:
        raise FormatError(f"{path}: {error.strerror}") from None
    except (msgspec.MsgspecError, UnicodeDecodeError) as error:
        raise FormatError(
            f"{path} is no {kind.__name__.lower()} (docs/refuelling-benchmark.md#format): {error}"
        ) from None


def raw(one: Instance | Schedule) -> bytes:
    """The file's bytes."""
    return msgspec.json.format(msgspec.json.encode(one), indent=1) + b"\n"


def plain(one: Instance | Schedule) -> dict[str, Any]:
    """The same as dicts and lists, as JSON has them."""
    return msgspec.json.decode(msgspec.json.encode(one))


def schema() -> dict[str, Any]:
    """JSON Schema of both files."""
    (instance, schedule), parts = msgspec.json.schema_components([Instance, Schedule], ref_template="#/$defs/{name}")
    about = {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "Refuelling instances and schedules"}
    return {**about, "anyOf": [instance, schedule], "$defs": parts}
