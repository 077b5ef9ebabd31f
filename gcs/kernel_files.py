"""Files that a kept kernel is made of besides its own."""

from __future__ import annotations

import zlib
from pathlib import Path
from types import ModuleType


def checksum(*modules: ModuleType) -> int:
    """Of these modules' files. numba notices a change of a kept kernel's own file alone, but keeps a kernel that closes
    over this number by it, so that it is compiled anew when one of these changes."""
    return zlib.crc32(b"".join(Path(str(module.__file__)).read_bytes() for module in modules))
