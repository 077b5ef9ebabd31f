"""Software-in-the-loop quadrotor vehicles that speak MAVLink."""

from simvehicle.renamed import install

install()
