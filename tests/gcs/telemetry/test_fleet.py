"""Telemetry in, SI and the common frame out. Frames are built by pymavlink's own encoder; ledgers are added by hand."""

import math
from typing import Any

import pymap3d
import pytest
from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec
from gcs.mavlink.autopilots import PX4, FlightMode, Profile
from gcs.telemetry.fleet import Fleet, GlobalOrigin
from gcs.telemetry.state import FleetSnapshot, VehicleView
from gcs.telemetry.track import Member

ORIGIN = GlobalOrigin(47.397742, 8.545594, 488.0)
DEG_E7 = (473977420, 85455940, 488000)
CAPACITY_J, INITIAL_J = 24_000.0, 18_000.0


def frame(kind: str, sysid: int = 3, compid: int = 1, **fields: Any) -> codec.Frame:
    """One message as pymavlink sends it."""
    sender = mav.MAVLink(None, srcSystem=sysid, srcComponent=compid)
    cls = getattr(mav, f"MAVLink_{kind.lower()}_message")
    content = dict.fromkeys(cls.fieldnames, 0) | {"mavlink_version": 3} | fields
    raw = cls(**{name: content[name] for name in cls.fieldnames}).pack(sender)
    return codec.split(bytes(raw)).frames[0]


def heartbeat(custom_mode: int = 6 << 16, base_mode: int = 0x81, autopilot: int = 12, **sender: int) -> codec.Frame:
    return frame("HEARTBEAT", type=2, autopilot=autopilot, base_mode=base_mode, custom_mode=custom_mode, **sender)


def position(t_ms: int = 0, at: tuple[float, ...] = (1.5, -2.5, -3.5), v: tuple[float, ...] = (0.5, 0.25, -0.125),
             **sender: int) -> codec.Frame:  # fmt: skip
    axes: dict[str, Any] = dict(zip(("x", "y", "z", "vx", "vy", "vz"), (*at, *v), strict=True))
    return frame("LOCAL_POSITION_NED", time_boot_ms=t_ms, **axes, **sender)


def origin(lat: int = DEG_E7[0], lon: int = DEG_E7[1], alt: int = DEG_E7[2]) -> codec.Frame:
    return frame("GPS_GLOBAL_ORIGIN", latitude=lat, longitude=lon, altitude=alt)


def battery(energy_consumed: int = -1, battery_remaining: int = -1, battery_id: int = 0) -> codec.Frame:
    return frame(
        "BATTERY_STATUS", id=battery_id, energy_consumed=energy_consumed, battery_remaining=battery_remaining,
        voltages=[65535] * 10, voltages_ext=[0] * 4, current_battery=-1, current_consumed=-1,
    )  # fmt: skip


def counter(name: str, value: int, t_ms: int = 0) -> codec.Frame:
    return frame("NAMED_VALUE_INT", name=name.encode(), value=value, time_boot_ms=t_ms)


def parameter(name: str, value: float) -> codec.Frame:
    return frame("PARAM_VALUE", param_id=name.encode(), param_value=value, param_type=9, param_count=1)


@pytest.fixture
def fleet() -> Fleet:
    members = [
        Member(200, "tanker", "tanker 200", 150_000.0, 150_000.0),
        Member(3, "pursuer", "pursuer 3", CAPACITY_J, INITIAL_J),
    ]
    return Fleet(members, ORIGIN)


def seen(fleet: Fleet, *frames: codec.Frame, at_s: float = 0.0) -> VehicleView:
    for one in frames:
        fleet.ingest(one, at_s)
    return fleet.snapshot(at_s).vehicle(3)


def test_a_heartbeat_tells_autopilot_mode_and_arming(fleet: Fleet) -> None:
    view = seen(fleet, heartbeat(), at_s=1.5)
    assert (view.profile, view.mode, view.armed, view.last_received_s) == (PX4, FlightMode.OFFBOARD, True, 1.5)
    view = seen(fleet, heartbeat(base_mode=0x01, custom_mode=9, autopilot=3))
    assert (view.profile.name, view.mode, view.armed) == ("ardupilot", FlightMode.LAND, False)


