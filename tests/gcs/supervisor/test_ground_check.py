"""The check list of one vehicle that learns its place late, as an ArduCopter does; the frames are pymavlink's."""

from typing import Any

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.scenario.model import Scenario
from gcs.supervisor.ground_check import GroundCheck

TICK_S = 0.1
PLACE_S, HEALTHY_S = 41.0, 42.0


class LateLink:
    """Link to vehicle 3, whose streams come as they are asked for, its place from PLACE_S on or never."""

    joined = frozenset({(3, 1)})

    def __init__(self, *, knows_its_place: bool) -> None:
        self.knows_its_place = knows_its_place
        self.now_s = 0.0
        self.sender = mav.MAVLink(None, srcSystem=3, srcComponent=1)

    def collect(self) -> dict[tuple[int, int], list[codec.Frame]]:
        tick, boot_ms = round(self.now_s / TICK_S), round(1e3 * self.now_s)
        healthy = mav.MAV_SYS_STATUS_PREARM_CHECK if self.now_s >= HEALTHY_S else 0
        said: list[Any] = [mav.MAVLink_attitude_message(boot_ms, *[0.0] * 6)]
        if self.knows_its_place and self.now_s >= PLACE_S:
            said.append(mav.MAVLink_local_position_ned_message(boot_ms, *[0.0] * 6))
        if tick % 5 == 0:
            said += [
                mav.MAVLink_heartbeat_message(2, 3, 81, 0, 3, 3),
                mav.MAVLink_extended_sys_state_message(0, 1),
                mav.MAVLink_battery_status_message(0, 0, 1, 32767, [4000] * 4 + [65535] * 6, 0, 0, 0, 90),
                mav.MAVLink_sys_status_message(mav.MAV_SYS_STATUS_PREARM_CHECK, 0, healthy, 0, 16000, 0, 90, *[0] * 6),
            ]
        raw = b"".join(bytes(message.pack(self.sender)) for message in said)
        return {(3, 1): codec.split(raw).frames}

    def grant(self, *_: Any) -> None:
        """Nothing that is said to it matters."""

    def offsets_s(self) -> dict[int, float]:
        return {3: 0.0}

    def pop_rebooted(self) -> tuple[int, ...]:
        return ()

    def links(self) -> dict[int, Any]:
        return {}


def checked_until_ready(link: LateLink) -> tuple[float, dict[str, bool]]:
    """When the check has ended as `--wait-ready` ends it, and what passed."""
    external = {"connect": "udpin:127.0.0.1:14550", "sysid": 3, "capacity_j": 1e5}
    scenario = Scenario.model_validate({
        "schema": 1, "name": "late", "axes": "ned", "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0},
        "goal": {"duration_s": 60.0},
        "vehicles": {"pursuers": [{"external": external}]},
    })  # fmt: skip
    check = GroundCheck(scenario, link)  # type: ignore[arg-type]
    while not (check.done and check.ready):
        assert link.now_s < 100.0
        link.now_s += TICK_S
        check.tick(link.now_s, 0)
    return link.now_s, {item.key: item.passed for item in check.lists({})[3]}


def test_streams_that_begin_when_it_is_ready_are_counted_before_they_are_judged() -> None:
    ended_s, passed = checked_until_ready(LateLink(knows_its_place=True))
    assert (passed["ready"], passed["streams"]) == (True, True)
    assert HEALTHY_S <= ended_s < HEALTHY_S + 6.0


def test_a_stream_that_never_comes_is_waited_for_no_longer_than_a_count_takes() -> None:
    ended_s, passed = checked_until_ready(LateLink(knows_its_place=False))
    assert (passed["ready"], passed["streams"]) == (True, False)
    assert ended_s < HEALTHY_S + 12.0
