"""Flown by MAVSDK, in the peers' own Python: `with_mavsdk.py PORT SCENE [SYSIDS]`; fails where a scene does."""

import asyncio
import contextlib
import math
import sys
import time

from mavsdk.asyncio import ComponentType, Configuration, Mavsdk
from mavsdk.asyncio.plugins.action import ActionAsync, ActionError
from mavsdk.asyncio.plugins.failure import FailureAsync, FailureError, FailureType, FailureUnit
from mavsdk.asyncio.plugins.follow_me import Config, FollowMeAsync, FollowMeError, TargetLocation
from mavsdk.asyncio.plugins.mission import MissionAsync, MissionItem, MissionPlan
from mavsdk.asyncio.plugins.offboard import OffboardAsync, PositionNedYaw, VelocityBodyYawspeed, VelocityNedYaw
from mavsdk.asyncio.plugins.param import ParamAsync, ParamError
from mavsdk.asyncio.plugins.telemetry import FlightMode, LandedState, TelemetryAsync

WITHIN_S = 90.0
PER_M = math.degrees(1.0 / 6.37e6)
NAN = float("nan")
OF_MANY = ("four", "looks_on")
"""Scenes that get all pilots by system id; the others get the first vehicle's."""


async def first_that(what, ask, updates, holds, within_s=WITHIN_S):
    """The first answer that holds, of what is known now and of every update after it."""
    answers, last = asyncio.Queue(), None

    async def listen():
        async for answer in updates():
            answers.put_nowait(answer)

    async def look():
        answers.put_nowait(await ask())

    try:
        async with asyncio.timeout(within_s), asyncio.TaskGroup() as group:
            # tasks begin in order: it listens before it looks, so that nothing falls between
            tasks = [group.create_task(listen()), group.create_task(look())]
            while last is None or not holds(last):
                last = await answers.get()
            for task in tasks:
                task.cancel()
    except TimeoutError:
        raise AssertionError(f"{what}: not within {within_s} s; last: {last}") from None
    return last


async def until(what, source, name, holds, within_s=WITHIN_S):
    """The first value of a plugin's that holds."""
    return await first_that(what, getattr(source, name), getattr(source, f"subscribe_{name}"), holds, within_s)


async def next_of(updates, count):
    """The next updates of a stream, as they come."""
    async with contextlib.aclosing(updates()) as stream, asyncio.timeout(WITHIN_S):
        return [await anext(stream) for _ in range(count)]


class Pilot:
    """One vehicle with the plugins that fly it."""

    def __init__(self, system):
        self.system = system
        self.action, self.telemetry = ActionAsync(system), TelemetryAsync(system)
        self.offboard, self.param = OffboardAsync(system), ParamAsync(system)
        self.mission, self.follow_me = MissionAsync(system), FollowMeAsync(system)
        self.failure = FailureAsync(system)

    async def mode(self, wanted):
        await until(f"mode {wanted.name}", self.telemetry, "flight_mode", lambda mode: mode == wanted)

    async def near(self, north, east, down, within_m=0.4):
        def there(m):
            p = m.position
            return math.dist((p.north_m, p.east_m, p.down_m), (north, east, down)) < within_m

        await until(f"{north}, {east}, {down}", self.telemetry, "position_velocity_ned", there)

    async def ready(self):
        await until("health_all_ok", self.telemetry, "health_all_ok", bool)

    async def in_air(self):
        await self.ready()
        await self.action.arm()
        await until("armed", self.telemetry, "armed", bool)
        await self.action.takeoff()
        await until("in_air", self.telemetry, "in_air", bool)
        await self.mode(FlightMode.HOLD)

    async def down_and_disarmed(self):
        await until("landed", self.telemetry, "landed_state", lambda s: s == LandedState.ON_GROUND)
        await until("disarmed", self.telemetry, "armed", lambda armed: not armed)


