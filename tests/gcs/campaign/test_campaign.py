"""Campaign files, what they draw, and what becomes of their tables."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import duckdb
import numpy as np
import pytest
from click.testing import CliRunner
from distributed.client import FutureCancelledError
from distributed.comm.core import CommClosedError

from gcs.campaign import draws, file, report, statistics, table
from gcs.campaign.cluster import EngineError, check_scheduler, result
from gcs.campaign.model import Draw
from gcs.campaign.plan import Plan, PlannedRow, make, read
from gcs.campaign.statistics import Interval
from gcs.cli.campaign.command import campaign
from gcs.extras import MissingExtra
from gcs.scenario.model import ScenarioError
from skytender import geometry

CONTENT: dict[str, Any] = {
    "schema": 1,
    "name": "trial",
    "scenario": "demo",
    "sessions": 50,
    "seed": 7,
    "vary": {"competition.policy": ["winner_take_all", "optimal"], "planner.cruise_m_s": [1.0, 2.0]},
    "draw": {
        "vehicles.pursuers.*.battery.initial_percent": {"uniform": [45, 100]},
        "radio.loss": {"uniform": [0.0, 0.3]},
    },
}


def plan(**changes: Any) -> Plan:
    return make(file.from_data({**CONTENT, **changes}), [])


def told(**changes: Any) -> str:
    with pytest.raises(ScenarioError) as refused:
        replace(plan(**changes), trusted=True).checked()
    return str(refused.value)


@pytest.mark.parametrize(
    ("changes", "sentence"),
    [
        ({"draw": {"planner.crise_m_s": {"uniform": [1, 2]}}}, "did you mean 'cruise_m_s'?"),
        ({"draw": {"radio.loss": {"uniform": [5, 1]}}}, "the first below the second, not [5, 1]"),
        ({"draw": {"radio.loss": {}}}, "a draw needs exactly one of uniform"),
        ({"draw": {"radio.loss": {"choice": []}}}, "should have at least 1 item"),
        ({"draw": {"radio.loss": {"log_uniform": [0, 1]}}}, "must be above 0"),
        ({"measure": ["min_seperation_m"]}, "no measure 'min_seperation_m'; did you mean 'min_separation_m'?"),
        ({"expect": {"losst": {"at_most": 0}}}, "there is no measure 'losst'; did you mean 'lost'?"),
        (
            {"expect": {"closest.separaton.distance_m": {"at_least": 500}}},
            "no measure 'closest.separaton.distance_m'; did you mean 'closest.separation.distance_m'?",
        ),
        (
            {"measure": ["vehicles.1.energy.remaning_j"]},
            "no measure 'vehicles.1.energy.remaning_j'; did you mean 'vehicles.1.energy.remaining_j'?",
        ),
        ({"measure": ["goal.seperation.met"]}, "did you mean 'goal.separation.met'?"),
        ({"measure": ["refuelling.first.energy_j"]}, "there is no measure 'refuelling.first.energy_j'"),
        ({"measure": ["vehicles.0.final_mode"]}, "vehicles.0.final_mode is no number"),
        ({"measure": ["versions.numpy"]}, "versions.numpy is no number"),
        ({"measure": ["goal.separation.sysids"]}, "goal.separation.sysids is no number"),
        ({"expect": {"outcome": {"at_least": 1}}}, "outcome is no number"),
        ({"search": {"minimise": "outcome"}}, "outcome is no number"),
        ({"sessions": 0}, "sessions must be greater than or equal to 1"),
        ({"scenario": "demmo"}, "did you mean 'demo'?"),
        ({"scenario": None}, "exactly one of scenario, generate"),
        ({"vary": {"radio.loss": [0.1]}}, "radio.loss is set twice"),
        ({"vary": {"seed": [1, 2]}}, "each session has a seed of its own"),
        ({"keep": "some"}, "keep must be 'all', 'failed' or 'none'"),
        ({"sesions": 3}, "unknown key 'sesions' at the top level; did you mean 'sessions'?"),
        ({"generate": "nowhere:family", "scenario": None}, "there is no module 'nowhere'"),
    ],
)
def test_mistakes_are_told_before_anything_flies(changes: dict[str, Any], sentence: str) -> None:
    text = told(**changes)
    assert sentence.lower().replace("should", "must") in text.lower().replace("should", "must")


MADE = """
import pathlib
import numpy as np

