"""Bounds and schedules of instances: against the verifier, against each other, and against an enumeration."""

from __future__ import annotations

import itertools
import json
import math
import random
from collections.abc import Callable, Sequence
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

from gcs.benchmark import beam, bounds, compare, format, gaps
from gcs.benchmark.arrays import Arrays
from gcs.benchmark.format import Instance, Schedule, ScheduledService, plain
from gcs.benchmark.generator import instance, instances
from gcs.benchmark.prices import STEP_S, CheapestPlans
from gcs.benchmark.solve import lost_of, solve
from gcs.benchmark.verifier import place, verify
from gcs.cli.main import run_argv

TRIED = [("tankers", 27), ("reloads", 18), ("bases", 54)]


@pytest.mark.parametrize(("kind", "number"), TRIED)
def test_every_schedule_can_be_carried_out_and_loses_no_fewer_than_the_bound(kind: str, number: int) -> None:
    one = instance(kind, number)
    arrays = Arrays(one)
    at_least = bounds.least_lost(arrays, arrays.n, 3.0)
    for weights in beam.PORTFOLIO:
        verdict = verify(plain(one), plain(beam.search(arrays, weights, 20)))
        assert verdict["problems"] == []
        assert len(verdict["lost"]) >= at_least


def priced(one: Instance, schedule: Schedule, price: Callable[[float], float]) -> dict[int, float]:
    """What each receiver pays for tankers' time: of the ways straight to it, and of its services. `price` is that of
    all time until then."""
    pays = dict.fromkeys((receiver.id for receiver in one.receivers), 0.0)
    paths = {receiver.id: receiver.path for receiver in one.receivers}
    for tanker in one.tankers:
        at: Sequence[float] = tanker.position_m
        for s in sorted((s for s in schedule.services if s.tanker == tanker.id), key=lambda s: s.start_s):
            assert s.receiver is not None
            way_s = math.dist(at, place(paths[s.receiver], s.start_s)) / tanker.speed_m_s
            pays[s.receiver] += price(s.end_s) - price(s.start_s - way_s)
            at = place(paths[s.receiver], s.end_s)
    return pays


@pytest.mark.parametrize("number", [16, 27, 54])
def test_no_receiver_that_a_schedule_keeps_pays_less_than_its_cheapest_plan(number: int) -> None:
    """At any prices: here drawn ones, by schedules that the verifier accepts."""
    one = instance("tankers", number)
    arrays = Arrays(one)
    plans = CheapestPlans(arrays, *bounds._least_ways_s(arrays))
    times = np.arange(plans.steps + 1) * STEP_S
    draw = np.random.default_rng(number)
    compared = 0
    for weights in beam.PORTFOLIO[:3]:
        schedule = beam.search(arrays, weights, 20)
        lost = {entry["receiver"] for entry in verify(plain(one), plain(schedule))["lost"]}
        for _ in range(4):
            price = draw.exponential(size=plans.steps) * (draw.uniform(size=plans.steps) < draw.uniform())
            paid = np.concatenate([[0.0], np.cumsum(price * STEP_S)])
            cheapest, _ = plans.cheapest(price)
            pays = priced(one, schedule, lambda t, paid=paid: float(np.interp(t, times, paid)))  # type: ignore[misc]
            for i, cost in zip(plans.receivers, cheapest, strict=True):
                if one.receivers[i].id not in lost:
                    assert cost <= pays[one.receivers[i].id] + 1e-6
                    compared += cost > 0.0
    assert compared > 50


def small(seed: int) -> Instance:
    """Two receivers that stand still and one tanker, drawn so that some are lost."""
    draw = random.Random(seed)
    one = instance("tankers", 0)
    one.seed, one.receivers = seed, one.receivers[:2]
    one.rate_w, one.horizon_s = draw.choice((400.0, 800.0, 3000.0)), float(draw.randrange(60, 200, 10))
    for receiver in one.receivers:
        receiver.path = [(0.0, draw.uniform(-40.0, 40.0), draw.uniform(-40.0, 40.0), -8.0)]
        receiver.capacity_j = draw.uniform(4_000.0, 16_000.0)
        receiver.lands_at_j = 0.05 * receiver.capacity_j
        receiver.energy_j = receiver.lands_at_j + draw.uniform(5.0, 60.0) * receiver.power_w
        receiver.energy_j = min(receiver.energy_j, receiver.capacity_j)
    tanker = one.tankers[0]
    spare_j = draw.uniform(2_000.0, 60_000.0)
    tanker.energy_j = tanker.capacity_j = tanker.reserve_j + tanker.power_w * one.horizon_s + spare_j
    return one


