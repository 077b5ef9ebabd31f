from simvehicle.autopilot.vehicle cimport Vehicle
from simvehicle.mavlink.codec cimport ReceivedFrame
from simvehicle.mavlink.connection cimport Connection
from simvehicle.mavlink.dispatcher cimport Services
from simvehicle.sitl.truth cimport TruthWriter

cdef class Unit:
    cpdef hello(self)
    cpdef start_clock(self, long long time_ms, unsigned long long unix_us)
    cpdef receive(self, ReceivedFrame frame, Connection connection)
    cpdef advance(self, long long to_ms)

cdef class VehicleUnit(Unit):
    cdef Vehicle _vehicle
    cdef Services _services
    cdef TruthWriter _truth

    cdef _speak(self)
