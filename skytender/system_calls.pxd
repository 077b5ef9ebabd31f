# Sockets as the system has them; a call that fails gives -1.

cdef extern from "<sys/socket.h>" nogil:
    ctypedef unsigned int socklen_t
    cdef struct sockaddr:
        pass
    enum:
        MSG_DONTWAIT
    Py_ssize_t recvfrom(int fd, void* data, size_t size, int flags, sockaddr* origin, socklen_t* origin_bytes)
    Py_ssize_t recv(int fd, void* data, size_t size, int flags)
    Py_ssize_t send(int fd, const void* data, size_t size, int flags)
    Py_ssize_t sendto(int fd, const void* data, size_t size, int flags, const sockaddr* to, socklen_t to_bytes)

cdef extern from "<sched.h>" nogil:
    int sched_yield()
