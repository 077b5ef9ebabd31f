"""Vehicles that return without a station through each other's columns, while the radio parts them.

Distances are the vehicles' true ones; nothing of the filter is asked.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from swarm import PLAN, SEPARATION_M, Swarm, rules_of


@pytest.mark.slow
@pytest.mark.parametrize("loss", [0.0, 0.3])
@pytest.mark.parametrize("from_s", [1.0, 6.5])
def test_two_groups_that_do_not_receive_each_other_keep_apart(from_s: float, loss: float) -> None:
    """Two stacks in which the lowest returns highest, so that each has to pass others, of its own group and of the
    other, when the radio parts them: before they set out, or while they pass."""
    places = {3 * k + i + 1: (9.0, 1.5 * k, -2.5 - 1.4 * i) for k in range(2) for i in range(3)}
    homes = {sysid: (2.0 * (sysid // 3), 2.0 * (sysid % 3), 0.0) for sysid in places}
    heights_m = {sysid: 9.0 + 1.2 * (2 * (2 - (sysid - 1) % 3) + (sysid - 1) // 3) for sysid in places}
    rng = np.random.default_rng(5)
    group = {1: 0, 2: 1, 3: 0, 4: 1, 5: 1, 6: 0}

    def passes(sender: int, reader: int, now_s: float) -> bool:
        parted = from_s <= now_s < 40.0 and group[sender] != group[reader]
        return not parted and rng.random() >= loss

    swarm = Swarm(places, rules_of(homes, heights_m), passes, up=True)
    swarm.fly(80.0)
    assert swarm.least_m >= SEPARATION_M
    for sysid, vehicle in swarm.vehicles.items():
        assert math.dist(vehicle.p_ned[:2], homes[sysid][:2]) < 0.6


@pytest.mark.parametrize("parted_s", [0.0, 0.1, 0.3, 0.6])
def test_the_lower_of_a_column_waits_if_the_radio_parts_it_while_it_climbs(parted_s: float) -> None:
    """One below the other, from their places, heights and homes of row 56 of the campaign silence, seed 7301: each has
    climbed past where the other received it last when it finds that other silent."""
    places = {3: (6.0, 0.0, -6.19), 4: (6.0, 0.0, -4.96)}
    rules = rules_of({3: (0.0, -1.0, 0.0), 4: (2.0, 1.0, 0.0)}, {3: 10.06, 4: 11.09}, separation_m=0.63)
    swarm = Swarm(places, rules, lambda _s, _r, now_s: now_s < 5.0 + parted_s, up=True)
    swarm.fly(30.0)
    assert swarm.least_m >= 0.63


def test_one_below_another_that_returns_less_high_waits_where_it_is_while_others_are_silent() -> None:
    """Three of the 22 of row 98 of the campaign silence, seed 20261128: 20 cannot pass 11, both of which do not receive
    10, and would wait beneath it where 10 flies level."""
    places = {10: (16.12, 5.97, -6.85), 11: (12.55, 1.37, -8.86), 20: (13.15, 1.30, -3.42)}
    homes = {10: (2.0, -4.0, 0.0), 11: (4.0, 4.0, 0.0), 20: (6.0, 4.0, 0.0)}
    heights_m = {10: 20.215, 11: 21.445, 20: 32.515}
    rules = rules_of(homes, heights_m, {"level_after_s": 10.5, "down_after_s": 17.0}, separation_m=0.83)
    swarm = Swarm(places, rules, lambda sender, reader, now_s: now_s < 2.0 or 10 not in (sender, reader), up=True)
    climbed_m = []
    swarm.fly(40.0, lambda _: climbed_m.append(places[20][2] - swarm.vehicles[20].p_ned[2]))
    assert swarm.least_m >= 0.83
    assert max(climbed_m) < 0.3
    swarm.fly(75.0)
    assert swarm.least_m >= 0.83
    assert math.dist(swarm.vehicles[20].p_ned[:2], homes[20][:2]) < 0.6


@pytest.mark.parametrize("parted_s", [1.0, 1.5, 2.0, 2.5])
def test_one_below_another_that_returns_less_high_climbs_beside_its_column(parted_s: float) -> None:
    """Three of the 44 of row 181 of the campaign silence, seed 20261204: 13 would push 25 above its height, where the
    radio parts 25 from 3, which returns a little higher."""
    places = {3: (18.06, 2.74, -4.42), 13: (13.14, 0.08, -1.84), 25: (14.01, -0.04, -2.85)}
    homes = {3: (8.0, -1.0, 0.0), 13: (8.0, 1.0, 0.0), 25: (10.0, 1.0, 0.0)}
    times = {"level_after_s": 13.96, "down_after_s": 22.5}
    rules = rules_of(homes, {3: 12.3, 13: 24.8, 25: 11.05}, times, separation_m=0.85)
    begins_s = 5.0

    def passes(sender: int, reader: int, now_s: float) -> bool:
        parted = begins_s + parted_s <= now_s < begins_s + 25.0
        return not (parted and 25 in (sender, reader))

    swarm = Swarm(places, rules, passes, up=True)
    highest_m = []
    swarm.fly(begins_s + 13.9, lambda _: highest_m.append(-swarm.vehicles[25].p_ned[2]))
    assert max(highest_m) < 11.05 + 0.3
    assert -swarm.vehicles[13].p_ned[2] == pytest.approx(24.8, abs=0.3)
    swarm.fly(60.0)
    assert swarm.least_m >= 0.85
    for sysid, vehicle in swarm.vehicles.items():
        assert math.dist(vehicle.p_ned[:2], homes[sysid][:2]) < 0.6


@pytest.mark.parametrize(("aside_m", "returns"), [((-1.2, 1.2), True), ((-1.2, 1.2), False), ((0.9,), False)])
def test_one_between_others_or_below_one_that_is_held_climbs_in_its_column(
    aside_m: tuple[float, ...], returns: bool
) -> None:
    """Others that return are on both sides of it, or stay in the air by their station's order while it has lost that:
    a station that leads others expects it above where it was."""
    places = {1: (9.0, 0.0, -5.0), **{sysid: (9.0, e, -6.0) for sysid, e in enumerate(aside_m, 2)}}
    heights_m = {1: 12.0, 2: 9.0, 3: 10.2}
    homes = {sysid: (0.0, 2.0 * sysid, 0.0) for sysid in places}
    swarm = Swarm(places, rules_of(homes, heights_m), lambda *_: True, up=True)
    off_m = []

    def station(_: float) -> None:
        for sysid, vehicle in swarm.vehicles.items():
            if not returns and sysid != 1:
                vehicle.receive_gcs_heartbeat()
        off_m.append(math.dist(swarm.vehicles[1].p_ned[:2], places[1][:2]))

    swarm.fly(5.0 + PLAN["level_after_s"], station)
    assert swarm.least_m >= SEPARATION_M
    assert -swarm.vehicles[1].p_ned[2] == pytest.approx(12.0, abs=0.3)
    assert returns or max(off_m) < 0.3


@pytest.mark.parametrize("parted_s", [2.1, 2.5])
def test_one_that_turns_while_the_radio_parts_it_stays_where_the_other_group_presumes_it(parted_s: float) -> None:
    """Seven of the 26 of row 4 of that seed, and their heights: 21 evades 6 and 22 on its way up while the radio
    parts them from 7 and 9, which later fly level past the place where they received it last."""
    places = {
        6: (17.81, -0.46, -5.9),
        7: (20.71, -0.84, -5.48),
        9: (18.9, 0.47, -5.46),
        17: (17.59, 0.83, -5.41),
        21: (17.65, -0.24, -4.33),
        22: (18.2, -1.42, -4.83),
        23: (16.91, -1.71, -4.97),
    }
    homes = {
        6: (6.0, -3.0, 0.0),
        7: (6.0, -1.0, 0.0),
        9: (4.0, 3.0, 0.0),
        17: (6.0, 5.0, 0.0),
        21: (4.0, -3.0, 0.0),
        22: (2.0, -1.0, 0.0),
        23: (0.0, 3.0, 0.0),
    }
    heights_m = {6: 13.15, 7: 14.48, 9: 17.14, 17: 27.78, 21: 33.1, 22: 34.43, 23: 35.76}
    times = {"level_after_s": 11.95, "down_after_s": 21.42, "again_after_s": 40.51}

    def passes(sender: int, reader: int, now_s: float) -> bool:
        return now_s < 5.0 + parted_s or (sender in (7, 9)) == (reader in (7, 9))

    swarm = Swarm(places, rules_of(homes, heights_m, times, separation_m=0.93), passes, up=True)
    swarm.fly(24.0)
    assert swarm.least_m >= 0.93
