# Made by tests/support/message_structs.py from pymavlink's definitions: payloads as on the wire.

cdef packed struct Heartbeat:
    unsigned int custom_mode
    unsigned char type
    unsigned char autopilot
    unsigned char base_mode
    unsigned char system_status
    unsigned char mavlink_version

cdef packed struct SysStatus:
    unsigned int onboard_control_sensors_present
    unsigned int onboard_control_sensors_enabled
    unsigned int onboard_control_sensors_health
    unsigned short load
    unsigned short voltage_battery
    short current_battery
    unsigned short drop_rate_comm
    unsigned short errors_comm
    unsigned short errors_count1
    unsigned short errors_count2
    unsigned short errors_count3
    unsigned short errors_count4
    signed char battery_remaining
    unsigned int onboard_control_sensors_present_extended
    unsigned int onboard_control_sensors_enabled_extended
    unsigned int onboard_control_sensors_health_extended

cdef packed struct SystemTime:
    unsigned long long time_unix_usec
    unsigned int time_boot_ms

cdef packed struct Ping:
    unsigned long long time_usec
    unsigned int seq
    unsigned char target_system
    unsigned char target_component

cdef packed struct GpsRawInt:
    unsigned long long time_usec
    int lat
    int lon
    int alt
    unsigned short eph
    unsigned short epv
    unsigned short vel
    unsigned short cog
    unsigned char fix_type
    unsigned char satellites_visible
    int alt_ellipsoid
    unsigned int h_acc
    unsigned int v_acc
    unsigned int vel_acc
    unsigned int hdg_acc
    unsigned short yaw

cdef packed struct Attitude:
    unsigned int time_boot_ms
    float roll
    float pitch
    float yaw
    float rollspeed
    float pitchspeed
    float yawspeed

cdef packed struct AttitudeQuaternion:
    unsigned int time_boot_ms
    float q1
    float q2
    float q3
    float q4
    float rollspeed
    float pitchspeed
    float yawspeed
    float[4] repr_offset_q

cdef packed struct LocalPositionNed:
    unsigned int time_boot_ms
    float x
    float y
    float z
    float vx
    float vy
    float vz

cdef packed struct GlobalPositionInt:
    unsigned int time_boot_ms
    int lat
    int lon
    int alt
    int relative_alt
    short vx
    short vy
    short vz
    unsigned short hdg

cdef packed struct MissionCurrent:
    unsigned short seq
    unsigned short total
    unsigned char mission_state
    unsigned char mission_mode

cdef packed struct GpsGlobalOrigin:
    int latitude
    int longitude
    int altitude
    unsigned long long time_usec

cdef packed struct VfrHud:
    float airspeed
    float groundspeed
    float alt
    float climb
    short heading
    unsigned short throttle

cdef packed struct SetPositionTargetLocalNed:
    unsigned int time_boot_ms
    float x
    float y
    float z
    float vx
    float vy
    float vz
    float afx
    float afy
    float afz
    float yaw
    float yaw_rate
    unsigned short type_mask
    unsigned char target_system
    unsigned char target_component
    unsigned char coordinate_frame

cdef packed struct PositionTargetLocalNed:
    unsigned int time_boot_ms
    float x
    float y
    float z
    float vx
    float vy
    float vz
    float afx
    float afy
    float afz
    float yaw
    float yaw_rate
    unsigned short type_mask
    unsigned char coordinate_frame

cdef packed struct Altitude:
    unsigned long long time_usec
    float altitude_monotonic
    float altitude_amsl
    float altitude_local
    float altitude_relative
    float altitude_terrain
    float bottom_clearance

cdef packed struct FollowTarget:
    unsigned long long timestamp
    unsigned long long custom_state
    int lat
    int lon
    float alt
    float[3] vel
    float[3] acc
    float[4] attitude_q
    float[3] rates
    float[3] position_cov
    unsigned char est_capabilities

cdef packed struct BatteryStatus:
    int current_consumed
    int energy_consumed
    short temperature
    unsigned short[10] voltages
    short current_battery
    unsigned char id
    unsigned char battery_function
    unsigned char type
    signed char battery_remaining
    int time_remaining
    unsigned char charge_state
    unsigned short[4] voltages_ext
    unsigned char mode
    unsigned int fault_bitmask

