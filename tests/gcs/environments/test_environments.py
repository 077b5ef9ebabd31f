"""Sessions as environments: the checkers of PettingZoo and Gymnasium, seeds, ends, options and errors."""

from __future__ import annotations

import multiprocessing
import re
import subprocess
import sys
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np
import psutil
import pytest
from gymnasium.spaces import Box, Discrete
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import parallel_api_test, parallel_seed_test
from sessions import all_gone, merged, small

import gcs
from gcs.environments.parallel import ParallelSessionEnv
from gcs.environments.single import SessionEnv
from gcs.environments.transition import Transition
from gcs.scenario.document import Document
from gcs.scenario.file import dump, resolve
from gcs.scenario.model import Obstacle

ID = "gcs.environments:skytender/Session-v0"
STILL = np.zeros(3, np.float32)


def scenario(**changes: Any) -> gcs.Scenario:
    """Two pursuers in the air and what they follow, in one process, for 2 s."""
    content = small(goal={"duration_s": 2.0, "refuelled_at_least": 0, "lost_at_most": 2}, vehicles_per_process=3)
    vehicles = content["vehicles"]
    del vehicles["tankers"], content["formation"]
    vehicles["pursuers"].append(dict(vehicles["pursuers"][0], sysid=2, start_m=[-2.0, 1.0, 0.0]))
    for vehicle in (*vehicles["pursuers"], *vehicles["targets"]):
        vehicle.update(airborne=True, start_m=[*vehicle["start_m"][:2], -3.0])
    return made_of(merged(content, changes))


def made_of(content: dict[str, Any]) -> gcs.Scenario:
    return resolve(Document("small.yaml", content), {})


