"""The rigid body on four rotors, held against closed forms, its energy, and a second model written apart from it."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation

from simvehicle.world import rotors
from simvehicle.world.airframes import AIRFRAMES, GRAVITY_M_S2, SPIN, RotorAirframe, pack

Array = NDArray[np.float64]
DT_S = 0.004
STILL = np.zeros(3)


def body(
    *, p: tuple[float, ...] = (0, 0, 0), v: tuple[float, ...] = (0, 0, 0), euler: tuple[float, ...] = (0, 0, 0),
    rates: tuple[float, ...] = (0, 0, 0), speeds: tuple[float, ...] = (0, 0, 0, 0),
) -> Array:  # fmt: skip
    x, y, z, w = Rotation.from_euler("ZYX", euler[::-1]).as_quat()
    return np.array([*p, *v, w, x, y, z, *rates, *speeds], dtype=np.float64)


def flown(airframe: RotorAirframe, start: Array, wanted: Array, wind: Array = STILL, density: float = 1.225) -> Array:
    """Start and every step after it, (k + 1, 17)."""
    winds, packed = np.broadcast_to(wind, (len(wanted), 3)).copy(), pack(airframe, density)
    at, path = start.copy(), [start]
    for speeds, blowing in zip(wanted.astype(np.float64), winds, strict=True):
        rotors.body_step(at, speeds, blowing, packed, DT_S)
        path.append(at.copy())
    return np.array(path)


@pytest.mark.parametrize("airframe", AIRFRAMES.values(), ids=list(AIRFRAMES))
def test_it_hovers_where_its_thrust_equals_its_weight(airframe: RotorAirframe) -> None:
    speed = math.sqrt(airframe.mass_kg * 9.80665 / (4 * airframe.thrust_n_s2))
    upright = replace(airframe, arms_m=((0.1, -0.1), (-0.1, 0.1), (0.1, 0.1), (-0.1, -0.1)))
    path = flown(upright, body(speeds=(speed,) * 4), np.full((2500, 4), speed))
    assert np.abs(path[-1, :13] - path[0, :13]).max() < 1e-9


def test_without_rotors_it_falls_freely_and_the_air_stops_it_at_its_terminal_speed() -> None:
    dragless = replace(AIRFRAMES["hummingbird"], body_drag_kg_m=(0.0, 0.0, 0.0))
    path = flown(dragless, body(v=(1, 2, 3)), np.zeros((500, 4)))
    assert path[-1, :3] == pytest.approx([2.0, 4.0, 6.0 - 0.5 * GRAVITY_M_S2 * 4.0], abs=1e-9)
    airframe = AIRFRAMES["hummingbird"]
    terminal_m_s = math.sqrt(airframe.mass_kg * GRAVITY_M_S2 / airframe.body_drag_kg_m[2])
    path = flown(airframe, body(), np.zeros((1000, 4)))
    t = DT_S * np.arange(1001)
    assert path[:, 5] == pytest.approx(-terminal_m_s * np.tanh(GRAVITY_M_S2 * t / terminal_m_s), abs=1e-9)
    assert flown(airframe, body(), np.zeros((10000, 4)))[-1, 5] == pytest.approx(-terminal_m_s, rel=1e-3)


def test_motors_spin_up_as_a_first_order_lag() -> None:
    path = flown(AIRFRAMES["iris"], body(), np.tile([500.0, 600.0, 700.0, 800.0], (100, 1)))
    share = 1.0 - np.exp(-DT_S * np.arange(101) / 0.05)
    assert path[:, 13:] == pytest.approx(np.outer(share, [500.0, 600.0, 700.0, 800.0]), abs=1e-9)


def test_a_body_without_moments_keeps_its_angular_momentum() -> None:
    airframe = replace(AIRFRAMES["iris"], inertia_kg_m2=(0.02, 0.03, 0.05))
    path = flown(airframe, body(rates=(3.0, 0.1, -2.0)), np.zeros((1000, 4)))
    world = Rotation.from_quat(path[:, [7, 8, 9, 6]]).apply(path[:, 10:13] * airframe.inertia_kg_m2)
    assert np.abs(world - world[0]).max() < 1e-6 * np.linalg.norm(world[0])


def second_model(airframe: RotorAirframe, wind: Array) -> object:
    """Time derivative by rotation matrices, rotor by rotor, from the same published parameters."""
    arms = np.array([[x, y, 0.0] for x, y in airframe.arms_m])
    inertia = np.diag(airframe.inertia_kg_m2)
    blade = np.diag([airframe.rotor_drag_kg, airframe.rotor_drag_kg, airframe.inflow_drag_kg])

    def wrench(s: Array) -> tuple[Array, Array]:
        turn = Rotation.from_quat(s[[7, 8, 9, 6]]).as_matrix()
        air = turn.T @ (s[3:6] - wind)
        force, moment = -np.linalg.norm(air) * np.diag(airframe.body_drag_kg_m) @ air, np.zeros(3)
        for arm, spin, speed in zip(arms, SPIN, s[13:17], strict=True):
            one = np.array([0, 0, airframe.thrust_n_s2 * speed**2]) - speed * blade @ (air + np.cross(s[10:13], arm))
            force = force + one
            moment = moment + np.cross(arm, one) - np.array([0, 0, spin * airframe.torque_nm_s2 * speed**2])
        return force, moment

    def rate(s: Array, wanted: Array) -> Array:
        turn = Rotation.from_quat(s[[7, 8, 9, 6]]).as_matrix()
        force, moment = wrench(s)
        spin = np.linalg.solve(inertia, moment - np.cross(s[10:13], inertia @ s[10:13]))
        w, v, o = s[6], s[7:10], s[10:13]
        quaternion = 0.5 * np.array([-v @ o, *(w * o + np.cross(v, o))])
        lag = (wanted - s[13:17]) / airframe.motor_lag_s
        return np.concatenate([s[3:6], turn @ force / airframe.mass_kg - [0, 0, GRAVITY_M_S2], quaternion, spin, lag])

    return rate, wrench


def lively(airframe: RotorAirframe, steps: int) -> Array:
    """Rotor speeds that climb, roll, pitch and yaw it gently."""
    t = DT_S * np.arange(steps)[:, None]
    phases = np.array([0.0, 0.3, 2.1, 2.6])
    return airframe.hover_rad_s * (1.03 + 0.02 * np.sin(4.0 * t + phases))


@pytest.mark.parametrize("name", AIRFRAMES)
def test_its_path_is_that_of_a_second_model(name: str) -> None:
    airframe, wind, steps = AIRFRAMES[name], np.array([6.0, -3.0, 0.5]), 250
    start = body(p=(1, 2, 3), v=(2, -1, 1), euler=(0.2, -0.3, 2.0), rates=(0.1, -0.2, 0.3), speeds=(500.0,) * 4)
    wanted = lively(airframe, steps)
    path = flown(airframe, start, wanted, wind)
    rate, _ = second_model(airframe, wind)  # type: ignore[misc]
    s = start
    for k in range(steps):
        s = solve_ivp(lambda _, y, u=wanted[k]: rate(y, u), (0, DT_S), s, rtol=1e-8, atol=1e-10).y[:, -1]
    assert path[-1] == pytest.approx(s, rel=1e-5, abs=1e-5)


def test_energy_is_what_rotors_and_air_put_in() -> None:
    airframe, wind, steps = AIRFRAMES["hummingbird"], np.array([6.0, -3.0, 0.5]), 1000
    start = body(v=(2, -1, 1), euler=(0.2, -0.3, 2.0), rates=(0.1, -0.2, 0.3), speeds=(400.0,) * 4)
    path = flown(airframe, start, np.full((steps, 4), airframe.hover_rad_s) * [1.0, 1.001, 1.002, 1.0], wind)
    _, wrench = second_model(airframe, wind)  # type: ignore[misc]
    inertia = np.array(airframe.inertia_kg_m2)
    kinetic = 0.5 * airframe.mass_kg * (path[:, 3:6] ** 2).sum(1) + 0.5 * (inertia * path[:, 10:13] ** 2).sum(1)
    energy = kinetic + airframe.mass_kg * GRAVITY_M_S2 * path[:, 2]
    power = []
    for s in path:
        force, moment = wrench(s)
        power.append(Rotation.from_quat(s[[7, 8, 9, 6]]).apply(force) @ s[3:6] + moment @ s[10:13])
    t = DT_S * np.arange(steps + 1)
    spline = CubicSpline(t, power)
    put_in = float(spline.integrate(0.0, t[-1]))
    moved = float(CubicSpline(t, np.abs(power)).integrate(0.0, t[-1]))
    assert energy[-1] - energy[0] == pytest.approx(put_in, abs=1e-6 * moved)


def test_air_half_as_dense_carries_and_brakes_half_as_much() -> None:
    airframe = AIRFRAMES["hummingbird"]
    start = body(v=(4, 1, -2), euler=(0.1, 0.2, 0.3), speeds=(400.0,) * 4)
    thin, dense = (flown(airframe, start, np.full((1, 4), 400.0), density=share * 1.225)[1] for share in (0.5, 1.0))
    fall = np.array([0, 0, -GRAVITY_M_S2 * DT_S])
    assert thin[3:6] - start[3:6] - fall == pytest.approx(0.5 * (dense[3:6] - start[3:6] - fall), rel=1e-2, abs=1e-4)


@pytest.mark.parametrize("airframe", AIRFRAMES.values(), ids=list(AIRFRAMES))
def test_allocation_gives_what_rotors_can_and_gives_up_yaw_first(airframe: RotorAirframe) -> None:
    packed, random = pack(airframe), np.random.default_rng(1)
    x, y = np.array(airframe.arms_m).T
    ratio = airframe.torque_nm_s2 / airframe.thrust_n_s2
    most_n = airframe.thrust_n_s2 * airframe.fastest_rad_s**2
    exact = 0
    for _ in range(500):
        thrust = random.uniform(0.0, 4.4) * most_n
        mx, my, mz = random.normal(0.0, 1.0, 3) * most_n * [abs(y).max(), abs(x).max(), 0.7 * ratio]
        speeds = rotors.rotor_speeds(thrust, mx, my, mz, packed)
        forces = airframe.thrust_n_s2 * speeds**2
        assert np.all(forces >= 0.0)
        assert np.all(speeds <= airframe.fastest_rad_s * (1 + 1e-12))
        got = np.array([forces.sum(), y @ forces, -x @ forces, -ratio * np.array(SPIN) @ forces])
        wanted = np.array([thrust, mx, my, mz])
        plain = np.linalg.solve(airframe.effectiveness, wanted)
        scale = most_n * np.array([1.0, abs(y).max(), abs(x).max(), ratio])
        if plain.min() >= 0.0 and plain.max() <= most_n:
            exact += 1
            assert np.abs((got - wanted) / scale).max() < 1e-9
        elif abs(got[3] - mz) < 1e-9 * scale[3]:
            continue
        else:  # as long as some yaw is left to give up, tilt is whole
            tilt = np.abs((got - wanted)[1:3] / scale[1:3]).max()
            assert tilt < 1e-9 or abs(got[3]) < abs(mz)
    assert exact > 20


def test_moments_turn_the_angles_as_the_law_asks() -> None:
    airframe, random = AIRFRAMES["iris"], np.random.default_rng(2)
    packed, inertia = pack(airframe), np.array(airframe.inertia_kg_m2)
    for _ in range(20):
        angles, rates, wanted = random.uniform(-1, 1, 3), random.uniform(-2, 2, 3), random.uniform(-9, 9, 3)
        moment = np.array(rotors.moments(angles, rates, wanted, packed))
        h = 1e-4
        turns = [Rotation.from_euler("ZYX", (angles + rates * t + 0.5 * wanted * t * t)[::-1]) for t in (-h, 0, h)]
        before, after = ((a.inv() * b).as_rotvec() / h for a, b in ((turns[0], turns[1]), (turns[1], turns[2])))
        body_rates, acceleration = 0.5 * (before + after), (after - before) / h
        expected = inertia * acceleration + np.cross(body_rates, inertia * body_rates)
        assert moment == pytest.approx(expected, rel=1e-4, abs=1e-5)


def test_the_ground_holds_it_level_and_lets_it_go() -> None:
    start = body(p=(1, 2, -0.01), v=(1, 0, -2), euler=(0.1, 0.2, 0.7), rates=(1, 1, 1))
    assert rotors.meet_ground(start, 0.5, 0.6, True)
    assert start[:13] == pytest.approx(body(p=(0.5, 0.6, 0), euler=(0, 0, start_yaw(0.1, 0.2, 0.7)))[:13], abs=1e-12)
    rising = body(v=(0, 0, 0.1))
    assert not rotors.meet_ground(rising, 0.0, 0.0, True)


def start_yaw(roll: float, pitch: float, yaw: float) -> float:
    return float(Rotation.from_euler("ZYX", (yaw, pitch, roll)).as_euler("ZYX")[0])


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"mass_kg": -1.0}, "mass_kg is -1.0"),
        ({"mass_kg": 3.0}, "cannot lift it"),
        ({"arms_m": ((0.1, 0.1),) * 4}, "lift and turn"),
    ],
)
def test_an_airframe_that_cannot_fly_is_refused(change: dict[str, object], said: str) -> None:
    with pytest.raises(ValueError, match=said):
        replace(AIRFRAMES["iris"], **change)  # type: ignore[arg-type]
