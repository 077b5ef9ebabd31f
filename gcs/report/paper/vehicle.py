"""The figures that need the vehicle's own code: `simvehicle paper`, called as a program (paper Figs. 5 and 12)."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gcs.processes.fork_server import vehicle_program
from gcs.report.paper.study import Measurement, PaperError, Study, Table

NAMES = ("fig5", "fig12", "implicit", "noise")
CAPTIONS = {
    "fig5": "Fig. 5: the differentiator on 5 sin t, ε = 0.04, X(0) = 0, implicit steps of 4 ms.",
    "fig12": "Fig. 12: derivative of sin t by the finite-time, sliding-mode and linear high-gain differentiators.",
    "implicit": "Why the differentiator is stepped implicitly: torque and speed error against step and noise.",
    "noise": "Three differentiators in flight, on an estimate that errs as by a scenario's sensors.",
}
RIVALS = {"finite_time": "finite-time", "sliding_mode": "sliding mode", "high_gain": "linear high gain"}
COMPARED = (
    "derivative_error_rms_rad_s",
    "derivative_error_max_rad_s",
    "settled_variation_rad_s",
    "convergence_time_s",
)
STEP_S = 0.004


def make(folder: Path, names: list[str]) -> dict[str, Any]:
    """Let `simvehicle paper` write these figures into `folder`; its numbers, by figure. Raises PaperError."""
    _call(folder, "--only", ",".join(names))
    content: dict[str, Any] = json.loads((folder / "vehicle.json").read_text(encoding="utf-8"))
    return content["figures"]


def energies(folder: Path, plans: Path) -> dict[str, NDArray[Any]]:
    """Let `simvehicle paper` fly plans; what it writes into `folder`, by name. Raises PaperError."""
    _call(folder, "--plans", str(plans))
    with np.load(folder / "energies.npz") as file:
        return dict(file)


def _call(folder: Path, *options: str) -> None:
    program = vehicle_program()
    if program is None:
        raise PaperError("the program 'simvehicle' is not installed beside gcs; install Skytender again")
    command = [program, "paper", "--out", str(folder), *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        last = (done.stderr.strip() or done.stdout.strip() or "no words").splitlines()[-1]
        raise PaperError(f"simvehicle paper ended with status {done.returncode}: {last}")


def fig5(numbers: dict[str, Any]) -> Study:
    """The three layers against the signal and its derivatives."""
    keys = {"x1": ("rad", "max"), "x2": ("rad_s", "max"), "x3": ("rad_s2", "rms")}
    measured = {
        f"fig5-{x}": Measurement(numbers[f"{x}_error_{kind}_{unit}"], f"from {numbers['settled_after_s']:g} s on")
        for x, (unit, kind) in keys.items()
    }
    noise = numbers["noise_rms_share_of_amplitude"]
    words = f"noise of {numbers['noise_std_rad']:g} rad rms"
    measured["noise-x2-5sin"] = Measurement(noise["5 sin t"][1], words)
    measured["noise-x2-sin"] = Measurement(noise["1 sin t"][1], words)
    measured["noise-x3"] = Measurement(noise["5 sin t"][2], f"{words}; of sin t {noise['1 sin t'][2]:.3g}")
    rows = [
        [x.upper(), f"{numbers[f'{x}_error_max_{unit}']:.4f}", f"{numbers[f'{x}_error_rms_{unit}']:.4f}"]
        for x, (unit, _) in keys.items()
    ]
    return Study(measured, (), [Table("Errors from 3 s on", ["layer", "greatest", "rms"], rows)])


def fig12(numbers: dict[str, Any]) -> Study:
    """Which of three differentiators is the smoothest, the most precise, the fastest, at the vehicle's step."""
    cases = {name: numbers["clean"][name] for name in RIVALS}
    fine = {name: numbers["clean_fine_step"][name] for name in RIVALS}
    measured = {}
    for claim, key in (
        ("fig12-smooth", "settled_variation_rad_s"),
        ("fig12-precise", "derivative_error_rms_rad_s"),
        ("fig12-fast", "convergence_time_s"),
    ):
        words = "; ".join(f"{RIVALS[name]} {_number(cases[name][key])}" for name in RIVALS)
        note = f"at steps of 4 ms {words}; at 0.1 ms its place is {_place(fine, key)}"
        measured[claim] = Measurement(_place(cases, key), note)
    rows = [
        [RIVALS[name], f"{1e3 * numbers[case]['step_s']:g} ms{', noisy' if case == 'noisy' else ''}"]
        + [_number(numbers[case][name][key]) for key in COMPARED]
        for case in ("clean", "noisy", "clean_fine_step")
        for name in RIVALS
    ]
    columns = ["differentiator", "step", "error, rms", "greatest", "total variation", "within 0.1 after, s"]
    variation = numbers["clean"]["truth"]["settled_variation_rad_s"]
    caption = f"Derivative of sin t, whose own total variation is {variation:.2f}"
    return Study(measured, (), [Table(caption, columns, rows)])


