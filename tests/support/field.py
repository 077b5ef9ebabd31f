"""The planner's compiled potential field, summed over what attracts and repels at one place; and the
potentials that docs/model/planner.md#potential-field gives, whose gradients these forces are."""

import math
from typing import Any

import numpy as np
from compiled import function

from gcs.planner import fuzzy_escape, potential_field
from gcs.planner.potential_field import SURFACE_FLOOR_M, FieldConstants
from skytender import geometry

_attraction_to = function(potential_field, "attraction_to", 3, *["number"] * 7, "row")
_repulsion_size = function(potential_field, "repulsion_size", 1, "number", "number", "row")
_repulsion_of_shape = function(potential_field, "repulsion_of_shape", 3, "row", *["number"] * 4, "row")
_escape_force = function(fuzzy_escape, "escape_force", 3, "row", *["number"] * 12)
_shape_surface = function(geometry, "shape_surface", 4, "row", *["number"] * 3)


def force(q: Any, *, tracked: Any, waypoints: Any, repulsors: Any, ranges_m: Any, field: FieldConstants) -> Any:
    """Attraction (3,) and repulsion (3,) at a place: what the leader's kernel adds up."""
    constants, reach_m = field.constants(), field.attraction_range_m
    pulls = [_attraction_to(*g, math.inf, *q, constants) for g in tracked]
    pulls += [_attraction_to(*g, reach_m, *q, constants) for g in waypoints]
    pushes = [_repulsion_of_shape(*one, *q, constants) for one in zip(repulsors, ranges_m, strict=True)]
    return np.array([(0.0, 0.0, 0.0), *pulls]).sum(axis=0), np.array([(0.0, 0.0, 0.0), *pushes]).sum(axis=0)


def escape(
    q: Any,
    attraction: Any,
    repulsion: Any,
    goal_m: float,
    memory: Any,
    *,
    field: FieldConstants,
    step_m: float | None = None,
) -> Any:
    """Escape force (3,) and the memory after it."""
    following, full_m = memory.copy(), field.step_m if step_m is None else step_m
    return np.array(_escape_force(following, *q, *attraction, *repulsion, goal_m, full_m, field.step_m)), following


def surface(table: Any, q: Any) -> Any:
    """Signed distance (m,) to each shape's surface, and unit vectors (m, 3) from the surfaces towards a place."""
    found = np.array([_shape_surface(row, *q) for row in table]).reshape(-1, 4)
    return found[:, 0], found[:, 1:]


def attraction_potential(rho: float, field: FieldConstants) -> float:
    """U_g, straight on from the cap with the slope that it has reached."""
    near = min(rho, field.cap_m)
    return 0.5 * field.k0 * near**2 + (field.k0 * field.cap_m * (rho - near) if rho > near else 0.0)


def repulsion_potential(rho: float, range_m: float, field: FieldConstants) -> float:
    """U_o, straight on below SURFACE_FLOOR_M with the slope that it has reached."""
    near, inner = max(rho, SURFACE_FLOOR_M), field.b * range_m
    potential = 0.0
    if near <= range_m:
        potential += 0.5 * field.k1 * (1 / near - 1 / range_m) ** 2
    if near <= inner:
        potential += 0.5 * field.a * field.k1 * (1 / near - 1 / inner) ** 2
    return potential + (near - rho) * float(_repulsion_size(near, range_m, field.constants()))
