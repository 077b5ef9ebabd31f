"""Software-in-the-loop quadrotor vehicles that speak MAVLink."""

from skytender.compiled import check

check("skytender")
check("simvehicle")
