cdef struct Front:  # of a search for a path from one cell
    long long* heap  # estimate of the whole path << 32 | cell, the least first
    Py_ssize_t size
    Py_ssize_t heap_room
    long long* seen  # cells that were not seen before
    Py_ssize_t met  # how many these are
    Py_ssize_t seen_room
    long long settled
    long long limit  # cost of the path, once it is known
    long long[27] around
    long long[27] moves
    Py_ssize_t stride_n
    Py_ssize_t stride_e
    Py_ssize_t count_e
    Py_ssize_t start
