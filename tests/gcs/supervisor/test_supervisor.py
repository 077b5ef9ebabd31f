"""One tick, top to bottom, over a link whose vehicles follow a script."""

import json
from typing import Any

import numpy as np
import pytest

from gcs.mavlink import codec
from gcs.supervisor.arming import Stage

HOLD, OFFBOARD, SET_MODE = 4 << 16 | 3 << 24, 6 << 16, 176


def test_the_first_grant_is_time_zero_and_every_tick_grants_one_period_more(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    assert [t_ms for t_ms, key, _ in session.link.bundles if key == (1, 1)] == [0, 100, 200, 300]
    for t_ms, _, frames in session.link.bundles:
        last = codec.fields(frames[-1])
        assert (type(last).__name__, last.time_boot_ms) == ("SYSTEM_TIME", t_ms)
        assert last.time_unix_usec == session.supervisor.epoch_us + 1000 * t_ms


def test_how_late_a_tick_is_is_asked_once_its_answers_are_in(scripted: Any) -> None:
    session = scripted()
    answered: list[int] = []

    def periods() -> int:
        answered.append(len(session.link.answered))
        return 3

    session.supervisor.tick(lambda: None, periods)
    assert answered == [1]
    assert session.supervisor.time_ms == 300


def test_bundles_go_out_in_order_of_system_id(scripted: Any) -> None:
    session = scripted()
    session.fly(2)
    assert [key[0] for _, key, _ in session.link.bundles] == [1, 101, 201] * 3


def test_every_vehicle_hears_a_heartbeat_once_a_second(scripted: Any) -> None:
    session = scripted()
    session.fly(35)
    for key in session.link.joined:
        granted = [t_ms for t_ms, _ in session.link.sent("HEARTBEAT", key)]
        # The first comes with grant 0; those due at 1, 2 and 3 s leave with the grants that follow these times.
        assert granted == [0, 1100, 2100, 3100]


def test_frames_are_recorded_in_the_order_in_which_they_came(scripted: Any) -> None:
    session = scripted()
    session.fly(5)
    session.recorder.close()
    data, frames, at = (session.folder / "session.tlog").read_bytes(), [], 0
    while at < len(data):
        end = at + 8 + 12 + data[at + 9]
        frames.append(data[at + 8 : end])
        at = end
    came = [frame.raw for frame in frames_of(session.link.answered)]
    assert [raw for raw in frames if raw[5] != 255] == came
    assert session.supervisor.received == len(came)
    assert session.supervisor.sent == len(frames) - len(came)
    assert session.supervisor.gaps.lost == 0


def frames_of(ticks: list[list[codec.Frame]]) -> list[codec.Frame]:
    return [frame for tick in ticks for frame in tick]


@pytest.mark.parametrize("offset", [(0.0, 0.0, 0.0), (120.0, -80.0, 15.0)])
def test_set_points_are_in_the_vehicles_own_frame_with_position_and_velocity(scripted: Any, offset: Any) -> None:
    session = scripted(offset=offset)
    session.fly(4)
    decided = [json.loads(line) for line in _decisions(session)]
    planned = [d for d in decided if d["kind"] == "set_point" and d["sysid"] == 1]
    sent = session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1))
    assert len(sent) == len(planned) > 0
    for (t_ms, content), plan in zip(sent, planned, strict=True):
        # Ignored: acceleration 64 + 128 + 256, yaw 1024, yaw rate 2048.
        assert (content.type_mask, content.coordinate_frame) == (3520, 1)
        assert (content.target_system, content.target_component) == (1, 1)
        assert content.time_boot_ms == t_ms - 100
        common = [x + o for x, o in zip((content.x, content.y, content.z), offset, strict=True)]
        assert common == pytest.approx(plan["p_ned"], abs=0.012)
        assert (content.vx, content.vy, content.vz) == pytest.approx(plan["v_ned"], abs=1e-6)


def test_a_vehicle_whose_own_origin_moves_is_sent_its_set_points_in_the_new_frame(scripted: Any) -> None:
    session = scripted()
    session.fly(4)
    session.link.vehicles[(1, 1)].offset = moved = (25.0, -10.0, 3.0)
    session.fly(3)
    planned = [d for d in map(json.loads, _decisions(session)) if d["kind"] == "set_point" and d["sysid"] == 1]
    sent = [content for _, content in session.link.sent("SET_POSITION_TARGET_LOCAL_NED", (1, 1))]
    assert len(sent) == len(planned) == 7
    for k, (content, plan) in enumerate(zip(sent, planned, strict=True)):
        origin = moved if k >= 4 else (0.0, 0.0, 0.0)
        common = [x + o for x, o in zip((content.x, content.y, content.z), origin, strict=True)]
        assert common == pytest.approx(plan["p_ned"], abs=0.012)


def _decisions(session: Any) -> list[str]:
    session.recorder.close()
    return list((session.folder / "decisions.jsonl").read_text().splitlines())


