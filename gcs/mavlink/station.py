"""What a ground station says each second for as long as it is there."""

from pymavlink.dialects.v20 import common as mav

from gcs.mavlink import codec

OUR_HEARTBEAT = codec.message(
    "HEARTBEAT",
    type=mav.MAV_TYPE_GCS,
    autopilot=mav.MAV_AUTOPILOT_INVALID,
    base_mode=0,
    custom_mode=0,
    system_status=mav.MAV_STATE_ACTIVE,
)
