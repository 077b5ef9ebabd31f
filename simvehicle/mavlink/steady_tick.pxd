cimport cython
from simvehicle.law.rows cimport Command, Parameters, RotorState, State
from simvehicle.mavlink.steady_answer cimport Steady
from simvehicle.world.rows cimport AirframeRow, Gust, Weather

cpdef enum:
    MOST_STEPS = 25
    SENT_BYTES = 4096

cdef enum:
    LONGEST_MS = 103  # a vehicle looks at its failsafes every 100 ms: a longer stretch is no usual tick
    STEP_MS = 4
    _SYSTEM = 255  # the supervisor
    _COMPONENT = 190
    _PING_ID = 4
    _PING_SEED = 237
    _PING_TARGET = 12
    _HEARTBEAT_ID = 0
    _HEARTBEAT_SEED = 50
    _HEARTBEAT_TYPE = 4
    _SET_ID = 84
    _SET_SEED = 143
    _SET_BYTES = 53
    _SET_MASK = 0xDC0
    _GCS = 6
    _LOCAL_NED = 1

cdef struct Fleet:  # the vehicles of one process by rows, and what is written when they are flown
    bint marked  # whether a PING to its vehicle stands before each bundle; else the whole datagram is one, the first row's
    const long long* row_of  # (256,) row of a system id, -1 without one
    Py_ssize_t count
    Steady* rows
    double* states  # (count, state_size) as the plant has it
    Py_ssize_t state_size
    const Parameters* parameters
    const AirframeRow* airframes  # NULL on the paper's plant
    const Weather* weathers
    const Gust* gusts  # that blow on all
    Py_ssize_t gust_count
    const double* noise  # (count, noise_steps, NOISE_SIZE) of the next steps
    Py_ssize_t noise_steps
    const long long* frames  # steady_answer.frame_table()
    double* truth  # (count, truth_size), a record of each that is flown
    Py_ssize_t truth_size
    long long* flown  # (count,), which rows were flown, in order
    long long* left  # (most_left, 2), beginnings and ends of what was not
    Py_ssize_t most_left
    unsigned char* out  # (SENT_BYTES + FRAMES_BYTES,), the answers, one after the other

@cython.locals(value=cython.longlong)
cdef long long _number(const unsigned char* datagram, Py_ssize_t body, int at, int size) noexcept nogil
cdef double _float(const unsigned char* datagram, Py_ssize_t at) noexcept nogil
cdef Py_ssize_t _frame_end(const unsigned char* datagram, Py_ssize_t at, Py_ssize_t size) noexcept nogil
cdef bint _is_supervisors(
    const unsigned char* datagram, Py_ssize_t at, Py_ssize_t end, int msgid, unsigned int seed) noexcept nogil
cdef (Py_ssize_t, Py_ssize_t, Py_ssize_t) _bundle(
    const Fleet* fleet, const unsigned char* datagram, Py_ssize_t size, Py_ssize_t at) noexcept nogil
cdef bint _is_set_point(const Steady* one, const unsigned char* datagram, Py_ssize_t body) noexcept nogil
cdef Py_ssize_t _usual(
    const Steady* one, const State* s, const unsigned char* datagram, Py_ssize_t at, Py_ssize_t stop) noexcept nogil
cdef void _take_in(Steady* one, const unsigned char* datagram, Py_ssize_t at, Py_ssize_t grant) noexcept nogil
cdef void _command(const Steady* one, Command* command) noexcept nogil
cdef void _advance(
    const Fleet* fleet, Py_ssize_t row, const Command* command, double time_s, Py_ssize_t steps,
    double* thrust) noexcept nogil
cdef (Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t) fly(
    const Fleet* fleet, const unsigned char* datagram, Py_ssize_t size, Py_ssize_t at) noexcept nogil
