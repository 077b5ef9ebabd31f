cimport cython
from posix.time cimport timespec
from simvehicle.law.rows cimport Parameters
from simvehicle.mavlink.steady_answer cimport Steady
from simvehicle.mavlink.steady_tick cimport Fleet
from simvehicle.world.rows cimport AirframeRow, Gust, Weather

cdef extern from "sys/socket.h" nogil:
    ssize_t recv(int fd, void* buffer, size_t size, int flags)
    ssize_t send(int fd, const void* buffer, size_t size, int flags)

cdef extern from "sched.h" nogil:
    int sched_yield()

cpdef enum:
    DATAGRAMS = 64
    LOOK_NS = 500_000

cdef enum:
    # After so long without the processor that was left to others, sleep is better: to be woken gives it back at once.
    CROWDED_NS = 1_300_000
    # So many waits are slept through then; twice as many as the last time, up to a most, where fewer waits than those
    # of the last number were looked through in between.
    SLEEPS = 50
    MOST_SLEEPS = 3200
    UNDISTURBED = 200

cdef struct Waits:
    long long last_ns  # how long the last one was
    long long sleeps_left  # how many are to be slept through
    long long slept  # how many were to be
    long long looked  # how many were looked through since

cdef int _DONTWAIT, _FIXED_NUMBERS
cdef double _ROUNDING_S

cdef long long _now_ns() noexcept nogil
@cython.locals(again=cython.bint)
cdef void _go_on_with_sleep(Waits* waits) noexcept nogil
cdef ssize_t _received(int fd, unsigned char* buffer, Py_ssize_t size, Waits* waits) noexcept nogil
cdef bint _written_down(Steady* one, double* record) noexcept nogil
cpdef serve(
    int fd, Py_ssize_t have, Py_ssize_t at, Py_ssize_t others, Py_ssize_t many, Py_ssize_t first, Py_ssize_t written,
    unsigned char[::1] buffer, bint marked, const long long[::1] row_of, Steady[::1] rows, double[:, ::1] states,
    const double[:, ::1] parameters, const double[:, ::1] airframes, const double[:, ::1] weathers,
    const double[:, ::1] gusts, const double[:, :, ::1] noise, const long long[:, ::1] frames, double[:, ::1] truth,
    long long[::1] flown, long long[:, ::1] left, unsigned char[::1] out, long long[::1] waits)
cdef (Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t, Py_ssize_t) _serve(
    const Fleet* fleet, int fd, Py_ssize_t have, Py_ssize_t at, Py_ssize_t others, Py_ssize_t many, Py_ssize_t first,
    Py_ssize_t written, unsigned char* buffer, Py_ssize_t size, Waits* waits) noexcept nogil
