"""Methods of the field: schedules that the verifier accepts, and choices that can be checked by hand."""

from __future__ import annotations

import itertools
import math
import sys
from pathlib import Path
from statistics import NormalDist

import numpy as np
import pytest

from gcs.benchmark import compare, format
from gcs.benchmark.arrays import Arrays
from gcs.benchmark.format import Instance, plain
from gcs.benchmark.generator import instance
from gcs.benchmark.peers.cp_sat import CpSat
from gcs.benchmark.peers.dispatching import ApparentTardiness, FirstToLand, LeastWays, NearestPair
from gcs.benchmark.peers.due_windows import ModifiedTardiness, PiecewiseTardiness, Windows
from gcs.benchmark.peers.flight import DispatchedFlight
from gcs.benchmark.peers.gap_gate import GapGate
from gcs.benchmark.peers.own import PlannedAhead, WinnerTakeAll
from gcs.benchmark.peers.py_vrp import PyVrp
from gcs.benchmark.peers.rendezvous import RISK, UNSERVED, VARIES, Rendezvous, edges
from gcs.benchmark.peers.rolling import Jobs, jobs_of
from gcs.benchmark.verifier import verify
from gcs.cli.main import run_argv


@pytest.mark.parametrize(
    ("method", "kind"), list(zip(compare.METHODS, itertools.cycle(["tankers", "reloads", "bases"]), strict=False))
)
def test_every_method_makes_schedules_that_can_be_carried_out(method: str, kind: str) -> None:
    one = instance(kind, 15)
    verdict = verify(plain(one), plain(compare.METHODS[method](Arrays(one), 0.5)))
    assert verdict["problems"] == []
    assert verdict["delivered_j"] > 0.0


def standing(places: list[tuple[float, float]], tankers: list[tuple[float, float]], left_s: list[float]) -> Instance:
    """Receivers that stand still at (north, east), with so long left, and tankers beside them; all at one height."""
    one = instance("tankers", 15)
    one.rate_w, one.horizon_s = 1000.0, 120.0
    one.receivers, one.tankers = one.receivers[: len(places)], one.tankers[: len(tankers)]
    for receiver, (n, e), s in zip(one.receivers, places, left_s, strict=True):
        receiver.path, receiver.power_w, receiver.capacity_j = [(0.0, n, e, -8.0)], 200.0, 30_000.0
        receiver.lands_at_j = 1_500.0
        receiver.energy_j = receiver.lands_at_j + 200.0 * s
    for tanker, (n, e) in zip(one.tankers, tankers, strict=True):
        tanker.position_m, tanker.speed_m_s = (n, e, -8.0), 4.0
    return one


@pytest.mark.parametrize("method", ["beam_search", "earliest_deadline", "winner_take_all"])
def test_a_receiver_that_draws_what_a_transfer_gives_is_kept_for_as_long_as_it_lasts(method: str) -> None:
    """Its charge stays while energy flows: 90 s of it beside 30 s of its own keep it to the end, however full it is."""
    one = standing([(4.0, 0.0)], [(0.0, 0.0)], [30.0])
    one.rate_w, one.tankers[0].energy_j = 200.0, one.tankers[0].capacity_j
    with np.errstate(all="raise"):
        verdict = verify(plain(one), plain(compare.METHODS[method](Arrays(one), 0.5)))
    assert (verdict["problems"], verdict["lost"]) == ([], [])


def looking(one: Instance) -> DispatchedFlight:
    flight = DispatchedFlight(Arrays(one))
    flight._look()
    return flight


def test_each_rule_looks_at_what_its_name_says() -> None:
    """A receiver 2 m away lasts 60 s, one 20 m away 30 s."""
    flight = looking(standing([(2.0, 0.0), (20.0, 0.0)], [(0.0, 0.0)], [60.0, 30.0]))
    assert NearestPair().assign(flight) == {0: 0}
    assert LeastWays().assign(flight) == {0: 0}
    assert FirstToLand().assign(flight) == {0: 1}


def test_hungarian_has_the_least_sum_of_ways_of_all_pairings() -> None:
    draw = np.random.default_rng(4)
    tankers: list[tuple[float, float]] = [tuple(p) for p in draw.uniform(-30, 30, (2, 2)).tolist()]  # type: ignore[misc]
    for _ in range(5):
        places: list[tuple[float, float]] = [tuple(p) for p in draw.uniform(-30, 30, (4, 2)).tolist()]  # type: ignore[misc]
        flight = looking(standing(places, tankers, [60.0] * 4))
        found = LeastWays().assign(flight)
        ways_s = flight.ways_s()
        sums = [ways_s[0, a] + ways_s[1, b] for a, b in itertools.permutations(range(4), 2)]
        assert sum(ways_s[k, i] for k, i in found.items()) == pytest.approx(min(sums))


