cimport cython
from simvehicle.autopilot.vehicle cimport SetPoint, Vehicle
from skytender.messages cimport SetPositionTargetLocalNed

cdef enum:
    # Accelerations, or forces, are not flown: all three of POSITION_TARGET_TYPEMASK's bits for them.
    ACCELERATIONS_IGNORED = 448

cdef struct Wanted:  # what a set point of either message asks for
    int frame
    bint travels  # whether places count from where the vehicle is
    bint turned  # whether velocities count from its yaw, and places that travel
    unsigned int mask
    double[3] place  # m, in its frame
    double[3] velocity  # m/s
    double yaw
    double yaw_rate

@cython.locals(frame=int)
cpdef local_set_point(object context, Vehicle vehicle, unsigned int sysid, bytes payload)
cdef bint is_ground_station(bytes payload) except -1
cpdef global_set_point(object context, object call)
@cython.locals(use_yaw=cython.bint, use_rate=cython.bint, flown=cython.bint, halved=cython.bint,
               position=cython.bint, velocity=cython.bint, i=int)
cdef _take(object context, Vehicle v, const Wanted* wanted)
@cython.locals(sin=double, cos=double, north=double, east=double)
cdef void _turn(double* v, double yaw_rad) noexcept
