"""Studies that need no flight: fuzzy surface and local minima (Fig. 3), level sets (Fig. 6), the order of the two
loops."""

from __future__ import annotations

import itertools

import numpy as np
from matplotlib.figure import Figure

from gcs.planner import fuzzy_escape
from gcs.planner.leader import advance
from gcs.planner.potential_field import FieldConstants
from gcs.recording.series import Floats
from gcs.report.paper import figures
from gcs.report.paper.session import NED_TO_PAPER
from gcs.report.paper.study import Drawing, Measurement, Study, Table
from skytender import geometry

TERMS = ("NB", "NM", "S", "PM", "PB")
# Of docs/model/planner.md#fuzzy-escape, since Table I's entries are lost; rows: terms of ΔΦ, columns: terms of ΔF.
RULES = (
    ("NB", "NB", "NB", "NM", "S"),
    ("NM", "NM", "NM", "S", "S"),
    ("S", "S", "S", "S", "S"),
    ("PM", "PM", "PM", "S", "S"),
    ("PB", "PB", "PB", "PM", "S"),
)
PEAKS_PHI, PEAKS_F = np.linspace(-np.pi, np.pi, 5), np.linspace(-1.0, 1.0, 5)

WALL = [(5.0, -0.5, 0.0), (5.0, 0.0, 0.0), (5.0, 0.5, 0.0)]
LAYOUTS = {
    "one obstacle on the line": [(5.0, 0.0, 0.0)],
    "wall of three, 0.5 m apart": WALL,
    "wall of three, 0.8 m apart": [(5.0, -0.8, 0.0), (5.0, 0.0, 0.0), (5.0, 0.8, 0.0)],
    "U, shallow": [*WALL, (4.5, -0.5, 0.0), (4.5, 0.5, 0.0)],
    "U, deep": [*WALL, (4.5, -0.5, 0.0), (4.5, 0.5, 0.0), (4.0, -0.5, 0.0), (4.0, 0.5, 0.0)],
}
TARGET = np.array([10.0, 0.0, 0.0])
STEPS, ARRIVED_M, CLEAR_M = 1000, 0.1, 0.2

EXPONENTS = (1.5, 2.0, 2.5, 5.0)
VECTORS, SIZE, SEED = 10_000, 15, 1

RATE_GAIN = ANGLE_GAIN = 1.5  # Ap, Aq: the paper's
DEFAULT_GAINS = (12.0, 36.0)  # Ap, Aq of the vehicle's default set, whose lambda is the paper's
SPEED_GAIN, ROTATIONAL_DRAG_1_S = 3.0, 0.2 * 0.015 / 1.25  # λ and L Kγ/Iγ


def fig3() -> Study:
    """The fuzzy surface against its rule table; five layouts with and without the fuzzy force."""
    off = max(
        abs(fuzzy_escape.escape_strength(phi, force) - PEAKS_F[TERMS.index(RULES[i][j])])
        for i, phi in enumerate(PEAKS_PHI)
        for j, force in enumerate(PEAKS_F)
    )
    rows, stuck, reached = [], 0, 0
    trails: dict[str, tuple[Floats, Floats]] = {}
    for name, points in LAYOUTS.items():
        plain, fled = walk(points, escape=False), walk(points, escape=True)
        trails[name] = plain, fled
        stuck += not _arrived(plain)
        clear = float(geometry.clearance(geometry.points(np.array(points)), fled).min())
        reached += _arrived(fled) and clear >= CLEAR_M
        stops = "reaches it" if _arrived(plain) else f"stops {np.linalg.norm(plain[-1] - TARGET):.2f} m before it"
        rows.append([name, stops, str(len(fled) - 1) if _arrived(fled) else "not reached", f"{clear:.3f}"])
    measured = {
        "fig3a-rules": Measurement(float(off), "against this project's own table"),
        "fig3b-stuck": Measurement(stuck, "scenes; only exactly on the axis: the minimum is a saddle"),
        "fig3b-escape": Measurement(reached, "scenes"),
    }
    drawings = [
        Drawing("fig3a", "Fig. 3(a): fuzzy output f over ΔΦ and ΔF.", _surface()),
        Drawing(
            "fig3b",
            "Fig. 3(b): the scenes from above and from the side; grey without, blue with the fuzzy force.",
            _layouts(trails),
        ),
    ]
    columns = ["scene", "without the fuzzy force", "steps with it", "clearance, m"]
    return Study(measured, drawings, [Table("Local minima (target at (10, 0, 0) m)", columns, rows)])


def walk(points: list[tuple[float, float, float]], *, escape: bool) -> Floats:
    """Planned points (k, 3) m from the origin to TARGET, one step of 0.1 m each, at most STEPS of them."""
    field, table = FieldConstants(), geometry.points(np.array(points))
    q, memory, trail = np.zeros((1, 3)), fuzzy_escape.new_memory(1), [np.zeros(3)]
    while len(trail) <= STEPS and np.linalg.norm(trail[-1] - TARGET) > ARRIVED_M:
        q, memory, _ = step_alone(q, memory, TARGET, obstacles=table, field=field, escape=escape)
        trail.append(q[0])
    return np.array(trail)


