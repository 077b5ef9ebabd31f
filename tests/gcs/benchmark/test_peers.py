"""Methods of the field: schedules that the verifier accepts, and choices that can be checked by hand."""

from __future__ import annotations

import itertools
import sys
from pathlib import Path

import numpy as np
import pytest

from gcs.benchmark import compare, format
from gcs.benchmark.arrays import Arrays
from gcs.benchmark.format import Instance, plain
from gcs.benchmark.generator import instance
from gcs.benchmark.peers.cp_sat import CpSat
from gcs.benchmark.peers.dispatching import ApparentTardiness, FirstToLand, LeastWays, NearestPair
from gcs.benchmark.peers.flight import DispatchedFlight
from gcs.benchmark.peers.own import PlannedAhead, WinnerTakeAll
from gcs.benchmark.peers.py_vrp import PyVrp
from gcs.benchmark.peers.rolling import jobs_of
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


@pytest.mark.parametrize("solver", [CpSat, PyVrp])
def test_a_plan_serves_both_where_only_one_order_does(solver: type[CpSat] | type[PyVrp]) -> None:
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
