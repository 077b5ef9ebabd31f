"""Judges a schedule of an instance: whether it can be carried out, which receivers are lost and when, energy and way.

It shares no code with what makes schedules, needs Python alone, and runs by itself as well:

    python verifier.py INSTANCE.json SCHEDULE.json

Exit status 0: it can be carried out; 1: it cannot; 2: a file is none of the format. The rules and the format stand in
docs/refuelling-benchmark.md. SI, NED.
"""

from __future__ import annotations

import json
import sys
from itertools import pairwise
from math import dist, inf
from pathlib import Path
from typing import Any

TOLERANCE = 1e-6
"""Of times in s, places in m and, times the capacity, of energies in J: schedules are made of rounded numbers."""
MOST = sys.float_info.max
NUMBER, POSITIVE, NOT_NEGATIVE, TEXT = "number", "number above 0", "number from 0 on", "text"
WHOLE, ID = "whole number", "whole number from 1 to 254"
BOUNDS = {NUMBER: (-MOST, MOST), POSITIVE: (5e-324, MOST), NOT_NEGATIVE: (0, MOST), ID: (1, 254)}
VEHICLE = {"id": ID, "speed_m_s": POSITIVE, "capacity_j": POSITIVE, "energy_j": NOT_NEGATIVE, "power_w": NOT_NEGATIVE}
SHAPES: dict[str, Any] = {
    "instance": {
        "format": TEXT, "name": TEXT, "kind": TEXT, "tightness": NUMBER, "seed": WHOLE, "horizon_s": POSITIVE,
        "setup_s": NOT_NEGATIVE, "rate_w": POSITIVE,
        "receivers": [VEHICLE | {"path": [(NUMBER,) * 4], "lands_at_j": NOT_NEGATIVE}],
        "tankers": [VEHICLE | {"position_m": (NUMBER,) * 3, "reserve_j": NOT_NEGATIVE}],
        "bases": [{"name": TEXT, "position_m": (NUMBER,) * 3, "stock_j": NOT_NEGATIVE, "rate_w": POSITIVE}],
    },
    "schedule": {
        "format": TEXT, "instance": TEXT,
        "services": [
            {"start_s": NUMBER, "end_s": NUMBER, "energy_j": NUMBER, "receiver": WHOLE, "tanker": WHOLE, "base": TEXT,
             "leave_s": NUMBER, "back_s": NUMBER},
        ],
    },
}  # fmt: skip
OPTIONAL = ("receiver", "tanker", "base", "leave_s", "back_s")
"""Of a service."""


def place(path: Any, t_s: float) -> list[float]:
    """Where a path (corners t, n, e, d) is at a time; before its first corner and after its last one it stands."""
    for (t0, *p0), (t1, *p1) in pairwise(path):
        if t0 <= t_s <= t1 and t1 > t0:
            return [a + (b - a) * (t_s - t0) / (t1 - t0) for a, b in zip(p0, p1, strict=True)]
    return path[0][1:] if t_s < path[0][0] else path[-1][1:]


def followed(path: Any, begin_s: float, end_s: float) -> tuple[float, float]:
    """Length of a path between two times, and its greatest speed there."""
    corners = [begin_s, *(t for t, *_ in path if begin_s < t < end_s), end_s]
    legs = [(t1 - t0, dist(place(path, t0), place(path, t1))) for t0, t1 in pairwise(corners)]
    return sum(way for _, way in legs), max((way / s for s, way in legs if s > TOLERANCE), default=0.0)


def levels(energy_j: float, powers: list[tuple[float, float, float]], horizon_s: float) -> list[tuple[float, float]]:
    """Energy at each time at which a power changes, (time, energy): `powers` are (begin_s, end_s, watts), added up."""
    times = sorted({0.0, horizon_s, *(t for b, e, _ in powers for t in (b, e) if 0.0 < t < horizon_s)})
    found = [(0.0, energy_j)]
    for t0, t1 in pairwise(times):
        watts = sum(w for b, e, w in powers if b <= t0 and t1 <= e)
        found.append((t1, found[-1][1] + watts * (t1 - t0)))
    return found


def first_below(corners: list[tuple[float, float]], least_j: float, slack_j: float) -> float:
    """When a level first falls below another; infinite where it never does."""
    for (t0, e0), (t1, e1) in pairwise(corners):
        if e1 < least_j - slack_j:
            return t0 if e0 <= least_j else t0 + (t1 - t0) * (e0 - least_j) / (e0 - e1)
    return inf