def test_the_tardiness_index_is_the_formula() -> None:
    """ATCS by hand: of two with one way and one service's time the one with less slack, of equal slack the nearer."""
    near = looking(standing([(0.0, 9.0), (9.0, 0.0)], [(0.0, 0.0)], [60.0, 30.0]))
    assert ApparentTardiness().assign(near) == {0: 1}
    apart = looking(standing([(0.0, 25.0), (5.0, 0.0)], [(0.0, 0.0)], [40.0, 40.0]))
    assert ApparentTardiness().assign(apart) == {0: 1}


def test_the_urgencies_of_due_windows_are_the_formulas() -> None:
    """By hand, for K1 p = 20 s: 10 s before the due date e^-0.5 = 0.60653, 30 s before the deadline e^-1.5 = 0.22313,
    15 s before it e^-0.75 = 0.47237; both windows last 20 s."""
    windows = Windows(np.array([[10.0, -5.0]]), np.array([[30.0, 15.0]]), 20.0 / PiecewiseTardiness.K1)
    steeper = PiecewiseTardiness.STEEPER
    by_hand = [0.60653 + steeper * 0.22313, 1.0 + steeper * 0.47237]
    assert PiecewiseTardiness().urgency(windows)[0] == pytest.approx(by_hand, rel=1e-4)
    windows = windows._replace(mean_s=20.0 / ModifiedTardiness.K1)
    assert ModifiedTardiness().urgency(windows)[0] == pytest.approx([0.60653 / 20.0, 1.0 / 20.0], rel=1e-4)


def test_after_the_due_date_the_deadline_counts_for_piecewise_costs_alone() -> None:
    """Both are as near, 8.25 s of way and setup, and late: due dates are 7.1 s before deadlines, a twentieth of
    142.5 s. The modified rule takes the shorter service, which is that of the later deadline."""
    flight = looking(standing([(0.0, 9.0), (9.0, 0.0)], [(0.0, 0.0)], [10.0, 14.0]))
    assert PiecewiseTardiness().assign(flight) == {0: 0}
    assert ModifiedTardiness().assign(flight) == {0: 1}


@pytest.mark.parametrize("rule", [ModifiedTardiness, PiecewiseTardiness])
def test_a_tanker_keeps_itself_free_for_an_urgent_one_that_is_ready_soon(rule: type[ModifiedTardiness]) -> None:
    """The second, with a small battery, holds a half 13.5 s before it lands, which is in 1 s; a service of the first
    lasts longer than both."""
    one = standing([(2.0, 0.0), (0.0, 2.0)], [(0.0, 0.0)], [60.0, 14.5])
    small = one.receivers[1]
    small.capacity_j, small.lands_at_j, small.energy_j = 6_000.0, 300.0, 300.0 + 200.0 * 14.5
    flight = looking(one)
    assert flight.waiting == [0]
    assert rule().assign(flight) == {0: 1}
    assert DispatchedFlight(flight.arrays).flown(rule()).services[0].receiver == small.id
    others = DispatchedFlight(flight.arrays).flown(FirstToLand())
    assert small.id not in {service.receiver for service in others.services}


@pytest.mark.parametrize(
    ("left_s", "tankers", "sent"),
    [
        ([60.0], 1, False),  # its own energy lasts
        ([6.7], 1, True),  # 0.5 s of way and 6 s of setup
        ([30.0, 66.0], 1, False),  # a service of 6 s and a flow of some 18 s fits between them
        ([30.0, 31.0], 1, True),
        ([40.0, 41.0, 42.0], 1, True),  # the third waits for two services
        ([40.0, 41.0, 42.0], 2, False),  # and here for one
    ],
)
def test_the_gate_opens_when_remaining_times_come_too_near(left_s: list[float], tankers: int, sent: bool) -> None:
    places = [(2.0, 0.0), (0.0, 2.0), (-2.0, 0.0)][: len(left_s)]
    one = standing(places, [(0.0, 0.0)] * tankers, left_s)
    found = GapGate().assign(looking(one))
    assert list(found.values()) == ([0] if sent else [])


def some_jobs(draw: np.random.Generator) -> Jobs:
    """4 receivers, 2 tankers, the one free now and the other later."""
    from_s = draw.uniform(0.0, 10.0, 4)
    return Jobs(
        [0, 1, 2, 3], [0, 1], from_s, from_s + draw.uniform(5.0, 40.0, 4), draw.uniform(10.0, 20.0, 4),
        np.array([0.0, 6.0]), draw.uniform(1.0, 9.0, (2, 4)), draw.uniform(1.0, 9.0, (2, 4, 4)) * (1.0 - np.eye(4)),
    )  # fmt: skip


def test_the_risk_of_a_rendezvous_is_that_of_a_normal_consumption() -> None:
    jobs = some_jobs(np.random.default_rng(1))
    cost_s, risk = edges(jobs)
    assert cost_s[:, 0] == pytest.approx(jobs.first_s[0])
    for j in range(4):
        meets_s = max(jobs.first_s[0, j], jobs.from_s[j])
        in_time = NormalDist(0.0, VARIES * jobs.until_s[j]).cdf(jobs.until_s[j] - meets_s)
        assert risk[j, 0] == pytest.approx(-math.log(in_time), abs=1e-9)
        assert risk[j, -1] == UNSERVED