def test_grants_are_exempt_from_the_radio_and_nothing_else_is(scripted: Any) -> None:
    session = scripted(radio={"loss": 1.0})
    session.fly(10)
    for t_ms, _, frames in session.link.bundles:
        assert [frame.msgid for frame in frames] == [codec.msgid("SYSTEM_TIME")], t_ms
    assert session.supervisor.snapshot.vehicle(1).p_ned is None
    assert session.supervisor.received == 30  # one SYSTEM_TIME each
    assert session.supervisor.arming[1].stage is Stage.IDENTIFY


@pytest.mark.parametrize("loss", [0.2, 0.5, 1.0])
def test_the_loss_that_is_shown_is_that_of_the_radio(scripted: Any, loss: float) -> None:
    """The SYSTEM_TIME of answers, which the radio never loses, does not count; nor does a replay count it."""
    session = scripted(radio={"loss": loss}, goal={"duration_s": 200.0})
    shares = []
    for _ in range(6):
        session.fly(110)
        shares += [session.supervisor.quality.lost_share(sysid) for sysid in (1, 101, 201)]
    assert np.mean(shares) == pytest.approx(loss, abs=0.03)


def test_the_digest_is_the_same_again_and_another_for_one_set_point(scripted: Any) -> None:
    def digest(nudge_m: float = 0.0) -> str:
        session = scripted()
        for tick in range(20):
            if tick == 10:
                session.supervisor.planner._p_ned[0, 0] += nudge_m
            session.fly(1)
        return str(session.supervisor.digest.hexdigest())

    assert digest() == digest() != digest(1e-4)


def test_the_seed_changes_what_a_lossy_radio_loses(scripted: Any) -> None:
    digests = []
    for seed in (1, 1, 2):
        session = scripted(radio={"loss": 0.2}, seed=seed)
        session.fly(20)
        digests.append(session.supervisor.digest.hexdigest())
    assert digests[0] == digests[1] != digests[2]
    assert session.supervisor.gaps.lost > 0


def test_what_vehicles_say_and_what_is_decided_are_events(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1})
    pursuer = session.link.vehicles[1, 1]
    pursuer.more = [("STATUSTEXT", {"severity": 4, "text": "Battery low"})]
    pursuer.energy_hj = 80
    session.fly(40)
    events = [(event.sysid, event.level, event.text) for event in session.supervisor.events]
    assert (1, "warning", "Battery low") in events
    assert (1, "info", "Refuelling of 1 by 201 decided, unopposed") in events
    assert [e["receiver"] for e in map(json.loads, _decisions(session)) if e["kind"] == "decided"] == [1]


def test_a_command_that_nobody_answers_is_told_and_counted(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1})
    session.link.vehicles[1, 1].energy_hj = 80
    tanker = session.link.vehicles[201, 1]
    tanker.hear = lambda _: None
    session.fly(60)
    texts = [event.text for event in session.supervisor.events if event.sysid == 201]
    assert texts == ["Command 511 (refuel 1 stream) timed out"]
    assert session.supervisor.command_queue.resent == 3


def test_in_silence_a_pilots_command_is_repeated_but_never_lined_up(scripted: Any) -> None:
    session = scripted()
    deaf = session.link.vehicles[1, 1]
    deaf.hear, deaf.custom_mode = (lambda _: None), HOLD
    session.fly(200)
    # 0.5 s apart, as the command protocol repeats it; never two at once.
    sent = _set_modes(session)
    assert len(sent) == len(set(sent)) > 25
    deaf.acks = [SET_MODE]
    session.fly(5)
    assert len(_set_modes(session)) <= len(sent) + 1


def test_what_a_stage_asked_for_is_not_repeated_once_its_vehicle_has_gone_on(scripted: Any) -> None:
    """It would bring the vehicle back: a take-off repeated in offboard ends that."""
    session = scripted()
    deaf = session.link.vehicles[1, 1]
    deaf.hear, deaf.custom_mode = (lambda _: None), HOLD
    session.fly(12)
    assert _set_modes(session)
    deaf.custom_mode = OFFBOARD
    session.fly(1)
    sent = _set_modes(session)
    session.fly(30)
    assert _set_modes(session) == sent
    assert not [event for event in session.supervisor.events if "timed out" in event.text]


def _set_modes(session: Any) -> list[int]:
    sent = session.link.sent("COMMAND_LONG", (1, 1))
    return [t_ms for t_ms, content in sent if content.command == SET_MODE]


def test_a_dead_vehicle_is_told_and_the_others_fly_on(scripted: Any) -> None:
    session = scripted()
    session.fly(10)
    session.supervisor.lose((1, 1), "pursuer 1 (process 9) was killed by signal 9")
    session.fly(10)
    assert session.supervisor.events[-1].level == "critical"
    assert not session.supervisor.snapshot.vehicle(1).alive
    assert session.supervisor.arming[1].stage is Stage.DOWN
    (death,) = [d for d in map(json.loads, _decisions(session)) if d["kind"] == "death"]
    assert death == {"t_s": 1.0, "kind": "death", "sysid": 1, "text": "pursuer 1 (process 9) was killed by signal 9"}
    assert max(t_ms for t_ms, key, _ in session.link.bundles if key == (1, 1)) == 1000
    assert session.link.bundles[-1][0] == 2000