def verify(instance: Any, schedule: Any) -> dict[str, Any]:
    """The verdict as a dict: feasible, problems, lost, delivered_j, way_m, idle_s."""
    horizon_s, setup_s, problems = instance["horizon_s"], instance["setup_s"], []
    receivers = {one["id"]: one for one in instance["receivers"]}
    tankers = {one["id"]: one for one in instance["tankers"]}
    bases = {one["name"]: one for one in instance["bases"]}
    powers = {id_: [(0.0, horizon_s, -one["power_w"])] for id_, one in {**receivers, **tankers}.items()}
    busy: dict[Any, list[tuple[float, float, str]]] = {id_: [] for id_ in (*receivers, *tankers, *bases)}
    stock = {name: base["stock_j"] for name, base in bases.items()}
    stops: dict[int, list[Any]] = {id_: [] for id_ in tankers}
    ends = []

    for k, service in enumerate(schedule["services"]):
        receiver, tanker, base = (service.get(key) for key in ("receiver", "tanker", "base"))
        start_s, end_s, energy_j = service["start_s"], service["end_s"], service["energy_j"]
        what = f"service {k}"
        named = [pair for pair in ((receiver, receivers), (tanker, tankers), (base, bases)) if pair[0] is not None]
        if len(named) != 2 or any(one not in them for one, them in named):
            problems.append(f"{what} needs two of receiver, tanker and base, each of the instance")
            continue
        begin_s, back_s = (service.get(key) for key in ("leave_s", "back_s")) if tanker is None else (start_s, end_s)
        if begin_s is None or back_s is None:
            problems.append(f"{what} of a receiver at a base needs leave_s and back_s")
            continue
        in_order = 0.0 <= begin_s <= start_s <= end_s <= min(back_s, horizon_s + TOLERANCE)
        if not (in_order and back_s < inf and 0.0 <= energy_j < inf):  # so that it is true of NaN too
            problems.append(f"{what} has times or an energy that cannot be")
            continue
        rate_w = instance["rate_w"] if base is None else bases[base]["rate_w"]
        flows_s = end_s - start_s - setup_s
        if energy_j > rate_w * max(flows_s, 0.0) * (1.0 + TOLERANCE):
            problems.append(f"{what} transfers {energy_j:g} J in {max(flows_s, 0.0):g} s, more than {rate_w:g} W")
            continue
        flow_w = energy_j / flows_s if energy_j else 0.0
        takes, gives = (tanker, base) if receiver is None else (receiver, tanker)
        powers[takes].append((start_s + setup_s, end_s, flow_w))
        if base is None:
            powers[gives].append((start_s + setup_s, end_s, -flow_w))
        else:
            stock[base] -= energy_j
            powers[takes].append((start_s, end_s, (receivers | tankers)[takes]["power_w"]))  # it stands there
        for one, _ in named:
            busy[one].append((start_s, end_s, what) if one == base else (begin_s, back_s, what))
        if tanker is not None:
            stops[tanker].append((start_s, end_s, receivers[receiver]["path"] if base is None else None, base, what))
        else:
            one = receivers[receiver]
            for s, t_s in ((start_s - begin_s, begin_s), (back_s - end_s, back_s)):
                if dist(place(one["path"], t_s), bases[base]["position_m"]) > one["speed_m_s"] * s + TOLERANCE:
                    problems.append(f"{what}: receiver {receiver} cannot fly between its path and {base} in {s:g} s")
        if receiver is not None:
            ends.append((receiver, end_s, what))

    for one, times in busy.items():
        for (_, end_s, first), (start_s, _, second) in pairwise(sorted(times)):
            if start_s < end_s - TOLERANCE:
                problems.append(f"{second} of {one} begins at {start_s:g} s, before {first} ends")
    for name, left_j in stock.items():
        if left_j < -TOLERANCE * bases[name]["stock_j"]:
            problems.append(f"{name} gives {-left_j:g} J more than it has")

    way_m, idle_s = 0.0, 0.0
    for id_, tanker in tankers.items():
        at, free_s = tanker["position_m"], 0.0
        for start_s, end_s, path, base, what in sorted(stops[id_], key=lambda stop: stop[:2]):
            there = place(path, start_s) if base is None else bases[base]["position_m"]
            leg_m = dist(at, there)
            if leg_m > tanker["speed_m_s"] * (start_s - free_s) + TOLERANCE:
                problems.append(f"{what}: tanker {id_} cannot fly {leg_m:.2f} m in {start_s - free_s:.2f} s")
            along_m, speed_m_s = followed(path, start_s, end_s) if base is None else (0.0, 0.0)
            if speed_m_s > tanker["speed_m_s"] + TOLERANCE:
                problems.append(f"{what}: tanker {id_} cannot follow a receiver at {speed_m_s:g} m/s")
            way_m, idle_s = way_m + leg_m + along_m, idle_s + start_s - free_s - leg_m / tanker["speed_m_s"]
            at, free_s = place(path, end_s) if base is None else there, end_s
        idle_s += horizon_s - free_s

    lost, fell_s = [], {}
    for id_, one in {**receivers, **tankers}.items():
        corners, slack_j = levels(one["energy_j"], powers[id_], horizon_s), TOLERANCE * one["capacity_j"]
        least_j = one["lands_at_j"] if id_ in receivers else one["reserve_j"]
        fell_s[id_] = first_below(corners, least_j, slack_j)
        if any(e > one["capacity_j"] + slack_j for t, e in corners if t <= fell_s[id_]):
            problems.append(f"vehicle {id_} gets more than it holds")
        if fell_s[id_] < inf and id_ in receivers:
            lost.append({"receiver": id_, "at_s": round(fell_s[id_], 6)})
        elif fell_s[id_] < inf:
            problems.append(f"tanker {id_} is below its reserve at {fell_s[id_]:.2f} s")
    for receiver, end_s, what in ends:
        if fell_s[receiver] < end_s - TOLERANCE:
            problems.append(f"{what}: receiver {receiver} is lost at {fell_s[receiver]:.2f} s, before it ends")
    delivered_j = sum(one["energy_j"] for one in schedule["services"] if one.get("receiver") is not None)
    return {"feasible": not problems, "problems": problems, "lost": sorted(lost, key=lambda one: one["at_s"]),
            "delivered_j": delivered_j, "way_m": way_m, "idle_s": idle_s}  # fmt: skip


