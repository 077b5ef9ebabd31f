"""Bases on the ground, and what keeps one from serving."""

from collections.abc import Iterator, Sequence
from typing import Annotated

from gcs.scenario.document import Conflict
from gcs.scenario.parts.surroundings import Obstacle
from gcs.scenario.parts.vehicles import Pursuer
from gcs.scenario.types import Exact, Label, Metres, Part, Positive, Vec3

LEAST_BASE_CLEARANCE_M = 0.3


class Base(Part):
    """A giver on the ground, with a rate and a stock; it serves one vehicle at a time."""

    name: Label
    """name in messages and records; unique"""
    position_m: Vec3
    """where vehicles land"""
    rate_w: Positive = 2000.0
    """charging power, W"""
    stock_j: Annotated[float, Exact(gt=0, lt=1 << 31)]
    """whole joules of it are given"""
    radius_m: Metres = 1.0
    """how far from its place a vehicle may stand and still be charged"""
    height_m: Metres = 2.5
    """the height above it from which vehicles come down"""

    @property
    def above_m(self) -> tuple[float, float, float]:
        """NED; where vehicles come down from."""
        n, e, d = self.position_m
        return (n, e, d - self.height_m)


def base_conflicts(
    bases: Sequence[Base], pursuers: Sequence[Pursuer], obstacles: Sequence[Obstacle], *, capture_m: float
) -> Iterator[Conflict]:
    """Fault that keeps bases and the vehicles that need them from working together; `capture_m` is refuelling's."""
    launched = any(pursuer.external is None for pursuer in pursuers)
    for i, base in enumerate(bases):
        place = ("bases", i, "position_m")
        if launched and base.position_m[2] != 0.0:
            yield Conflict(place, f"the base {base.name} must stand on the ground: its third number is 0")
        if launched and base.radius_m > capture_m:
            sentence = f"radius_m is at most refuelling.capture_m, {capture_m:g}: vehicles take nothing from beyond it"
            yield Conflict(("bases", i, "radius_m"), sentence)
        for j, obstacle in enumerate(obstacles):
            if obstacle.fault():
                continue
            if min(map(obstacle.clearance_m, (base.position_m, base.above_m))) < LEAST_BASE_CLEARANCE_M:
                what = obstacle.name or f"{obstacle.kind} {j + 1}"
                sentence = (
                    f"the base {base.name} lies inside or within {LEAST_BASE_CLEARANCE_M} m of the obstacle {what}"
                )
                yield Conflict(place, sentence, ("obstacles", j))
        for other in range(i):
            if bases[other].name == base.name:
                yield Conflict(("bases", i, "name"), f"the name {base.name} is given twice", ("bases", other, "name"))
    for i, pursuer in enumerate(pursuers):
        if bases and pursuer.transfer is False and pursuer.airborne:
            sentence = f"{pursuer.label} starts airborne, without a ground, and so cannot land at a base"
            yield Conflict(("vehicles", "pursuers", i, "airborne"), sentence)
