"""Paths, speeds and attitudes of a recorded session against their reference (paper Figs. 7 and 9)."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from gcs.recording.series import Floats
from gcs.report.paper import figures
from gcs.report.paper.session import RecordedFlight
from gcs.report.paper.study import Measurement, Table

SETTLED_AFTER_S = 8.0
ALONG_FROM_S = 5.0
LAMBDA, DRAG_1_S, GRAVITY = 3.0, 0.1 / 2.0, 9.8  # 1/s, K/m 1/s, m/s²: the paper's
FLOOR = 0.3  # of g, least W_z (docs/model/control.md#speed-loop)
_ROUNDING_S = 1e-6


def desired_attitude(v: Floats, v_d: Floats, a_d: Floats, yaw: Floats) -> tuple[Floats, Floats]:
    """φ_d and θ_d (k,) rad from v, v_d m/s and v_d' m/s² (k, 3), paper axes (docs/model/control.md#speed-loop; paper
    eqs. 13-17) [choice].

    W = v_d' + (K/m) v + (0, 0, g) - λ (v - v_d),  θ_d = atan2(W_x cosψ + W_y sinψ, W_z),
    φ_d = asin((W_x sinψ - W_y cosψ)/|W|)
    """
    w = a_d + DRAG_1_S * v - LAMBDA * (v - v_d)
    w[:, 2] = np.maximum(w[:, 2] + GRAVITY, FLOOR * GRAVITY)
    pitch = np.arctan2(w[:, 0] * np.cos(yaw) + w[:, 1] * np.sin(yaw), w[:, 2])
    roll = np.arcsin((w[:, 0] * np.sin(yaw) - w[:, 1] * np.cos(yaw)) / np.linalg.norm(w, axis=1))
    return roll, pitch


def attitude_reference(flight: RecordedFlight) -> Floats:
    """φ_d, θ_d, ψ_d (k, 3) rad at the flight's times; ψ_d is the initial yaw, which the reference keeps."""
    v_d, a_d = flight.reference()
    roll, pitch = desired_attitude(flight.v, v_d, a_d, flight.attitude[:, 2])
    return np.column_stack((roll, pitch, np.full(len(roll), flight.attitude[0, 2])))


def speed_errors(flights: Sequence[RecordedFlight]) -> list[float]:
    """Greatest |v - v_d| of each, m/s, from SETTLED_AFTER_S after its reference became constant."""
    return [float(speed_error(f)[_settled(f)].max()) for f in flights]


def path_errors(flights: Sequence[RecordedFlight]) -> list[float]:
    """Root mean square of |v - v_d| of each, m/s, from ALONG_FROM_S until its reference is constant."""
    errors = []
    for f in flights:
        along = (f.time_s >= ALONG_FROM_S - _ROUNDING_S) & (f.time_s <= f.constant_from_s + _ROUNDING_S)
        errors.append(float(np.sqrt(np.mean(speed_error(f)[along] ** 2))))
    return errors


def attitude_errors(flights: Sequence[RecordedFlight]) -> list[float]:
    """Greatest difference of any angle of each to its reference, rad, over the same time as the speeds."""
    errors = []
    for f in flights:
        difference = f.attitude - attitude_reference(f)
        wrapped = np.abs((difference + np.pi) % (2.0 * np.pi) - np.pi)
        errors.append(float(wrapped[_settled(f)].max()))
    return errors


def arrival_errors(flights: Sequence[RecordedFlight], way: Floats, end: Floats) -> list[float]:
    """For each plan the larger of its least distance to the way point and its last one to the end, m."""
    return [
        float(max(np.linalg.norm(f.plan_p - way, axis=1).min(), np.linalg.norm(f.plan_p[-1] - end))) for f in flights
    ]


def clearances(flights: Sequence[RecordedFlight], obstacles: Floats) -> list[float]:
    """Least distance of each plan, its legs included, to any of the obstacle points (m, 3), in m."""
    return [path_clearance(f.plan_p, obstacles) for f in flights]


def measure(prefix: str, flights: Sequence[RecordedFlight]) -> dict[str, Measurement]:
    """The claims on speed and attitude that each example makes."""
    speed, along, angle = speed_errors(flights), path_errors(flights), attitude_errors(flights)
    least = min(float(f.time_s[-1] - f.constant_from_s) for f in flights)
    worst = flights[int(np.argmax(along))].sysid
    return {
        f"{prefix}-speed": Measurement(
            max(speed), f"worst of {len(flights)} vehicles; the reference was constant for {least:.1f} s or more"
        ),
        f"{prefix}-speed-path": Measurement(max(along), f"vehicle {worst}; least {min(along):.3g} m/s"),
        f"{prefix}-attitude": Measurement(max(angle), f"worst of {len(flights)} vehicles"),
    }


