"""Who is who on the network, as (system id, component id)."""

AUTOPILOT = 1
"""The component of a vehicle that flies it, MAV_COMP_ID_AUTOPILOT1."""
STATION = (255, 190)
"""This ground station, as supervisor, monitor and check; the component is MAV_COMP_ID_MISSIONPLANNER."""
TRAFFIC = (255, 156)
"""Who reports the scenario's traffic; the component is MAV_COMP_ID_ADSB."""