async def flight(pilot):
    """Arm, take-off, hold, goto, return, land, disarm; what telemetry tells meanwhile; parameters."""
    await pilot.in_air()
    telemetry = pilot.telemetry
    home = await until("home", telemetry, "home", lambda h: math.isfinite(h.latitude_deg))
    assert abs(home.latitude_deg - 47.397742) < 1e-5
    position = await telemetry.position()
    assert 0.5 < position.relative_altitude_m < 5.0, position
    battery = await telemetry.battery()
    assert 0.0 < battery.remaining_percent <= 100.0, battery
    assert 10.0 < battery.voltage_v < 20.0, battery
    assert abs((await telemetry.attitude_euler()).roll_deg) < 30.0
    assert abs((await telemetry.attitude_quaternion()).w) <= 1.0
    await pilot.action.hold()
    lat, lon = home.latitude_deg + 3.0 * PER_M, home.longitude_deg
    await pilot.action.goto_location(lat, lon, home.absolute_altitude_m + 2.5, NAN)
    await pilot.near(3.0, 0.0, -2.5)
    await pilot.param.set_param_float("MPC_LAND_SPEED", 2.0)
    assert await pilot.param.get_param_float("MPC_LAND_SPEED") == 2.0
    assert await pilot.param.get_param_int("SYS_AUTOSTART") == 4001
    for refused in (
        pilot.param.set_param_float("MPC_LAND_SPEED", 99.0),
        pilot.param.get_param_float("NO_SUCH"),
        pilot.param.set_param_int("MPC_LAND_SPEED", 1),
    ):
        began_s = time.monotonic()
        try:
            await refused
        except ParamError:
            assert time.monotonic() - began_s < 1.0
        else:
            raise AssertionError("a bad parameter was taken")
    assert await pilot.param.get_param_float("MPC_LAND_SPEED") == 2.0
    everything = await pilot.param.get_all_params()
    assert len(everything.float_params) + len(everything.int_params) > 30
    await pilot.action.set_takeoff_altitude(3.0)
    assert await pilot.action.get_takeoff_altitude() == 3.0
    await pilot.action.return_to_launch()
    await pilot.mode(FlightMode.RETURN_TO_LAUNCH)
    await pilot.down_and_disarmed()
    await pilot.action.arm()
    await until("armed", telemetry, "armed", bool)
    await pilot.action.disarm()
    await until("disarmed", telemetry, "armed", lambda armed: not armed)


async def offboard(pilot):
    """Offboard by position, by velocity, by velocity and turn of the body's own, then land."""
    await pilot.in_air()
    await pilot.offboard.set_position_ned(PositionNedYaw(1.5, 1.0, -2.0, 0.0))
    await pilot.offboard.start()
    await pilot.mode(FlightMode.OFFBOARD)
    await pilot.near(1.5, 1.0, -2.0)
    await pilot.offboard.set_velocity_ned(VelocityNedYaw(1.0, 0.0, 0.0, 0.0))
    await until("1 m/s", pilot.telemetry, "velocity_ned", lambda v: abs(v.north_m_s - 1.0) < 0.15)
    await pilot.offboard.set_velocity_body(VelocityBodyYawspeed(0.5, 0.0, 0.0, 40.0))
    await until("turned east", pilot.telemetry, "attitude_euler", lambda a: a.yaw_deg > 90.0)
    await until("0.5 m/s east", pilot.telemetry, "velocity_ned", lambda v: v.east_m_s > 0.4)
    await pilot.offboard.stop()
    await pilot.mode(FlightMode.HOLD)
    await pilot.action.land()
    await pilot.mode(FlightMode.LAND)
    await pilot.down_and_disarmed()


