"""`simvehicle`: one simulated quadrotor on the command line, the fork server of many, and traffic."""

from simvehicle.cli.command import cli, main, run_argv

__all__ = ["cli", "main", "run_argv"]
