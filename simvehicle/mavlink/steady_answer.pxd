cimport cython
from simvehicle.law.rows cimport RotorState

cpdef enum:
    TRUTH_NUMBERS = 18
    FRAMES_BYTES = 1024
    PAYLOAD_BYTES = 64

cdef enum:
    AUTOPILOT = 1
    SYSTEM_TIME_ID = 2
    SYSTEM_TIME_SEED = 137
    _SYSTEM_TIME_BYTES = 12
    _CELLS = 4
    _STANDBY = 3
    _ACTIVE = 4
    _ON_GROUND = 1
    _IN_AIR = 2
    _PREARM = 0x10000000
    STREAM_COUNT = 19

cdef enum:  # streams that are written here, in the order of telemetry.TELEMETRY
    _HEARTBEAT
    _STATUS
    _EXTENDED
    _ATTITUDE
    _LOCAL
    _GLOBAL
    _GPS
    _HOME
    _ORIGIN
    _BATTERY
    _TARGET
    _EFFORT
    _OUT
    _IN

cdef double _FULL_V, _EMPTY_V

cdef struct Steady:  # a vehicle that is flown in compiled code
    long long steady  # 1 while nothing but set points moves it
    long long sysid
    long long granted_ms  # time of the last grant
    long long time_ms  # the vehicle's: what is no whole step is not flown yet
    long long number  # of the supervisor's next frame
    long long seq  # of its own next frame
    long long until_ms  # when something is due that is not written here
    long long ground
    long long checked  # whether a low battery refuses arming
    long long unix_epoch_us
    double given_j
    double received_j
    long long truth_fd  # of its file of truth, -1 without one
    double truth_period_s  # 0: a record at each grant
    double truth_due_s
    long long truth_bytes  # written while it is steady, and of the last record
    long long truth_taken
    long long ticks  # flown here
    double gcs_seen_s  # NaN: never
    double gcs_loss_s
    double set_s  # of the set point, and its place and velocity
    double[3] set_p_ned
    double[3] set_v_ned
    double set_loss_s
    double yaw_ned
    double fastest_m_s
    double power_w
    long long rotors  # whether it flies on rotors, and its estimate errs
    long long senses
    long long noise_step  # place of the next step's noise, the end of what there is,
    long long noise_end
    long long noise_moves  # and by how many places a step goes on: 0 where all of it is 0
    double floor_j  # below it the vehicle lands
    double capacity_j
    double home_down_m
    double[5] origin  # as write_motion has it
    long long[STREAM_COUNT] due_ms
    long long[STREAM_COUNT] interval_ms
    unsigned char[(STREAM_COUNT + 1) * PAYLOAD_BYTES] payloads  # with what stays the same; the last is SYSTEM_TIME's
    long long answer_bytes  # of the last one; 0 where that was not written here
    unsigned char[FRAMES_BYTES] answer

cdef inline object a_row():
    """A view of a row, for its format alone."""
    cdef Steady one
    return <Steady[:1]>&one

cdef void _put(unsigned char* out, Py_ssize_t at, long long value, int size) noexcept nogil
cdef void _put_float(unsigned char* out, Py_ssize_t at, double value) noexcept nogil
@cython.locals(still=cython.bint, stands=cython.bint)
cdef bint _landed(const Steady* one, const RotorState* s) noexcept nogil
cdef void _write_values(const Steady* one, const RotorState* s, int stream, unsigned char* payload) noexcept nogil
@cython.locals(value=cython.longlong)
cdef long long _number_of(const unsigned char* payload, Py_ssize_t at) noexcept nogil
cdef void write_answer(Steady* one, const RotorState* s, const long long* frames, long long unix_us) noexcept nogil
cdef void write_truth(
    const Steady* one, const RotorState* s, const double* thrust, Py_ssize_t steps, double* truth) noexcept nogil