def test_a_hold_after_the_take_off_is_known_until_something_else_was_flown(fleet: Fleet) -> None:
    """Take-off, hold, offboard, hold, by PX4's numbers of AUTO.TAKEOFF, AUTO.LOITER and OFFBOARD."""
    takeoff, loiter, offboard = 4 << 16 | 2 << 24, 4 << 16 | 3 << 24, 6 << 16
    flown = [seen(fleet, heartbeat(mode)) for mode in (loiter, takeoff, loiter, offboard, loiter)]
    assert [view.has_climbed for view in flown] == [False, True, True, False, False]


def test_what_a_vehicle_has_and_uses_and_says_is_out_of_order_is_unhealthy(fleet: Fleet) -> None:
    has, uses, healthy = 0b1110 << 28, 0b0111 << 28, 0b1101 << 28
    assert seen(fleet, heartbeat()).unhealthy == 0
    said = {"onboard_control_sensors_present": has, "onboard_control_sensors_enabled": uses}
    assert seen(fleet, frame("SYS_STATUS", **said, onboard_control_sensors_health=healthy)).unhealthy == 1 << 29
    assert seen(fleet, frame("SYS_STATUS", **said, onboard_control_sensors_health=has)).unhealthy == 0


@pytest.mark.parametrize(
    ("status", "base_mode", "failsafe"),
    [(mav.MAV_STATE_ACTIVE, 0x81, False), (mav.MAV_STATE_CRITICAL, 0x81, True), (mav.MAV_STATE_CRITICAL, 0x01, False)],
)
def test_a_heartbeat_tells_whether_a_failsafe_flies(fleet: Fleet, status: int, base_mode: int, failsafe: bool) -> None:
    """As a PX4 1.17 said it when its set points ceased, and when its battery was low."""
    assert seen(fleet, heartbeat(base_mode=base_mode, system_status=status)).failsafe is failsafe


def test_a_mode_that_was_reported_long_ago_is_not_believed_until_the_next_heartbeat(fleet: Fleet) -> None:
    """A vehicle that was silent may have changed it: its first message may be of its place."""
    assert seen(fleet, heartbeat(), origin(), position(0)).fresh
    assert seen(fleet, position(5900), at_s=5.9).fresh
    late = seen(fleet, position(6100), at_s=6.1)
    assert (late.fresh, fleet.snapshot(6.1).columns.fresh[0]) == (False, False)
    again = seen(fleet, heartbeat(), at_s=6.2)
    assert (again.fresh, fleet.snapshot(6.2).columns.fresh[0]) == (True, True)


def test_nothing_is_known_of_a_place_before_the_origin(fleet: Fleet) -> None:
    assert seen(fleet).p_ned is None
    assert seen(fleet, position()).p_ned is None
    assert not seen(fleet, heartbeat(), frame("EXTENDED_SYS_STATE", landed_state=2)).flying
    assert seen(fleet, origin()).flying


def test_a_vehicle_at_the_common_origin_is_where_it_says(fleet: Fleet) -> None:
    view = seen(fleet, origin(), position())
    assert view.p_ned == pytest.approx((1.5, -2.5, -3.5), abs=1e-3)
    assert view.v_ned == (0.5, 0.25, -0.125)


def test_an_arcsecond_of_latitude_is_the_published_length_of_one(fleet: Fleet) -> None:
    """Length of a degree of latitude on WGS 84 at 47.4°: 111 132.954 - 559.822 cos 2φ + 1.175 cos 4φ m."""
    phi = math.radians(47.397742)
    degree_m = 111_132.954 - 559.822 * math.cos(2 * phi) + 1.175 * math.cos(4 * phi)
    view = seen(fleet, origin(lat=DEG_E7[0] + round(1e7 / 3600), alt=488_000 + 7_250), position())
    assert view.origin_offset_ned is not None
    assert view.origin_offset_ned[0] == pytest.approx(degree_m / 3600, rel=2e-4)
    assert view.origin_offset_ned[1:] == pytest.approx((0.0, -7.25), abs=1e-3)
    assert view.ground_amsl_m == 495.25


