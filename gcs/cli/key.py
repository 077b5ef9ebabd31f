"""`gcs key`: keys of MAVLink 2 signing."""

# ruff: noqa: PLC0415 - so that `gcs --help` answers at once

from __future__ import annotations

import hashlib
from pathlib import Path

import click


@click.group(short_help="Make keys for MAVLink 2 signing.")
def key() -> None:
    """Keys of MAVLink 2 signing: 32 bytes in a file that only you can read.

    Give the file to `gcs run`, `monitor` and `check` by --key-file, to a scenario's external vehicles by
    `signing: {key_file: ...}`, and to `simvehicle` by --key-file. Where a key is set, only what is signed with it
    counts.
    """


@key.command(short_help="Write a new key to a file.")
@click.argument("file", type=click.Path(path_type=Path, dir_okay=False))
@click.option(
    "--passphrase",
    is_flag=True,
    help="Ask for a passphrase and take its SHA-256, as MAVProxy, QGroundControl and Mission Planner do.",
)
def new(file: Path, passphrase: bool) -> int:
    """Write a new random key to FILE, which must not exist yet and is readable by you alone.

    \b
    Examples:
      gcs key new fleet.key
      gcs key new fleet.key --passphrase

    \b
    Exit status:
      0    the file was written
      2    it exists already, or could not be written
    """
    from gcs.link.keys import KeyRefused, new_key

    digest = None
    if passphrase:
        words = click.prompt("Passphrase", hide_input=True, confirmation_prompt=True, err=True)
        digest = hashlib.sha256(str(words).encode()).digest()
    try:
        new_key(file, digest)
    except KeyRefused as error:
        raise click.UsageError(f"{error}.") from None
    click.echo(f"{file}: written. Copy it to both ends of the link over a channel that is not overheard.")
    return 0