def fewest_lost(one: Instance, most_services: int) -> int:
    """The least lost by any order of services, each begun as soon as it can be or seconds later, with a share of the
    greatest energy: an enumeration in closed form for receivers that stand still, which shares no code with `gcs`."""
    tanker, fewest = one.tankers[0], len(one.receivers)

    def gone(lands_s: list[float]) -> int:
        return sum(s < one.horizon_s - 1e-9 for s in lands_s)

    def go(at: tuple[float, ...], now_s: float, spare_j: float, lands_s: list[float], left: int) -> None:
        nonlocal fewest
        fewest = min(fewest, gone(lands_s))
        if left == 0 or fewest == 0:
            return
        for (i, r), wait_s, share in itertools.product(enumerate(one.receivers), (0.0, 12.0), (1.0, 0.5)):
            place = r.path[0][1:]
            flows_s = now_s + math.dist(at, place) / tanker.speed_m_s + wait_s + one.setup_s
            if lands_s[i] < flows_s or flows_s >= one.horizon_s or lands_s[i] >= one.horizon_s:
                continue
            held_j = r.power_w * (lands_s[i] - flows_s)
            takes_s = min(
                (r.capacity_j - r.lands_at_j - held_j) / (one.rate_w - r.power_w), one.horizon_s - flows_s,
                spare_j / one.rate_w,
            ) * share  # fmt: skip
            new = list(lands_s)
            new[i] += takes_s * one.rate_w / r.power_w
            go(place, flows_s + takes_s, spare_j - takes_s * one.rate_w, new, left - 1)

    starts = [(r.energy_j - r.lands_at_j) / r.power_w for r in one.receivers]
    spare_j = tanker.energy_j - tanker.reserve_j - tanker.power_w * one.horizon_s
    go(tanker.position_m, 0.0, spare_j, starts, most_services)
    return fewest


def test_no_order_of_services_loses_fewer_than_the_bound_on_tiny_instances() -> None:
    """The bound stays at or below what an enumeration finds, and is the same for most."""
    found = [(fewest_lost(one, 4), bounds.least_lost(Arrays(one), 2, 0.5)) for one in map(small, range(25))]
    assert all(at_least <= fewest for fewest, at_least in found), found
    assert {fewest for fewest, _ in found} >= {0, 1}
    lossy = [pair for pair in found if pair[0] > 0]
    assert sum(at_least == fewest for fewest, at_least in lossy) >= len(lossy) // 2, found


def test_the_search_finds_what_the_enumeration_finds() -> None:
    for one in map(small, range(5)):
        gap, schedule = solve(one, 0.5)
        assert gap.upper == lost_of(one, schedule)
        assert gap.upper is not None
        assert gap.lower <= gap.upper <= fewest_lost(one, 4)


def test_the_shipped_table_has_each_instance_once_and_its_bound() -> None:
    lines = (resources.files("gcs") / "benchmark" / "gaps.jsonl").read_text().splitlines()
    shipped = gaps.shipped()
    assert len(lines) == len(shipped)
    assert shipped.keys() <= {one.name for one in instances()}
    assert all(gap.upper is not None and 0 <= gap.lower <= gap.upper for gap in shipped.values())
    assert bounds.least_lost(Arrays(instance("tankers", 27)), 1, 60.0) == 1 <= (shipped["tankers-027"].upper or 0)


