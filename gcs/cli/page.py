"""`--web` of run, monitor and replay: the page's server, and what the terminal says of it."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from pathlib import Path

    from gcs.session.client import MessageSource

WEB = click.option("--web", is_flag=True, help="A page in the browser instead of the console; the link is printed.")


def _checked(_context: click.Context, _option: click.Parameter, given: str | None) -> str | None:
    if given is None:
        return None
    from gcs.web.tiles import checked

    try:
        return checked(given)
    except ValueError as error:
        raise click.UsageError(f"--tiles: {error}.") from None


FOXGLOVE = click.option(
    "--foxglove",
    is_flag=True,
    help="Serve it to Foxglove on this machine (Open connection, Foxglove WebSocket); the address is printed.",
)
TILES = click.option(
    "--tiles",
    metavar="URL",
    callback=_checked,
    help="Map tiles under the page's map, such as https://tile.openstreetmap.org/{z}/{x}/{y}.png; none by default.",
)


def refuse_tiles(tiles: str | None, *, web: bool) -> None:
    """Raises click.UsageError where tiles are given and no page shows them."""
    if tiles is not None and not web:
        raise click.UsageError("--tiles is for the page's map: add --web.")


def print_links(links: Mapping[str, str], *, commands: bool = True, err: bool = False) -> None:
    """Print where the page is."""
    if not links:
        click.echo("gcs: the page's server could not be started; the session goes on without it", err=True)
        return
    click.echo(f"page: {links['command']}", err=err)
    if commands:
        click.echo(f"page that only shows: {links['view']}", err=err)


def show_in_foxglove(source: MessageSource) -> None:
    """Serve a source to Foxglove until it ends. Raises click.UsageError without its library, KeyboardInterrupt on
    Ctrl-C."""
    from gcs.report import foxglove

    if not foxglove.available():
        raise click.UsageError(foxglove.MISSING)
    from gcs.report.foxglove_live import serve

    def ready(address: str) -> None:
        click.echo(f"foxglove: {address}")
        click.echo("gcs: Ctrl-C ends it.", err=True)

    serve(source, ready)


def show(source: MessageSource, *, commands: bool, tiles: str | None = None, report: Path | None = None) -> None:
    """Serve a source's page until it ends, and on where `report` is given. Raises KeyboardInterrupt on Ctrl-C."""
    from gcs.web.serve import serve

    def ready(links: Mapping[str, str]) -> None:
        print_links(links, commands=commands)
        click.echo("gcs: Ctrl-C ends it.", err=True)

    serve(source, ready, tiles, report)