@pytest.mark.parametrize("away", [(300.0, -120.0, 15.0), (-2500.0, 1800.0, -40.0)])
def test_the_offset_is_the_inverse_of_geodesy(fleet: Fleet, away: tuple[float, float, float]) -> None:
    lat, lon, alt = pymap3d.ned2geodetic(*away, ORIGIN.lat_deg, ORIGIN.lon_deg, ORIGIN.alt_m)
    there = origin(round(1e7 * float(lat)), round(1e7 * float(lon)), round(1e3 * float(alt)))
    # 1e-7 degrees are 11 mm.
    assert seen(fleet, there, position(at=(0, 0, 0))).p_ned == pytest.approx(away, abs=0.012)


def test_a_position_is_as_old_as_its_own_time_and_carried_forward(fleet: Fleet) -> None:
    seen(fleet, origin(), position(t_ms=2000), at_s=2.2)
    view = fleet.snapshot(2.4).vehicle(3)
    assert view.age_s == pytest.approx(0.4)
    assert view.p_now_ned() == pytest.approx((1.7, -2.4, -3.55), abs=1e-3)


def test_a_position_is_never_from_the_future(fleet: Fleet) -> None:
    assert seen(fleet, origin(), position(t_ms=99_000), at_s=2.0).age_s == 0.0
    assert fleet.snapshot(3.0).vehicle(3).age_s == 1.0


def test_an_older_position_that_comes_late_does_not_replace_a_newer_one(fleet: Fleet) -> None:
    view = seen(fleet, origin(), position(t_ms=2000, at=(2, 0, 0)), position(t_ms=1900, at=(1, 0, 0)), at_s=2.0)
    assert view.p_ned == pytest.approx((2, 0, 0), abs=1e-3)


def test_a_way_is_from_each_report_to_the_next_also_of_two_in_one_tick_and_across_a_silence(fleet: Fleet) -> None:
    said = position(0, (1.0, 0.0, -3.0)), position(100, (4.0, 4.0, -3.0)), position(200, (4.0, 4.0, -5.0))
    assert seen(fleet, origin(), *said, at_s=0.3).way_m == 7.0
    assert seen(fleet, position(150, (40.0, 4.0, -5.0)), at_s=0.4).way_m == 7.0
    assert seen(fleet, at_s=5.0).way_m == 7.0
    assert seen(fleet, position(5_000, (10.0, 12.0, -5.0)), at_s=5.0).way_m == 17.0


def test_a_battery_is_empty_by_its_percentage_though_its_total_is_rounded_down(fleet: Fleet) -> None:
    all_but_one = round(INITIAL_J / 100.0) - 1
    assert not seen(fleet, parameter("SIM_BAT_INIT_J", INITIAL_J), battery(all_but_one, 1)).battery_empty
    view = seen(fleet, battery(all_but_one, 0))
    assert (view.remaining_j, view.battery_empty) == (100.0, True)
    assert not seen(fleet, battery(all_but_one, 40)).battery_empty


def test_numbers_that_are_none_change_nothing(fleet: Fleet) -> None:
    nan = math.nan
    before = seen(fleet, origin(), position(), frame("ATTITUDE", yaw=0.5), parameter("SIM_BAT_CAP_J", 20_000.0),
                  frame("NAMED_VALUE_FLOAT", name=b"CtlEffort", value=5.0))  # fmt: skip
    after = seen(fleet, position(at=(nan, 0, 0)), position(v=(0, math.inf, 0)), frame("ATTITUDE", yaw=nan),
                 parameter("SIM_BAT_CAP_J", nan), parameter("SIM_BAT_INIT_J", -5.0),
                 frame("NAMED_VALUE_FLOAT", name=b"CtlEffort", value=nan))  # fmt: skip
    assert after._replace(doubt="") == before
    assert after.doubt
    assert (after.heading_rad, after.control_effort, after.capacity_j) == (0.5, 5.0, 20_000.0)


