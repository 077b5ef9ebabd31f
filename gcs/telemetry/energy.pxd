cimport cython
from cpython.buffer cimport PyBUF_WRITABLE, PyBuffer_Release, PyObject_GetBuffer
from libc.stdint cimport int64_t

cpdef enum:  # a meter stands at its source's place in SOURCES; of the first none is ever spoken to
    NONE
    TOTAL
    POWER
    SHARE

cpdef enum:  # fate of a report
    IMPOSSIBLE_TOTAL = -2
    IMPOSSIBLE_POWER = -1
    SECOND_HAND = 0  # SYS_STATUS does not count while BATTERY_STATUS may still come, or does
    COUNTED = 1
    DRAWN = 2  # it was counted, and the source of the energy drawn was among its words

cpdef enum:
    METERS = 4
    MOST_HISTORY = 256

cdef double _GAP_S, _SWAP_SHARE, _SWAP_AFTER_S, _RESTART_J, _POWER_WINDOW_S, _STEPS_WINDOW_S, _JUMP_J, _MOST_W, _STEP_J

cdef struct Account:
    double capacity_j
    double initial_j
    double received_j  # by its own counter and by others' books
    double booked_j  # by others' books
    double given_j
    double before_j  # drawn before the first report, where that is not counted
    double drawn_j
    double[METERS] meters_j
    double[METERS] anchors_j  # a meter's reading from which the energy drawn goes on,
    double[METERS] at_anchors_j  # and the energy drawn then
    double[METERS] spoke_s
    double first_hand_s
    double believed_j  # the last total that can be,
    double believed_s  # and when it came
    double total_j  # since the autopilot's last restart
    double before_restart_j
    double sample_s
    double sample_w
    double expected_j  # what should be left by the last share and by what has moved since
    double moved_j  # received less given by its own words, as far as that expects it
    double seen_booked_j
    double armed_s  # when it last reported while it was armed
    double unseen_j  # booked, and not yet seen as a rise of the share
    double share  # of the capacity, that its last report left; NaN before the first
    double[2] told_j  # by its counters of what it received and gave: the last that can be,
    double[2] told_s  # and when it came
    double power_w  # mean of the last while,
    int64_t power_source  # by this source,
    double[MOST_HISTORY] drawn_at_s  # from when so much had been drawn, in a ring
    double[MOST_HISTORY] drawn_then_j
    double metered_then_j  # what its power had amounted to by the newest of them
    int64_t oldest
    int64_t history  # how many of them there are
    int64_t source
    int64_t initial_known  # 1 or 0
    int64_t swappable  # whether a great rise on the ground may be a swapped battery
    int64_t from_now  # drawn since the first report, not since the vehicle was switched on

cdef struct Outcome:
    int became  # fate of a report
    double bridged_s  # the span over which power was bridged, or NaN
    double gained_j  # what a swapped battery brought, or NaN

cdef Account[1] _BLANK

cdef inline object _blank():
    return <Account[:1]>_BLANK

cdef inline Account* accounts_of(object array) except NULL:
    # By a memoryview of structs every field's type would be compared with each call: 26 us.
    cdef Py_buffer view
    PyObject_GetBuffer(array, &view, PyBUF_WRITABLE)
    PyBuffer_Release(&view)
    if view.len % <Py_ssize_t>sizeof(Account):
        raise TypeError("an array of ACCOUNT is needed")
    return <Account*>view.buf

@cython.locals(total=cython.bint, power=cython.bint, share=cython.bint, spoke=cython.bint)
cdef Outcome count(
    Account* one, double t_s, double consumed_j, double power_w, double remaining, bint second_hand,
    bint armed) noexcept nogil
@cython.locals(other=cython.bint, in_steps=cython.bint)
cdef bint mean_power(Account* one, double now_s) noexcept nogil
cdef void _draw(Account* one, int best) noexcept nogil
cdef void _total(Account* one, double consumed_j, bint armed) noexcept nogil
cdef double _integrate(Account* one, double t_s, double power_w) noexcept nogil
cdef double _fall(Account* one, double t_s, double left_j, bint armed) noexcept nogil
cpdef take(
    account, double t_s, double consumed_j, double power_w, double remaining, bint second_hand, bint armed)
cpdef take_all(
    account, const double[:] t_s, const double[:] consumed_j, const double[:] power_w,
    const double[:] remaining, const unsigned char[:] second_hand, bint armed, double[:] left_j)