def check(one: Any, shape: Any, where: str = "") -> None:
    """Raises ValueError, with the place, for a part of a file that the format does not have."""
    if isinstance(shape, str):
        kinds = {TEXT: (str,), WHOLE: (int,), ID: (int,)}.get(shape, (int, float))
        if type(one) not in kinds or (shape in BOUNDS and not BOUNDS[shape][0] <= one <= BOUNDS[shape][1]):
            raise ValueError(f"{where} is no {shape}")
    elif isinstance(shape, dict):
        if not isinstance(one, dict):
            raise ValueError(f"{where or 'it'} is no object")
        for key in (*shape, *one):
            inner = f"{where}.{key}".lstrip(".")
            if key not in shape or (key not in one and key not in OPTIONAL):
                raise ValueError(f"{inner} is {'missing' if key in shape else 'unknown'}")
            if key not in OPTIONAL or one.get(key) is not None:
                check(one[key], shape[key], inner)
    else:
        if not isinstance(one, list) or (isinstance(shape, tuple) and len(one) != len(shape)):
            raise ValueError(f"{where} is no array{f' of {len(shape)}' if isinstance(shape, tuple) else ''}")
        for k, part in enumerate(one):
            check(part, shape[0], f"{where}[{k}]")


def check_instance(instance: Any) -> None:
    """Raises ValueError, with the place, where two things have one name, or a path is none."""
    named: dict[Any, str] = {}
    for group in ("receivers", "tankers", "bases"):
        for k, one in enumerate(instance[group]):
            name, here = one.get("id", one.get("name")), f"{group}[{k}]"
            if name in named:
                raise ValueError(f"{here} has the {'id' if 'id' in one else 'name'} {name} of {named[name]}")
            named[name] = here
    for k, one in enumerate(instance["receivers"]):
        if not one["path"]:
            raise ValueError(f"receivers[{k}].path has no corner")
        for corner, ((t0, *p0), (t1, *p1)) in enumerate(pairwise(one["path"]), 1):
            if t1 < t0 or (t1 == t0 and p1 != p0):
                before = f"not later than the corner before ({t0:g} s)"
                raise ValueError(f"receivers[{k}].path[{corner}] is at {t1:g} s, {before}")


def read(name: str, kind: str) -> Any:
    """The instance or schedule in a file. Raises ValueError."""
    try:
        one = json.loads(Path(name).read_text(encoding="utf-8"))
        check(one, SHAPES[kind])
        if one["format"] != f"skytender-refuelling-{kind}/1":
            raise ValueError(f"format is not skytender-refuelling-{kind}/1")
        if kind == "instance":
            check_instance(one)
    except OSError as error:
        raise ValueError(f"{name}: {error.strerror}") from None
    except ValueError as error:
        raise ValueError(f"{name} is no {kind} (docs/refuelling-benchmark.md#format): {error}") from None
    return one


def main(names: list[str]) -> int:
    """Print the verdict of two files; the exit status."""
    try:
        if len(names) != 2:
            raise ValueError("it needs two files: verifier.py INSTANCE SCHEDULE")
        instance, schedule = read(names[0], "instance"), read(names[1], "schedule")
        if schedule["instance"] != instance["name"]:
            of, name = schedule["instance"], instance["name"]
            raise ValueError(f"{names[1]} is a schedule of {of!r}, and {names[0]} is {name!r}")
    except ValueError as error:
        print(error, file=sys.stderr)
        return 2
    verdict = verify(instance, schedule)
    print(json.dumps(verdict, indent=1))
    return 0 if verdict["feasible"] else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
