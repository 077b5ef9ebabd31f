"""Checks of telemetry that peers expect unasked: heartbeat, flight mode, stream rates, health."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from gcs.cli.check.asking import MAVPROXY, MAVSDK, QGC, judged, to_vehicle
from gcs.cli.check.dialogue import CheckedVehicle, Question, ReceivedMessage, Verdict
from gcs.cli.check.predicates import OK, steady, streamed
from gcs.mavlink.codec import Message
from skytender import mavlink as mav

LISTEN_S = 4.0
MAVSDK_LOSES_S = 3.0


def _stream_request(vehicle: CheckedVehicle) -> Sequence[Message]:
    """ArduPilot's peers ask for its streams; PX4 sends them unasked."""
    if not vehicle.profile.streams_on_request:
        return []
    return to_vehicle("REQUEST_DATA_STREAM", req_stream_id=0, req_message_rate=4, start_stop=1)(vehicle)


def _heartbeat_fault(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    content = vehicle.of("HEARTBEAT")
    if vehicle.compid != mav.MAV_COMP_ID_AUTOPILOT1:
        return Verdict("wrong", f"comes from component {vehicle.compid}, not from 1")
    if not content.base_mode & mav.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED:
        return Verdict("wrong", "MAV_MODE_FLAG_CUSTOM_MODE_ENABLED is not set, so its mode means nothing")
    return OK


def _mode_fault(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    number = vehicle.of("HEARTBEAT").custom_mode
    known = number in mav.MODES[vehicle.profile.mode_table].values()
    return OK if known else Verdict("wrong", f"custom_mode {number} is none of {vehicle.profile.name}'s")


def _autopilot_fault(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    if not vehicle.profile.commanded_by_peers:
        return Verdict("wrong", f"MAV_AUTOPILOT {vehicle.of('HEARTBEAT').autopilot} is neither PX4 nor ArduPilot")
    return OK


def _stream(name: str, hz: float, misses: dict[str, str]) -> Question:
    return judged(f"stream-{name.lower().replace('_', '-')}", f"{name} at {hz:g} Hz", misses, streamed(name, hz))


def _fence(vehicle: CheckedVehicle, received: Sequence[ReceivedMessage]) -> Verdict:
    """A PX4 has a fence, and no word of it in SYS_STATUS: MAVProxy says 'fence breach' of each, once."""
    status = vehicle.of("SYS_STATUS")
    reported = status.onboard_control_sensors_present | status.onboard_control_sensors_enabled
    if not vehicle.profile.fence_in_status and not reported & mav.MAV_SYS_STATUS_GEOFENCE:
        return Verdict("late", "it is not reported, as by PX4 up to 1.18")
    return _health(mav.MAV_SYS_STATUS_GEOFENCE, "GEOFENCE")(vehicle, received)


def _health(bits: int, names: str) -> Callable[[CheckedVehicle, Sequence[ReceivedMessage]], Verdict]:
    def at_end(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
        status = vehicle.of("SYS_STATUS")
        unhealthy = bits & ~status.onboard_control_sensors_health
        return Verdict("wrong", f"onboard_control_sensors_health lacks {unhealthy:#x} ({names})") if unhealthy else OK

    return at_end


def _without_status(vehicle: CheckedVehicle) -> str:
    return "" if vehicle.of("SYS_STATUS") is not None else "there is no SYS_STATUS to read"


SENSORS = (
    mav.MAV_SYS_STATUS_SENSOR_3D_GYRO
    | mav.MAV_SYS_STATUS_SENSOR_3D_ACCEL
    | mav.MAV_SYS_STATUS_SENSOR_3D_MAG
    | mav.MAV_SYS_STATUS_SENSOR_GPS
)
HEARTBEAT_MISSES = {
    MAVSDK: "never discovers the vehicle, or shows flight mode UNKNOWN",
    QGC: "stays at 'Disconnected', or shows no flight mode",
    MAVPROXY: "waits for a heartbeat",
}

PRESENCE = [
    Question(
        "heartbeat",
        "HEARTBEAT of component 1 with a custom mode",
        HEARTBEAT_MISSES,
        lambda *_: None,
        ask=_stream_request,
        at_end=_heartbeat_fault,
        repeat_s=LISTEN_S,
        tries=1,
    ),
    _stream(
        "HEARTBEAT",
        1.0,
        {MAVSDK: "loses the vehicle and finds it again, over and over", QGC: "says that it lost communication"},
    ),
    judged(
        "mode", "a custom mode that the autopilot has", {MAVPROXY: "shows Mode(number) instead of a name"}, _mode_fault
    ),
    judged("autopilot", "an autopilot that peers know", {QGC: "disables take-off, land and return"}, _autopilot_fault),
    _stream("SYS_STATUS", 0.5, {MAVSDK: "health_all_ok never turns true", QGC: "never gets ready to fly"}),
    _stream("ATTITUDE", 1.0, {MAVSDK: "telemetry.attitude_euler() never yields", QGC: "the horizon stands still"}),
    _stream(
        "GLOBAL_POSITION_INT", 1.0, {MAVSDK: "telemetry.position() never yields", QGC: "shows no vehicle on the map"}
    ),
    _stream(
        "LOCAL_POSITION_NED",
        1.0,
        {MAVSDK: "telemetry.position_velocity_ned() never yields, health lacks a local position"},
    ),
    _stream(
        "GPS_RAW_INT",
        0.5,
        {MAVSDK: "telemetry.gps_info() never yields", QGC: "shows no satellites", MAVPROXY: "shows no GPS"},
    ),
    _stream("BATTERY_STATUS", 0.4, {MAVSDK: "telemetry.battery() never yields", QGC: "shows no battery"}),
    judged(
        "health-sensors",
        "SYS_STATUS health of gyroscope, accelerometer, magnetometer and GPS",
        {MAVSDK: "health_all_ok never turns true"},
        _health(SENSORS, "gyro, accel, mag, GPS"),
        when=_without_status,
    ),
    judged(
        "health-prearm",
        "SYS_STATUS health of the pre-arm check",
        {QGC: "says 'Not Ready'"},
        _health(mav.MAV_SYS_STATUS_PREARM_CHECK, "PREARM_CHECK"),
        when=_without_status,
    ),
    judged(
        "health-geofence",
        "SYS_STATUS health of the geofence",
        {MAVPROXY: "prints 'fence breach'"},
        _fence,
        when=_without_status,
    ),
]


def _clock_fault(vehicle: CheckedVehicle, _: Sequence[ReceivedMessage]) -> Verdict:
    if vehicle.backwards:
        return Verdict("wrong", f"{vehicle.backwards}'s time_boot_ms went back")
    return OK


AT_LAST = [
    judged(
        "heartbeat-steady",
        "HEARTBEAT without a pause, all the while",
        {MAVSDK: "says that the vehicle timed out", QGC: "says that it lost communication"},
        steady("HEARTBEAT", MAVSDK_LOSES_S),
    ),
    judged(
        "clock",
        "time_boot_ms never goes back",
        {MAVPROXY: "takes it for a reboot and asks for everything again"},
        _clock_fault,
    ),
]
