"""Software-in-the-loop quadrotor vehicles that speak MAVLink."""

from simvehicle.renamed import install
from skytender.compiled import check

check("skytender")
check("simvehicle")
install()
