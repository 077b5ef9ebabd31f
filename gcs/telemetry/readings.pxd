cimport cython
from libc.stdint cimport int64_t

from gcs.telemetry.energy cimport Account

cpdef enum:
    # Why `read` stops: nothing is left; the next message is kept elsewhere; a HEARTBEAT has another mode; a place cannot
    # be (found[0]: a fault of plausibility.py, found[1]: how far it jumps, m); there is more to a battery's report than
    # what its account keeps (found: the arguments of `BatteryAccount.taken`); the last run is of none of the vehicles.
    END
    ELSEWHERE
    MODE
    PLACE
    BATTERY
    UNKNOWN

cpdef enum:
    FROM_AUTOPILOT = 1
    FROM_ANYBODY = 2
    SMALL_IDS = 13_000  # all messages that are kept have an id below

cdef enum:
    _HEADER_BYTES = 10
    _HEARTBEAT = 0
    _SYS_STATUS = 1
    _SYSTEM_TIME = 2
    _GPS_RAW_INT = 24
    _ATTITUDE = 30
    _LOCAL_POSITION_NED = 32
    _GPS_GLOBAL_ORIGIN = 49
    _BATTERY_STATUS = 147
    _HOME_POSITION = 242
    _EXTENDED_SYS_STATE = 245
    _NAMED_VALUE_FLOAT = 251
    _NAMED_VALUE_INT = 252
    _NO_CELL = 65535
    _FIRST_CELLS = 10
    _CELLS = 14
    _NO_CURRENT = -1
    _PX4_NO_CURRENT = -100

cdef int _AUTOPILOT_1, _ARMED, _ON_GROUND, _UNDEFINED, _PROPULSION
cdef double _MOST_EFFORT, _HECTOJOULE

cdef struct Readings:
    double north  # m, in its own frame; NaN before the first
    double east
    double down
    double v_north  # m/s
    double v_east
    double v_down
    double position_s  # as of when, in session time; so are the others in s
    double heading  # rad
    double roll
    double pitch
    double landed  # 1 or 0
    double landed_reported
    double effort  # NaN before the first
    double effort_s
    double autopilot  # of its last HEARTBEAT; -1 before the first
    double custom_mode
    double base_mode
    double system_status
    double received_s  # of its last HEARTBEAT
    double clock_s  # offset from its own time to the session's, NaN while that is not known
    double power_w
    double[2] counted_s  # its counters of energy received and given; -inf before the first
    double external  # 1 or 0
    double origin_lat  # the last GPS_GLOBAL_ORIGIN that was believed, as it stood there; NaN without
    double origin_lon
    double origin_alt
    double several_batteries  # 1 once it has reported another than number 0, or none that it flies on
    double message_s  # when anything but SYSTEM_TIME came from its autopilot
    double unhealthy  # MAV_SYS_STATUS_SENSOR of what it has, uses, and says is out of order; 0 before the first SYS_STATUS
    double fix_type  # of its last GPS_RAW_INT, with accuracies, mm, and whether it was armed then; -1 before the first
    double fix_h
    double fix_v
    double fix_armed
    double way  # m, from each place that it has reported to the next, on the ground too
    double first_s  # of battery 0, as long as it is the only one; -inf before its first report
    double first_consumed_j
    double first_power_w
    double first_share
    double first_v
    double first_function

cdef inline Readings* readings_at(double[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Readings*>&rows[i, 0]

cdef double _session_s(const Readings* row, int64_t boot_ms, double now_s) noexcept nogil
cdef bint _read_place(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, Readings* row, double now_s, double* found) noexcept nogil
cdef void _read_attitude(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, Readings* row) noexcept nogil
@cython.locals(same=cython.bint)
cdef bint _read_mode(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, Readings* row, double now_s) noexcept nogil
cdef bint _is_named(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, const char* name) noexcept nogil
@cython.locals(same=cython.bint)
cdef bint _is_repeated(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, int msgid, Readings* row, Account* one,
    double now_s) noexcept nogil
cdef void _read_effort(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t stop, Readings* row, double now_s) noexcept nogil
cdef int64_t _cells_mv(const unsigned char* data, Py_ssize_t at, Py_ssize_t stop) noexcept nogil
cdef double _power_w(int64_t total_mv, int64_t current_ca) noexcept nogil
cdef double _share(int64_t percent) noexcept nogil
cdef bint _is_armed(const Readings* row) noexcept nogil
@cython.locals(armed=cython.bint, other=cython.bint)
cdef bint _count_report(
    Account* one, double* found, Readings* row, double now_s, double consumed_j, double power_w, double remaining,
    bint second) noexcept nogil

cdef struct Stop:
    Py_ssize_t at  # where the next frame begins
    int why

@cython.locals(counted=cython.bint, own=cython.bint, small=cython.bint, elsewhere=cython.bint, consumed_hj=int64_t,
               total_mv=int64_t, power_w=double, remaining=double)
cdef Stop _read_run(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t end, double now_s, Readings* row, Account* one,
    const unsigned char[::1] kept, double* found) noexcept nogil

cdef class TelemetryReader:
    cdef const int64_t[::1] _row_by_sysid
    cdef double[:, ::1] _readings
    cdef Account[::1] _accounts
    cdef const unsigned char[::1] _kept
    cdef double[::1] _found

    cpdef read(self, bytes data, Py_ssize_t at, Py_ssize_t end, Py_ssize_t vehicle, double now_s)
    @cython.locals(stop=Stop)
    cpdef read_runs(
        self, bytes data, Py_ssize_t at, Py_ssize_t end, Py_ssize_t vehicle, Py_ssize_t run, int64_t[:, ::1] spans,
        int64_t[:, ::1] runs, double now_s)
    @cython.locals(
        stop=Stop, octets="const unsigned char *", at=Py_ssize_t, behind=Py_ssize_t, vehicle=Py_ssize_t,
        signature=Py_ssize_t)
    cpdef read_dated(
        self, bytes data, const int64_t[::1] places, const int64_t[::1] sysids, const double[::1] times_s,
        const int64_t[::1] row_by_sysid, Py_ssize_t k, Py_ssize_t end)
    cdef Stop _read(
        self, const unsigned char* data, Py_ssize_t at, Py_ssize_t end, Py_ssize_t vehicle, double now_s) noexcept nogil