def test_wrong_senders_are_not_believed(fleet: Fleet) -> None:
    before = fleet.snapshot(0.0)
    senders: tuple[dict[str, Any], ...] = ({"sysid": 4}, {"compid": 100}, {"sysid": 255, "compid": 190})
    for sender in senders:
        fleet.ingest(heartbeat(**sender), 0.0)
        fleet.ingest(position(**sender), 0.0)
    assert fleet.snapshot(0.0) == before
    fleet.ingest(codec.Frame(3, 1, 0, 380, b"\xfd\0\0\0\0\3\1\x7c\1\0ab"), 0.0)
    after = fleet.snapshot(0.0).vehicle(3)
    assert after._replace(last_message_s=-math.inf) == before.vehicle(3)
    assert after.silent_s(0.5) == 0.5


def test_need_and_remaining_are_the_ledger_by_hand(fleet: Fleet) -> None:
    view = seen(
        fleet, parameter("SIM_BAT_CAP_J", 20_000.0), parameter("SIM_BAT_INIT_J", 16_000.0),
        battery(energy_consumed=73), counter("XferIn", 2_500), counter("XferOut", 200),
    )  # fmt: skip
    # 16 000 + 2 500 - 73 hJ - 200
    assert view.remaining_j == 11_000.0
    assert view.need == pytest.approx(0.45)
    assert view.battery_reported
    assert view.energy_source == "energy_consumed"


def test_counters_and_consumption_never_fall(fleet: Fleet) -> None:
    view = seen(fleet, battery(50), battery(49), counter("XferOut", 9), counter("XferOut", 7), counter("XferIn", -1))
    assert (view.drawn_j, view.given_j, view.received_j) == (5000.0, 9, 0)


def test_a_counter_is_as_new_as_it_was_sent(fleet: Fleet) -> None:
    """Whether a giver's counter may be a transfer's start depends on it; the radio may hold it back."""
    assert seen(fleet, counter("XferOut", 0, t_ms=1200), at_s=3.0).given_reported_s == 1.2
    assert seen(fleet, counter("XferOut", 0, t_ms=1000), at_s=3.1).given_reported_s == 1.2


def test_power_is_what_a_window_of_5_s_shows(fleet: Fleet) -> None:
    for k in range(21):  # 200 W for 5 s, then 400 W for 5 s
        t = 0.5 * k
        drawn_j = 200.0 * min(t, 5.0) + 400.0 * max(t - 5.0, 0.0)
        fleet.ingest(battery(round(drawn_j / 100)), t)
        power_w = fleet.snapshot(t).vehicle(3).power_w
        if t > 0:
            assert power_w == pytest.approx(drawn_j / t if t <= 5 else (drawn_j - 200.0 * (t - 5)) / 5, abs=40.0)
    assert power_w == pytest.approx(400.0)
    assert fleet.snapshot(10.0).vehicle(3).endurance_s == pytest.approx((18_000 - 3_000) / 400.0)


def test_without_a_draw_it_lasts_for_ever(fleet: Fleet) -> None:
    assert seen(fleet).endurance_s == math.inf


def test_a_vehicle_that_counts_no_energy_is_read_by_its_percentage(fleet: Fleet) -> None:
    """PX4's simulator: energy_consumed is -1 (docs/how-to/external-autopilots.md#what-real-autopilots-report)."""
    view = seen(fleet, parameter("SIM_BAT_INIT_J", INITIAL_J), battery(battery_remaining=70))
    assert view.energy_source == "battery_remaining"
    assert view.remaining_j == pytest.approx(0.7 * CAPACITY_J)
    view = seen(fleet, counter("XferIn", 2_000), battery(battery_remaining=78))
    assert view.remaining_j == pytest.approx(0.78 * CAPACITY_J)
    assert view.drawn_j == pytest.approx(INITIAL_J + 2_000 - 0.78 * CAPACITY_J)


def test_the_first_percentage_is_the_start_of_a_vehicle_that_names_none(fleet: Fleet) -> None:
    """docs/protocol/energy.md#energy-accounting: initial is the parameter, else the first battery_remaining."""
    view = seen(fleet, battery(energy_consumed=10, battery_remaining=50))
    assert view.initial_j == pytest.approx(0.5 * CAPACITY_J + 1000)
    assert view.remaining_j == pytest.approx(0.5 * CAPACITY_J)
    assert seen(fleet, battery(energy_consumed=20, battery_remaining=40)).initial_j == view.initial_j
    assert seen(fleet, parameter("SIM_BAT_INIT_J", 15_000.0)).initial_j == 15_000.0
    assert seen(fleet, battery(energy_consumed=20, battery_remaining=1)).initial_j == 15_000.0


