from simvehicle.autopilot.vehicle cimport Vehicle
from simvehicle.fleet.peer_table cimport PeerTable
from simvehicle.mavlink.codec cimport ReceivedFrame
from simvehicle.mavlink.connection cimport Connection

cdef class Services:
    cdef readonly Vehicle vehicle
    cdef readonly unsigned int sysid
    cdef readonly list connections
    cdef object _context
    cdef object _planning
    cdef object _logs
    cdef object _files
    cdef object _remote_id
    cdef object _reboot
    cdef object _control
    cdef dict _commands
    cdef readonly object fleet
    cdef double _follow_rate_hz
    cdef bint _fast_counters
    cdef int _long_texts
    cdef bint _leads
    cdef PeerTable _peers  # None where it keeps apart from no peer
    cdef bint _at_work

    cpdef receive(self, ReceivedFrame frame, Connection connection)
    cdef bint _deaf(self) except -1
    cdef _command(self, object call)
    cpdef decide(self)
    cpdef report(self)
    cdef _announce(self)
    cdef _intend(self)
    cdef bint _counts_fast(self) except -1
    cdef _pace_counters(self)
