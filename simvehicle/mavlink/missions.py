"""Missions, geofence and rally points: the protocol's plans put in force in the vehicle, and their progress
reported."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial

from simvehicle.autopilot.mission import Leg
from simvehicle.autopilot.modes import Mode, Severity
from simvehicle.autopilot.vehicle import Vehicle
from simvehicle.mavlink.codec import message
from simvehicle.mavlink.context import Call, ServiceContext, Store, unwritten
from simvehicle.mavlink.mission_protocol import MissionProtocol, Post
from simvehicle.mavlink.plan_items import (
    Item,
    PlanError,
    check_item,
    fence_from,
    item_from,
    item_of,
    legs_from,
    rally_from,
    row_of,
)
from simvehicle.mavlink.telemetry import message_of
from skytender import mavlink as mav

GUIDED_ITEM = 2
"""MISSION_ITEM.current of an item that is no part of a mission: fly there now."""
CURRENT_HZ = 1.0
STOPPED_US = -1
"""MESSAGE_INTERVAL of a message that is not streamed."""


class Planning:
    """One vehicle's plans."""

    def __init__(self, context: ServiceContext) -> None:
        self._context = context
        self.protocol = MissionProtocol(self._accept, self._check)

    def _accept(self, kind: int, items: tuple[Item, ...]) -> None:
        _put_in_force(self._context, kind, items, self._context.store)

    def _check(self, kind: int, number: int, item: Item) -> None:
        vehicle = self._context.vehicle
        with _refusals_announced(vehicle):
            item_0_is_home = vehicle.identity.item_0_is_home
            check_item(
                kind, number, item, vehicle.frame, home_down_m=vehicle.home_ned[2], item_0_is_home=item_0_is_home
            )

    def restart(self) -> None:
        """Have what the store has kept, and nothing else; a plan that is refused now is none."""
        self.protocol.forget()
        store = self._context.store
        for kind, rows in store.plans.items() if store is not None else ():
            items = tuple(map(item_of, rows))
            with contextlib.suppress(PlanError):
                _put_in_force(self._context, kind, items)
                self.protocol.plans[kind] = items

    def receive(self, call: Call) -> None:
        """Act on a message of the mission protocol."""
        content, peer, channel, protocol = call.content, call.sender, call.connection, self.protocol
        now_s = self._context.vehicle.time_s
        match call.frame.msgid:
            case mav.MAVLINK_MSG_ID_MISSION_COUNT:
                _send(protocol.count(content, peer, channel, now_s))
            case mav.MAVLINK_MSG_ID_MISSION_ITEM_INT | mav.MAVLINK_MSG_ID_MISSION_ITEM:
                if content.current == GUIDED_ITEM and self._context.vehicle.identity.guided:
                    _send([Post(channel, self._go_there(call))])
                else:
                    _send(protocol.item(content, peer, channel, now_s))
            case mav.MAVLINK_MSG_ID_MISSION_REQUEST_LIST:
                _send(protocol.send_count(content, peer, channel))
            case mav.MAVLINK_MSG_ID_MISSION_REQUEST_INT | mav.MAVLINK_MSG_ID_MISSION_REQUEST:
                _send(protocol.request(content, peer, channel, current=self._current(), home=self._home()))
            case mav.MAVLINK_MSG_ID_MISSION_CLEAR_ALL:
                _send(protocol.clear(content, peer, channel))
            case mav.MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST:
                _send(protocol.partial(content, peer, channel))
            case mav.MAVLINK_MSG_ID_MISSION_ACK:
                protocol.cancel(content, peer)
            case mav.MAVLINK_MSG_ID_MISSION_SET_CURRENT:
                mission = self._context.vehicle.mission
                if mission is None or not mission.go_to(content.seq):
                    self._context.vehicle.announce(Severity.WARNING, f"Mission has no item {content.seq}")
                self._send_current()
                if channel.streams.interval_us(mav.MAVLINK_MSG_ID_MISSION_CURRENT) == STOPPED_US:
                    channel.put(message_of(self._context.vehicle, "MISSION_CURRENT"))

    @property
    def at_work(self) -> bool:
        """Whether something may become due while no message comes."""
        return self.protocol.at_work or self._context.vehicle.mission is not None

    def report(self) -> None:
        """Queue what is due: requests repeated, and items reached since the last time."""
        _send(self.protocol.due(self._context.vehicle.time_s))
        mission = self._context.vehicle.mission
        if mission is None or not mission.reached:
            return
        for seq in mission.reached:
            for connection in self._context.connections:
                connection.put(message("MISSION_ITEM_REACHED")(seq=seq))
        mission.reached.clear()
        self._send_current()

    def _current(self) -> int:
        mission = self._context.vehicle.mission
        return 0 if mission is None else mission.index

    def _home(self) -> Item | None:
        """Home as an item, as AP_Mission writes it, where missions begin with it."""
        vehicle = self._context.vehicle
        if not vehicle.identity.item_0_is_home:
            return None
        lat, lon, alt = vehicle.frame.to_global(*vehicle.home_ned)
        x, y = round(1e7 * lat), round(1e7 * lon)
        return Item(mav.MAV_CMD_NAV_WAYPOINT, mav.MAV_FRAME_GLOBAL, (0.0, 0.0, 0.0, 0.0), x, y, alt)

    def _send_current(self) -> None:
        for connection in self._context.connections:
            connection.streams.hasten("MISSION_CURRENT", self._context.vehicle.time_ms)

    def _go_there(self, call: Call) -> object:
        """A waypoint to fly to at once, as ArduPilot's ground stations send it in GUIDED; refused in other modes, as
        ArduCopter does."""
        vehicle = self._context.vehicle
        spoken = vehicle.identity.spoken
        result = mav.MAV_MISSION_ACCEPTED
        try:
            if spoken[vehicle.mode] != spoken[Mode.GUIDED]:
                raise PlanError("not in guided mode", mav.MAV_MISSION_ERROR)
            (leg,) = _legs(vehicle, [item_from(call.content)], item_0_is_home=False)
            place = leg.place
            if place.north_m is None or place.east_m is None or place.height_m is None:
                raise PlanError("no place", mav.MAV_MISSION_INVALID)
            down_m = (vehicle.home_ned[2] if place.above_home else 0.0) - place.height_m
            if not vehicle.reposition((place.north_m, place.east_m, down_m)):
                result = mav.MAV_MISSION_ERROR
        except PlanError as error:
            result = error.result
        system, component = call.sender
        return message("MISSION_ACK")(target_system=system, target_component=component, type=result)


