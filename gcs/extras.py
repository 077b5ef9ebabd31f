"""Packages that few need, and how to get them: the extras of pyproject.toml."""

from __future__ import annotations


class MissingExtra(ImportError):
    """A package that Skytender only needs for this is not installed; the text says which extra brings it."""


def missing(what: str, package: str, extra: str) -> MissingExtra:
    """The error that says in one sentence what needs which package, and how to install it."""
    return MissingExtra(
        f"{what} needs {package}, which is not installed: pip install '.[{extra}]' in Skytender's checkout"
    )