def test_traffic_is_read_in_the_units_of_adsb(fleet: Fleet) -> None:
    lat, lon, alt = pymap3d.ned2geodetic(40.0, -30.0, -20.0, ORIGIN.lat_deg, ORIGIN.lon_deg, ORIGIN.alt_m)
    fleet.ingest(
        frame(
            "ADSB_VEHICLE", 255, 156, ICAO_address=7, lat=round(1e7 * float(lat)), lon=round(1e7 * float(lon)),
            altitude=round(1e3 * float(alt)), heading=9000, hor_velocity=150, ver_velocity=50, callsign=b"NORTH1",
            tslc=1,
        ),
        4.0,
    )  # fmt: skip
    (aircraft,) = fleet.snapshot(4.5).traffic
    assert aircraft.callsign == "NORTH1"
    assert aircraft.p_ned == pytest.approx((40.0, -30.0, -20.0), abs=0.012)
    assert aircraft.v_ned == pytest.approx((0.0, 1.5, -0.5))  # heading east, climbing
    assert aircraft.age_s == pytest.approx(1.5)


def test_traffic_that_is_silent_for_long_is_forgotten(fleet: Fleet) -> None:
    fleet.ingest(frame("ADSB_VEHICLE", 255, 156, ICAO_address=7, callsign=b"A"), 0.0)
    assert len(fleet.snapshot(10.0).traffic) == 1
    assert fleet.snapshot(10.1).traffic == ()


def test_texts_and_acknowledgements_are_taken_once(fleet: Fleet) -> None:
    fleet.ingest(frame("STATUSTEXT", severity=4, text=b"Battery low"), 0.0)
    fleet.ingest(frame("COMMAND_ACK", command=400, result=2, target_system=255, target_component=190), 0.0)
    assert fleet.pop_statustexts(0.0) == [(3, 4, "Battery low")]
    ((sysid, ack),) = fleet.pop_acks()
    assert (sysid, ack.command, ack.result) == (3, 400, 2)
    assert fleet.pop_statustexts(0.0) == []
    assert fleet.pop_acks() == []


def test_a_dead_vehicle_does_not_fly(fleet: Fleet) -> None:
    assert seen(fleet, heartbeat(), origin(), position(), frame("EXTENDED_SYS_STATE", landed_state=2)).flying
    fleet.lost(3)
    assert not seen(fleet).flying


def test_vehicles_stand_in_order_and_unknown_ones_are_an_error(fleet: Fleet) -> None:
    snapshot: FleetSnapshot = fleet.snapshot(0.0)
    assert [view.sysid for view in snapshot.vehicles] == [3, 200]
    assert [view.sysid for view in snapshot.of_role("tanker")] == [200]
    with pytest.raises(KeyError):
        snapshot.vehicle(9)


def test_a_text_in_chunks_is_told_as_one(fleet: Fleet) -> None:
    words = "A sentence of more than fifty characters comes in two parts, or in three if it is longer than a hundred."
    for seq, part in enumerate((words[:50], words[50:100], words[100:])):
        seen(fleet, frame("STATUSTEXT", severity=4, text=part.encode(), id=7, chunk_seq=seq))
    seen(fleet, frame("STATUSTEXT", severity=6, text=b"Short\t"))
    assert fleet.pop_statustexts(0.0) == [(3, 4, words), (3, 6, "Short")]


# vehicles that the session has not launched


def strangers(profile: Profile | None = None) -> Fleet:
    return Fleet([Member(3, "pursuer", "pursuer 3", CAPACITY_J, CAPACITY_J, external=True, profile=profile)], ORIGIN)