cdef packed struct HomePosition:
    int latitude
    int longitude
    int altitude
    float x
    float y
    float z
    float[4] q
    float approach_x
    float approach_y
    float approach_z
    unsigned long long time_usec

cdef packed struct ExtendedSysState:
    unsigned char vtol_state
    unsigned char landed_state

cdef packed struct NamedValueFloat:
    unsigned int time_boot_ms
    float value
    char[10] name

cdef packed struct NamedValueInt:
    unsigned int time_boot_ms
    int value
    char[10] name

cdef packed struct CurrentMode:
    unsigned int custom_mode
    unsigned int intended_custom_mode
    unsigned char standard_mode

cdef packed struct ControlStatus:
    unsigned char flags
    unsigned char gcs_main
    unsigned char[10] gcs_secondary

cdef enum:
    HEARTBEAT_ID = 0
    SYSTEM_TIME_ID = 2
    PING_ID = 4
    LOCAL_POSITION_NED_ID = 32
    SET_POSITION_TARGET_LOCAL_NED_ID = 84
    POSITION_TARGET_LOCAL_NED_ID = 85
    SYSTEM_TIME_SEED = 137
    MAV_COMP_ID_AUTOPILOT1 = 1
    MAV_TYPE_GCS = 6
    MAV_TYPE_QUADROTOR = 2
    MAV_MODE_FLAG_CUSTOM_MODE_ENABLED = 1
    MAV_MODE_FLAG_STABILIZE_ENABLED = 16
    MAV_MODE_FLAG_GUIDED_ENABLED = 8
    MAV_MODE_FLAG_AUTO_ENABLED = 4
    MAV_MODE_FLAG_SAFETY_ARMED = 128
    MAV_STATE_BOOT = 1
    MAV_STATE_STANDBY = 3
    MAV_STATE_ACTIVE = 4
    MAV_STATE_CRITICAL = 5
    MAV_SYS_STATUS_SENSOR_3D_GYRO = 1
    MAV_SYS_STATUS_SENSOR_3D_ACCEL = 2
    MAV_SYS_STATUS_SENSOR_3D_MAG = 4
    MAV_SYS_STATUS_SENSOR_ABSOLUTE_PRESSURE = 8
    MAV_SYS_STATUS_SENSOR_GPS = 32
    MAV_SYS_STATUS_SENSOR_BATTERY = 33554432
    MAV_SYS_STATUS_SENSOR_MOTOR_OUTPUTS = 32768
    MAV_SYS_STATUS_GEOFENCE = 1048576
    MAV_SYS_STATUS_AHRS = 2097152
    MAV_SYS_STATUS_PREARM_CHECK = 268435456
    MAV_VTOL_STATE_UNDEFINED = 0
    MAV_LANDED_STATE_ON_GROUND = 1
    MAV_LANDED_STATE_IN_AIR = 2
    MAV_LANDED_STATE_TAKEOFF = 3
    MAV_LANDED_STATE_LANDING = 4
    GPS_FIX_TYPE_NO_FIX = 1
    GPS_FIX_TYPE_3D_FIX = 3
    MAV_BATTERY_FUNCTION_ALL = 1
    MAV_BATTERY_TYPE_LIPO = 1
    MAV_BATTERY_CHARGE_STATE_OK = 1
    MAV_BATTERY_CHARGE_STATE_CRITICAL = 3
    MAV_BATTERY_CHARGE_STATE_EMERGENCY = 4
    MAV_FRAME_LOCAL_NED = 1
    MAV_FRAME_LOCAL_OFFSET_NED = 7
    MAV_FRAME_BODY_NED = 8
    MAV_FRAME_BODY_OFFSET_NED = 9
    MAV_FRAME_BODY_FRD = 12
    POSITION_TARGET_TYPEMASK_AX_IGNORE = 64
    POSITION_TARGET_TYPEMASK_AY_IGNORE = 128
    POSITION_TARGET_TYPEMASK_AZ_IGNORE = 256
    POSITION_TARGET_TYPEMASK_YAW_IGNORE = 1024
    POSITION_TARGET_TYPEMASK_YAW_RATE_IGNORE = 2048
    GCS_CONTROL_STATUS_FLAGS_SYSTEM_MANAGER = 1
    GCS_CONTROL_STATUS_FLAGS_TAKEOVER_ALLOWED = 2