def test_rendezvous_are_the_cheapest_that_keep_to_the_risk() -> None:
    """All choices one by one: the least unserved, then within the risk or as near to it as can be, then the cost."""
    kept = 0
    for seed in range(12):
        jobs = some_jobs(np.random.default_rng(seed))
        cost_s, risk = edges(jobs)
        turns, choices = (cost_s.shape[1] - 1) // 2, []
        for columns in itertools.product(range(cost_s.shape[1]), repeat=4):
            used = [c for c in columns if c < 2 * turns]
            if len(set(used)) == len(used) and all(c % turns == 0 or c - 1 in used for c in used):
                risks = float(sum(risk[j, c] for j, c in enumerate(columns)))
                if math.isfinite(risks):
                    choices.append((risks, float(sum(cost_s[j, c] for j, c in enumerate(columns))), columns))
        least = min(choices)[0]
        most = max(least, UNSERVED * (least // UNSERVED) - math.log(1.0 - RISK))
        best = min(cost for risks, cost, _ in choices if risks <= most + 1e-9)
        firsts = [
            {c // turns: j for j, c in enumerate(columns) if c < 2 * turns and c % turns == 0}
            for risks, cost, columns in choices if risks <= most + 1e-9 and cost < best + 1e-9
        ]  # fmt: skip
        assert Rendezvous(Arrays(instance("tankers", 0)), 60.0).plan(jobs, 60.0) in firsts
        kept += least <= -math.log(1.0 - RISK)
    assert 0 < kept < 12


@pytest.mark.parametrize("solver", [CpSat, PyVrp, Rendezvous])
def test_a_plan_serves_both_where_only_one_order_does(solver: type[CpSat] | type[PyVrp] | type[Rendezvous]) -> None:
    """The far one lands at 20 s, the near one at 60 s; a service takes 6 s and what flows: only far, then near."""
    one = standing([(2.0, 0.0), (20.0, 0.0)], [(0.0, 0.0)], [60.0, 20.0])
    flight = looking(one)
    plan = solver(flight.arrays, 5.0).plan(jobs_of(flight), 1.0)
    jobs = jobs_of(flight)
    assert {jobs.tankers[k]: jobs.receivers[j] for k, j in plan.items()} == {0: 1}


def test_the_own_policies_serve_what_lands_first_when_both_can_be_kept() -> None:
    one = standing([(2.0, 0.0), (6.0, 0.0)], [(0.0, 0.0)], [70.0, 25.0])
    arrays = Arrays(one)
    for rule in (PlannedAhead(arrays), WinnerTakeAll(arrays)):
        schedule = DispatchedFlight(arrays).flown(rule)
        assert verify(plain(one), plain(schedule))["lost"] == []
        assert schedule.services[0].receiver == one.receivers[1].id


def test_the_command_prints_one_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in (0, 3):
        (tmp_path / f"{number}.json").write_bytes(format.raw(instance("tankers", number)))
    asked = ["benchmark", "compare", "--seconds", "1", "--instances", str(tmp_path)]
    assert run_argv([*asked, "--methods", "atcs", "--methods", "earliest_deadline"]) == 0
    head, *rows = capsys.readouterr().out.splitlines()
    assert " ".join(head.split()) == "method loses some 95 % lost 95 % gap 95 % kJ way m CPU s"
    assert [row.split()[0] for row in rows] == ["atcs", "earliest_deadline"]
    results = ["--table", str(tmp_path / "results.jsonl")]
    assert run_argv([*asked, *results, "--methods", "atcs"]) == 0
    head, row = capsys.readouterr().out.splitlines()
    lines = (tmp_path / "results.jsonl").read_bytes()
    with monkeypatch.context() as without:
        without.setitem(compare.METHODS, "atcs", None)  # type: ignore[arg-type]
        assert run_argv([*asked, *results, "--methods", "atcs"]) == 0
    assert capsys.readouterr().out.splitlines() == [head, row]
    assert (tmp_path / "results.jsonl").read_bytes() == lines
    assert len(lines.splitlines()) == 2
    assert run_argv([*asked, "--methods", "magic"]) == 2
    assert "'magic' is no method; there are" in capsys.readouterr().err


def test_what_is_missing_is_said_in_one_sentence(monkeypatch: pytest.MonkeyPatch) -> None:
    from gcs.benchmark import bounds  # noqa: PLC0415 - beside the module that is hidden
    from gcs.extras import MissingExtra  # noqa: PLC0415

    monkeypatch.setitem(sys.modules, "ortools", None)
    with pytest.raises(MissingExtra, match=r"a proven bound needs OR-Tools, .*\[benchmark\]"):
        bounds.least_lost(Arrays(instance("tankers", 0)), 1, 1.0)
