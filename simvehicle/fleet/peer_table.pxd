cimport cython

cpdef enum:
    VEHICLES = 256

cdef struct PeerRow:
    bint known
    long long place_ms
    long long leader_ms
    long long arrived_ms
    double[3] p
    double[3] v
    double[3] lp  # of its leader
    double[3] lv
    double[3] rp  # of its leader, as reported
    double[3] rv
    double[3] wanted

cdef class PeerTable:
    cdef PeerRow[VEHICLES] _peers
    cdef double _period_s

    @cython.locals(peer='PeerRow *', total=double, ignored='unsigned int')
    cpdef receive(self, unsigned int sysid, unsigned int msgid, bytes payload, long long now_ms)
    @cython.locals(peer='PeerRow *', i=int)
    cpdef predict(self, unsigned int sysid, tuple p_ned, tuple v_ned)
    @cython.locals(
        peer='PeerRow *', sysid=int, p='const double *', v='const double *', led=cython.bint, last_ms='long long',
        n=double, e=double, d=double, vn=double, ve=double, vd=double, dn=double, de=double, dd=double, wn=double,
        we=double, wd=double, square=double, t_s=double)
    cpdef list worth_looking(
        self, long long now_ms, tuple p_ned, tuple v_ned, double near_m, double ahead_s, double silent_s)
    @cython.locals(m='PeerRow *')
    cpdef tuple place(self, unsigned int sysid)
    @cython.locals(m='PeerRow *')
    cpdef tuple leader(self, unsigned int sysid)
    cpdef long long arrived(self, unsigned int sysid)
    @cython.locals(m='PeerRow *', led=cython.bint)
    cpdef tuple newest(self, unsigned int sysid)
