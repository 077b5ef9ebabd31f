"""The bad radio: statistics, order in time, and the same fate every time."""

import math
import subprocess
import sys
from typing import Any

from gcs.link.impairment import Burst, Impairment

MANY = 20_000


def flown(radio: Impairment, ticks: int, per_tick: int = 5, sysid: int = 1) -> list[tuple[float, int]]:
    """(delivery time, number of the frame) of frames numbered in the order of sending, ticks 0.1 s apart."""
    out = []
    for tick in range(ticks):
        frames = list(range(tick * per_tick, (tick + 1) * per_tick))
        out += [(tick / 10, frame) for frame in radio.apply(sysid, "in", tick / 10, frames)]
    return out


def numbers(flight: list[tuple[float, int]]) -> list[int]:
    return [number for _, number in flight]


def test_share_lost_is_the_loss() -> None:
    radio = Impairment(loss=0.2, seed=1)
    through = len(radio.apply(1, "out", 0.0, range(MANY)))
    # Five standard deviations of the binomial law.
    assert abs(through - 0.8 * MANY) < 5 * math.sqrt(MANY * 0.2 * 0.8)


def test_share_duplicated_is_the_duplicate_rate() -> None:
    through = Impairment(duplicate=0.1, seed=1).apply(1, "out", 0.0, range(MANY))
    assert set(through) == set(range(MANY))
    assert abs(len(through) - 1.1 * MANY) < 5 * math.sqrt(MANY * 0.1 * 0.9)


def test_delay_of_whole_ticks_arrives_on_its_tick_in_order() -> None:
    flight = flown(Impairment(delay_s=0.2), ticks=50)
    assert flight == [(tick / 10, 5 * (tick - 2) + i) for tick in range(2, 50) for i in range(5)]


def test_jitter_stays_within_its_bounds_and_lets_frames_overtake() -> None:
    flight = flown(Impairment(delay_s=0.2, jitter_s=0.3, seed=2), ticks=200)
    waits = [round(at - (number // 5) / 10, 6) for at, number in flight]
    assert min(waits) == 0.3  # 0.2 s only for a draw of exactly 0
    assert max(waits) == 0.5
    assert numbers(flight) != sorted(numbers(flight))
    assert set(range(970)) <= set(numbers(flight))  # all but those sent in the last 0.5 s, each once
    assert len(set(numbers(flight))) == len(flight)


def test_reordered_frame_follows_the_next_one_even_over_ticks() -> None:
    radio = Impairment(reorder=0.3, seed=3)
    flight = numbers(flown(radio, ticks=400))
    assert len(set(flight)) == len(flight)
    assert set(range(1980)) <= set(flight)
    late = [i for i in range(1, len(flight)) if flight[i] < max(flight[:i])]
    assert abs(len(late) - 0.3 * len(flight)) < 5 * math.sqrt(len(flight) * 0.3 * 0.7)


def test_other_vehicles_and_directions_do_not_change_a_vehicles_fate() -> None:
    settings: dict[str, Any] = {"loss": 0.3, "jitter_s": 0.2, "duplicate": 0.1, "reorder": 0.1, "seed": 9}
    alone = flown(Impairment(**settings), ticks=50)
    radio = Impairment(**settings)
    crowded = []
    for tick in range(50):
        radio.apply(2, "in", tick / 10, range(tick))
        radio.apply(1, "out", tick / 10, range(7))
        frames = list(range(tick * 5, tick * 5 + 5))
        crowded += [(tick / 10, frame) for frame in radio.apply(1, "in", tick / 10, frames)]
    assert crowded == alone


def test_vehicles_directions_and_seeds_have_fates_of_their_own() -> None:
    radio = Impairment(loss=0.5, seed=1)
    fates = {tuple(radio.apply(sysid, way, 0.0, range(64))) for sysid in (1, 2) for way in ("in", "out")}
    fates.add(tuple(Impairment(loss=0.5, seed=2).apply(1, "in", 0.0, range(64))))
    assert len(fates) == 5


def test_fate_is_the_same_in_every_process() -> None:
    code = (
        "from gcs.link.impairment import Impairment\n"
        "radio = Impairment(loss=0.3, jitter_s=0.5, duplicate=0.2, reorder=0.2, seed=7)\n"
        "print([list(radio.apply(s, 'in', t / 10, range(9))) for t in range(9) for s in (1, 2)])"
    )
    runs = {
        subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=env).stdout
        for env in ({"PYTHONHASHSEED": "1"}, {"PYTHONHASHSEED": "2"})
    }
    assert len(runs) == 1


def test_a_burst_makes_one_vehicle_worse_while_it_lasts_and_leaves_the_draws_as_they_were() -> None:
    clear, burst = Impairment(loss=0.2, seed=4), Impairment(loss=0.2, seed=4, bursts=[Burst(1, 5.0, 10.0, loss=0.7)])
    before, after = set(numbers(flown(clear, 200))), set(numbers(flown(burst, 200)))
    inside = {number for number in range(1000) if 5.0 <= (number // 5) / 10 < 10.0}
    assert after < before
    assert before - after <= inside
    kept = len(after & inside) / len(inside)
    assert abs(kept - 0.3) < 5 * math.sqrt(0.3 * 0.7 / len(inside))
    assert flown(clear, 200, sysid=2) == flown(burst, 200, sysid=2)


def test_a_burst_of_delay_adds_to_the_delay_and_lets_later_frames_overtake() -> None:
    flight = flown(Impairment(delay_s=0.1, bursts=[Burst(1, 1.0, 2.0, delay_s=0.5)]), 40, per_tick=1)
    waits = {number: round(at - number / 10, 6) for at, number in flight}
    assert {waits[number] for number in range(10, 20)} == {0.6}
    assert {waits[number] for number in (*range(10), *range(20, 30))} == {0.1}


def test_a_burst_in_one_direction_leaves_the_other_alone() -> None:
    radio = Impairment(bursts=[Burst(1, 0.0, 9.0, loss=1.0, only="out")])
    assert not radio.clear
    assert list(radio.apply(1, "out", 1.0, [1, 2])) == []
    assert list(radio.apply(1, "in", 1.0, [1, 2])) == [1, 2]


def test_a_burst_that_is_added_in_flight_is_as_one_that_was_there_from_the_start() -> None:
    burst = Burst(1, 2.0, 3.0, loss=1.0, delay_s=0.2)
    whole = flown(Impairment(loss=0.3, seed=4, bursts=[burst]), 50)
    radio, parts = Impairment(loss=0.3, seed=4), []
    for tick in range(50):
        if tick == 15:
            radio.add([burst])
        frames = list(range(tick * 5, (tick + 1) * 5))
        parts += [(tick / 10, frame) for frame in radio.apply(1, "in", tick / 10, frames)]
    assert parts == whole
    assert not radio.prompt


def test_a_clear_radio_is_not_clear_any_more_once_it_has_a_burst() -> None:
    radio = Impairment(seed=4)
    assert (radio.clear, radio.prompt) == (True, True)
    radio.add([Burst(None, 1.0, 2.0, loss=1.0)])
    assert (radio.clear, radio.prompt) == (False, True)
    assert list(radio.apply(1, "in", 0.9, [1, 2])) == [1, 2]
    assert list(radio.apply(1, "in", 1.0, [3])) == []
