"""Faults of a scenario: what may stand there, and how the seed draws them."""

from __future__ import annotations

from pathlib import Path

import pytest

from gcs.scenario.faults import Fault, drawn
from tests.support.scenarios import SMALL, loaded, refusal

BLACKOUT = {"fault": "blackout", "sysid": 1, "for_s": 2.0}
EXTERNAL = SMALL.replace(
    "{sysid: 2, start_m: [5, 0, 0], battery: {capacity_j: 1000}}",
    '{external: {sysid: 2, connect: "udpin:127.0.0.1:14550", capacity_j: 1000}}',
)


def fault(**keys: object) -> Fault:
    return Fault.model_validate(BLACKOUT | keys)


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("fault: blackout, sysid: 1, at_s: 1", "blackout needs for_s"),
        ("fault: kill, sysid: 1, at_s: 1, for_s: 2", "kill has no for_s"),
        ("fault: kill, at_s: 1", "kill needs the sysid of the vehicle that it befalls"),
        ("fault: kill, sysid: 9, at_s: 1", "there is no vehicle 9"),
        ("fault: kill, sysid: 1", "a fault needs either at_s or between_s"),
        ("fault: kill, sysid: 1, at_s: 1, between_s: [1, 2]", "a fault needs either at_s or between_s"),
        ("fault: kill, sysid: 1, between_s: [3, 2]", "between_s needs the earlier time first"),
        ("fault: kill, sysid: 1, at_s: 10", "fault 1 (kill) begins at 10 s, which is not before duration_s"),
        ("fault: tanker_out, sysid: 1, at_s: 1", "pursuer 1 is no tanker"),
        ("fault: loss, at_s: 1, for_s: 2", "loss needs share"),
        ("fault: battery, sysid: 1, at_s: 1, share: 1.5", "less than or equal to 1"),
        ("fault: blackuot, sysid: 1, at_s: 1", "blackout"),
    ],
)
def test_a_fault_that_cannot_be_is_refused_in_one_sentence(tmp_path: Path, line: str, said: str) -> None:
    text = refusal(tmp_path / "one.yaml", f"{SMALL}faults:\n  - {{{line}}}\n")
    assert said in text
    assert len(text.splitlines()) == 1


@pytest.mark.parametrize("kind", ["kill", "hang", "battery, share: 0.5", "gps_jump, jump_m: [1, 0]"])
def test_external_vehicles_have_only_what_a_command_can_carry(tmp_path: Path, kind: str) -> None:
    said = refusal(tmp_path / "one.yaml", f"{EXTERNAL}faults:\n  - {{fault: {kind}, sysid: 2, at_s: 1}}\n")
    assert "pursuer 2 is external" in said
    assert len(said.splitlines()) == 1
    scenario = loaded(tmp_path / "two.yaml", f"{EXTERNAL}faults:\n  - {{fault: gps_off, sysid: 2, at_s: 1}}\n")
    assert scenario.faults[0].fault == "gps_off"


def test_a_vehicle_without_ground_does_not_lose_its_motors(tmp_path: Path) -> None:
    airborne = SMALL.replace("sysid: 1, start_m: [0, 0, 0]", "sysid: 1, airborne: true, start_m: [0, 0, -3]")
    said = refusal(tmp_path / "one.yaml", f"{airborne}faults:\n  - {{fault: motor, sysid: 1, at_s: 1}}\n")
    assert "without a ground that it could fall to" in said


def test_the_seed_decides_what_happens_and_when_and_nothing_else_does() -> None:
    faults = [fault(between_s=(10.0, 20.0), chance=0.3), fault(at_s=5.0), fault(between_s=(0.0, 60.0))]
    assert drawn(faults, 7) == drawn(faults, 7)
    assert {one.number: one.begin_s for one in drawn(faults[:1], 7)}.items() <= {
        one.number: one.begin_s for one in drawn(faults, 7)
    }.items()  # a further fault changes none before it
    seeds = range(1000)
    happened = [one for seed in seeds for one in drawn(faults, seed) if one.number == 1]
    assert 0.25 < len(happened) / len(seeds) < 0.35  # five standard deviations are 0.07
    assert all(10.0 <= one.begin_s <= 20.0 and one.end_s == one.begin_s + 2.0 for one in happened)
    assert 14.0 < sum(one.begin_s for one in happened) / len(happened) < 16.0
    for seed in (1, 2, 3):
        times = [one.begin_s for one in drawn(faults, seed)]
        assert times == sorted(times)
        assert 5.0 in times


@pytest.mark.parametrize(("chance", "count"), [(0.0, 0), (1.0, 200)])
def test_what_is_certain_always_happens_and_what_has_no_chance_never(chance: float, count: int) -> None:
    assert sum(len(drawn([fault(at_s=1.0, chance=chance)], seed)) for seed in range(200)) == count