def _put_in_force(context: ServiceContext, kind: int, items: tuple[Item, ...], store: Store | None = None) -> None:
    """Let the vehicle have a plan, once the store has it; raises PlanError, said aloud, and the old one stays."""
    with _refusals_announced(context.vehicle):
        put_in_force = _understood(context.vehicle, kind, items)
        if store is not None:
            try:
                store.keep_plan(kind, map(row_of, items))
            except OSError as error:
                raise PlanError(unwritten(error), mav.MAV_MISSION_ERROR) from error
    put_in_force()
    if kind == mav.MAV_MISSION_TYPE_MISSION:
        context.set_rate("MISSION_CURRENT", CURRENT_HZ)


def _understood(vehicle: Vehicle, kind: int, items: tuple[Item, ...]) -> Callable[[], None]:
    """The call that lets the vehicle have a plan; raises PlanError."""
    if kind == mav.MAV_MISSION_TYPE_MISSION:
        legs = _legs(vehicle, items, item_0_is_home=vehicle.identity.item_0_is_home)
        return partial(vehicle.load_mission, legs)
    if kind == mav.MAV_MISSION_TYPE_FENCE:
        return partial(setattr, vehicle, "fence", fence_from(items, vehicle.frame))
    return partial(setattr, vehicle, "rally_ned", rally_from(items, vehicle.frame))


@contextlib.contextmanager
def _refusals_announced(vehicle: Vehicle) -> Iterator[None]:
    try:
        yield
    except PlanError as error:
        vehicle.announce(Severity.WARNING, f"Plan refused: {error}")
        raise


def _legs(vehicle: Vehicle, items: Sequence[Item], *, item_0_is_home: bool) -> tuple[Leg, ...]:
    return legs_from(items, vehicle.frame, home_down_m=vehicle.home_ned[2], item_0_is_home=item_0_is_home)


def _send(posts: Iterable[Post]) -> None:
    for post in posts:
        post.channel.put(post.content)


MESSAGES = frozenset(
    {
        mav.MAVLINK_MSG_ID_MISSION_COUNT,
        mav.MAVLINK_MSG_ID_MISSION_ITEM_INT,
        mav.MAVLINK_MSG_ID_MISSION_ITEM,
        mav.MAVLINK_MSG_ID_MISSION_REQUEST_LIST,
        mav.MAVLINK_MSG_ID_MISSION_REQUEST_INT,
        mav.MAVLINK_MSG_ID_MISSION_REQUEST,
        mav.MAVLINK_MSG_ID_MISSION_CLEAR_ALL,
        mav.MAVLINK_MSG_ID_MISSION_WRITE_PARTIAL_LIST,
        mav.MAVLINK_MSG_ID_MISSION_ACK,
        mav.MAVLINK_MSG_ID_MISSION_SET_CURRENT,
    }
)