def home(at: tuple[float, float, float], local: tuple[float, float, float]) -> codec.Frame:
    lat, lon, alt = (float(x) for x in pymap3d.ned2geodetic(*at, ORIGIN.lat_deg, ORIGIN.lon_deg, ORIGIN.alt_m))
    return frame(
        "HOME_POSITION", latitude=round(1e7 * lat), longitude=round(1e7 * lon), altitude=round(1e3 * alt),
        x=local[0], y=local[1], z=local[2], q=[1.0, 0.0, 0.0, 0.0],
    )  # fmt: skip


def test_a_strangers_time_is_its_own_and_told_by_its_clock() -> None:
    fleet = strangers()
    for one in (heartbeat(), origin()):
        fleet.ingest(one, 10.0)
    fleet.set_clock(3, -590.0)
    fleet.ingest(position(t_ms=600_000), 10.3)
    assert fleet.snapshot(10.5).vehicle(3).age_s == pytest.approx(0.5)
    fleet.set_clock(3, 300.0)  # it has booted: another clock, whose times are the later ones all the same
    fleet.ingest(position(t_ms=1_000), 301.2)
    assert fleet.snapshot(301.2).vehicle(3).age_s == pytest.approx(0.2)


@pytest.mark.parametrize("autopilot", [12, 0])
def test_home_aligns_a_frame_whose_origin_is_not_told(autopilot: int) -> None:
    """Home lies 30 m north of the scenario's origin and 4 m north of the vehicle's own."""
    fleet = strangers()
    for one in (
        heartbeat(autopilot=autopilot),
        home((30.0, -7.0, 2.0), (4.0, 0.0, -1.0)),
        position(at=(1.0, 2.0, -5.0)),
    ):
        fleet.ingest(one, 0.0)
    view = fleet.snapshot(0.0).vehicle(3)
    assert view.p_ned == pytest.approx((27.0, -5.0, -2.0), abs=0.01)
    assert view.height_m == pytest.approx(4.0, abs=0.01)
    assert view.ground_amsl_m == pytest.approx(486.0, abs=0.01)
    lat, lon, alt = pymap3d.ned2geodetic(0.0, 100.0, 0.0, ORIGIN.lat_deg, ORIGIN.lon_deg, ORIGIN.alt_m)
    fleet.ingest(origin(round(1e7 * lat), round(1e7 * lon), round(1e3 * alt)), 1.0)
    assert fleet.snapshot(1.0).vehicle(3).p_ned == pytest.approx((1.0, 102.0, -5.0), abs=0.02)


def test_arducopters_home_does_not_align_it_since_it_says_nothing_of_its_frame() -> None:
    fleet = strangers()
    for one in (heartbeat(autopilot=3, custom_mode=4), home((30.0, 0.0, 2.0), (0.0, 0.0, 0.0)), position()):
        fleet.ingest(one, 0.0)
    view = fleet.snapshot(0.0).vehicle(3)
    assert (view.p_ned, view.origin_offset_ned) == (None, None)
    assert view.ground_amsl_m == pytest.approx(486.0, abs=0.01)


def test_a_stranger_that_never_says_whether_it_has_landed_is_in_the_air_when_it_is_high() -> None:
    fleet = strangers()
    for one in (heartbeat(), origin(), position(at=(0.0, 0.0, -0.1))):
        fleet.ingest(one, 0.0)
    assert fleet.snapshot(0.0).vehicle(3).landed
    fleet.ingest(position(t_ms=100, at=(0.0, 0.0, -1.0)), 0.1)
    assert fleet.snapshot(0.1).vehicle(3).flying
    fleet.ingest(frame("EXTENDED_SYS_STATE", landed_state=1), 0.2)
    assert fleet.snapshot(0.2).vehicle(3).landed


def test_the_scenario_may_know_better_than_the_heartbeat_whose_habits_a_vehicle_has() -> None:
    fleet = strangers(PX4)
    fleet.ingest(heartbeat(autopilot=0), 0.0)
    assert fleet.snapshot(0.0).vehicle(3).profile is PX4


def test_a_lost_vehicle_may_be_found_again() -> None:
    fleet = strangers()
    fleet.lost(3)
    assert not fleet.snapshot(0.0).vehicle(3).alive
    fleet.found(3)
    assert fleet.snapshot(0.0).vehicle(3).alive