def test_the_command_solves(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = {}
    for kind, number in (("tankers", 0), ("tankers", 5)):
        files[number] = tmp_path / f"{kind}-{number}.json"
        files[number].write_bytes(format.raw(instance(kind, number)))
    mine, table = tmp_path / "mine.json", tmp_path / "gaps.jsonl"
    assert run_argv(["benchmark", "solve", str(files[0]), "--out", str(mine), "--table", str(table)]) == 0
    assert "tankers-000: lost 0 of 4, proven" in capsys.readouterr().out
    assert lost_of(instance("tankers", 0), format.read(mine, Schedule)) == 0
    assert run_argv(["benchmark", "solve", *map(str, files.values()), "--seconds", "0.5", "--table", str(table)]) == 1
    lines = [json.loads(line) for line in table.read_text().splitlines()]
    assert [line["instance"] for line in lines] == ["tankers-000", "tankers-005"]
    assert "tankers-000" not in capsys.readouterr().out
    assert run_argv(["benchmark", "solve", *map(str, files.values()), "--out", str(mine)]) == 2
    table.write_text("{}\n")
    assert run_argv(["benchmark", "solve", str(files[0]), "--table", str(table)]) == 2
    assert "no table of gaps" in capsys.readouterr().err


def beside_a_base() -> Instance:
    """One receiver that stands at a base and lands at 10 s, and a tanker that is never in time."""
    one = instance("bases", 0)
    one.horizon_s, one.setup_s, one.rate_w = 60.0, 2.0, 1000.0
    one.receivers, one.tankers, one.bases = one.receivers[:1], one.tankers[:1], one.bases[:1]
    (receiver,), (tanker,), (base,) = one.receivers, one.tankers, one.bases
    receiver.path, base.position_m, tanker.position_m = [(0.0, 0.0, 0.0, -1.0)], (0.0, 0.0, -1.0), (900.0, 0.0, -1.0)
    receiver.capacity_j, receiver.lands_at_j, receiver.energy_j, receiver.power_w = 14_000.0, 0.0, 2_000.0, 200.0
    base.stock_j, base.rate_w = 20_000.0, 1_000.0
    tanker.speed_m_s, tanker.energy_j = 1.0, tanker.reserve_j + 60.0 * tanker.power_w + 1_000.0
    tanker.capacity_j = tanker.energy_j
    return one


def test_the_bound_counts_what_a_base_gives_before_a_tanker_comes() -> None:
    """It holds 12 kJ at 12 s and draws 200 W: it flies until 72 s."""
    one = beside_a_base()
    service = ScheduledService(
        0.0, 12.0, 10_000.0, receiver=1, base=one.bases[0].name, leave_s=0.0, back_s=12.0
    )  # fmt: skip
    assert lost_of(one, Schedule(format.SCHEDULE, one.name, [service])) == 0
    assert bounds.least_lost(Arrays(one), 1, 5.0) == 0


def test_instances_without_tankers_are_solved() -> None:
    one = beside_a_base()
    one.tankers = []
    gap, schedule = solve(one, 5.0)
    assert (gap.lower, gap.upper, lost_of(one, schedule)) == (0, 0, 0)
    one.bases[0].stock_j = 3_000.0  # and 2 kJ of its own, for 200 W: it has to stand at the base for 35 s
    assert bounds.least_lost(Arrays(one), 1, 5.0) <= lost_of(one, solve(one, 1.0)[1])
    one.bases = []
    gap, schedule = solve(one, 5.0)
    assert (gap.lower, gap.upper, schedule.services) == (1, 1, [])
    one.receivers[0].energy_j = 12_500.0
    assert solve(one, 5.0)[0].upper == 0


def dry() -> Instance:
    """A tanker that is at its reserve 100 s before the horizon, and no base to load at: no schedule is feasible."""
    one = instance("tankers", 0)
    one.receivers, one.tankers = one.receivers[:2], one.tankers[:1]
    one.tankers[0].energy_j = one.tankers[0].reserve_j + one.tankers[0].power_w * (one.horizon_s - 100.0)
    return one


def test_where_no_schedule_can_be_carried_out_that_is_the_result(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path, mine, table = tmp_path / "dry.json", tmp_path / "mine.json", tmp_path / "gaps.jsonl"
    path.write_bytes(format.raw(dry()))
    arguments = ["benchmark", "solve", str(path), "--seconds", "0.5", "--out", str(mine), "--table", str(table)]
    assert run_argv(arguments) == 1
    assert "tankers-000: found no schedule that can be carried out, any would lose at least " in capsys.readouterr().out
    assert not mine.exists()
    (row,) = gaps.read(table, gaps.Gap)
    assert (row.upper, row.proven) == (None, False)
    folder = tmp_path / "instances"
    folder.mkdir()
    path.rename(folder / path.name)
    compared = ["--methods", "beam_search", "--methods", "hungarian", "--seconds", "0.5"]
    assert run_argv(["benchmark", "compare", "--instances", str(folder), *compared]) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        f"{method} made no schedule that can be carried out of tankers-000" for method in ("beam_search", "hungarian")
    ]


def test_an_instance_without_receivers_loses_none_of_none(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    one = instance("bases", 0)
    one.name, one.receivers = "unlike", []
    (path := tmp_path / "unlike.json").write_bytes(format.raw(one))
    assert run_argv(["benchmark", "solve", str(path)]) == 0
    assert "unlike: lost 0 of 0, proven" in capsys.readouterr().out
    assert run_argv(["benchmark", "compare", "--instances", str(tmp_path), "--seconds", "0.2"]) == 0
    head, *rows = capsys.readouterr().out.splitlines()
    assert head.split()[:7] == ["method", "loses", "some", "95", "%", "lost", "95"]
    assert len(rows) == len(compare.METHODS)
    for row in rows:  # loses some, of which an interval, lost, gap: nothing is proven of it
        assert row.split()[1:11] == ["0", "%", "0", "to", "79", "%", "0.00", "-", "-", "-"]


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("kind", ["tankers", "bases"])
def test_receivers_that_draw_nothing_are_lost_if_they_hold_too_little_at_the_start(kind: str) -> None:
    one = instance(kind, 0)
    for receiver, share in zip(one.receivers, (2.0, 2.0, 2.0, 0.5), strict=True):
        receiver.power_w, receiver.energy_j = 0.0, share * receiver.lands_at_j
    gap, schedule = solve(one, 0.5)
    assert (gap.upper, schedule.services) == (1, [])
    assert gap.lower <= 1
    assert [compare.run(method, one, 0.2).lost for method in ("optimal", "hungarian", "greedy_nearest")] == [1, 1, 1]


def test_an_instance_that_lasts_too_long_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    one = instance("tankers", 0)
    one.horizon_s = 1e9
    (path := tmp_path / "long.json").write_bytes(format.raw(one))
    for command in (["solve", str(path)], ["compare", "--instances", str(tmp_path)]):
        assert run_argv(["benchmark", *command]) == 2
        assert capsys.readouterr().err == (
            "gcs: tankers-000 lasts 1e+09 s, and a search takes 250000 s of 4 receivers at most\n"
        )