def waypoint(home, north_m, east_m, height_m, speed_m_s=NAN, wait_s=NAN, stop=False):
    lat = home.latitude_deg + north_m * PER_M
    lon = home.longitude_deg + east_m * PER_M / math.cos(math.radians(home.latitude_deg))
    item = MissionItem()
    item.latitude_deg, item.longitude_deg, item.relative_altitude_m = lat, lon, height_m
    item.speed_m_s, item.loiter_time_s, item.is_fly_through = speed_m_s, wait_s, not stop
    return item


async def mission(pilot):
    """Uploaded, downloaded, flown, paused, continued, flown to its end with a return; cleared."""
    await pilot.ready()
    home = await until("home", pilot.telemetry, "home", lambda h: math.isfinite(h.latitude_deg))
    items = [
        waypoint(home, 0, 0, 2.0, 3.0),
        waypoint(home, 6, 0, 2.5, 2.0),
        waypoint(home, 6, 5, 3.0, 3.0, wait_s=1.0, stop=True),
    ]
    await pilot.mission.set_return_to_launch_after_mission(True)
    await pilot.mission.upload_mission(MissionPlan(items))
    back = await pilot.mission.download_mission()
    assert len(back.mission_items) == 3, back
    assert abs(back.mission_items[1].latitude_deg - items[1].latitude_deg) < 1e-6
    await pilot.action.arm()
    await pilot.mission.start_mission()
    await pilot.mode(FlightMode.MISSION)
    await until("first item", pilot.mission, "mission_progress", lambda p: p.current >= 1)
    await pilot.mission.pause_mission()
    await pilot.mode(FlightMode.HOLD)
    progress = await pilot.mission.mission_progress()
    assert progress.total == 3, progress
    await pilot.mission.start_mission()
    await pilot.mode(FlightMode.MISSION)
    await until("finished", pilot.mission, "mission_progress", lambda p: p.current == p.total)
    await pilot.down_and_disarmed()
    p = (await pilot.telemetry.position_velocity_ned()).position
    assert math.hypot(p.north_m, p.east_m) < 0.5, p
    await pilot.mission.clear_mission()
    assert (await pilot.mission.download_mission()).mission_items == []


async def follow(pilot):
    """Follow-me behind a target that walks north."""
    await pilot.in_air()
    home = await pilot.telemetry.home()
    config = Config()
    config.follow_height_m, config.follow_distance_m, config.responsiveness = 8.0, 3.0, 0.1
    config.follow_angle_deg, config.max_tangential_vel_m_s = 180.0, 4.0
    await pilot.follow_me.set_config(config)
    await pilot.follow_me.start()
    await pilot.mode(FlightMode.FOLLOW_ME)
    north_m = 4.0
    for _ in range(60):
        target = TargetLocation()
        target.latitude_deg, target.longitude_deg = home.latitude_deg + north_m * PER_M, home.longitude_deg
        target.absolute_altitude_m = home.absolute_altitude_m
        target.velocity_x_m_s, target.velocity_y_m_s, target.velocity_z_m_s = 0.5, 0.0, 0.0
        try:
            await pilot.follow_me.set_target_location(target)
        except FollowMeError as error:  # MAVSDK's telemetry knows the mode a moment before its follow_me does
            if north_m > 4.5 or "NOT_ACTIVE" not in str(error):
                raise
        await asyncio.sleep(0.2)
        north_m += 0.1
        p = (await pilot.telemetry.position_velocity_ned()).position
        if math.dist((p.north_m, p.east_m, -p.down_m), (north_m - 3.0, 0.0, 8.0)) < 1.0:
            break
    else:
        raise AssertionError(f"target at {north_m}, vehicle at {p}")
    await pilot.follow_me.stop()
    await pilot.mode(FlightMode.HOLD)
    await pilot.action.land()


async def allow_failures(pilot):
    """Set SYS_FAILURE_EN; the plugin reads it when it is made, and only then."""
    await pilot.param.set_param_int("SYS_FAILURE_EN", 1)
    pilot.failure.destroy()
    pilot.failure = FailureAsync(pilot.system)
    async with contextlib.aclosing(pilot.telemetry.subscribe_position()) as stream, asyncio.timeout(6.0):
        async for _ in stream:
            try:
                await pilot.failure.inject(FailureUnit.SYSTEM_BATTERY, FailureType.OK, 0)
            except FailureError:
                continue
            break


