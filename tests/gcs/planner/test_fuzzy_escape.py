"""Truth: scikit-fuzzy's control system, the rule table of docs/model/planner.md#fuzzy-escape, and the scenes measured
in docs/model/planner.md#fuzzy-escape."""

import warnings

import numpy as np
import pytest
import skfuzzy
from field import escape, force
from skfuzzy import control

from gcs.planner import fuzzy_escape
from gcs.planner.potential_field import FieldConstants
from skytender import geometry

FIELD = FieldConstants()
TERMS = ["NB", "NM", "S", "PM", "PB"]
# Rows ΔΦ, columns ΔF; [choice], since the entries of the paper's Table I are lost.
RULES = {
    "NB": "NB NB NB NM S",
    "NM": "NM NM NM S S",
    "S": "S S S S S",
    "PM": "PM PM PM S S",
    "PB": "PB PB PB PM S",
}
GOAL = np.array([10.0, 0.0, 0.0])
WALL = [(5, -0.5, 0), (5, 0, 0), (5, 0.5, 0)]
SHALLOW_U = [*WALL, (4.5, -0.5, 0), (4.5, 0.5, 0)]
SCENES = {
    "one obstacle on the line": [(5, 0, 0)],
    "wall of three, 0.5 m apart": WALL,
    "wall of three, 0.8 m apart": [(5, -0.8, 0), (5, 0, 0), (5, 0.8, 0)],
    "shallow U": SHALLOW_U,
    "deep U": [*SHALLOW_U, (4, -0.5, 0), (4, 0.5, 0)],
}


def scikit_fuzzy_system() -> control.ControlSystemSimulation:
    def variable(kind: type, name: str, universe: np.ndarray, peak_of_pb: float) -> object:
        v = kind(universe, name)
        for term, peak in zip(TERMS, np.linspace(-peak_of_pb, peak_of_pb, 5), strict=True):
            v[term] = skfuzzy.trimf(universe, [peak - peak_of_pb / 2, peak, peak + peak_of_pb / 2])
        return v

    phi = variable(control.Antecedent, "phi", np.linspace(-np.pi, np.pi, 401), np.pi)
    df = variable(control.Antecedent, "df", np.linspace(-1, 1, 401), 1.0)
    f = variable(control.Consequent, "f", np.linspace(-1.5, 1.5, 601), 1.0)
    rules = [
        control.Rule(phi[row] & df[column], f[output])
        for row, outputs in RULES.items()
        for column, output in zip(TERMS, outputs.split(), strict=True)
    ]
    return control.ControlSystemSimulation(control.ControlSystem(rules))


def test_strength_agrees_with_scikit_fuzzy() -> None:
    system = scikit_fuzzy_system()
    rng = np.random.default_rng(7)
    for phi, df in zip(rng.uniform(-np.pi, np.pi, 60), rng.uniform(-1, 1, 60), strict=True):
        system.input["phi"], system.input["df"] = phi, df
        with warnings.catch_warnings():
            # scikit-fuzzy 0.5 passes np.maximum its output by position, which numpy 2.4 deprecates.
            warnings.simplefilter("ignore", DeprecationWarning)
            system.compute()
        assert fuzzy_escape.escape_strength(phi, df) == pytest.approx(system.output["f"], abs=2e-5)


def test_at_the_peaks_the_output_is_the_tables_term() -> None:
    value = dict(zip(TERMS, (-1, -0.5, 0, 0.5, 1), strict=True))
    for row, outputs in RULES.items():
        for column, output in zip(TERMS, outputs.split(), strict=True):
            got = fuzzy_escape.escape_strength(value[row] * np.pi, value[column])
            assert got == pytest.approx(value[output], abs=1e-12)


def test_strength_is_odd_in_the_angle_and_within_one() -> None:
    for phi, df in np.random.default_rng(5).uniform((-4, -1.5), (4, 1.5), (300, 2)):
        f = fuzzy_escape.escape_strength(phi, df)
        assert -1 <= f <= 1
        assert f == pytest.approx(-fuzzy_escape.escape_strength(-phi, df), abs=1e-12)


def walk(points: object, *, escapes: bool, full_steps: bool, limit: int = 400) -> tuple[bool, int, np.ndarray]:
    """From the origin towards GOAL: reached, steps, path. Full steps κF/|F|, or the law's κ min(1, |F|/k0) F/|F|."""
    table = geometry.points(points)
    ranges, memory, path = np.ones(len(table)), fuzzy_escape.new_memory(1)[0], [np.zeros(3)]
    while np.linalg.norm(path[-1] - GOAL) > 0.1 and len(path) <= limit:
        q = path[-1]
        attraction, repulsion = force(q, tracked=[GOAL], waypoints=[], repulsors=table, ranges_m=ranges, field=FIELD)
        total = attraction + repulsion
        if escapes:
            distance = float(np.linalg.norm(GOAL - q))
            pushed, memory = escape(q, attraction, repulsion, distance, memory, field=FIELD)
            total = total + pushed
        size = np.linalg.norm(total)
        path.append(q + FIELD.step_m * total / (size if full_steps else max(size, FIELD.k0)))
    return bool(np.linalg.norm(path[-1] - GOAL) <= 0.1), len(path) - 1, np.array(path)


