"""Files of kept machine code: one for each kernel, beside numba's own, and with the same rules.

What is kept holds for the file that the kernel stands in as it was read, what the kernel closes over, numba's and the
interpreter's version, and this kind of processor.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import marshal
import os
import sys
import zlib
from collections.abc import Callable, Iterator
from importlib.util import source_hash
from pathlib import Path
from types import FunctionType
from typing import Any

from simvehicle.kernels.argument_types import Key
from simvehicle.kernels.extensions import CACHE_FOLDER
from simvehicle.kernels.machine_code import Image

Signature = tuple[Key | None, ...]
"""Types of arguments, in order."""

_MARK = b"kept code 1\n"
_PROCESSOR = Path("/sys/devices/system/cpu/modalias")
_PLAIN = (bool, int, float, str, bytes, type(None))


def stamp_of(function: Callable[..., Any]) -> bytes | None:
    """A number that tells whether a function's file has changed; None where it cannot be read."""
    path = _code_of(function).co_filename
    try:
        status = os.stat(path)
        return _stamp(path, status.st_mtime_ns, status.st_size)
    except OSError:
        return None


@functools.cache
def _stamp(path: str, *_: int) -> bytes:
    return source_hash(Path(path).read_bytes())


def read(function: Callable[..., Any], stamp: bytes, version: str) -> dict[Signature, Image]:
    """Code that is kept of a function for arguments of these types, wherever numba keeps its own.

    Args:
        function: a kernel's.
        stamp: `stamp_of` it when it was defined.
        version: numba's.
    """
    for folder in _folders(_code_of(function).co_filename):
        found = File(Path(folder), function, stamp, version).read()
        if found:
            return found
    return {}


class File:
    """The file of a function in a folder."""

    def __init__(self, folder: Path, function: Callable[..., Any], stamp: bytes, version: str) -> None:
        """Arguments as `read` has them."""
        code = _code_of(function)
        name = f"{Path(code.co_filename).stem}.{function.__qualname__}-{code.co_firstlineno}"
        name = name.replace("<", "").replace(">", "")
        self._path = folder / f"{name}.{sys.implementation.cache_tag}.kept"
        self._validity = _validity(function, stamp, version)

    def read(self) -> dict[Signature, Image]:
        """All that it keeps; nothing where there is none, or a broken one, or one that does not hold."""
        try:
            content = self._path.read_bytes()
        except OSError:
            return {}
        start = len(_MARK) + 4
        payload = memoryview(content)[start:]
        mark = _MARK + zlib.crc32(payload).to_bytes(4, "little")
        if self._validity is None or content[:start] != mark:
            return {}
        validity, kept = marshal.loads(payload)
        return {signature: Image(*image) for signature, image in kept} if validity == self._validity else {}

    def add(self, signature: Signature, image: Image) -> None:
        """Keep code, with what is kept there and still holds.

        Nothing is kept where it cannot be told whether it will hold, nor where nothing can be written.
        """
        if self._validity is None:
            return
        kept = {**self.read(), signature: image}
        payload = marshal.dumps((self._validity, [(key, tuple(code)) for key, code in kept.items()]))
        beside = self._path.with_name(f"{self._path.name}.{os.urandom(8).hex()}")
        try:
            beside.write_bytes(_MARK + zlib.crc32(payload).to_bytes(4, "little") + payload)
            beside.replace(self._path)
        except OSError:
            with contextlib.suppress(OSError):
                beside.unlink(missing_ok=True)


def _validity(function: Callable[..., Any], stamp: bytes, version: str) -> Any:
    """All that kept code holds for; None where not all of it can be told."""
    closed_over = tuple(cell.cell_contents for cell in function.__closure__ or ())
    processor = _processor()
    if processor is None or not all(type(value) in _PLAIN for value in closed_over):
        return None
    return (stamp, repr(closed_over), version, sys.version, processor)


@functools.cache
def _processor() -> bytes | None:
    """Its maker, its model and what it can do."""
    try:
        return _PROCESSOR.read_bytes()
    except OSError:
        return None


def _folders(path: str) -> Iterator[str]:
    """Where numba keeps code of a file, the first first."""
    folder = os.path.dirname(os.path.abspath(path))
    own = f"{os.path.basename(folder)}_{hashlib.sha1(folder.encode()).hexdigest()}"
    if elsewhere := os.environ.get(CACHE_FOLDER):
        yield f"{elsewhere}/{own}"
    yield f"{folder}/__pycache__"
    yield f"{os.environ.get('XDG_CACHE_HOME', os.path.expanduser('~/.cache'))}/numba/{own}"


def _code_of(function: Callable[..., Any]) -> Any:
    assert isinstance(function, FunctionType)
    return function.__code__
