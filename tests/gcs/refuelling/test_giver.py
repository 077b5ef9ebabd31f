"""Service times learnt, and when a vehicle is served if another is first: least squares by numpy, sums by hand."""

import math

import numpy as np
import pytest

from gcs.refuelling.giver import Giver, ServiceTimes, lasts_s, nearest_s, served_if_passed_over_s, ways_s
from gcs.refuelling.service import Phase, Service
from gcs.scenario.model import RefuellingRules
from tests.support.services import view


def served(number: int, way_s: float, begins_s: float, ends_s: float, energy_j: int, **changed: object) -> Service:
    done = Service(number, 1, 201, "competition", {}, 10.0, phase=Phase.DONE)
    done.meets_in_s, done.start_s, done.energy_j = way_s, 10.0 + begins_s, energy_j
    done.end_s = 10.0 + begins_s + ends_s
    for name, value in changed.items():
        setattr(done, name, value)
    return done


def test_what_is_learnt_is_the_least_squares_fit_with_the_first_guess_as_four_services() -> None:
    ways = np.array([0.5, 2.0, 4.0, 9.0, 6.0])
    begins = 2.0 + 1.5 * ways
    times = ServiceTimes(3.0, 1.0, 1.0)
    times.learn(
        (served(i, w, b, 5.4, 10_000) for i, (w, b) in enumerate(zip(ways, begins, strict=True))), lambda _: 2e3
    )
    rows = np.array([[1.0, w] for w in (1.0, 1.0, 5.0, 5.0, *ways)])
    fitted = np.linalg.lstsq(rows, np.array([4.0, 4.0, 8.0, 8.0, *begins]), rcond=None)[0]
    assert (times.start_s, times.per_way) == pytest.approx(tuple(fitted))
    assert times.end_s == pytest.approx((4 * 1.0 + 5 * 0.4) / 9)


def test_each_service_is_learnt_once_and_only_if_it_went_as_it_should() -> None:
    times = ServiceTimes(3.0, 1.0, 1.0)
    bad = [
        served(2, 2.0, 30.0, 5.0, 10_000, start_s=None),
        served(3, 2.0, 30.0, 5.0, 10_000, phase=Phase.TRANSFER),
    ]
    times.learn(bad, lambda _: 2e3)
    assert (times.start_s, times.per_way, times.end_s) == pytest.approx((3.0, 1.0, 1.0))
    good = [served(4, 2.0, 30.0, 5.0, 10_000)]
    times.learn(good, lambda _: 2e3)
    once = times.start_s
    times.learn(good, lambda _: 2e3)
    assert times.start_s == once > 3.0


def test_what_a_broken_off_transfer_costs_is_learnt_as_time_at_its_end() -> None:
    """By hand: decided at 10 s, energy expected from 15 s on for 5 s, ended at 45 s: 25 s were lost."""
    times = ServiceTimes(3.0, 1.0, 1.0)
    times.learn([served(1, 2.0, 30.0, 5.0, 10_000, breaks=1)], lambda _: 2e3)
    assert (times.start_s, times.per_way, times.end_s) == pytest.approx((3.0, 1.0, (4 * 1.0 + 25.0) / 5))


def test_a_vehicle_lasts_until_the_charge_at_which_it_lands() -> None:
    hovering = view(1, "pursuer", (0.0, 0.0, 0.0), 3_000.0, 20_000.0)._replace(power_w=200.0)
    assert lasts_s(hovering, 0.05) == pytest.approx(10.0)  # 1000 J are never used
    assert lasts_s(hovering, 0.2) == 0.0
    assert lasts_s(hovering._replace(power_w=0.0), 0.05) == math.inf


def test_who_is_passed_over_waits_for_a_whole_service_or_for_a_giver_that_is_free_later() -> None:
    """By hand, 1 m/s, a = 2, b = 1, end 1 s, net 1800 W: 1 at 3 m lacks 900 J, 2 at 10 m lacks 9000 J.

    2 first: begins at 12, draws 2400 meanwhile, so flows 6.33 s, ends at 19.33, 7 m back: begins at 28.33.
    1 first: begins at 5, draws 1000 meanwhile, flows 1.06 s, ends at 7.06, 7 m on: begins at 16.06.
    """
    rules = RefuellingRules(until=1.0)
    times = ServiceTimes(2.0, 1.0, 1.0)
    one = view(1, "pursuer", (3.0, 0.0, 0.0), 19_100.0, 20_000.0)._replace(power_w=200.0)
    two = view(2, "pursuer", (10.0, 0.0, 0.0), 11_000.0, 20_000.0)._replace(power_w=200.0)
    tanker = Giver(201, (0.0, 0.0, 0.0), 0.0, 1.0, 1e5, 2000.0)
    assert served_if_passed_over_s([tanker], [one, two], times, rules) == pytest.approx([28.333, 16.056], abs=1e-3)
    other = Giver(202, (10.0, 0.0, 0.0), 6.0, 1.0, 1e5, 2000.0)
    assert served_if_passed_over_s([tanker, other], [one, two], times, rules) == pytest.approx([15.0, 8.0])
    assert ways_s([tanker, other], [one, two]) == [3.0, 10.0]
    assert nearest_s([tanker, other], two, times) == pytest.approx(8.0)
    assert served_if_passed_over_s([tanker], [two], times, rules) == pytest.approx([12.0])
