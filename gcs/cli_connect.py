"""`gcs monitor --connect`: any fleet on the air."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import sys

import click


def watch(connect: str, *, control: bool, plain: bool, as_json: bool) -> int:
    """Show whoever is heard at an address until the person ends it; the exit status. Raises click.UsageError."""
    from gcs.monitor import MonitorError, MonitorSource, address

    try:
        at = address(connect)
        source = MonitorSource(at, control=control)
    except MonitorError as error:
        raise click.UsageError(f"--connect: {error}") from None
    if not plain and not as_json and sys.stdout.isatty() and sys.stdin.isatty():
        from gcs.console.app import show

        return show(source, at.text)
    from gcs.console.follow import follow

    if at.way == "udpin":
        click.echo(f"gcs: listening at {at._replace(port=source.port).text}; Ctrl-C ends it.", err=True)
    try:
        follow(source, click.echo, as_json=as_json)
    except KeyboardInterrupt:
        return 0
    return 0


@click.command(short_help="Watch any fleet.")
@click.option("--connect", metavar="udpin|udpout|tcp:HOST:PORT", required=True)
@click.option("--control", is_flag=True)
@click.option("--plain", is_flag=True)
@click.option("--json", "as_json", is_flag=True)
def monitor(connect: str, control: bool, plain: bool, as_json: bool) -> int:
    """Watch."""
    return watch(connect, control=control, plain=plain, as_json=as_json)