async def failures(pilot):
    """Refused until SYS_FAILURE_EN allows it; then each, with what telemetry says of it."""
    await pilot.in_air()
    try:
        await pilot.failure.inject(FailureUnit.SENSOR_GPS, FailureType.OFF, 0)
        raise AssertionError("a failure was injected without leave")
    except FailureError:
        pass
    await allow_failures(pilot)
    await pilot.failure.inject(FailureUnit.SYSTEM_BATTERY, FailureType.OFF, 0)
    await until("empty", pilot.telemetry, "battery", lambda b: b.remaining_percent == 0.0)
    await pilot.mode(FlightMode.LAND)
    await pilot.failure.inject(FailureUnit.SYSTEM_BATTERY, FailureType.OK, 0)
    await pilot.action.hold()
    await pilot.failure.inject(FailureUnit.SENSOR_GPS, FailureType.OFF, 0)
    await until("no fix", pilot.telemetry, "gps_info", lambda g: g.num_satellites == 0)
    await pilot.mode(FlightMode.LAND)
    await pilot.down_and_disarmed()
    await until("unhealthy", pilot.telemetry, "health_all_ok", lambda ok: not ok)
    try:
        await pilot.action.arm()
        raise AssertionError("armed without GPS")
    except ActionError:
        pass
    await pilot.failure.inject(FailureUnit.SENSOR_GPS, FailureType.OK, 0)
    await pilot.in_air()
    await pilot.failure.inject(FailureUnit.SYSTEM_MAVLINK_SIGNAL, FailureType.OFF, 0)
    connected = pilot.system.is_connected, pilot.system.is_connected_state
    await first_that("silent", *connected, lambda connected: not connected)


async def motor(pilot):
    """A motor is lost: down, crashed and disarmed."""
    await pilot.in_air()
    await allow_failures(pilot)
    await pilot.failure.inject(FailureUnit.SYSTEM_MOTOR, FailureType.OFF, 1)
    await pilot.down_and_disarmed()


async def identity(pilot):
    """Arm, take-off, hold, goto and return under another autopilot's numbers; integers in its own encoding."""
    await pilot.ready()
    await pilot.action.arm()
    await until("armed", pilot.telemetry, "armed", bool)
    await pilot.action.takeoff()
    await until("high", pilot.telemetry, "position", lambda p: p.relative_altitude_m > 1.8)
    await pilot.action.hold()
    await pilot.mode(FlightMode.HOLD)
    home = await pilot.telemetry.home()
    altitude_m = home.absolute_altitude_m + 2.5
    await pilot.action.goto_location(home.latitude_deg + 2.0 * PER_M, home.longitude_deg, altitude_m, NAN)
    await pilot.near(2.0, 0.0, -2.5)
    await pilot.offboard.set_position_ned(PositionNedYaw(1.0, 1.0, -2.0, 0.0))
    await pilot.offboard.start()
    await pilot.near(1.0, 1.0, -2.0)
    assert await pilot.param.get_param_int("SYS_AUTOSTART") == 4001
    await pilot.param.set_param_int("SYS_AUTOSTART", 10016)
    assert await pilot.param.get_param_int("SYS_AUTOSTART") == 10016
    await pilot.action.return_to_launch()
    await pilot.mode(FlightMode.RETURN_TO_LAUNCH)
    await pilot.down_and_disarmed()


