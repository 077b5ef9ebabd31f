cimport cython
from simvehicle.mavlink.telemetry cimport STREAMS

cpdef enum:
    FASTEST_MS = 4
    SLOWEST_MS = 2_000_000  # MESSAGE_INTERVAL holds intervals in 32 bits of µs

cdef class StreamSchedule:
    cdef public long long tick_ms
    cdef long long[STREAMS] _default_ms
    cdef long long[STREAMS] _interval_ms
    cdef long long[STREAMS] _due_ms

    cdef bint take(self, Py_ssize_t stream, long long now_ms) noexcept
    cpdef hasten(self, str key, long long now_ms)
    cpdef set_rate(self, str key, double rate_hz, long long now_ms)
    cpdef set_default(self, str key, double rate_hz)
