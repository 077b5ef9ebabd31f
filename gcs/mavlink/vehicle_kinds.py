"""Kinds of vehicles in plain words, by HEARTBEAT's type."""

from __future__ import annotations

from collections.abc import Mapping

from skytender import mavlink as mav

KINDS: Mapping[int, str] = {
    **dict.fromkeys(
        (
            mav.MAV_TYPE_QUADROTOR,
            mav.MAV_TYPE_COAXIAL,
            mav.MAV_TYPE_HELICOPTER,
            mav.MAV_TYPE_HEXAROTOR,
            mav.MAV_TYPE_OCTOROTOR,
            mav.MAV_TYPE_TRICOPTER,
            mav.MAV_TYPE_DODECAROTOR,
            mav.MAV_TYPE_DECAROTOR,
            mav.MAV_TYPE_GENERIC_MULTIROTOR,
        ),
        "copter",
    ),
    **dict.fromkeys(
        (
            mav.MAV_TYPE_VTOL_DUOROTOR,
            mav.MAV_TYPE_VTOL_QUADROTOR,
            mav.MAV_TYPE_VTOL_TILTROTOR,
            *range(mav.MAV_TYPE_VTOL_RESERVED2, mav.MAV_TYPE_VTOL_RESERVED5 + 1),
        ),
        "VTOL",
    ),
    **dict.fromkeys((mav.MAV_TYPE_FIXED_WING, mav.MAV_TYPE_FLAPPING_WING, mav.MAV_TYPE_PARAFOIL), "plane"),
    **dict.fromkeys((mav.MAV_TYPE_AIRSHIP, mav.MAV_TYPE_FREE_BALLOON, mav.MAV_TYPE_KITE), "balloon"),
    mav.MAV_TYPE_GROUND_ROVER: "rover",
    mav.MAV_TYPE_SURFACE_BOAT: "boat",
    mav.MAV_TYPE_SUBMARINE: "submarine",
    mav.MAV_TYPE_ROCKET: "rocket",
    mav.MAV_TYPE_GENERIC: "vehicle",
}
"""Kind of a vehicle, by HEARTBEAT's type. Types that are not here are no vehicles: ground stations, cameras, …"""
