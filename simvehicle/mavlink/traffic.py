"""Other aircraft that a vehicle receives on board: ADSB_VEHICLE, as an ADS-B receiver hands them to an autopilot."""

from __future__ import annotations

from simvehicle.mavlink.context import Call, MessageHandler, ServiceContext
from skytender import mavlink as mav

SENDER = (255, mav.MAV_COMP_ID_ADSB)


def adsb_vehicle(context: ServiceContext, call: Call) -> None:
    """Keep one for the separation on board; another sender's, or one from another connection, is passed over."""
    vehicle, content = context.vehicle, call.content
    if vehicle.separation is None or call.sender != SENDER or call.connection is not context.connections[0]:
        return
    p_ned = vehicle.frame.to_local(1e-7 * content.lat, 1e-7 * content.lon, 1e-3 * content.altitude)
    vehicle.separation.traffic.receive(content, p_ned, vehicle.time_s)


MESSAGES: dict[int, MessageHandler] = {mav.MAVLINK_MSG_ID_ADSB_VEHICLE: adsb_vehicle}