# Steps and clearance of docs/model/planner.md#fuzzy-escape, first column. It gives no coordinates: start, goal and the
# two walls were recovered from the figures (one step more in each wall); of the U's only the pattern is held, their
# arms being our guess.
@pytest.mark.parametrize(
    ("scene", "steps", "clearance_m"),
    [
        ("one obstacle on the line", 111, 0.40),
        ("wall of three, 0.5 m apart", 116, 0.40),
        ("wall of three, 0.8 m apart", 127, 0.36),
    ],
)
def test_published_scenes_take_the_published_steps_to_one(scene: str, steps: int, clearance_m: float) -> None:
    reached, taken, path = walk(SCENES[scene], escapes=True, full_steps=True)
    assert reached
    assert taken == pytest.approx(steps, abs=1)
    assert geometry.clearance(geometry.points(SCENES[scene]), path).min() == pytest.approx(clearance_m, abs=0.005)


@pytest.mark.parametrize("full_steps", [True, False])
@pytest.mark.parametrize("scene", SCENES)
def test_every_scene_is_passed_with_the_escape_and_stops_without(scene: str, full_steps: bool) -> None:
    # Exactly axis-aligned, since the minimum is a saddle: rounding off the axis would free even the plain field.
    reached, _, path = walk(SCENES[scene], escapes=True, full_steps=full_steps)
    assert reached
    assert geometry.clearance(geometry.points(SCENES[scene]), path).min() > 0.34
    assert not walk(SCENES[scene], escapes=False, full_steps=full_steps)[0]


def stuck(attraction: object, repulsion: object, calls: int) -> tuple[list[np.ndarray], np.ndarray]:
    """Forces of `calls` steps on the spot, 5 m from the goal."""
    memory, forces = fuzzy_escape.new_memory(1)[0], []
    for _ in range(calls):
        pushed, memory = escape((0, 0, 0), attraction, repulsion, 5.0, memory, field=FIELD)
        forces.append(pushed)
    return forces, memory


def test_it_engages_at_the_eleventh_step_on_the_spot_with_the_published_size() -> None:
    forces, _ = stuck((15, 0, 0), (-15, 0, 0), 11)
    assert (np.array(forces[:10]) == 0).all()
    # Head-on and balanced: f = PB = 1; s = north × up = east.
    assert forces[10] == pytest.approx([0, 1.3 * 15, 0])


def test_it_leans_to_the_side_to_which_the_repulsion_leans() -> None:
    assert stuck((15, 0, 0), (-15, -0.1, 0), 11)[0][-1][1] < 0
    assert stuck((15, 0, 0), (-15, 0.1, 0), 11)[0][-1][1] > 0


def test_the_side_is_kept_while_engaged() -> None:
    _, memory = stuck((15, 0, 0), (-15, 0.1, 0), 11)
    pushed, _ = escape((0, 0, 0), (15, 0, 0), (-15, -0.1, 0), 5.0, memory, field=FIELD)
    assert pushed[1] > 0


@pytest.mark.parametrize("lean", [-0.1, 0.1])
def test_stuck_for_25_steps_it_turns_a_quarter_upwards_first(lean: float) -> None:
    forces, _ = stuck((15, 0, 0), (-15, lean, 0), 10 + 4 * 26 + 1)
    turns = [np.round(forces[10 + 26 * k] / np.linalg.norm(forces[10 + 26 * k])) for k in range(5)]
    aside = np.array([0, np.sign(lean), 0])
    assert np.array_equal(turns, [aside, (0, 0, -1), -aside, (0, 0, 1), aside])


@pytest.mark.parametrize("attraction", [(15, 0, 0), (-9, 4, 11), (0, 0, -15), (0, 0, 15), (1e-3, 0, -15)])
def test_the_force_is_perpendicular_to_the_line_to_the_target(attraction: object) -> None:
    towards = np.array(attraction, dtype=float)
    for pushed in stuck(towards, -towards + (0.1, 0.2, 0.3), 80)[0][10:]:
        assert np.linalg.norm(pushed) > 0
        assert pushed @ towards == pytest.approx(0, abs=1e-9)


def test_it_lets_go_when_nearer_or_clear_or_arrived() -> None:
    _, memory = stuck((15, 0, 0), (-15, 0, 0), 12)
    _, nearer = escape((0.31, 0, 0), (15, 0, 0), (-15, 0, 0), 4.69, memory, field=FIELD)
    _, arrived = escape((0, 0, 0), (15, 0, 0), (-15, 0, 0), 0.1, memory, field=FIELD)
    assert memory[fuzzy_escape.ENGAGED] == 1
    assert nearer[fuzzy_escape.ENGAGED] == arrived[fuzzy_escape.ENGAGED] == 0
    for _ in range(20):
        assert memory[fuzzy_escape.ENGAGED] == 1
        _, memory = escape((0, 0, 0), (15, 0, 0), (0, 0, 0), 5.0, memory, field=FIELD)
    assert memory[fuzzy_escape.ENGAGED] == 0


def test_a_slow_leader_that_makes_its_full_steps_is_not_stuck() -> None:
    memory = fuzzy_escape.new_memory(1)[0]
    for k in range(40):
        q = (0.02 * k, 0, 0)
        pushed, memory = escape(q, (15, 0, 0), (-5, 0, 0), 5 - q[0], memory, field=FIELD, step_m=0.02)
        assert (pushed == 0).all()
