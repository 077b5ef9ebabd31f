"""Series out of a session's files, against closed forms, pandas and what the session itself counted."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pymap3d
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gcs.mavlink import codec
from gcs.recording import pursuit_held, series, tlog_reader
from gcs.recording.recorder import Recorder
from gcs.recording.session_folder import NoSession, Recorded, read, read_recording
from gcs.report import distances
from gcs.report.findings import Findings
from gcs.scenario.file import dump
from gcs.scenario.model import Scenario
from gcs.telemetry.pursuit import PursuitHeld

LAT, LON, ALT = 47.0, 8.0, 400.0
EPOCH_US = 1_767_225_600_000_000
RADIUS_M, RATE = 10.0, 0.2
OFFSET = (30.0, -20.0, 0.0)
END_S = 60.0


def scenario(**changed: Any) -> Scenario:
    battery = {"capacity_j": 20_000.0}
    content: dict[str, Any] = {
        "schema": 1, "name": "circle", "axes": "ned", "origin": {"lat_deg": LAT, "lon_deg": LON, "alt_m": ALT},
        "goal": {"duration_s": END_S, "pursue": {"within_m": 11.0, "for_s": 20.0}}, "clock": {"mode": "lockstep"},
        "vehicles": {
            "pursuers": [{"sysid": 1, "start_m": (10.0, 0.0, -5.0), "airborne": True, "battery": battery}],
            "targets": [{"sysid": 101, "start_m": (0.0, 0.0, -5.0), "airborne": True, "battery": battery,
                         "path_m": [(0.0, 0.0, -5.0)], "speed_m_s": 1.0}],
        },
        "obstacles": [{"sphere_m": (0.0, 14.0, -5.0), "radius_m": 1.0}],
    }  # fmt: skip
    return Scenario.model_validate(content | changed)


def circle(t: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """Place and velocity of who flies round the origin, 5 m high."""
    c, s = math.cos(RATE * t), math.sin(RATE * t)
    return (RADIUS_M * c, RADIUS_M * s, -5.0), (-RADIUS_M * RATE * s, RADIUS_M * RATE * c, 0.0)


def record(folder: Path, off_plan_m: float = 0.25) -> None:
    """Vehicle 1 flies a circle round target 101, which stands; its own frame's zero is OFFSET away; its set points lie
    `off_plan_m` above it. It draws 100 W and is given 50 J/s from 20 s to 30 s. Of its frames one in 50 is missing."""
    folder.mkdir()
    (folder / "scenario.yaml").write_text(dump(scenario()), encoding="utf-8")
    seq = {1: 0, 101: 0}
    sent = 0

    with Recorder(folder) as recorder:

        def tell(t: float, sysid: int, message: str, /, **fields: Any) -> None:
            nonlocal sent
            sent += 1
            if sysid != 1 or sent % 50:
                recorder.frames(EPOCH_US + round(1e6 * t), [codec.encode(message, seq[sysid], sysid, 1, **fields)])
            seq[sysid] = (seq[sysid] + 1) % 256

        for k in range(1, round(END_S / 0.1) + 1):
            t = k / 10
            for sysid in (1, 101):
                if k % 10 == 1:
                    beat = {"type": 2, "autopilot": 12, "base_mode": 0x81, "custom_mode": 6 << 16, "system_status": 4}
                    tell(t, sysid, "HEARTBEAT", **beat)
                    tell(t, sysid, "EXTENDED_SYS_STATE", vtol_state=0, landed_state=2)
                    lat, lon, alt = pymap3d.ned2geodetic(*(OFFSET if sysid == 1 else (0, 0, 0)), LAT, LON, ALT)
                    place = {"latitude": round(1e7 * lat), "longitude": round(1e7 * lon), "altitude": round(1e3 * alt)}
                    tell(t, sysid, "GPS_GLOBAL_ORIGIN", **place)
                p, v = circle(t) if sysid == 1 else ((0.0, 0.0, -5.0), (0.0, 0.0, 0.0))
                x, y, z = (a - b for a, b in zip(p, OFFSET if sysid == 1 else (0, 0, 0), strict=True))
                state = {"x": x, "y": y, "z": z, "vx": v[0], "vy": v[1], "vz": v[2]}
                tell(t, sysid, "LOCAL_POSITION_NED", time_boot_ms=100 * k, **state)
            if k % 5 == 0:
                given = round(50 * min(max(t - 20.0, 0.0), 10.0))
                tell(t, 1, "NAMED_VALUE_INT", time_boot_ms=100 * k, name="XferIn", value=given)
                status = {"battery_function": 0, "type": 0, "temperature": 0, "voltages": [65535] * 10}
                rest = {"current_battery": -1, "current_consumed": -1, "battery_remaining": -1}
                tell(t, 1, "BATTERY_STATUS", id=0, energy_consumed=round(t), **status, **rest)
            point = [*circle(t)[0][:2], -5.0 - off_plan_m]
            recorder.decisions([{"t_s": t, "kind": "set_point", "sysid": 1, "p_ned": point, "v_ned": circle(t)[1]}])


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Recorded:
    folder = tmp_path_factory.mktemp("report") / "session"
    record(folder)
    return read(folder)


@pytest.fixture(scope="module")
def tracks(recorded: Recorded) -> dict[int, series.Track]:
    return series.tracks(recorded)


def test_positions_are_in_the_common_frame(tracks: dict[int, series.Track]) -> None:
    track = tracks[1]
    north, east = track.p_ned[:, 0], track.p_ned[:, 1]
    assert np.hypot(north, east) == pytest.approx(RADIUS_M, abs=0.02)
    assert np.unwrap(np.arctan2(east, north)) == pytest.approx(RATE * track.t_s, abs=0.002)
    assert np.linalg.norm(track.v_ned, axis=1) == pytest.approx(RADIUS_M * RATE, rel=1e-5)


def test_a_place_is_carried_forward_for_as_long_as_it_is_fresh(tracks: dict[int, series.Track]) -> None:
    last_s = tracks[1].t_s[-1]
    here, soon, late = tracks[1].at(np.array([last_s, last_s + 0.5, last_s + 2.0]))
    assert np.linalg.norm(soon - here) == pytest.approx(0.5 * RADIUS_M * RATE, rel=1e-6)
    assert np.isnan(late).all()


def test_distances_are_those_of_the_circle(recorded: Recorded, tracks: dict[int, series.Track]) -> None:
    near = distances.measure(recorded, tracks, {})
    known = ~np.isnan(near.separation.values)
    assert known.sum() > 590
    assert near.separation.values[known] == pytest.approx(RADIUS_M, abs=0.03)
    # To the sphere of 1 m radius 14 m east of the middle, by the law of cosines; the target stands 13 m from it.
    t_s = near.clearance.t_s[known]
    gap = np.sqrt(RADIUS_M**2 + 14.0**2 - 2 * RADIUS_M * 14.0 * np.sin(RATE * t_s)) - 1.0
    gap = np.minimum(gap, 13.0)
    assert near.clearance.values[known] == pytest.approx(gap, abs=0.03)
    assert near.clearance.values[known].min() == pytest.approx(3.0, abs=0.03)
    assert near.held_s[1] == pytest.approx(END_S, abs=0.5)


@pytest.mark.parametrize(("height_m", "parts_until_s"), [(1.2, 30.0), (0.5, 33.0)])
def test_partners_whose_decision_was_not_kept_are_apart_for_the_session(
    recorded: Recorded, tracks: dict[int, series.Track], height_m: float, parts_until_s: float
) -> None:
    """A line says that 101 served 1 until 30 s; nearer than the separation in it, they have 3 s to part."""
    served = {"t_s": 30.0, "kind": "served", "receiver": 1, "tanker": 101, "decided_at_s": 2.0}
    told = scenario(refuelling={"height_m": height_m, "enabled": False})
    near = distances.measure(replace(recorded, scenario=told, decisions=[served]), tracks, {})
    counts = np.isfinite(near.separation.values)
    t_s = near.separation.t_s
    assert not counts[(t_s > 1.95) & (t_s < parts_until_s + 0.05)].any()
    assert counts[t_s > parts_until_s + 0.15].all()
    assert counts[(t_s > 0.15) & (t_s < 1.95)].all()


def test_the_tracking_error_is_the_distance_from_the_plan(recorded: Recorded, tracks: dict[int, series.Track]) -> None:
    error = distances.tracking_errors(recorded, tracks)[1]
    known = error.values[~np.isnan(error.values)]
    assert len(known) > 550
    assert known == pytest.approx(0.25, abs=0.02)
    assert np.isnan(error.values[:19]).all(), "a plan of fewer points is not yet a path"


def test_the_battery_is_the_ledger(recorded: Recorded) -> None:
    battery = series.batteries(recorded)[1]
    t_s = battery.remaining.t_s
    received = 50.0 * np.clip(t_s - 20.0, 0.0, 10.0)
    assert battery.capacity_j == 20_000.0
    # The counter may be one message old where its own was lost.
    assert battery.remaining.values == pytest.approx(20_000.0 - 100.0 * np.round(t_s) + received, abs=26.0)


@given(st.lists(st.lists(st.booleans(), min_size=2, max_size=2), max_size=60), st.integers(1, 60))
def test_pursuit_is_held_from_the_first_to_the_last_tick_in_a_row_by_the_worst(holds: list[Any], block: int) -> None:
    t_s, near_m = 0.5 * np.arange(len(holds)), np.where(np.array(holds).reshape(-1, 2), 1.0, 3.0)
    at_once, by_tick = PursuitHeld((1, 2), 2.0), PursuitHeld((1, 2), 2.0)
    worst_s = at_once.update(t_s, near_m)
    some = [by_tick.update(t_s[k : k + block], near_m[k : k + block]) for k in range(0, len(t_s), block)]
    assert np.array_equal(np.concatenate([np.empty(0), *some]), worst_s)

    def longest_s(key: int, until: int) -> float:
        runs = itertools.groupby(range(until), lambda k: holds[k][key])
        return max([0.5 * (len(list(run)) - 1) for held, run in runs if held], default=0.0)

    assert worst_s.tolist() == [min(longest_s(0, k + 1), longest_s(1, k + 1)) for k in range(len(holds))]
    assert at_once.held_s == {1: longest_s(0, len(holds)), 2: longest_s(1, len(holds))}


def course_of(folder: Path, flown: Scenario) -> Callable[[float], float] | None:
    reader = pursuit_held.HeldTimesReader(flown, [])
    for chunk in tlog_reader.read(folder / "session.tlog").chunks():
        reader.add(chunk)
    reader.finish()
    return reader.held_times()


def test_pursuit_is_held_from_the_first_tick_on_by_who_circles_within_the_goals_distance(recorded: Recorded) -> None:
    """The first tick with a place is that of 0.1 s, and the last one is a period before the end."""
    course = course_of(recorded.folder, scenario())
    assert course is not None
    assert course(0.1) == 0.0
    for t_s, held_s in ((1.0, 0.9), (17.3, 17.2), (END_S, END_S - 0.2)):
        assert course(t_s) == pytest.approx(held_s)
    nearer = scenario(goal={"duration_s": END_S, "pursue": {"within_m": 9.0, "for_s": 20.0}})
    outside = course_of(recorded.folder, nearer)
    assert outside is not None
    assert outside(END_S) == 0.0
    assert course_of(recorded.folder, scenario(goal={"duration_s": END_S})) is None


def test_who_is_sent_after_another_target_pursues_that_from_then_on(recorded: Recorded) -> None:
    order = {"t_s": 20.0, "kind": "operator", "command": "retarget", "sysid": 1, "target": 102, "text": ""}
    t_s = pursuit_held.ticks_of(recorded, vehicles=3)
    for taken in (True, False):
        whom = pursuit_held.pursued(replace(recorded, decisions=[order | {"taken": taken}]), t_s)[1]
        assert set(whom[t_s < 19.95]) == {101}
        assert set(whom[t_s > 19.95]) == {102 if taken else 101}


def test_energy_from_a_base_counts_for_a_vehicle_that_does_not_count_itself(recorded: Recorded) -> None:
    served = {"t_s": 40.0, "kind": "served", "receiver": 1, "tanker": None, "base": "north", "energy_j": 500.0}
    tables = {**recorded.tables, "NAMED_VALUE_INT": recorded.tables["NAMED_VALUE_INT"][:0]}
    uncounted = Recorded(recorded.folder, None, recorded.scenario, tables, [served])
    remaining = series.batteries(uncounted)[1].remaining
    drawn = 20_000.0 - remaining.values - 100.0 * np.round(remaining.t_s)
    assert drawn[remaining.t_s < 40.0] == pytest.approx(0.0, abs=1.0)
    assert drawn[remaining.t_s >= 40.0] == pytest.approx(-500.0, abs=1.0)


def test_energy_that_cannot_be_is_no_more_believed_than_while_it_flew(recorded: Recorded) -> None:
    """200 MJ between two reports half a second apart, from a vehicle that draws 100 W."""
    rows = recorded.tables["BATTERY_STATUS"].copy()
    wrong_s = rows["t_s"][60]
    rows["energy_consumed"][60] = 2_000_000
    doubted = Recorded(recorded.folder, None, recorded.scenario, {**recorded.tables, "BATTERY_STATUS": rows})
    then, before = series.batteries(doubted)[1].remaining, series.batteries(recorded)[1].remaining
    assert wrong_s in before.t_s
    assert np.array_equal(then.t_s, before.t_s[before.t_s != wrong_s])
    assert np.array_equal(then.values, before.values[before.t_s != wrong_s])


def test_who_never_told_an_origin_is_named_as_missing(recorded: Recorded) -> None:
    origins = recorded.tables["GPS_GLOBAL_ORIGIN"]
    tables = {**recorded.tables, "GPS_GLOBAL_ORIGIN": origins[origins["sysid"] != 101]}
    found = Findings(Recorded(recorded.folder, None, recorded.scenario, tables, end_s=END_S))
    assert found.tracks.keys() == {1}
    assert "The paths of 101 are not known" in found.recorded.problems[0]


def test_traffic_of_a_recording_alone_is_in_the_frame_of_its_vehicles(tmp_path: Path) -> None:
    """A vehicle that hangs 20 m north of its origin, first received there, and an aircraft 3 m east of it."""

    def place(*p_ned: float) -> dict[str, int]:
        lat, lon, alt = pymap3d.ned2geodetic(*p_ned, LAT, LON, ALT)
        return {"lat": round(1e7 * lat), "lon": round(1e7 * lon), "alt": round(1e3 * alt)}

    origin = {"latitude": round(1e7 * LAT), "longitude": round(1e7 * LON), "altitude": round(1e3 * ALT)}
    own, other = place(20.0, 0.0, -5.0), place(20.0, 3.0, -5.0)
    other["altitude"] = other.pop("alt")
    rest = {"vx": 0, "vy": 0, "vz": 0}
    aircraft = {
        "ICAO_address": 7, "callsign": "OTHER", "altitude_type": 1, "heading": 0, "hor_velocity": 0,
        "ver_velocity": 0, "emitter_type": 0, "tslc": 0, "flags": 0, "squawk": 0,
    }  # fmt: skip
    with Recorder(tmp_path) as recorder:
        for k in range(20):
            sent = (
                codec.encode("GLOBAL_POSITION_INT", k, 1, 1, time_boot_ms=100 * k, **own, **rest, relative_alt=5000,
                             hdg=0),
                codec.encode("GPS_GLOBAL_ORIGIN", k, 1, 1, **origin),
                codec.encode("LOCAL_POSITION_NED", k, 1, 1, time_boot_ms=100 * k, x=20.0, y=0.0, z=-5.0, **rest),
                codec.encode("ADSB_VEHICLE", k, 255, 156, **aircraft, **other),
            )  # fmt: skip
            recorder.frames(EPOCH_US + 100_000 * k, sent)
    recorded = read_recording(tmp_path / "session.tlog", tmp_path / "session.tlog")
    (own_track,), (others,) = series.tracks(recorded).values(), series.traffic(recorded).values()
    apart_m = np.linalg.norm(others.p_ned[-1] - own_track.p_ned[-1])
    assert apart_m == pytest.approx(3.0, abs=0.02)


def test_frames_lost_in_the_last_second_which_is_not_whole_are_counted(tmp_path: Path) -> None:
    """10 frames a second for 10.9 s; of these one is missing in the 3rd second, and two are in the last."""
    beat = {"type": 2, "autopilot": 12, "base_mode": 0, "custom_mode": 0, "system_status": 4}
    with Recorder(tmp_path) as recorder:
        for k in range(110):
            if k not in (25, 103, 107):
                frame = codec.encode("HEARTBEAT", k, 1, 1, **beat)
                recorder.frames(EPOCH_US + 100_000 * k, [frame])
    recorded = read_recording(tmp_path / "session.tlog", tmp_path / "session.tlog")
    link = series.links(recorded, {})[1]
    assert link.lost.values.tolist() == [0, 0, *[1] * 8, 3]
    assert link.lost.t_s[-1] <= recorded.end_s
    assert link.rate_hz.values.tolist() == [10, 10, 9, *[10] * 7]  # the last second's rate is not known


# folders that lack something


def test_a_whole_session_leaves_only_its_summary_to_be_missed(recorded: Recorded) -> None:
    (problem,) = recorded.problems
    assert problem.startswith("summary.json is missing, as after a session that was killed")


@pytest.mark.parametrize(
    ("gone", "said"),
    [
        ("session.tlog", "session.tlog is missing: paths"),
        ("decisions.jsonl", "decisions.jsonl is missing: plan"),
        ("scenario.yaml", "scenario.yaml is missing: goal"),
    ],
)
def test_a_missing_file_costs_what_it_alone_could_tell(tmp_path: Path, gone: str, said: str) -> None:
    record(tmp_path / "session")
    (tmp_path / "session" / gone).unlink()
    found = Findings(read(tmp_path / "session"))
    assert any(problem.startswith(said) for problem in found.recorded.problems)
    assert bool(found.tracks) == (gone != "session.tlog")
    assert bool(found.errors) == (gone == "scenario.yaml")
    assert found.outcome == "No outcome is known"


def test_what_is_no_session_is_called_so(tmp_path: Path) -> None:
    with pytest.raises(NoSession, match="is no folder"):
        read(tmp_path / "none")
    with pytest.raises(NoSession, match=r"holds none of session\.tlog"):
        read(tmp_path)
