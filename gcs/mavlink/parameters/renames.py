"""Old names of parameters, by ArduCopter's and PX4's own tables of what an update converts.

A parameter that an autopilot does not know may be one that a later version has by another name, often in another unit;
or one that is newer than the autopilot.

[lineage] ArduPilot: convert_params and convert_parameters of ArduCopter/, libraries/AC_AttitudeControl, AC_WPNav,
AC_Avoidance, AP_Arming and AP_GPS; PX4: src/lib/parameters/param_translation.cpp, and where that says nothing the
commits that renamed a parameter
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple


class Renamed(NamedTuple):
    """New name of an old parameter."""

    now: str
    since: str
    """version from which on it has this name"""
    scale: float = 1.0
    """the new number is the old one times this"""
    also: str = ""
    """what else differs, in words"""

    def advice(self) -> str:
        """Clause that says what it is called now."""
        scaled = "" if self.scale == 1.0 else f", {self.scale:g} times the old number"
        return f"{self.since} calls it {self.now}{scaled}{f', {self.also}' * bool(self.also)}"


Table = Mapping[str, Renamed]


def unknown_name(name: str, table: Table) -> str:
    """Clause about a name that a vehicle does not know, where the table has it as an old name or a new one; else
    empty."""
    if name in table:
        return table[name].advice()
    older = [old for old, row in table.items() if row.now == name]
    if not older:
        return ""
    autopilot, _, since = table[older[0]].since.partition(" ")
    return f"{autopilot} before {since.removeprefix('since ')} calls it {older[0]}"


def _since(since: str, scale: float, names: str, also: str = "") -> dict[str, Renamed]:
    """Rows of `OLD NEW OLD NEW …`."""
    words = names.split()
    return {old: Renamed(now, since, scale, also) for old, now in zip(words[::2], words[1::2], strict=True)}


_AP47 = "ArduPilot 4.7"
_STREAMS = (
    *("RAW_SENS", "EXT_STAT", "RC_CHAN", "RAW_CTRL", "POSITION"),
    *("EXTRA1", "EXTRA2", "EXTRA3"),
    "PARAMS",
    "ADSB",
)
ARDUPILOT: Table = {
    **_since(
        _AP47,
        1.0,
        """
        SYSID_THISMAV MAV_SYSID             SYSID_MYGCS MAV_GCS_SYSID           TELEM_DELAY MAV_TELEM_DELAY
        PSC_VELZ_P PSC_D_VEL_P              PSC_VELZ_I PSC_D_VEL_I              PSC_VELZ_D PSC_D_VEL_D
        PSC_VELZ_FLTE PSC_D_VEL_FLTE        PSC_VELZ_FLTD PSC_D_VEL_FLTD        PSC_VELZ_FF PSC_D_VEL_FF
        PSC_ACCZ_FF PSC_D_ACC_FF            PSC_ACCZ_FLTT PSC_D_ACC_FLTT        PSC_ACCZ_FLTE PSC_D_ACC_FLTE
        PSC_ACCZ_FLTD PSC_D_ACC_FLTD        PSC_ACCZ_SMAX PSC_D_ACC_SMAX        PSC_ACCZ_PDMX PSC_D_ACC_PDMX
        PSC_ACCZ_D_FF PSC_D_ACC_D_FF        PSC_ACCZ_NEF PSC_D_ACC_NEF          PSC_ACCZ_NTF PSC_D_ACC_NTF
        PSC_VELXY_P PSC_NE_VEL_P            PSC_VELXY_I PSC_NE_VEL_I            PSC_VELXY_D PSC_NE_VEL_D
        PSC_VELXY_FLTE PSC_NE_VEL_FLTE      PSC_VELXY_FLTD PSC_NE_VEL_FLTD      PSC_VELXY_FF PSC_NE_VEL_FF
        """,
    ),
    **_since(_AP47, 0.1, "PSC_ACCZ_P PSC_D_ACC_P PSC_ACCZ_I PSC_D_ACC_I PSC_ACCZ_D PSC_D_ACC_D"),
    **_since(_AP47, 0.001, "PSC_ACCZ_IMAX PSC_D_ACC_IMAX"),
    **_since(_AP47, 0.01, "PSC_VELZ_IMAX PSC_D_VEL_IMAX PSC_VELXY_IMAX PSC_NE_VEL_IMAX"),
    **_since(
        _AP47,
        0.01,
        """
        WPNAV_SPEED WP_SPD           WPNAV_SPEED_UP WP_SPD_UP          WPNAV_SPEED_DN WP_SPD_DN
        WPNAV_RADIUS WP_RADIUS_M     WPNAV_ACCEL WP_ACC                WPNAV_ACCEL_Z WP_ACC_Z
        WPNAV_ACCEL_C WP_ACC_CNR     LOIT_SPEED LOIT_SPEED_MS          LOIT_ACC_MAX LOIT_ACC_MAX_M
        LOIT_BRK_ACCEL LOIT_BRK_ACC_M  LOIT_BRK_JERK LOIT_BRK_JRK_M    RTL_SPEED RTL_SPEED_MS
        RTL_ALT RTL_ALT_M            RTL_ALT_FINAL RTL_ALT_FINAL_M     RTL_CLIMB_MIN RTL_CLIMB_MIN_M
        LAND_SPEED LAND_SPD_MS       LAND_SPEED_HIGH LAND_SPD_HIGH_MS  LAND_ALT_LOW LAND_ALT_LOW_M
        PILOT_SPEED_UP PILOT_SPD_UP  PILOT_SPEED_DN PILOT_SPD_DN       PILOT_ACCEL_Z PILOT_ACC_Z
        PILOT_TKOFF_ALT PILOT_TKO_ALT_M  CIRCLE_RADIUS CIRCLE_RADIUS_M
        """,
        "metres for centimetres",
    ),
    **_since(
        _AP47,
        0.01,
        """
        ANGLE_MAX ATC_ANGLE_MAX      ATC_SLEW_YAW ATC_RATE_WPY_MAX     ATC_ACCEL_Y_MAX ATC_ACC_Y_MAX
        ATC_ACCEL_R_MAX ATC_ACC_R_MAX  ATC_ACCEL_P_MAX ATC_ACC_P_MAX   PHLD_BRAKE_ANGLE PHLD_BRK_ANGLE
        AVOID_ANGLE_MAX AVOID_ANG_MAX
        """,
        "degrees for hundredths",
    ),
    **{f"SR{port}_{group}": Renamed(f"MAV{port + 1}_{group}", _AP47) for port in range(7) for group in _STREAMS},
    "SYSID_ENFORCE": Renamed("MAV_OPTIONS", _AP47, also="whose bit 0 stands for 1"),
    "ARMING_CHECK": Renamed("ARMING_SKIPCHK", _AP47, also="whose bits are checks to skip: 1 is now 0, 0 is now -1"),
    **_since(
        "ArduPilot 4.6",
        1.0,
        """
        GPS_TYPE GPS1_TYPE           GPS_TYPE2 GPS2_TYPE               GPS_GNSS_MODE GPS1_GNSS_MODE
        GPS_GNSS_MODE2 GPS2_GNSS_MODE  GPS_RATE_MS GPS1_RATE_MS        GPS_RATE_MS2 GPS2_RATE_MS
        GPS_DELAY_MS GPS1_DELAY_MS   GPS_DELAY_MS2 GPS2_DELAY_MS       GPS_COM_PORT GPS1_COM_PORT
        GPS_COM_PORT2 GPS2_COM_PORT  GPS_CAN_NODEID1 GPS1_CAN_NODEID   GPS_CAN_NODEID2 GPS2_CAN_NODEID
        GPS_POS1_X GPS1_POS_X        GPS_POS1_Y GPS1_POS_Y             GPS_POS1_Z GPS1_POS_Z
        GPS_POS2_X GPS2_POS_X        GPS_POS2_Y GPS2_POS_Y             GPS_POS2_Z GPS2_POS_Z
        """,
    ),
    **_since("ArduPilot 4.2", 45.0, "ACRO_RP_P ACRO_RP_RATE ACRO_YAW_P ACRO_Y_RATE"),
}

PX4: Table = {
    "FW_ARSP_MODE": Renamed("FW_USE_AIRSPD", "PX4 since December 2023", also="inverted: 0 is now 1"),
    "CBRK_AIRSPD_CHK": Renamed("SYS_HAS_NUM_ASPD", "PX4 since December 2023", also="where 0 stands for 162128"),
    "SYS_MC_EST_GROUP": Renamed("EKF2_EN", "PX4 since April 2024", also="with LPE_EN and ATT_EN for the others"),
    "ASPD_FALLBACK_GW": Renamed("ASPD_FALLBACK", "PX4 since March 2025"),
    "MNT_RANGE_PITCH": Renamed("MNT_MAX_PITCH", "PX4 since November 2025", 0.5, "and MNT_MIN_PITCH, its negative"),
    **_since(
        "PX4 since March 2026",
        1.0,
        """
        EKF2_GPS_POS_X SENS_GPS0_OFFX  EKF2_GPS_POS_Y SENS_GPS0_OFFY  EKF2_GPS_POS_Z SENS_GPS0_OFFZ
        EKF2_ENGINE_WRM EKF2_POS_LOCK  FD_ACT_MOT_C2T MOTFAIL_C2T
        SENS_IMU_TEMP HEATER1_TEMP     SENS_IMU_TEMP_FF HEATER1_TEMP_FF  SENS_IMU_TEMP_I HEATER1_TEMP_I
        SENS_IMU_TEMP_P HEATER1_TEMP_P SENS_TEMP_ID HEATER1_SENS_ID    EKF2_AGP_CTRL EKF2_AGP0_CTRL
        EKF2_AGP_MODE EKF2_AGP0_MODE   EKF2_AGP_DELAY EKF2_AGP0_DELAY  EKF2_AGP_NOISE EKF2_AGP0_NOISE
        EKF2_AGP_GATE EKF2_AGP0_GATE
        """,
    ),
    "FD_ACT_MOT_TOUT": Renamed("MOTFAIL_TIME", "PX4 since March 2026", 0.001, "seconds for milliseconds"),
    "SIM_BAT_ENABLE": Renamed("SIM_BAT_DRAIN", "PX4 since April 2026", also="where 0 stands for 0"),
    "EKF2_GPS_DELAY": Renamed("SENS_GPS0_DELAY", "PX4 since March 2026", also="and SENS_GPS1_DELAY"),
    "MOT_POLE_COUNT": Renamed("DSHOT_MOT_POL1", "PX4 since March 2026", also="one for each motor up to 12"),
    **_since(
        "PX4 since June 2026",
        1.0,
        "HEATER1_IMU_ID HEATER1_SENS_ID HEATER2_IMU_ID HEATER2_SENS_ID HEATER3_IMU_ID HEATER3_SENS_ID",
    ),
    "COM_RC_OVERRIDE": Renamed("MAN_OVERRIDE_SPD", "PX4 since June 2026", also="where -1 stands for 0"),
    "COM_RC_STICK_OV": Renamed("MAN_OVERRIDE_SPD", "PX4 since June 2026", also="how fast a stick moves, not how far"),
    "MPC_LAND_RC_HELP": Renamed("MPC_AUTO_NUDGING", "PX4 since June 2026", also="whose bit 1 stands for 1"),
    "COM_ARM_TRAFF": Renamed("COM_TRAFF_AVOID", "PX4 since July 2026", also="where 2 stands for 2 and 3"),
}
