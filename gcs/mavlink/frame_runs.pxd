cimport cython
from libc.stdint cimport int64_t

from skytender.intact_frames cimport Intact

cpdef enum:
    NO_TIME = -1
    NUMBERS = 256
    HALF = 128
    NOT_GRANTED = -2
    NOWHERE = -1
    NO_RUN = -1
    MOST_BYTES = 16_384
    SMALLEST_FRAME = 12

cdef enum:
    _MOST_FRAMES = MOST_BYTES // SMALLEST_FRAME
    _SYSTEM_TIME = 2  # its message id,
    _TIME_BOOT_MS = 18  # and where in its frame this field stands

cdef struct Run:
    int64_t first  # places of its first frame and behind its last one in the list of frames
    int64_t last
    int64_t sysid  # of its first frame
    int64_t compid
    int64_t seq
    int64_t in_step  # 1: the others are of the same component and numbered on from it; else 0
    int64_t time_ms  # the last frame's time_boot_ms if that is SYSTEM_TIME, else NO_TIME

cdef struct Awaited:
    int64_t next  # number of its next frame
    int64_t granted_ms  # the time that its answer will say, or NOT_GRANTED
    int64_t compid
    int64_t held  # 1 where a part of the answer is there, else 0
    int64_t address  # where it speaks from, else NOWHERE
    int64_t run  # which of the buffer's runs its answer is, else NO_RUN

cdef struct Found:  # how many there are; -1 where a byte is of no frame of the dialect
    Py_ssize_t frames
    Py_ssize_t runs

cdef int64_t[_MOST_FRAMES + 1] _BEGINS
cdef Run[_MOST_FRAMES] _RUNS

cdef inline Run* run_at(int64_t[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Run*>&rows[i, 0]

cdef inline Awaited* awaited_at(int64_t[:, ::1] rows, Py_ssize_t i) noexcept nogil:
    return <Awaited*>&rows[i, 0]

@cython.locals(intact=Intact)
cdef Found find(
    const unsigned char* data, Py_ssize_t at, Py_ssize_t size, int64_t* begins, Run* rows, Found found) noexcept nogil
cpdef void add_frames(int64_t[:, ::1] rows, int64_t[::1] frames) noexcept nogil