async def rebooted(pilot):
    """A parameter and the length of a mission after a reboot, both having been changed before it."""
    await pilot.ready()
    home = await until("home", pilot.telemetry, "home", lambda h: math.isfinite(h.latitude_deg))
    await pilot.param.set_param_float("MPC_XY_CRUISE", 3.5)
    await pilot.mission.upload_mission(MissionPlan([waypoint(home, 0, 0, 2.0), waypoint(home, 6, 0, 2.5)]))
    await pilot.action.reboot()
    kept = await pilot.mission.download_mission()
    return await pilot.param.get_param_float("MPC_XY_CRUISE"), len(kept.mission_items)


async def reboot_keeps(pilot):
    """A changed parameter and a mission are still there."""
    assert await rebooted(pilot) == (3.5, 2)


async def reboot_forgets(pilot):
    """A changed parameter is what it was at start, and there is no mission."""
    assert await rebooted(pilot) == (5.0, 0)


async def looks_on(pilots):
    """Another ground station flies them: each is looked at in the air. Then whoever is named on stdin is landed."""
    for sysid, pilot in pilots.items():
        await until("in_air", pilot.telemetry, "in_air", bool)
        await pilot.mode(FlightMode.OFFBOARD)
        await until("high", pilot.telemetry, "position_velocity_ned", lambda m: m.position.down_m < -1.0)
        print(f"sees {sysid}", flush=True)
    while line := await asyncio.to_thread(sys.stdin.readline):
        pilot = pilots[int(line)]
        await pilot.action.land()
        await pilot.mode(FlightMode.LAND)
        await pilot.down_and_disarmed()
        print(f"landed {int(line)}", flush=True)


async def four(pilots):
    """Four on one port: each obeys its own orders and nobody else's."""
    first, second, third, fourth = (pilots[sysid] for sysid in sorted(pilots))
    for pilot in pilots.values():
        await pilot.ready()
    await second.action.arm()
    await until("second armed", second.telemetry, "armed", bool)
    for other in (first, third, fourth):
        assert await next_of(other.telemetry.subscribe_armed, 2) == [False, False]
    await second.action.takeoff()
    await until("second in air", second.telemetry, "in_air", bool)
    await fourth.in_air()
    assert [await p.telemetry.in_air() for p in (first, second, third, fourth)] == [False, True, False, True]
    await second.offboard.set_position_ned(PositionNedYaw(2.0, 4.0, -3.0, 0.0))
    await second.offboard.start()
    await fourth.offboard.set_velocity_ned(VelocityNedYaw(0.5, 0.0, 0.0, 0.0))
    await fourth.offboard.start()
    await second.near(2.0, 4.0, -3.0)
    moving = await fourth.telemetry.velocity_ned()
    assert abs(moving.north_m_s - 0.5) < 0.15, moving
    for pilot in (first, third):
        assert await pilot.telemetry.flight_mode() == FlightMode.HOLD
        assert not await pilot.telemetry.armed()
    await second.action.land()
    await second.mode(FlightMode.LAND)
    assert await fourth.telemetry.flight_mode() == FlightMode.OFFBOARD
    await second.down_and_disarmed()
    assert await fourth.telemetry.in_air()


async def main():
    port, scene, *sysids = sys.argv[1:]
    wanted = {int(sysid) for sysid in sysids} or {1}
    configuration = Configuration.create_with_component_type(ComponentType.GROUND_STATION)
    async with Mavsdk(configuration) as mavsdk:
        await mavsdk.add_any_connection(f"udpin://127.0.0.1:{port}")
        print("listens", flush=True)

        async def known():
            return {await s.get_system_id(): s for s in await mavsdk.get_systems()}

        async def new():
            async for _ in mavsdk.on_new_system():
                yield await known()

        systems = await first_that("systems", known, new, lambda found: set(found) >= wanted)
        pilots = {sysid: Pilot(systems[sysid]) for sysid in wanted}
        began_s = time.monotonic()
        await globals()[scene](pilots if scene in OF_MANY else pilots[1])
        print(f"{scene}: flown in {time.monotonic() - began_s:.1f} s", flush=True)


asyncio.run(main())
