"""Packages that few need, and how to get them: the extras of pyproject.toml."""

from __future__ import annotations

import importlib.util
from collections.abc import Mapping


class MissingExtra(ImportError):
    """A package that Skytender only needs for this is not installed; the text says which extra brings it."""


def missing(what: str, package: str, extra: str) -> MissingExtra:
    """The error that says in one sentence what needs which package, and how to install it."""
    return MissingExtra(
        f"{what} needs {package}, which is not installed: pip install '.[{extra}]' in Skytender's checkout"
    )


def require(what: str, packages: Mapping[str, str], extra: str) -> None:
    """Raise MissingExtra where a module of these is not installed, before anything is begun; `packages`: a package's
    name by its module's."""
    for module, package in packages.items():
        if importlib.util.find_spec(module) is None:
            raise missing(what, package, extra)
