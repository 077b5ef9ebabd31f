"""The law by which vehicles on missions wait, in situations whose outcome geometry gives."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from gcs.planner.mission_holds import ALONG_M, OURS, OnMission, Other, judge
from skytender.safety.intruders import Intruder, table_of
from skytender.safety.safety_filter import FilterSettings, Leaders, filter_step

WANTED_M = 1.0
STANDS = (0.0, 0.0, 0.0)
Vec3 = tuple[float, float, float]


def flier(sysid: int, p: Vec3, v: Vec3, *ahead: Vec3, goes: bool = True, led: bool = False) -> OnMission:
    return OnMission(sysid, f"pursuer {sysid}", p, v, ahead, goes, led, OURS)


EAST = flier(1, (0.0, 0.0, -4.0), (0.0, 2.0, 0.0), (0.0, 50.0, -4.0))


def test_one_alone_goes_and_claims_nothing_beside_its_line() -> None:
    verdict = judge([EAST], [], WANTED_M)[1]
    assert verdict.waits_for == ""
    assert len(verdict.claim_ned) == 0


def test_of_two_that_cross_the_later_one_in_order_waits_and_the_first_does_not() -> None:
    other = flier(2, (3.2, 4.0, -4.0), (-2.0, 0.0, 0.0), (-20.0, 4.0, -4.0))
    verdicts = judge([EAST, other], [], WANTED_M)
    assert (verdicts[1].waits_for, verdicts[2].waits_for) == ("", "pursuer 1")
    assert not verdicts[2].aside


def test_the_order_is_that_of_system_ids_and_not_of_places() -> None:
    other = flier(2, EAST.p_ned, EAST.v_ned, *EAST.ahead)
    first = flier(1, (2.5, 3.0, -4.0), (-2.0, 0.0, 0.0), (-20.0, 3.0, -4.0))
    assert judge([first, other], [], WANTED_M)[2].waits_for == "pursuer 1"


@pytest.mark.parametrize("height_m", [7.0, 1.0])
def test_ways_at_other_heights_do_not_cross(height_m: float) -> None:
    other = flier(2, (3.2, 4.0, -height_m), (-2.0, 0.0, 0.0), (-20.0, 4.0, -height_m))
    assert judge([EAST, other], [], WANTED_M)[2].waits_for == ""


def test_two_that_part_go_on_though_they_are_too_near() -> None:
    one = flier(1, (0.0, 0.0, -4.0), (0.0, 1.0, 0.0), (0.0, 9.0, -4.0))
    other = flier(2, (0.5, 0.0, -4.0), (1.0, -1.0, 0.0), (9.0, -9.0, -4.0))
    verdicts = judge([one, other], [], WANTED_M)
    assert (verdicts[1].waits_for, verdicts[2].waits_for) == ("", "")


def test_one_that_stands_in_the_way_of_a_first_one_steps_aside() -> None:
    other = flier(2, (0.0, 9.0, -4.0), (0.0, 0.0, 0.0), (0.0, -20.0, -4.0), goes=False)
    verdicts = judge([EAST, other], [], WANTED_M)
    assert verdicts[2].aside
    assert verdicts[2].waits_for == "pursuer 1"


def test_one_that_stands_in_the_way_of_a_first_one_that_stepped_aside_does_so_too() -> None:
    first = flier(1, (0.0, 0.0, -4.0), (0.0, 0.0, 0.0), (0.0, 20.0, -4.0), goes=False, led=True)
    other = flier(2, (0.0, 4.0, -4.0), (0.0, 0.0, 0.0), (0.0, 20.0, -4.0), goes=False)
    assert judge([first, other], [], WANTED_M)[2].aside


def test_of_ways_side_by_side_that_of_the_first_is_kept_free_and_one_far_away_too() -> None:
    stands = (0.0, 0.0, 0.0)
    flights = [
        flier(sysid, (north_m, 0.0, -4.0), stands, (north_m, 20.0, -4.0), goes=False)
        for sysid, north_m in ((1, 0.0), (2, 1.5), (3, 3.0), (4, 40.0))
    ]
    walls = [Other(f"wall {one.sysid}", (one.p_ned[0], 1.5, -4.0), stands) for one in flights]
    verdicts = judge(flights, walls, WANTED_M)
    assert all(verdict.waits_for for verdict in verdicts.values())
    assert [len(verdicts[k].claim_ned) > 0 for k in (1, 2, 3, 4)] == [True, False, False, True]


def test_of_two_that_could_set_out_for_one_place_the_first_does() -> None:
    stands = (0.0, 0.0, 0.0)
    both = [flier(k, (0.0, 4.0 * k, -4.0), stands, (0.0, 6.0, -4.0), goes=False, led=True) for k in (1, 2)]
    verdicts = judge(both, [], WANTED_M)
    assert (verdicts[1].waits_for, verdicts[2].waits_for) == ("", "pursuer 1")


def test_the_place_to_which_one_that_holds_may_come_back_is_kept_clear() -> None:
    evades = flier(2, (4.0, 2.5, -4.0), (0.0, 0.0, 0.0), (0.0, 50.0, -4.0), goes=False)
    assert judge([EAST, evades], [], WANTED_M)[1].waits_for == ""
    back = dataclasses.replace(evades, held_ned=np.array([(0.0, 2.5, -4.0)]))
    assert judge([EAST, back], [], WANTED_M)[1].waits_for == "pursuer 2"


def test_one_that_stands_in_a_way_that_is_kept_free_is_driven_forward_alone() -> None:
    stands = (0.0, 0.0, 0.0)
    waits = dataclasses.replace(flier(1, (0.0, 0.0, -4.0), stands, (0.0, 20.0, -4.0), goes=False), cruise_m_s=4.0)
    behind = Other("pursuer 9", (0.1, 3.0, -4.0), stands)
    east_m = judge([waits], [behind], WANTED_M)[1].claim_ned[:, 1]
    assert 2.0 < east_m.max() < 3.0
    beside = judge([waits], [dataclasses.replace(behind, p_ned=(0.9, 3.0, -4.0))], WANTED_M)[1].claim_ned[:, 1]
    assert beside.max() > 6.0


def test_a_way_is_kept_free_up_to_a_sharp_corner_so_that_one_in_it_can_leave() -> None:
    """Nine on one plan stood for 300 s: one waited 2.6 m before a corner, and the other, inside of the corner between
    both legs, did not find a way out."""
    waits = flier(1, (19.8, 21.4, -4.0), STANDS, (20.0, 24.0, -4.0), (0.0, 24.0, -4.0), goes=False)
    waits = dataclasses.replace(waits, cruise_m_s=4.0)
    inside = Other("pursuer 53", (18.8, 22.9, -3.9), STANDS)
    verdict = judge([waits], [inside], WANTED_M)[1]
    assert verdict.waits_for == inside.name
    assert verdict.claim_ned[:, 0].min() > 19.5, "no place beyond the corner"
    assert verdict.claim_ned[:, 1].max() == pytest.approx(24.0, abs=ALONG_M)
    p_ned, v_ned = np.array([inside.p_ned]), np.zeros((1, 3))
    others = [Intruder.of("", None, waits.p_ned, STANDS, 0.3, 1.15, 0.1)]
    others += [Intruder.of("", None, place, STANDS, 0.0, 1.65, 0.0) for place in verdict.claim_ned[::2]]
    for _ in range(50):
        led = Leaders(ids=[53], p_ned=p_ned, v_ned=v_ned, v_max_m_s=2.5, a_max_m_s2=4.0, margin_m=0.15)
        flown = filter_step(led, [[2.5, 0.2, 0.0]], rules=FilterSettings(0.1, WANTED_M), others=table_of(others))
        p_ned, v_ned = flown.p_next_ned, flown.v_next_ned
    assert min(np.linalg.norm(one.p_ned - p_ned) for one in others[1:]) > 1.65, "it has left what is claimed"


def test_a_corner_at_which_one_waits_does_not_end_what_is_kept_free() -> None:
    waits = flier(1, (0.0, 19.5, -4.0), STANDS, (0.0, 20.0, -4.0), (20.0, 20.0, -4.0), goes=False)
    waits = dataclasses.replace(waits, cruise_m_s=4.0)
    ahead = Other("pursuer 9", (3.0, 20.9, -4.0), STANDS)
    verdict = judge([waits], [ahead], WANTED_M)[1]
    assert verdict.waits_for == ahead.name
    assert verdict.claim_ned[:, 0].max() > 4.0


def test_beyond_a_corner_too_a_way_is_kept_free_where_none_is_between_its_legs() -> None:
    """Six of eight on one plan stood for ever before its first corner: one of them stood on the leg back."""
    waits = flier(1, (17.7, 1.8, -4.0), STANDS, (20.0, 0.0, -4.0), (0.0, 0.0, -4.0), goes=False, led=True)
    waits = dataclasses.replace(waits, cruise_m_s=4.0)
    ahead = Other("pursuer 6", (17.8, -0.5, -4.0), STANDS)
    verdict = judge([waits], [ahead], WANTED_M)[1]
    assert verdict.waits_for == ahead.name
    assert min(np.linalg.norm(place - np.array(ahead.p_ned)) for place in verdict.claim_ned) < WANTED_M


def test_one_does_not_wait_for_a_first_one_that_another_holds_as_well() -> None:
    """2 crosses behind the wall at which 1 waits: 1 could not go on either way."""
    first = flier(1, (0.0, -6.0, -4.0), STANDS, (0.0, 20.0, -4.0), goes=False)
    first = dataclasses.replace(first, cruise_m_s=4.0)
    crosses = flier(2, (3.0, -2.5, -4.0), (-2.0, 0.0, 0.0), (-20.0, -2.5, -4.0))
    wall = Other("pursuer 9", (0.0, -2.0, -4.0), STANDS)
    assert judge([first, crosses], [], WANTED_M)[2].waits_for == "pursuer 1"
    verdicts = judge([first, crosses], [dataclasses.replace(wall, p_ned=(0.0, 0.0, -4.0))], WANTED_M)
    assert verdicts[1].waits_for
    assert verdicts[2].waits_for == ""


def test_one_that_still_brakes_does_not_step_aside_yet() -> None:
    other = flier(2, (0.0, 9.0, -4.0), (0.0, -1.0, 0.0), (0.0, -20.0, -4.0), goes=False)
    assert not judge([EAST, other], [], WANTED_M)[2].aside


def test_a_later_one_does_not_go_on_while_a_first_one_waits_for_it() -> None:
    first = flier(1, (0.0, 0.0, -4.0), (0.0, 0.0, 0.0), (0.0, 50.0, -4.0), goes=False)
    other = flier(2, (0.0, 1.5, -4.0), (0.0, 0.0, 0.0), (40.0, 1.5, -4.0), goes=False, led=True)
    verdicts = judge([first, other], [], WANTED_M)
    assert verdicts[1].waits_for == "pursuer 2"
    assert verdicts[2].waits_for == "pursuer 1"
    near = [float(np.linalg.norm(place - np.array(other.p_ned))) for place in verdicts[1].claim_ned]
    assert min(near) < WANTED_M  # and what it claims drives the other out


def test_a_bend_within_its_stretch_is_claimed_and_the_straight_part_is_not() -> None:
    turning = flier(1, (0.0, 0.0, -4.0), (0.0, 4.0, 0.0), (0.0, 2.0, -4.0), (50.0, 2.0, -4.0))
    claim = judge([turning], [], WANTED_M)[1].claim_ned
    assert len(claim) > 0
    assert (claim[:, 0] > 0.0).all()
    np.testing.assert_allclose(claim[:, 1], 2.0)


@pytest.mark.parametrize(("along_m", "waits"), [(2.5, True), (30.0, False)])
def test_it_holds_for_another_that_it_would_hit_before_it_could_stand(along_m: float, waits: bool) -> None:
    stands = Other("pursuer 7", (0.0, along_m, -4.0), (0.0, 0.0, 0.0))
    assert judge([EAST], [stands], WANTED_M)[1].waits_for == ("pursuer 7" if waits else "")


def test_it_does_not_hold_for_another_that_leaves_in_time() -> None:
    leaves = Other("pursuer 7", (1.0, 2.5, -4.0), (4.0, 0.0, 0.0))
    assert judge([EAST], [leaves], WANTED_M)[1].waits_for == ""


def test_a_stretch_is_long_enough_to_stand_in() -> None:
    """By the closed form: reaction and braking from a speed that may still have grown."""
    for speed_m_s in (0.0, 2.0, 5.0):
        least_m = speed_m_s * OURS.reacts_s + speed_m_s * speed_m_s / (2.0 * OURS.brakes_m_s2)
        assert OURS.way_m(speed_m_s) > least_m


def test_held_ones_all_get_on_in_the_end() -> None:
    """Five missions through one point, flown by points that stop and go as ordered: all come to their ends, and
    no two are ever nearer than wanted. One that steps aside leaves at right angles."""
    goals = [(20.0 * math.cos(k), 20.0 * math.sin(k), -4.0) for k in np.arange(5) * 2.0 * math.pi / 5]
    places = [np.array((-n, -e, d)) for n, e, d in goals]
    going, aside, clear_s = [True] * 5, [False] * 5, [0.0] * 5
    speeds = [0.0] * 5
    nearest_m = math.inf
    for _ in range(3000):
        flights = []
        for k, goal in enumerate(goals):
            way = np.array(goal) - places[k]
            ahead = way / max(float(np.linalg.norm(way)), 1e-9)
            v = tuple(float(x) for x in speeds[k] * ahead)
            here = tuple(float(x) for x in places[k])
            if float(np.linalg.norm(way)) > 0.5:
                flights.append(dataclasses.replace(
                    flier(k + 1, here, v, goal, goes=going[k], led=aside[k]), cruise_m_s=2.0  # type: ignore[arg-type]
                ))  # fmt: skip
        verdicts = judge(flights, [], WANTED_M)
        for sysid, verdict in verdicts.items():
            k = sysid - 1
            if verdict.waits_for:
                going[k], clear_s[k] = False, 0.0
                aside[k] = aside[k] or verdict.aside
            else:
                clear_s[k] += 0.1
                if clear_s[k] >= 1.0:
                    going[k], aside[k] = True, False
            way = np.array(goals[k]) - places[k]
            ahead = way / max(float(np.linalg.norm(way)), 1e-9)
            speeds[k] = min(speeds[k] + 0.25, 2.0) if going[k] else max(speeds[k] - 0.25, 0.0)
            places[k] = places[k] + 0.1 * speeds[k] * ahead
            if aside[k]:
                places[k] = places[k] + 0.1 * np.array((-ahead[1], ahead[0], 0.0))
        up = [one.sysid - 1 for one in flights]
        pairs = [(a, b) for a in up for b in up if a < b]
        nearest_m = min([nearest_m, *(float(np.linalg.norm(places[a] - places[b])) for a, b in pairs)])
        if not flights:
            break
    assert not flights
    assert nearest_m >= WANTED_M