def test_one_that_dies_after_it_has_landed_is_dead_too(scripted: Any) -> None:
    session = scripted()
    session.fly(5)
    session.supervisor.arming[1].stage = Stage.DOWN
    session.supervisor.lose((1, 1), "gone")
    session.fly(1)
    assert not session.supervisor.snapshot.vehicle(1).flying


def test_a_late_vehicle_gets_its_first_grant_at_its_time(scripted: Any) -> None:
    battery = {"capacity_j": 20_000.0}
    late = {"sysid": 1, "start_m": (3.0, 0.0, -4.0), "airborne": True, "battery": battery, "join_s": 0.5}
    other = {"sysid": 101, "start_m": (0.0, 0.0, -4.0), "airborne": True, "battery": battery, "speed_m_s": 1.0,
             "path_m": [(0.0, 0.0, -4.0)]}  # fmt: skip
    tanker = {"sysid": 201, "start_m": (-6.0, 0.0, -4.0), "airborne": True, "battery": battery}
    session = scripted(vehicles={"pursuers": [late], "targets": [other], "tankers": [tanker]})
    session.fly(8)
    assert [t_ms for t_ms, key, _ in session.link.bundles if key == (1, 1)][:2] == [500, 600]
    assert session.supervisor.targets_move


def test_partners_frames_are_relayed_with_their_headers(scripted: Any) -> None:
    session = scripted(competition={"need_from": 0.1})
    session.link.vehicles[1, 1].energy_hj = 80
    session.fly(40)
    counters = {1: ("XferIn", 5), 201: ("XferOut", 7)}
    for sysid, (name, value) in counters.items():
        content = {"name": name, "value": value, "time_boot_ms": 0}
        session.link.vehicles[sysid, 1].more = [("NAMED_VALUE_INT", content)]
    session.fly(1)
    raw = {f.sysid: f.raw for f in session.link.answered[-1] if f.msgid == codec.msgid("NAMED_VALUE_INT")}
    bundles = {key[0]: frames for _, key, frames in session.link.bundles[-3:]}
    assert raw[201] in [frame.raw for frame in bundles[1]]
    assert raw[1] in [frame.raw for frame in bundles[201]]
    assert all(frame.sysid == 255 for frame in bundles[101])


def test_finishing_takes_the_last_answers_and_sends_nothing(scripted: Any) -> None:
    session = scripted()
    session.fly(3)
    sent, before = session.supervisor.sent, session.supervisor.received
    session.supervisor.finish(lambda: None)
    assert session.supervisor.sent == sent
    assert session.supervisor.received == before + len(session.link.answered[-1])


def test_a_boot_of_an_external_vehicle_is_recorded_and_its_arming_sequence_learns_of_it(
    scripted: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    def flown_by(sysid: int, **more: Any) -> dict[str, Any]:
        return {"external": {"connect": "udpin:127.0.0.1:14550", "sysid": sysid, "capacity_j": 1e5}, **more}

    path_m = [(0.0, 0.0, -4.0), (30.0, 0.0, -4.0)]
    vehicles = {
        "pursuers": [flown_by(1)], "targets": [flown_by(101, path_m=path_m, speed_m_s=0.8)],
        "tankers": [flown_by(201, reserve_j=0.0, home_m=(-6.0, 0.0, 0.0))],
    }  # fmt: skip
    session = scripted(clock={"mode": "real", "speed": 1}, vehicles=vehicles, goal={"duration_s": 60.0})
    rebooted: set[int] = set()
    session.link.pop_relinked, session.link.clock_offsets_s, session.link.unawaited_s = set, dict, lambda: 5.0
    session.link.pop_rebooted = lambda: set(rebooted)
    said: list[tuple[float, float]] = []
    monkeypatch.setattr(session.supervisor.preflight, "receive", lambda *of: said.append(of[2:]))
    session.fly(20)
    assert said[0] == (0.0, 5.0)  # the wall clock, on which it lives, is ahead of the ticks
    arming = session.supervisor.arming[1]
    assert (arming.stage, arming.booted) == (Stage.FLY, False)
    session.link.vehicles[1, 1].base_mode, session.link.vehicles[1, 1].custom_mode = 0x01, 4 << 16 | 3 << 24
    rebooted.add(1)
    session.fly(1)
    assert (arming.stage, arming.booted) == (Stage.DOWN, True)
    rebooted.clear()
    session.fly(1)
    session.recorder.close()
    recorded = map(json.loads, (session.folder / "decisions.jsonl").read_text(encoding="utf-8").splitlines())
    assert [(line["kind"], line["sysid"]) for line in recorded if line["kind"] == "boot"] == [("boot", 1)]
