"""Whatever a scenario names beyond its session is asked for once, and remembered until the scenario changes.

The answer is a file in the user's state folder, by the hash of the scenario's place and content.
"""

from __future__ import annotations

import hashlib
import os
import stat
import sys
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from gcs.cli.options import Refused

if TYPE_CHECKING:
    from gcs.scenario.parts.reach import Reached

TRUST = click.option(
    "--trust",
    is_flag=True,
    help="Let the scenario use the code, programs, key files, devices and addresses that it names; remembered until "
    "it changes.",
)


def digest(*parts: str | bytes) -> str:
    """Hash of what is trusted: a place and a content, or several of them."""
    hashed = hashlib.sha256()
    for part in parts:
        data = part.encode() if isinstance(part, str) else part
        hashed.update(len(data).to_bytes(8, "big") + data)
    return hashed.hexdigest()


def digest_of(file: Path) -> str:
    """Hash of a scenario's file. Raises OSError."""
    return digest(str(file.resolve()), file.read_bytes())


def text(named: Iterable[Reached]) -> str:
    """Things that a scenario names, in one line."""
    return ", ".join(one.text for one in named)


def allow(name: str, named: Sequence[Reached], key: str, *, trust: bool) -> None:
    """Return where what the scenario `name` names may be used: by --trust, an earlier answer, or one that is asked for.

    `key` is the scenario's hash. Raises Refused, click.Abort.
    """
    if not named or (not trust and _remembered(key)):
        return
    if not trust:
        if not (sys.stdin.isatty() and sys.stderr.isatty()):
            raise Refused(f"{name} names {text(named)}: read it, then let it use them with --trust")
        click.echo(f"{name} names, and would use as you:", err=True)
        for one in named:
            click.echo(f"  {one.text}", err=True)
        if not click.confirm("Let it, until it changes?", err=True):
            raise Refused(f"{name} may not use what it names; nothing of it has run")
    _remember(key, name, named)


def _folder() -> Path:
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "skytender" / "trusted"


def _remembered(key: str) -> bool:
    """Whether this user has answered before; what anybody else put there is no answer."""
    try:
        found = (_folder() / key).lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and found.st_uid == os.getuid()


def _remember(key: str, name: str, named: Iterable[Reached]) -> None:
    """Keep the answer; where that cannot be written it is asked for again."""
    try:
        _folder().mkdir(mode=0o700, parents=True, exist_ok=True)
        (_folder() / key).write_text("\n".join([name, *(one.text for one in named), ""]), encoding="utf-8")
    except OSError as error:
        click.echo(f"gcs: the answer cannot be kept in {_folder()}: {error.strerror}", err=True)
