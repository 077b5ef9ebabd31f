"""MAVLink ids of ground station, autopilot and traffic reporter, and the station's own HEARTBEAT."""

from gcs.mavlink import codec
from skytender import mavlink as mav

OUR_HEARTBEAT = codec.message(
    "HEARTBEAT",
    type=mav.MAV_TYPE_GCS,
    autopilot=mav.MAV_AUTOPILOT_INVALID,
    base_mode=0,
    custom_mode=0,
    system_status=mav.MAV_STATE_ACTIVE,
)

AUTOPILOT = 1
"""The component of a vehicle that flies it, MAV_COMP_ID_AUTOPILOT1."""
STATION = (255, 190)
"""This ground station, as supervisor, monitor and check; the component is MAV_COMP_ID_MISSIONPLANNER."""
TRAFFIC = (255, 156)
"""Sender of the scenario's traffic; the component is MAV_COMP_ID_ADSB."""
