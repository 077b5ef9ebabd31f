"""Lockstep: the same session is the same to the last bit, whatever the machine and the datagrams do."""

from __future__ import annotations

import contextlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from sessions import Outcome, fly, merged, raw_frames, small

DURATION_S = 20.0
BUSY = "while True: sum(range(10_000))"


def session(**changes: object) -> dict[str, object]:
    return merged(small(goal={"duration_s": DURATION_S, "refuelled_at_least": 0}), changes)


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Outcome:
    return fly(session(), tmp_path_factory.mktemp("plain"), "--plain")


@contextlib.contextmanager
def busy_cores(count: int) -> Iterator[None]:
    with contextlib.ExitStack() as stack:
        for _ in range(count):
            process = stack.enter_context(subprocess.Popen([sys.executable, "-c", BUSY]))
            stack.callback(process.kill)
        yield


def vehicle_frames(outcome: Outcome) -> list[bytes]:
    """What the vehicles sent, without their sequence numbers."""
    return [bytes(m.get_msgbuf())[5:-2] for _, m in outcome.messages("LOCAL_POSITION_NED") if m.get_srcSystem() < 255]


def test_it_is_the_same_to_the_last_byte_on_a_loaded_machine_and_by_another_seed_where_nothing_is_lost(
    plain: Outcome, tmp_path: Path
) -> None:
    with busy_cores(2):
        loaded = fly(session(), tmp_path, "--plain", "--seed", "7")
    assert loaded.summary["digest"] == plain.summary["digest"]
    assert (loaded.folder / "session.tlog").read_bytes() == (plain.folder / "session.tlog").read_bytes()


def test_the_digest_is_the_same_with_datagrams_dropped_and_sent_again(plain: Outcome, tmp_path: Path) -> None:
    dropped = fly(session(), tmp_path, "--plain", "--drop-datagrams", "0.05")
    assert dropped.summary["digest"] == plain.summary["digest"]
    assert dropped.summary["link"]["lost"] == 0


def test_the_digest_is_the_same_when_paced(plain: Outcome, tmp_path: Path) -> None:
    paced = fly(session(clock={"mode": "real", "speed": 20.0}), tmp_path, "--plain")
    assert paced.summary["digest"] == plain.summary["digest"]
    assert paced.summary["speed_achieved"] <= 20.5


def test_under_radio_loss_another_seed_makes_another_session(tmp_path: Path) -> None:
    """The same seed makes the same one: tests/system/test_base.py, test_onboard.py."""
    radio = session(radio={"loss": 0.2})
    one, other = (fly(radio, tmp_path / seed, "--plain", "--seed", seed) for seed in "12")
    assert one.summary["digest"] != other.summary["digest"]
    assert one.summary["link"]["lost"] > 0
    assert (one.truth(1).state[-1] != other.truth(1).state[-1]).any()


def test_one_changed_set_point_changes_the_vehicles_own_frames_and_the_digest(plain: Outcome, tmp_path: Path) -> None:
    moved = session()
    moved["vehicles"]["targets"][0]["path_m"] = [[0.0, 0.001, -2.5]]  # type: ignore[index]
    changed = fly(moved, tmp_path, "--plain")
    assert changed.summary["digest"] != plain.summary["digest"]
    assert vehicle_frames(changed) != vehicle_frames(plain)


def test_the_tlog_is_in_session_time_and_in_order(plain: Outcome) -> None:
    times = [t_s - plain.epoch_s for t_s, *_ in raw_frames(plain.folder / "session.tlog")]
    assert times == sorted(times)
    assert times[0] == pytest.approx(0.0, abs=1e-6)
    assert times[-1] == pytest.approx(DURATION_S, abs=1e-6)
