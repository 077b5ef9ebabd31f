"""Whatever a scenario names beyond its session is used once the user has agreed to it, until the scenario changes.

The answer is a file in the user's state folder, by the hash of the scenario's place and content.
"""

from __future__ import annotations

import hashlib
import os
import stat
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # the command has it late
    from gcs.scenario.parts.reach import Reached


class TrustError(PermissionError):
    """A scenario or campaign names code, programs, key files, devices or addresses that the user has not agreed to.

    `named` lists them; `trust=True` lets it use them.
    """

    def __init__(self, name: str, named: Sequence[Reached], how: str) -> None:
        super().__init__(f"{name} names {text(named)}: read it, then let it use them with {how}")
        self.named = tuple(named)


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


def require(name: str, named: Sequence[Reached], key: str | None, *, trust: bool) -> None:
    """Return where what the scenario `name` names may be used: by `trust`, which is remembered, or an earlier answer.

    `key` is the scenario's hash; None where it has no place, so that nothing is remembered of it. Raises TrustError.
    """
    if not named or (not trust and key is not None and remembered(key)):
        return
    if not trust:
        raise TrustError(name, named, "trust=True")
    if key is not None:
        try:
            remember(key, name, named)
        except OSError:
            return  # it is asked for again


def folder() -> Path:
    """Folder of the answers."""
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "skytender" / "trusted"


def remembered(key: str) -> bool:
    """Whether this user has answered before; a file of another user is no answer."""
    try:
        found = (folder() / key).lstat()
    except OSError:
        return False
    return stat.S_ISREG(found.st_mode) and found.st_uid == os.getuid()


def remember(key: str, name: str, named: Iterable[Reached]) -> None:
    """Keep the answer. Raises OSError."""
    folder().mkdir(mode=0o700, parents=True, exist_ok=True)
    (folder() / key).write_text("\n".join([name, *(one.text for one in named), ""]), encoding="utf-8")
