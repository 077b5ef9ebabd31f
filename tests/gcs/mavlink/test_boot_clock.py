"""A vehicle's clock seen from the session's: offsets that the test itself makes are found again."""

import pytest

from gcs.mavlink import codec
from gcs.mavlink.boot_clock import BootClock, ComparedClocks

OFFSET_S = 812.5
POSITION, ATTITUDE = 32, 30


def test_the_offset_is_that_of_the_message_that_came_the_quickest_way() -> None:
    clock = BootClock()
    assert clock.offset_s is None
    for k, delay_s in enumerate((0.08, 0.02, 0.3, 0.05)):
        clock.feed(POSITION, 0.1 * k, 0.1 * k + OFFSET_S + delay_s)
    assert clock.offset_s == pytest.approx(OFFSET_S + 0.02)


def test_a_simulated_autopilots_clock_is_followed_closely() -> None:
    """A PX4 in its own simulator lost 0.7 s in 100 s on a busy machine: at 2 m/s nobody is carried 10 cm too far."""
    clock = BootClock()
    for k in range(1000):
        clock.feed(POSITION, 0.1 * k * (1.0 - 0.007), 0.1 * k + OFFSET_S)
        assert 2.0 * (0.1 * k * 0.007 + OFFSET_S - clock.offset_s) < 0.1  # type: ignore[operator]


def test_another_boot_begins_a_new_offset_and_a_message_that_was_overtaken_does_not() -> None:
    clock = BootClock()
    for kind in (POSITION, ATTITUDE):
        assert not clock.feed(kind, 100.0, 100.0 + OFFSET_S)
    assert not clock.feed(POSITION, 99.8, 100.1 + OFFSET_S)
    assert clock.feed(POSITION, 0.5, 130.0)
    assert not clock.feed(ATTITUDE, 0.5, 130.0), "a boot is said once"
    assert clock.offset_s == pytest.approx(129.5)


def test_copies_that_go_another_way_for_seconds_are_no_boots() -> None:
    clock = BootClock()
    for k in range(600, 1200):
        assert not clock.feed(POSITION, 0.1 * k, 0.1 * k + OFFSET_S)
        assert not clock.feed(POSITION, 0.1 * k - 2.5, 0.1 * k + OFFSET_S)
    assert clock.offset_s == pytest.approx(OFFSET_S)
    assert clock.feed(POSITION, 50.0, 180.0 + OFFSET_S), "after a minute in which nothing came"


def test_a_message_whose_time_is_never_filled_in_is_no_boot_beside_one_whose_time_is() -> None:
    """MAVSDK's server plugins send ATTITUDE with time 0 beside a LOCAL_POSITION_NED that counts."""
    clock = BootClock()
    for k in range(100):
        assert not clock.feed(POSITION, 0.1 * k, 0.1 * k + OFFSET_S)
        assert not clock.feed(ATTITUDE, 0.0, 0.1 * k + OFFSET_S)
    assert clock.offset_s == pytest.approx(OFFSET_S)


def test_clocks_are_compared_of_some_vehicles_and_their_boots_told_once() -> None:
    clocks = ComparedClocks([(1, 1), (2, 1)])
    still = dict.fromkeys(("roll", "pitch", "yaw", "rollspeed", "pitchspeed", "yawspeed"), 0.0)

    def hear(sysid: int, boot_ms: int, arrival_s: float) -> None:
        attitude = codec.encode("ATTITUDE", 0, sysid, 1, time_boot_ms=boot_ms, **still)
        beat = codec.encode("HEARTBEAT", 1, sysid, 1, type=2, autopilot=3, base_mode=0, custom_mode=0, system_status=3)
        clocks.feed((sysid, 1), codec.split(attitude + beat).frames, arrival_s)

    assert clocks
    assert not ComparedClocks()
    assert clocks.offsets_s() == {}
    hear(1, 5_000, 12.0)
    hear(3, 5_000, 99.0)  # of whom nobody asked
    assert clocks.offsets_s() == {1: 7.0}
    assert clocks.pop_rebooted() == set()
    hear(2, 1_000, 12.0)
    hear(1, 500, 13.0)
    assert clocks.offsets_s() == {1: 12.5, 2: 11.0}
    assert clocks.pop_rebooted() == {1}
    assert clocks.pop_rebooted() == set()