@pytest.fixture(name="make")
def _make(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Iterator[Callable[..., ParallelSessionEnv]]:
    """Makes environments of the two pursuers, which leave no process, and no folder where none was asked for."""
    folder = tmp_path / "temporary"
    folder.mkdir()
    monkeypatch.setattr("tempfile.tempdir", str(folder))
    monkeypatch.chdir(folder)
    made, before = list[ParallelSessionEnv](), set(psutil.Process().children(recursive=True))

    def make(base: gcs.Scenario | str | None = None, **options: Any) -> ParallelSessionEnv:
        made.append(gcs.parallel_env(base or scenario(), **options))
        return made[-1]

    yield make
    for env in made:
        env.close()
    assert not list(folder.iterdir())
    assert set(psutil.Process().children(recursive=True)) <= before  # multiprocessing's tracker, of other tests


def fly(env: ParallelSessionEnv, seed: int | None = None) -> list[Any]:
    """Everything that an episode of sampled actions gives."""
    given: list[Any] = [env.reset(seed=seed)]
    for number, agent in enumerate(env.agents):
        env.action_space(agent).seed(number)
    while env.agents:
        given.append(env.step({agent: env.action_space(agent).sample() for agent in env.agents}))
    return given


@pytest.mark.slow
@pytest.mark.timeout(900)  # it flies a dozen sessions
def test_it_passes_pettingzoos_tests(make: Callable[..., ParallelSessionEnv]) -> None:
    parallel_api_test(make(), num_cycles=5)
    parallel_seed_test(make, num_cycles=5)


@pytest.mark.slow
@pytest.mark.timeout(900)  # it flies a dozen sessions
def test_it_passes_gymnasiums_test() -> None:
    env = gymnasium.make(ID, scenario=scenario(), agent=2)
    check_env(env.unwrapped, skip_render_check=True)  # held by test_it_is_drawn_from_above
    env.close()


def test_equal_seeds_make_equal_episodes_to_the_byte(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(scenario(radio={"loss": 0.2}, goal={"duration_s": 1.0}), render_mode=None)
    first, second, other = fly(env, seed=7), fly(env, seed=7), fly(env, seed=8)
    drawn = fly(env)
    assert repr(first) == repr(second)
    digests = [flown[-1][4]["pursuer_1"]["digest"] for flown in (first, second, other, drawn)]
    assert re.fullmatch("sha256:[0-9a-f]{64}", digests[0])
    assert digests[0] == digests[1]
    assert len(set(digests)) == 3
    assert repr(fly(env, seed=drawn[0][1]["pursuer_1"]["seed"])) == repr(drawn)


def test_an_episode_begins_also_where_the_processes_of_the_last_one_were_killed(
    make: Callable[..., ParallelSessionEnv],
) -> None:
    env = make(scenario(goal={"duration_s": 0.5}))
    before = set(psutil.Process().children())
    first = fly(env, seed=7)
    loaded = set(psutil.Process().children()) - before
    assert len(loaded) == 2
    assert repr(fly(env, seed=7)) == repr(first)
    assert set(psutil.Process().children()) - before == loaded
    for process in loaded:
        process.kill()
    assert not all_gone(list(loaded))
    assert repr(fly(env, seed=7)) == repr(first)


def test_episodes_are_of_the_scenario_that_the_environment_was_made_with(
    make: Callable[..., ParallelSessionEnv], tmp_path: Path
) -> None:
    file = tmp_path / "scenario.yaml"
    file.write_text(dump(scenario(goal={"duration_s": 0.5})), encoding="utf-8")
    env = make(str(file))
    first = fly(env, seed=7)
    file.unlink()
    assert repr(fly(env, seed=7)) == repr(first)


@pytest.mark.parametrize("every_s", [0.3, 5.0])
def test_steps_that_do_not_fill_the_session_are_refused(every_s: float) -> None:
    with pytest.raises(
        ValueError, match=rf"^every_s is {every_s}, of which the scenario's goal.duration_s, 2, is no multiple$"
    ):
        gcs.parallel_env(scenario(), every_s=every_s)


def test_a_fork_of_the_program_flies_episodes_of_its_own(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(scenario(goal={"duration_s": 0.5}))
    first = fly(env, seed=7)
    env.reset(seed=7)

    def fly_there(answers: Connection) -> None:
        with pytest.raises(gcs.SessionError, match="of which this is a fork"):
            env.step(dict.fromkeys(env.agents, STILL))
        answers.send(repr(fly(env, seed=7)))
        env.close()

    ours, theirs = multiprocessing.Pipe()
    fork = multiprocessing.get_context("fork").Process(target=fly_there, args=(theirs,))
    fork.start()
    assert ours.recv() == repr(first)
    fork.join()
    env.step(dict.fromkeys(env.agents, STILL))


def test_an_episode_is_its_session_to_the_end(make: Callable[..., ParallelSessionEnv], tmp_path: Path) -> None:
    env = make(scenario(obstacles=[{"sphere_m": [6.0, 0.0, -3.0], "radius_m": 1.0}]), out=tmp_path / "kept")
    _, info = env.reset(seed=5)
    assert info["pursuer_2"] == {"time_s": 0.0, "seed": 5}
    north = np.array([1.0, 0.0, 0.0], np.float32)
    times, places = [], []
    while env.agents:
        seen, rewards, ends, cut, infos = env.step({"pursuer_1": -north, "pursuer_2": STILL})
        times.append(infos["pursuer_1"]["time_s"])
        places.append(seen["pursuer_1"])
    assert times == pytest.approx(0.1 * np.arange(1, 21))
    assert cut == {"pursuer_1": True, "pursuer_2": True}
    assert not any(ends.values())
    flown = gcs.open(tmp_path / "kept" / "1")["LOCAL_POSITION_NED"]
    truth = env.session.truth
    last = flown[(flown.sysid == 1) & (flown.time_s <= 2.0 + 1e-9)].iloc[-1]
    assert places[-1][:3] == pytest.approx(truth.p_ned[0], abs=0.01)
    assert [last.x_ned_m, last.y_ned_m, last.z_ned_m] == pytest.approx(places[-1][:3], abs=0.01)
    assert places[0][0] - places[-1][0] > 1.0
    target = truth.p_ned[2] - truth.p_ned[0]
    assert places[-1][10:13] == pytest.approx(target, abs=0.02)
    other = truth.p_ned[1] - truth.p_ned[0]
    assert places[-1][16:20] == pytest.approx([1.0, *other], abs=0.02)
    to_centre = np.array([6.0, 0.0, -3.0]) - truth.p_ned[0]
    off_m = np.linalg.norm(to_centre)
    assert places[-1][23:] == pytest.approx(to_centre * (1.0 - 1.0 / off_m), abs=0.02)
    assert rewards["pursuer_1"] == pytest.approx(1.0 / (1.0 + np.linalg.norm(target)), abs=0.01)
    assert env.state().shape == (18,)
    assert env.step({}) == ({}, {}, {}, {}, {})
    digest = infos["pursuer_1"]["digest"]
    assert env.session.summary.digest == digest
    assert (tmp_path / "kept" / "1" / "summary.json").is_file()


def test_an_episode_that_ends_early_has_a_digest_that_repeats(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(scenario(goal={"duration_s": 30.0}), terminated=lambda step: step.after.time_s > 0.95)
    digests = []
    for _ in range(2):
        last = fly(env, seed=4)[-1]
        assert last[2] == {"pursuer_1": True, "pursuer_2": True}
        digests.append(last[4]["pursuer_2"]["digest"])
        assert env.session.summary.outcome == "interrupted"
    assert digests[0] == digests[1]


def test_functions_of_the_users_take_the_place_of_the_defaults(make: Callable[..., ParallelSessionEnv]) -> None:
    seen: list[Transition] = []

    def reward(step: Transition) -> float:
        seen.append(step)
        return step.session.truth.p_ned[step.row, 2]

    env = make(
        agents=[101, 1],
        reward=reward,
        terminated=lambda step: step.after.time_s > 0.65 and step.sysid == 1,
        observation=lambda snapshot, sysid: snapshot.p_ned[snapshot.row(sysid)],
        observation_space=Box(-100.0, 100.0, (3,), np.float64),
        action=lambda action, _, sysid: ((0.0, float(action), -4.0), STILL) if sysid == 101 else None,
        action_space=Discrete(3),
        every_s=0.2,
    )
    assert env.possible_agents == ["pursuer_1", "target_101"]
    given = fly(env, seed=1)
    assert [sorted(step[0]) for step in given[1:]] == [["pursuer_1", "target_101"]] * 4 + [["target_101"]] * 6
    assert given[4][2] == {"pursuer_1": True, "target_101": False}
    assert "digest" not in given[4][4]["pursuer_1"]
    assert given[-1][3] == {"target_101": True}
    assert given[-1][1]["target_101"] == pytest.approx(given[-1][0]["target_101"][2], abs=0.01)
    assert given[-1][0]["target_101"][2] == pytest.approx(-4.0, abs=0.3)
    assert [step.row for step in seen[:2]] == [0, 2]
    assert seen[0].after is seen[1].after


def test_actions_are_numbers_of_any_type(make: Callable[..., ParallelSessionEnv]) -> None:
    env, given = make(scenario(goal={"duration_s": 0.5})), [0.25, -0.5, 0.0]
    digests = []
    for action in (np.array(given, np.float32), np.array(given), given):
        env.reset(seed=1)
        while env.agents:
            infos = env.step({"pursuer_1": action, "pursuer_2": np.zeros(3, int)})[4]
        digests.append(infos["pursuer_1"]["digest"])
    assert len(set(digests)) == 1


def test_an_agent_flies_as_fast_as_it_is_commanded_at_any_step(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(scenario(goal={"duration_s": 5.0}), every_s=0.5)
    env.reset(seed=1)
    west = np.array([0.0, -0.3, 0.0], np.float32)
    flown = [env.step({"pursuer_1": west, "pursuer_2": STILL})[0]["pursuer_1"] for _ in range(10)]
    speed_m_s = 0.3 * env.session.scenario.planner.cruise_m_s
    assert [seen[4] for seen in flown[6:]] == pytest.approx([-speed_m_s] * 4, rel=0.02)
    assert flown[6][1] - flown[-1][1] == pytest.approx(3 * 0.5 * speed_m_s, rel=0.02)


def test_a_lost_vehicle_ends_its_agents_episode(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(
        scenario(goal={"duration_s": 20.0}, faults=[{"fault": "kill", "sysid": 2, "at_s": 1.0}], vehicles_per_process=1)
    )
    env.reset(seed=1)
    while "pursuer_2" in env.agents:
        _, rewards, ends, _, _ = env.step(dict.fromkeys(env.agents, STILL))
    assert ends == {"pursuer_1": False, "pursuer_2": True}
    assert rewards["pursuer_2"] == 0.0
    assert rewards["pursuer_1"] > 0.0
    assert env.session.scenario.goal.duration_s == 20.0
    assert env.agents == ["pursuer_1"]


def test_what_is_varied_is_flown_and_repeats(make: Callable[..., ParallelSessionEnv]) -> None:
    def lighter(base: gcs.Scenario, generator: np.random.Generator) -> gcs.Scenario:
        planner = base.planner.model_copy(update={"cruise_m_s": float(generator.uniform(0.5, 1.0))})
        return base.model_copy(update={"planner": planner})

    env = make(vary=lighter)
    speeds = []
    for seed in (1, 1, 2):
        env.reset(seed=seed)
        speeds.append(env.session.scenario.planner.cruise_m_s)
    assert speeds[0] == speeds[1] != speeds[2]
    fewer = make(
        vary=lambda base, _: base.model_copy(update={"vehicles": base.vehicles.model_copy(update={"targets": ()})})
    )
    with pytest.raises(ValueError, match="vary has changed which vehicles there are"):
        fewer.reset(seed=1)
    walled = make(
        vary=lambda base, _: base.model_copy(update={"obstacles": (Obstacle(point_m=(9.0, 9.0, -3.0)),)}),
    )
    with pytest.raises(ValueError, match="vary has changed what vehicle 1 sees from 23 numbers to 26"):
        walled.reset(seed=1)


def test_vehicles_on_the_ground_take_off_before_the_first_observation(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(made_of(small(goal={"duration_s": 12.0, "refuelled_at_least": 0})), every_s=0.5)
    seen, info = env.reset(seed=1)
    assert info["pursuer_1"]["time_s"] > 1.0
    assert seen["pursuer_1"][2] == pytest.approx(-2.5, abs=0.3)
    short = make(made_of(small(goal={"duration_s": 2.0, "refuelled_at_least": 0})))
    with pytest.raises(gcs.SessionError, match=r"ended before all agents flew: give it a longer goal\.duration_s"):
        short.reset(seed=1)


def test_it_is_drawn_from_above(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(scenario(obstacles=[{"box_m": [[3, 3, 0], [5, 5, -5]]}]), render_mode="rgb_array")
    env.reset(seed=1)
    first = env.render()
    for _ in range(10):
        env.step(dict.fromkeys(env.agents, np.ones(3, np.float32)))
    second = env.render()
    assert first.shape == second.shape == (480, 480, 3)
    assert first.dtype == np.uint8
    assert 0.0005 < (first != second).any(axis=2).mean() < 0.5
    assert ((first == first[..., :1]).all(axis=2) & (first[..., 0] == 89)).mean() > 0.001  # the obstacle, grey 0.35
    assert make().render() is None


def test_gymnasiums_vector_environments_fly_several_sessions() -> None:
    envs = gymnasium.make_vec(ID, num_envs=2, vectorization_mode="async", scenario=scenario())
    seen, info = envs.reset(seed=3)
    assert seen.shape == (2, *envs.single_observation_space.shape)
    assert info["seed"].tolist() == [3, 4]
    for _ in range(20):
        _, _, _, cut, info = envs.step(np.zeros((2, 3), np.float32))
    assert cut.tolist() == [True, True]
    assert len(set(info["digest"])) == 1  # nothing random in this scenario
    envs.close()


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        ({"agents": [9]}, "there is no vehicle 9 in this session: it has 1 to 2, 101"),
        ({"agents": 1}, "agents is 1, but it must be system ids of vehicles: [1], say"),
        ({"agents": ["2"]}, "'2' is no system id: give a vehicle's number, one of 1 to 2, 101"),
        ({"agents": []}, "there is no agent: agents is empty; name vehicles of [1, 2, 101] as agents"),
        ({"agents": [2, 1, 2]}, "vehicle 2 is named as an agent twice; name each once"),
        ({"observation": lambda *_: 0}, "observation and observation_space go together: give both, or neither"),
        ({"action_space": Discrete(2)}, "action and action_space go together"),
        ({"render_mode": "human"}, "render_mode is 'human'; sessions are drawn as 'rgb_array'"),
        ({"every_s": 0.25}, "every_s is 0.25; it must be a multiple of the scenario's period, 0.1 s"),
    ],
)
def test_wrong_options_are_refused_in_a_sentence(options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(ValueError, match=re.escape(sentence)):
        gcs.parallel_env(scenario(), **options)
    with pytest.raises(TypeError, match=r"environments have no option 'rewards': .*reward"):
        gcs.parallel_env(scenario(), rewards=1)  # type: ignore[call-arg]
    with pytest.raises(TypeError, match=r"environments have no option 'agents': action, .*, agent, "):
        gymnasium.make(ID, scenario=scenario(), agents=[1])


def test_wrong_calls_are_refused_in_a_sentence(make: Callable[..., ParallelSessionEnv]) -> None:
    env = make(render_mode="rgb_array")
    with pytest.raises(gcs.SessionError, match="no session before reset"):
        env.render()
    with pytest.raises(gcs.SessionError, match="no session before reset"):
        env.state()
    env.reset(seed=1)
    with pytest.raises(ValueError, match="of vehicle 1 is not in Box"):
        env.step({"pursuer_1": np.full(3, 2.0, np.float32), "pursuer_2": STILL})
    for wrong in ([0.0, 0.0], [0.0, 0.0, 1.1], [0.0, 0.0, 1e300], [0.0, 0.0, np.nan], [0.0, 0.0, 1j], "north", None):
        with pytest.raises(ValueError, match=r"^the action .* of vehicle 1 is not in Box"):
            env.step({"pursuer_1": wrong, "pursuer_2": STILL})
    with pytest.raises(
        ValueError, match=r"^there is no action of pursuer_2: step takes one of each agent of `agents`$"
    ):
        env.step({"pursuer_1": STILL})
    with pytest.raises(ValueError, match="there is no agent 'pursuer_3'; the agents are pursuer_1, pursuer_2"):
        env.step({"pursuer_3": STILL})
    env.close()
    env.close()
    assert env.step({}) == ({}, {}, {}, {}, {})
    alone = SessionEnv(scenario(goal={"duration_s": 0.1}))
    alone.reset(seed=1)
    assert alone.step(STILL)[2:4] == (False, True)
    with pytest.raises(gcs.SessionError, match="the episode has ended and cannot be stepped any more: call reset"):
        alone.step(STILL)
    alone.close()
    with pytest.raises(ValueError, match="there is no agent: small has no pursuer"):
        make(scenario(vehicles={"pursuers": []}))


def test_nothing_of_it_is_imported_unless_asked_for() -> None:
    code = "import sys, gcs; gcs.parallel_env, gcs.Session; "
    code += "print({'gymnasium', 'pettingzoo', 'gcs.environments'} & set(sys.modules))"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert said.stdout == "set()\n"


def test_without_the_extra_a_sentence_says_what_to_install() -> None:
    code = "import sys; sys.modules['pettingzoo'] = None\nimport gcs\n"
    code += "try: gcs.parallel_env('demo')\nexcept gcs.MissingExtra as error: print(error)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert said.stdout == (
        "gcs.environments needs PettingZoo, which is not installed: pip install '.[learn]' in Skytender's checkout\n"
    ), said.stderr