def table(flights: Sequence[RecordedFlight], obstacles: Floats) -> Table:
    """Tracking errors of each vehicle."""
    columns = ["vehicle", "start, m", "initial speed, m/s", "planned path, m", "clearance, m", "at the end after, s"]
    columns += ["|v - v_d| along the path, rms, m/s", "after 8 s constant, m/s", "control effort at the end"]
    values = zip(flights, clearances(flights, obstacles), path_errors(flights), speed_errors(flights), strict=True)
    rows = []
    for f, clear, along, late in values:
        length = float(np.linalg.norm(np.diff(f.plan_p, axis=0), axis=1).sum())
        numbers = [f"{length:.2f}", f"{clear:.3f}", f"{f.arrived_s:.1f}", f"{along:.3f}", f"{late:.1e}"]
        effort = f"{float(f.effort_at(f.arrived_s)):.2f}"
        rows.append([str(f.sysid), _triple(f.plan_p[0]), _triple(f.v[0]), *numbers, effort])
    return Table("Each vehicle, from the recorded session", columns, rows)


def path_figure(flights: Sequence[RecordedFlight], obstacles: Floats, way: Floats, end: Floats) -> Figure:
    """Planned and flown paths from above and from the side."""
    figure, axes = figures.sheet(3.6, 1, 2)
    for axis, (i, j, x, y) in zip(axes[0], ((0, 1, "x, m", "y, m"), (0, 2, "x, m", "z, m")), strict=True):
        axis.plot(obstacles[:, i], obstacles[:, j], "x", color="#777777", markersize=5, label="obstacles")
        for k, f in enumerate(flights):
            colour = figures.COLOURS[k % len(figures.COLOURS)]
            axis.plot(f.p[:, i], f.p[:, j], color=colour, linewidth=0.9, label=f"flown by {f.sysid}")
        for k, f in enumerate(flights):
            shown = {"color": "black", "linewidth": 1.3, "dashes": (4, 2)}
            axis.plot(f.plan_p[:, i], f.plan_p[:, j], **shown, label="planned" if k == 0 else None)
        axis.plot(*np.stack((way, end))[:, [i, j]].T, "o", color="black", markersize=4, label="way point, end")
        figures.label(axis, x, y, "from above" if j == 1 else "from the side")
        axis.set_aspect("equal", adjustable="datalim")
    axes[0, 1].legend(loc="upper left", bbox_to_anchor=(1.0, 1.0))
    return figure


def tracking_figure(flights: Sequence[RecordedFlight], *, literal: bool = False) -> Figure:
    """Speeds in three directions and three angles of each vehicle, and its reference; `literal`: no floor was flown."""
    figure, axes = figures.sheet(5.2, 3, 2, sharex=True)
    for k, f in enumerate(flights):
        v_d, _ = f.reference()
        angle_d = attitude_reference(f)
        colour = figures.COLOURS[k % len(figures.COLOURS)]
        for row in range(3):
            axes[row, 0].plot(f.time_s, f.v[:, row], color=colour, label=f"vehicle {f.sysid}")
            axes[row, 1].plot(f.time_s, f.attitude[:, row], color=colour)
            axes[row, 1].plot(f.time_s, angle_d[:, row], color=colour, linewidth=0.6, dashes=(3, 2))
            if k == len(flights) - 1 or not np.array_equal(f.plan_v, flights[0].plan_v):
                shown = {"color": "black", "linewidth": 0.9, "dashes": (4, 2)}
                name = "desired" if k == len(flights) - 1 else None
                axes[row, 0].plot(f.time_s[1:], v_d[1:, row], **shown, label=name)
    for row, (v_name, angle_name) in enumerate(zip("xyz", ("roll φ", "pitch θ", "yaw ψ"), strict=True)):
        figures.label(axes[row, 0], "time, s" if row == 2 else "", f"v{v_name}, m/s")
        figures.label(axes[row, 1], "time, s" if row == 2 else "", f"{angle_name}, rad")
    axes[0, 0].legend(ncols=3, fontsize=6.5)
    flown = "; flown without it" if literal else ""
    axes[0, 1].set_title(f"dashed: desired, with the floor of 0.3 g{flown}", loc="left")
    return figure


def speed_error(flight: RecordedFlight) -> Floats:
    """|v - v_d| (k,) at the flight's times, m/s."""
    return np.asarray(np.linalg.norm(flight.v - flight.reference()[0], axis=1))


def _settled(flight: RecordedFlight) -> NDArray[np.bool_]:
    """Records from SETTLED_AFTER_S after the reference became constant; ValueError where the session ends before."""
    late = flight.time_s >= flight.constant_from_s + SETTLED_AFTER_S - _ROUNDING_S
    if not late.any():
        raise ValueError(f"vehicle {flight.sysid}: the reference is not constant for {SETTLED_AFTER_S:g} s; fly longer")
    return np.asarray(late)


def path_clearance(path: Floats, obstacles: Floats) -> float:
    """Least distance of a path (k, 3), its legs included, to any of the points (m, 3), m."""
    a, along = path[:-1, np.newaxis], np.diff(path, axis=0)[:, np.newaxis]
    square = np.maximum((along**2).sum(axis=2), 1e-300)
    share = np.clip(((obstacles - a) * along).sum(axis=2) / square, 0.0, 1.0)
    return float(np.linalg.norm(a + share[..., np.newaxis] * along - obstacles, axis=2).min())


def _triple(vector: Floats) -> str:
    return ", ".join(f"{x + 0.0:g}" for x in np.round(vector, 3))
