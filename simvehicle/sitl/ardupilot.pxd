from simvehicle.sitl.autopilot_unit cimport Sensed