def family(seed, value):
    base = {"lat_deg": np.float32(47.5), "lon_deg": np.float64(8.5), "alt_m": np.int64(488)}
    loop = []
    loop.append(loop)
    if value == "exit":
        raise SystemExit(3)
    odd = {"set": {1.0}, "path": pathlib.Path("a"), "complex": np.array([1j]), "loop": loop, "wide": np.longdouble(1)}
    return {
        "schema": np.int64(1), np.str_("name"): np.str_("made"), "axes": "ned", "origin": base,
        "goal": {"duration_s": odd.get(value, np.float64(10.0))},
        "vehicles": {"pursuers": [{"sysid": np.uint8(1), "start_m": np.array([2.5, 0.0, 0.0]), "airborne": np.False_,
                                   "waypoints_m": (np.zeros(3) - [0, 0, 3],),
                                   "battery": {"capacity_j": np.int32(9000)}}]},
    }
"""


def generated(folder: Path, name: str, value: Any) -> Plan:
    """The plan of a campaign whose scenario a function makes; modules are imported once, so each has a name."""
    (folder / f"{name}.py").write_text(MADE)
    content = {"schema": 1, "name": "made", "generate": f"{name}:family", "arguments": {"value": value}, "sessions": 1}
    return replace(make(file.from_data(content), [folder]), trusted=True)


def test_numpys_numbers_and_arrays_are_plain_data(tmp_path: Path) -> None:
    flown = generated(tmp_path, "made_numbers", np.str_("none"))
    scenario, _ = flown.resolved(flown.row(0))
    assert (scenario.origin.lat_deg, scenario.origin.alt_m, scenario.goal.duration_s) == (47.5, 488.0, 10.0)
    (one,) = scenario.vehicles.pursuers
    assert (one.sysid, one.start_m, one.airborne) == (1, (2.5, 0.0, 0.0), False)
    assert one.waypoints_m == ((0.0, 0.0, -3.0),)
    given = plan(sessions=np.int64(3), vary={"planner.cruise_m_s": np.array([1.0, 2.0])})
    assert given == plan(sessions=3, vary={"planner.cruise_m_s": [1.0, 2.0]})
    assert given.trusted_by


@pytest.mark.parametrize(
    ("value", "sentence"),
    [
        ("set", "goal.duration_s is a Python set; it has to be a number, a text, a list or a block of keys"),
        ("path", "goal.duration_s is a Python PosixPath;"),
        ("complex", "goal.duration_s[0] is a Python complex;"),
        ("wide", "goal.duration_s is a Python longdouble;"),
        ("loop", "a list or a block of keys holds itself"),
        ("exit", "made_exit:family failed: SystemExit: 3"),
    ],
)
def test_what_a_generator_cannot_return_is_named_before_anything_flies(
    tmp_path: Path, value: str, sentence: str
) -> None:
    with pytest.raises(ScenarioError) as refused:
        generated(tmp_path, f"made_{value}", value).checked()
    assert sentence in str(refused.value)


def test_what_is_no_plain_data_of_a_campaign_is_named() -> None:
    assert "set.goal is a Python set; it has to be" in told(set={"goal": {1}})


@pytest.mark.parametrize(
    ("expect", "why"),
    [("vehicles.0.energy.drawm_j<=5", "did you mean 'vehicles.0.energy.drawn_j'?"), ("outcome>=1", "is no number")],
)
def test_a_limit_of_what_is_no_measure_is_refused(expect: str, why: str) -> None:
    done = CliRunner().invoke(campaign, ["shrink", "demo", "--expect", expect])
    assert (done.exit_code, why in done.output) == (2, True)


@pytest.mark.parametrize("limit", ["nan", "inf", "-inf", "x", ""])
def test_a_limit_that_is_no_number_is_refused(tmp_path: Path, limit: str) -> None:
    out = tmp_path / "small.yaml"
    done = CliRunner().invoke(campaign, ["shrink", "demo", "--expect", f"min_clearance_m>={limit}", "--out", str(out)])
    assert (done.exit_code, out.exists()) == (2, False)
    assert "write MEASURE>=N or MEASURE<=N" in done.output


def test_key_paths_of_numbers_and_the_summarys_own_words_are_measures() -> None:
    names = (
        *("digest", "completed", "link.lost", "goal.0.met", "goal.separation.value", "goal.separation.sysids.0"),
        *("closest.traffic.t_s", "vehicles.12.energy.drawn_j", "vehicles.0.mission.holds", "refuelling.0.bids.3"),
    )
    assert plan(measure=names).campaign.measure == names


def test_a_campaign_is_written_and_read_back_equal(tmp_path: Path) -> None:
    first = plan()
    first.write(tmp_path)
    second = read(tmp_path)
    assert second == first
    assert [second.resolved(second.row(i)) for i in (0, 5)] == [first.resolved(first.row(i)) for i in (0, 5)]


def test_combinations_of_a_session_share_draws_and_seed_and_sessions_do_not() -> None:
    flown = plan()
    rows = [flown.resolved(flown.row(number)) for number in range(8)]
    for scenarios in (rows[:4], rows[4:]):
        assert len({scenario.seed for scenario, _ in scenarios}) == 1
        assert len({scenario.radio.loss for scenario, _ in scenarios}) == 1
        assert len({(s.competition.policy, s.planner.cruise_m_s) for s, _ in scenarios}) == 4
    assert rows[0][0].seed != rows[4][0].seed
    assert rows[0][0].radio.loss != rows[4][0].radio.loss
    percents = [p.battery.initial_percent for p in rows[0][0].vehicles.pursuers]
    assert len(set(percents)) == 5  # one value for each vehicle
    assert rows[0][1]["vehicles.pursuers.*.battery.initial_percent"] == percents


def test_a_value_does_not_depend_on_other_draws_or_on_how_many_sessions_there_are() -> None:
    alone = plan(draw={"radio.loss": {"uniform": [0.0, 0.3]}}, sessions=3)
    assert [alone.row(n).values["radio.loss"] for n in range(12)] == [
        plan().row(n).values["radio.loss"] for n in range(12)
    ]


def test_seeds_are_those_of_numpys_spawned_sequences() -> None:
    spawned = np.random.SeedSequence(7).spawn(5)
    assert [draws.seed_of(7, i) for i in range(5)] == [int(one.generate_state(1)[0]) for one in spawned]


@pytest.mark.parametrize(
    ("draw", "mean", "deviation", "low", "high"),
    [
        ({"uniform": [2, 6]}, 4.0, 4.0 / math.sqrt(12.0), 2, 6),
        ({"normal": [3, 0.5]}, 3.0, 0.5, -math.inf, math.inf),
        ({"log_uniform": [1, math.e]}, math.e - 1.0, math.sqrt((math.e**2 - 1) / 2 - (math.e - 1) ** 2), 1, math.e),
        ({"integers": [1, 6]}, 3.5, math.sqrt(35.0 / 12.0), 1, 6),
    ],
)
def test_draws_have_the_moments_of_their_distribution(
    draw: dict[str, Any], mean: float, deviation: float, low: float, high: float
) -> None:
    rng = np.random.default_rng(3)
    values = np.array([draws.value(Draw.model_validate(draw), rng) for _ in range(20_000)])
    assert values.mean() == pytest.approx(mean, abs=4 * deviation / math.sqrt(20_000))
    assert values.std() == pytest.approx(deviation, rel=0.03)
    assert low <= values.min() <= values.max() <= high


def test_random_obstacles_lie_in_their_room_and_keep_clear() -> None:
    wanted = {"count": [3, 12], "within_m": [[-12, -12, 0], [12, 12, 6]], "apart_m": 1.2}
    flown = plan(draw={"obstacles": {"random": wanted}}, set={"obstacles": []}, vary={})
    counts = set()
    for number in range(20):
        scenario, _ = flown.resolved(flown.row(number))
        counts.add(len(scenario.obstacles))
        shapes = geometry.of_scenario(scenario.obstacles)
        starts = np.array([v.start_m for v in scenario.vehicles.launched])
        assert geometry.clearance(shapes, starts).min() >= 1.2
        for one in scenario.obstacles:
            centre = (np.array(one.low_m) + np.array(one.high_m)) / 2
            assert (np.abs(centre[:2]) <= 12.0).all()
            assert centre[2] <= 0.0  # above the ground: the demo's axes are the paper's, z up
    assert len(counts) > 3
    assert counts <= set(range(3, 13))


@pytest.mark.parametrize(
    ("count", "of", "low", "high"),
    [  # R 4.3, prop.test(count, of, correct = FALSE)$conf.int
        (10, 10, 0.7224672, 1.0),
        (0, 10, 0.0, 0.2775328),
        (5, 10, 0.2365931, 0.7634069),
        (81, 263, 0.2552579, 0.3662241),
    ],
)
def test_wilson_intervals_are_those_of_the_literature(count: int, of: int, low: float, high: float) -> None:
    interval = statistics.wilson(count, of)
    assert interval.low == pytest.approx(low, abs=2e-4)
    assert interval.high == pytest.approx(high, abs=2e-4)


def test_paired_differences_are_found_where_unpaired_ones_drown(tmp_path: Path) -> None:
    flown = plan(vary={"competition.policy": ["winner_take_all", "optimal"]}, draw={}, measure=["min_separation_m"])
    rng = np.random.default_rng(5)
    rows = []
    for session in range(40):
        common = float(rng.normal(10.0, 5.0))
        for combination in (0, 1):
            value = common + 0.5 * combination + float(rng.normal(0.0, 0.2))
            rows.append({"row": 2 * session + combination, "session": session, "combination": combination, "seed": 1}
                        | {"min_separation_m": value, "ok": True, "kept": False})  # fmt: skip
    writer = table.Writer(tmp_path, flown.campaign)
    writer.write(rows[60:])
    writer.write(rows[:60])
    read_back = table.read(tmp_path, flown.campaign)
    assert read_back["row"].to_pylist() == list(range(80))
    found = statistics.paired(read_back, "min_separation_m", 0, 1)
    assert found.pairs == 40
    assert found.difference.low < 0.5 < found.difference.high
    assert found.difference.low > 0.3
    counted = duckdb.sql(f"select count(*) from '{tmp_path}/rows/*.parquet'").fetchall()
    assert counted == [(80,)]


def test_combinations_are_named_by_what_differs() -> None:
    flown = plan(
        vary={"competition": [{"where": "vehicles", "need_from": 0.4}, {"policy": "optimal", "need_from": 0.4}]}
    )
    assert [statistics.name_of(flown, n) for n in range(2)] == ["where vehicles", "policy optimal"]
    assert statistics.name_of(plan(), 3) == "policy optimal, cruise_m_s 2.0"


def test_the_shipped_campaigns_can_be_flown() -> None:
    assert {"safety", "speed-against-safety", "loss", "policies"} < set(file.shipped_names())
    assert {"silence", "silent-traffic", "accuracy", "turning", "dense"} < set(file.shipped_names())
    assert len(file.shipped_names()) == 11
    for name in file.shipped_names():
        path = file.find(name)
        make(file.load(path), [path.parent]).checked()


@pytest.mark.parametrize(
    ("module", "options"), [("distributed.security", ["--scheduler", "tls://a:1"]), ("pyarrow", []), ("matplotlib", [])]
)
def test_a_campaign_without_its_extra_is_refused_before_it_leaves_a_folder(
    module: str, options: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, module, None)
    out = tmp_path / "campaign"
    said = CliRunner().invoke(campaign, ["run", "policies", "--out", str(out), *options], standalone_mode=False)
    assert isinstance(said.exception, MissingExtra)
    assert "pip install '.[campaign]'" in str(said.exception)
    assert not out.exists()


@pytest.mark.parametrize(
    ("measure", "low", "high", "better"),
    [
        ("lost_somebody", -0.07, -0.01, "b"),
        ("lost_somebody", 0.01, 0.07, "a"),
        ("lost_somebody", -0.01, 0.07, "-"),
        ("lowest_battery", -4.1, -0.8, "a"),
        ("lowest_battery", 0.8, 4.1, "b"),
        ("least_lost", math.nan, math.nan, "-"),
        ("sim_time_s", 1.0, 2.0, "they differ"),
    ],
)
def test_the_report_says_which_is_better_where_an_interval_shows_it(
    measure: str, low: float, high: float, better: str
) -> None:
    """The difference is b's mean less a's."""
    assert report._better(measure, Interval((low + high) / 2, low, high), "a", "b") == better


@pytest.mark.parametrize("rows", [0, 1, 5])
def test_a_campaign_that_was_stopped_early_has_a_report_of_what_flew(rows: int, tmp_path: Path) -> None:
    flown = plan(measure=["time_to_goal_s"], vary={"competition.policy": ["winner_take_all", "optimal"]})
    flown.write(tmp_path)
    table.Writer(tmp_path, flown.campaign).write(
        [
            {"row": k, "session": k // 2, "combination": k % 2, "seed": k, "ok": True, "time_to_goal_s": 50.0 + k}
            for k in range(rows)
        ]
    )
    shown = report.make(tmp_path, flown).read_text(encoding="utf-8")
    for policy, of in (("winner_take_all", (rows + 1) // 2), ("optimal", rows // 2)):
        assert f"<td>policy {policy}</td><td>{of} of {of}</td>" in shown


@pytest.mark.parametrize(
    ("address", "why"),
    [
        ("tcp://127.0.0.1:8786", "is no address of a scheduler with TLS"),
        ("127.0.0.1:8786", "is no address of a scheduler with TLS"),
        ("tls://127.0.0.1:8786", r"needs certificates on both sides: .*ca_file and cert and key is missing"),
    ],
)
def test_no_scheduler_is_spoken_to_without_certificates(address: str, why: str, tmp_path: Path) -> None:
    with pytest.raises(EngineError, match=why):
        check_scheduler(address)
    said = CliRunner().invoke(campaign, ["run", "policies", "--out", str(tmp_path / "out"), "--scheduler", address])
    assert said.exit_code == 2
    assert "--scheduler" in said.output
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("error", [CommClosedError("connection reset by peer"), FutureCancelledError("row-3", "lost")])
@pytest.mark.parametrize("status", ["finished", "error"])
def test_a_scheduler_that_goes_while_a_result_is_on_its_way_is_lost(status: str, error: Exception) -> None:
    def fetch() -> None:
        raise error

    future = SimpleNamespace(status=status, result=fetch, exception=fetch)
    plan = cast(Plan, None)  # nothing of it is asked where there is no row
    with pytest.raises(EngineError, match=r"^the scheduler is lost$"):
        result(plan, future, cast(PlannedRow, None))
