cimport cython
from simvehicle.autopilot.vehicle cimport Vehicle
cimport skytender.messages as messages

cpdef enum:
    STREAMS = 21
    LARGEST_BYTES = 96  # more than any stream's payload

cdef enum:  # of the streams, in the order of TELEMETRY
    _HEARTBEAT
    _SYS_STATUS
    _EXTENDED_SYS_STATE
    _ATTITUDE
    _LOCAL_POSITION_NED
    _GLOBAL_POSITION_INT
    _GPS_RAW_INT
    _HOME_POSITION
    _GPS_GLOBAL_ORIGIN
    _BATTERY_STATUS
    _POSITION_TARGET_LOCAL_NED
    _CONTROL_EFFORT
    _XFER_OUT
    _XFER_IN
    _FOLLOW_TARGET
    _MISSION_CURRENT
    _ATTITUDE_QUATERNION
    _ALTITUDE
    _VFR_HUD
    _CURRENT_MODE
    _CONTROL_STATUS

cdef struct Message:  # that a stream sends
    unsigned int msgid
    unsigned int seed
    Py_ssize_t size

cdef Message[STREAMS] MESSAGES
cdef double _TURN_RAD, _DEG
cdef long long _SENSORS
cdef object _HOLD, _TAKEOFF, _LAND, _MISSION

cdef void _fill()
cdef double _remainder(double x, double whole) noexcept nogil
cdef long long _bounded(double value, int bits) noexcept nogil
cdef long long _rounded(double value) noexcept nogil
cdef long long _cdeg(double angle_rad) noexcept nogil
cdef long long _turned(long long angle, long long whole) noexcept nogil
cdef double _radians(double angle_rad) noexcept nogil
cdef int _latitude(Vehicle v, double north_m) noexcept
cdef int _longitude(Vehicle v, double east_m) noexcept
cdef (double, double, double) _place(Vehicle v) noexcept

@cython.locals(base=int, flying=int)
cdef _heartbeat(Vehicle v, messages.Heartbeat* m)
@cython.locals(healthy="long long", ready="long long")
cdef _sys_status(Vehicle v, messages.SysStatus* m)
@cython.locals(landed=int)
cdef _extended_sys_state(Vehicle v, messages.ExtendedSysState* m)
cdef void _attitude(Vehicle v, messages.Attitude* m) noexcept
cdef void _local_position_ned(Vehicle v, messages.LocalPositionNed* m) noexcept
cdef void _global_position_int(Vehicle v, messages.GlobalPositionInt* m) noexcept
cdef _gps_raw_int(Vehicle v, messages.GpsRawInt* m)
cdef void _home_position(Vehicle v, messages.HomePosition* m) noexcept
cdef void _gps_global_origin(Vehicle v, messages.GpsGlobalOrigin* m) noexcept
cdef _battery_status(Vehicle v, messages.BatteryStatus* m)
cdef _position_target_local_ned(Vehicle v, messages.PositionTargetLocalNed* m)
cdef _control_effort(Vehicle v, messages.NamedValueFloat* m)
cdef _transferred(Vehicle v, messages.NamedValueInt* m, const char* name, long long joules)
cdef void _follow_target(Vehicle v, messages.FollowTarget* m) noexcept
cdef _mission_current(Vehicle v, messages.MissionCurrent* m)
cdef _attitude_quaternion(Vehicle v, messages.AttitudeQuaternion* m)
cdef void _altitude(Vehicle v, messages.Altitude* m) noexcept
cdef _vfr_hud(Vehicle v, messages.VfrHud* m)
cdef _current_mode(Vehicle v, messages.CurrentMode* m)
cdef void _control_status(Vehicle v, messages.ControlStatus* m) noexcept

cdef write_payload(Vehicle v, int stream, unsigned char* payload)
