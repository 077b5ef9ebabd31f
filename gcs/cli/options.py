"""Options that several commands have, their checks, and what one of them refuses together with another."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import contextlib
import math
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import click

from gcs.cli import page
from gcs.scenario.endpoint import EXAMPLE, FORM, Endpoint, address
from skytender.exit import BAD_INPUT

USUAL_COMPID = 190
PLAIN = click.option(
    "--plain", is_flag=True, help="Lines of text instead of the console; also used without a terminal."
)
ONE_STDOUT = "--plain and --json exclude each other: choose what goes to stdout."


class Refused(click.ClickException):
    """Why nothing was begun, where the command's usage does not help."""

    exit_code = BAD_INPUT


class _Seconds(click.FloatRange):
    """A tenth of a second or more; `nan` and `inf` are none."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float:
        number = super().convert(value, param, ctx)
        if not math.isfinite(number):
            self.fail(f"{value} is not a finite number.", param, ctx)
        return float(number)


SECONDS = _Seconds(0.1)


def limits(wanted: str, holds: Callable[[Any], bool]) -> Callable[[click.Context, click.Parameter, Any], Any]:
    """A callback that refuses a value outside its limits; `nan` lies in none."""

    def check(ctx: click.Context, param: click.Parameter, value: Any) -> Any:
        if value is not None and not holds(value):
            raise click.BadParameter(f"{value} is not {wanted}.", ctx, param)
        return value

    return check


def endpoint(ctx: click.Context, param: click.Parameter, value: str | None) -> Endpoint | None:
    """The callback of an option that is an address."""
    if value is None:
        return None
    at = address(value)
    if at is None:
        raise click.BadParameter(f"{value!r} is no address; write {FORM}, {EXAMPLE}.", ctx, param)
    return at


def _station(ctx: click.Context, param: click.Parameter, value: str) -> tuple[int, int]:
    """The callback of --station: (system, component)."""
    sysid, slash, compid = value.partition("/")
    if not (sysid.isascii() and sysid.isdigit() and (compid.isascii() and compid.isdigit()) is bool(slash)):
        raise click.BadParameter(f"{value!r} is no id; write SYSID or SYSID/COMPID, such as 245/190.", ctx, param)
    ids = int(sysid), int(compid) if slash else USUAL_COMPID
    if not (1 <= ids[0] <= 255 and 2 <= ids[1] <= 255):
        raise click.BadParameter(f"{value} is no station's: SYSID is 1 to 255, COMPID 2 to 255.", ctx, param)
    return ids


Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


def connect_option(help: str, *, default: str | None = None) -> Decorator:
    """The option --connect, an address."""
    shown = default is not None
    return click.option(
        "--connect", default=default, show_default=shown, callback=endpoint, metavar="ADDRESS", help=help
    )


def key_file_option(help: str) -> Decorator:
    """The option --key-file, a key of MAVLink 2 signing."""
    return click.option("--key-file", type=click.Path(path_type=Path, dir_okay=False), metavar="FILE", help=help)


def out_option(help: str) -> Decorator:
    """The option --out, a folder that need not be there."""
    return click.option("--out", type=click.Path(path_type=Path), metavar="DIR", help=help)


def speed_option(help: str) -> Decorator:
    """The option --speed, seconds per second on the wall."""
    holds = limits("a speed above 0 and up to 1000", lambda speed: 0.0 < speed <= 1000.0)
    return click.option("--speed", type=float, callback=holds, metavar="X", help=help)


STATION_OPTION = click.option(
    "--station",
    default="255/190",
    show_default=True,
    callback=_station,
    metavar="SYSID[/COMPID]",
    help="MAVLink id to send as, for vehicles that obey one ground station alone; QGroundControl's and MAVProxy's "
    "system is 255.",
)


@contextlib.contextmanager
def connecting() -> Iterator[None]:
    """Inside, an address or a key that cannot be used is said of --connect or --key-file, as click.UsageError."""
    from gcs.link.socket import AddressRefused
    from skytender.key_files import KeyRefused

    try:
        yield
    except AddressRefused as error:
        raise click.UsageError(f"--connect: {error}.") from None
    except KeyRefused as error:
        raise click.UsageError(f"--key-file: {error}.") from None


def refuse_two_shows(*, plain: bool, as_json: bool, web: bool, foxglove: bool, tiles: str | None) -> None:
    """Raise click.UsageError where more than one is to show a source, or what is asked of the page has none."""
    if plain and as_json:
        raise click.UsageError(ONE_STDOUT)
    if sum((web, foxglove, plain or as_json)) > 1:
        raise click.UsageError("--web, --foxglove, and --plain or --json exclude each other: choose one.")
    page.refuse_tiles(tiles, web=web)
