"""Which sources are compiled, and whether those that are there now are the ones that were.

A Python file with a `.pxd` beside it, which declares its C types, is compiled when the package is built (setup.py). In
a checkout the source may change afterwards; what runs would be the old one.
"""

from __future__ import annotations

from zlib import crc32

TYPE_CHECKING = False  # every start of a program pays for what is imported here

if TYPE_CHECKING:
    from pathlib import Path

PACKAGES = ("skytender", "simvehicle", "gcs")
LIST = "compiled.txt"
"""In each package: a line for each file that its compiled modules are made of, with its checksum."""
_HERE = __file__.rpartition("/")[0].rpartition("/")[0]


def compiled_sources(root: Path) -> list[Path]:
    """Sources that are compiled, relative to the folder of the packages, in order."""
    return [file.relative_to(root) for package in PACKAGES for file in _files(root / package) if file.suffix == ".py"]


def listing(root: Path, package: str) -> list[str]:
    """Lines of a package's list, for the sources as they are."""
    return [f"{crc32(file.read_bytes()):08x} {file.relative_to(root).as_posix()}" for file in _files(root / package)]


def changed(package: str, root: str = _HERE) -> list[str]:
    """Paths of a package's compiled sources, in the folder of the packages, that are not what was compiled.

    Raises:
        FileNotFoundError: none has been compiled.
    """
    with open(f"{root}/{package}/{LIST}", encoding="utf-8") as file:
        listed = (line.split(" ", 1) for line in file.read().splitlines())
    return [path for checksum, name in listed if _checksum(path := f"{root}/{name}") != int(checksum, 16)]


def check(package: str, root: str = _HERE) -> None:
    """Refuse a package of which a compiled source is no longer what was compiled.

    Raises:
        ImportError: one was changed or removed, or none has been compiled.
    """
    try:
        paths = changed(package, root)
    except FileNotFoundError:
        raise ImportError(f"{root}/{package} has not been compiled: run `make build` in {root}") from None
    if paths:
        raise ImportError(f"{paths[0]} was changed after it was compiled: run `make build` in {root}")


def _checksum(path: str) -> int | None:
    try:
        with open(path, "rb") as source:
            return crc32(source.read())
    except FileNotFoundError:
        return None


def _files(package: Path) -> list[Path]:
    declared = sorted(package.rglob("*.pxd"))
    return [file for found in declared for file in (found.with_suffix(".py"), found) if file.exists()]
