"""Ways past obstacles and peers, judged by distances sampled here."""

from __future__ import annotations

import math
import random

import pytest

from gcs.scenario.model import Obstacle
from simvehicle.fleet.routes import Surroundings, meeting_place, room_m, route
from simvehicle.fleet.rules import Solid

WALL = Solid("box", (4.0, -3.0, -5.0), (4.5, 3.0, 0.0), 0.0)
FREE = Surroundings((), 0.2, (), 0.6)
TRANSIT_DOWN_M = -8.0


def least_room_m(
    start: tuple[float, float, float], corners: list[tuple[float, float, float]], around: Surroundings
) -> float:
    least, here = math.inf, start
    for corner in corners:
        for i in range(1, 201):
            share = i / 200
            point = tuple(a + share * (b - a) for a, b in zip(here, corner, strict=True))
            least = min(least, room_m((point[0], point[1], point[2]), around))
        here = corner
    return least


@pytest.mark.parametrize(
    "keys",
    [
        {"point_m": (1.0, 2.0, -3.0)},
        {"sphere_m": (1.0, 2.0, -3.0), "radius_m": 0.7},
        {"box_m": ((0.0, 0.0, -3.0), (1.0, 2.0, -1.0))},
        {"cylinder_m": (1.0, 2.0), "radius_m": 0.5, "bottom_m": -1.0, "top_m": -3.0},
    ],
)
def test_distances_to_obstacles_are_the_scenarios(keys: dict[str, object]) -> None:
    obstacle = Obstacle.model_validate(keys)
    solid = Solid(obstacle.kind, obstacle.low_m, obstacle.high_m, obstacle.radius_m)
    rng = random.Random(1)
    for _ in range(200):
        place = (rng.uniform(-3, 4), rng.uniform(-3, 4), rng.uniform(-5, 1))
        assert solid.clearance_m(place) == obstacle.clearance_m(place)


def test_a_free_way_is_straight() -> None:
    assert route((0.0, 0.0, -3.0), (9.0, 0.0, -3.0), FREE, TRANSIT_DOWN_M) == [(9.0, 0.0, -3.0)]


def test_a_wall_is_crossed_no_higher_than_needed_and_at_its_distance() -> None:
    around = FREE._replace(obstacles=(WALL,))
    corners = route((0.0, 0.0, -3.0), (9.0, 0.0, -3.0), around, TRANSIT_DOWN_M)
    assert corners is not None
    assert corners[0][2] == pytest.approx(-5.5)  # the wall's 5 m and 0.45 m, in steps of half a metre
    assert least_room_m((0.0, 0.0, -3.0), corners, around) >= 0.0


def test_tankers_that_are_to_travel_high_do_so() -> None:
    corners = route((0.0, 0.0, -3.0), (9.0, 0.0, -3.0), FREE, TRANSIT_DOWN_M, high=True)
    assert corners == [(0.0, 0.0, -8.0), (9.0, 0.0, -8.0), (9.0, 0.0, -3.0)]


def test_no_way_leads_to_a_place_that_is_taken() -> None:
    around = FREE._replace(peers_ned=((9.0, 0.5, -3.0),))
    assert route((0.0, 0.0, -3.0), (9.0, 0.0, -3.0), around, TRANSIT_DOWN_M) is None


def test_a_receiver_waits_where_it_is_if_its_tanker_can_come() -> None:
    assert meeting_place((2.0, 0.0, -3.0), (0.0, 0.0, -6.0), 1.2, FREE, TRANSIT_DOWN_M) == (2.0, 0.0, -3.0)


def test_a_receiver_below_an_obstacle_moves_to_where_its_tanker_can_stand() -> None:
    roof = Solid("box", (1.0, -1.0, -4.5), (3.0, 1.0, -4.0), 0.0)
    around = FREE._replace(obstacles=(roof,), peers_ned=((2.0, 3.0, -3.0),))
    place = meeting_place((2.0, 0.0, -3.0), (0.0, 0.0, -9.0), 1.2, around, TRANSIT_DOWN_M)
    assert place is not None
    above = (place[0], place[1], place[2] - 1.2)
    assert min(room_m(place, around), room_m(above, around)) >= 0.0
    assert least_room_m((2.0, 0.0, -3.0), [place, above], around) >= 0.0


def test_a_receiver_that_is_shut_in_has_no_place() -> None:
    shell = Solid("sphere", (2.0, 0.0, -3.0), (2.0, 0.0, -3.0), 9.0)
    assert meeting_place((2.0, 0.0, -3.0), (0.0, 0.0, -20.0), 1.2, FREE._replace(obstacles=(shell,)), -22.0) is None
