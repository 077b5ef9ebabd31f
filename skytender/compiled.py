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


def listing(root: Path, package: str) -> str:
    """Text of a package's list, for the sources as they are."""
    return "".join(
        f"{crc32(file.read_bytes()):08x} {file.relative_to(root).as_posix()}\n" for file in _files(root / package)
    )


def check(package: str, root: str = _HERE) -> None:
    """Compare a package's compiled sources, in the folder of the packages, with those that were compiled.

    Raises:
        ImportError: one was changed, or none has been compiled.
    """
    try:
        with open(f"{root}/{package}/{LIST}", encoding="utf-8") as file:
            listed = file.read().splitlines()
    except FileNotFoundError:
        raise ImportError(f"{root}/{package} has not been compiled: run `make build` in {root}") from None
    for line in listed:
        checksum, name = line.split(" ", 1)
        try:
            with open(f"{root}/{name}", "rb") as source:
                content = source.read()
        except FileNotFoundError:  # an installation may leave the sources of what is compiled out
            continue
        if crc32(content) != int(checksum, 16):
            raise ImportError(f"{root}/{name} was changed after it was compiled: run `make build` in {root}")


def _files(package: Path) -> list[Path]:
    declared = sorted(package.rglob("*.pxd"))
    return [file for found in declared for file in (found.with_suffix(".py"), found) if file.exists()]