def step_alone(
    q: Floats, memory: Floats, goal: Floats, *, obstacles: Floats, field: FieldConstants, escape: bool
) -> tuple[Floats, Floats, Floats]:
    """A planned point's next step of 0.1 m and 0.1 s by itself, as `leader.advance` returns it."""
    return advance(
        q,
        memory,
        [goal],
        [np.zeros(3)],
        repulsors=obstacles,
        moving=np.zeros((0, 3)),
        ranges_m=(),
        owner=(),
        exempt=np.zeros((1, 0), dtype=bool),
        field=field,
        speed_m_s=1.0,
        period_s=0.1,
        escape=escape,
    )


def fig6() -> Study:
    """Level sets of the p-norms, and Remark 4's inequality on random vectors."""
    x = np.abs(np.random.default_rng(SEED).standard_normal((VECTORS, SIZE)))
    norms = np.column_stack([(x**p).sum(axis=1) ** (1.0 / p) for p in EXPONENTS])
    broken = int((np.diff(norms, axis=1) > 1e-12).any(axis=1).sum())
    past_jensen = np.zeros(VECTORS, dtype=np.bool_)
    for (i, p2), (j, p1) in itertools.combinations(enumerate(EXPONENTS), 2):
        past_jensen |= norms[:, i] > SIZE ** (1.0 / p2 - 1.0 / p1) * norms[:, j] + 1e-12
    figure, axes = figures.sheet(3.0, 1, 2)
    angle = np.linspace(0.0, 2.0 * np.pi, 361)
    circle = np.stack((np.cos(angle), np.sin(angle)))
    for p in EXPONENTS:
        axes[0, 0].plot(*(circle / (np.abs(circle) ** p).sum(axis=0) ** (1.0 / p)), label=f"p = {p:g}")
    axes[0, 0].set_aspect("equal")
    axes[0, 0].legend(loc="center")
    figures.label(axes[0, 0], "x1", "x2", "norm 1")
    axes[0, 1].boxplot(norms, tick_labels=[f"{p:g}" for p in EXPONENTS], showfliers=False)
    figures.label(axes[0, 1], "p", "norm", "10,000 random vectors of 15")
    drawing = Drawing("fig6", "Fig. 6: where the p-norm is 1, and how it falls with p.", figure)
    measured = {"fig6-norms": Measurement(broken), "jensen-upper": Measurement(int(past_jensen.sum()))}
    return Study(measured, [drawing])


def loops() -> Study:
    """Rate at which the attitude's error falls, against the speed's (docs/model/control.md#control-law)."""
    measured = {}
    for claim, rate, angle in (("loops-order", RATE_GAIN, ANGLE_GAIN), ("loops-default", *DEFAULT_GAINS)):
        inner = float(-np.roots([1.0, rate + ROTATIONAL_DRAG_1_S, angle]).real.max())
        note = f"the attitude's error falls with {inner:.3f} 1/s, the speed's with {SPEED_GAIN:g} 1/s"
        measured[claim] = Measurement(inner / SPEED_GAIN, note)
    return Study(measured)


def _arrived(trail: Floats) -> bool:
    return bool(np.linalg.norm(trail[-1] - TARGET) <= ARRIVED_M)


def _surface() -> Figure:
    phi, force = np.linspace(-np.pi, np.pi, 61), np.linspace(-1.0, 1.0, 41)
    f = np.array([[fuzzy_escape.escape_strength(x, y) for x in phi] for y in force])
    figure = Figure(figsize=(figures.WIDTH_IN, 3.4), layout="constrained")
    axes = figure.add_subplot(1, 2, 1, projection="3d")
    axes.plot_surface(*np.meshgrid(phi, force), f, cmap="viridis", linewidth=0.0, rstride=1, cstride=1)
    axes.set(xlabel="ΔΦ, rad", ylabel="ΔF", zlabel="f")
    flat = figure.add_subplot(1, 2, 2)
    drawn = flat.contourf(phi, force, f, levels=20, cmap="viridis")
    figure.colorbar(drawn, ax=flat, label="f")
    figures.label(flat, "ΔΦ, rad", "ΔF")
    flat.grid(visible=False)
    return figure


def _layouts(trails: dict[str, tuple[Floats, Floats]]) -> Figure:
    figure, axes = figures.sheet(4.6, len(trails), 2, sharex=True)
    for row, (name, both) in enumerate(trails.items()):
        points, plain, fled = (NED_TO_PAPER * trail for trail in (np.array(LAYOUTS[name]), *both))
        for column, (axis, y) in enumerate(((1, "y, m"), (2, "z, m"))):
            ax = axes[row, column]
            ax.plot(points[:, 0], points[:, axis], "x", color="#d55e00", markersize=4)
            ax.plot(fled[:, 0], fled[:, axis], color=figures.COLOURS[0])
            ax.plot(plain[:, 0], plain[:, axis], color="#777777", linewidth=1.6, dashes=(3, 2))
            figures.label(ax, "x, m" if row == len(trails) - 1 else "", y, name if column == 0 else "")
    return figure