def implicit(numbers: dict[str, Any]) -> Study:
    """Torque in steady flight by the way the differentiator is stepped."""
    cases = numbers["cases"]
    measured = {}
    for method in ("implicit", "explicit"):
        found = next(c for c in cases if (c["method"], c["step_s"], c["velocity_noise_m_s"]) == (method, STEP_S, 0.0))
        torque = found["torque_rms_rad_s2"]
        measured[f"chatter-{method}"] = Measurement(float("inf") if torque is None else torque)
    rows = [
        [
            *(c["method"], f"{1e3 * c['step_s']:g}", f"{c['velocity_noise_m_s']:g}"),
            *(_number(c["torque_rms_rad_s2"]), _number(c["speed_error_max_m_s"])),
        ]
        for c in cases
    ]
    columns = ["step taken", "ms", "velocity noise, m/s", "torque rms, rad/s²", "greatest speed error, m/s"]
    return Study(measured, (), [Table("Steady flight with the paper's gains", columns, rows)])


def noise(numbers: dict[str, Any]) -> Study:
    """Torque and speed error of a circle that is flown on an estimate with errors, by differentiator."""
    rows = [
        [
            *(RIVALS[c["differentiator"]], f"{c['errors_over_sensors']:g}"),
            *(_number(c["torque_rms_rad_s2"]), _number(c["torque_variation_rad_s2"])),
            *(_number(c["speed_error_rms_m_s"]), _number(c["speed_error_max_m_s"])),
        ]
        for c in numbers["cases"]
    ]
    measured = {}
    for claim, key, unit in (
        ("noise-flight-speed", "speed_error_rms_m_s", "m/s"),
        ("noise-flight-torque", "torque_rms_rad_s2", "rad/s²"),
    ):
        of = {c["differentiator"]: c[key] for c in numbers["cases"] if c["errors_over_sensors"] == 1.0}
        words = "; ".join(f"{RIVALS[name]} {_number(of[name])} {unit}" for name in RIVALS)
        own = of.pop("finite_time")
        measured[claim] = Measurement(own / min(of.values()), words)
    columns = [
        *("differentiator", "errors over those of `sensors: {}`", "torque rms, rad/s²", "its total variation"),
        *("speed error rms, m/s", "greatest"),
    ]
    caption = f"A circle at {numbers['speed_m_s']:g} m/s, from {numbers['counted_from_s']:g} s on"
    return Study(measured, (), [Table(caption, columns, rows)])


STUDIES = {"fig5": fig5, "fig12": fig12, "implicit": implicit, "noise": noise}


def _place(cases: dict[str, Any], key: str) -> int:
    own = cases["finite_time"][key]
    if own is None:
        return len(cases)
    return 1 + sum(bool(other[key] is not None and other[key] < own) for other in cases.values())


def _number(value: float | None) -> str:
    return "never" if value is None else f"{value:.4g}"
