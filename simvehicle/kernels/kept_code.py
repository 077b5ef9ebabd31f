"""Files of kept machine code: one for each kernel, beside numba's own, and with the same rules.

What is kept holds for all source of the package that any kernel there is made of; for the kernel, what it closes over,
numba's and the interpreter's version, and this kind of processor.
It is machine code, and so read only from files that nobody but this user, or the system's, can have written.
"""

from __future__ import annotations

import contextlib
import functools
import hashlib
import marshal
import os
import re
import stat
import sys
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from types import FunctionType
from typing import Any, BinaryIO

from simvehicle.kernels.argument_types import Key
from simvehicle.kernels.extensions import CACHE_FOLDER
from simvehicle.kernels.machine_code import Image

Signature = tuple[Key | None, ...]
"""Types of arguments, in order."""

_MARK = b"kept code 1\n"
_PROCESSOR = Path("/sys/devices/system/cpu/modalias")
_PLAIN = (bool, int, float, str, bytes, type(None))


OWN_MODE = 0o644
"""Of a file of kept code: others may read it, whatever the umask."""
_OTHERS_WRITE = stat.S_IWGRP | stat.S_IWOTH
_SYSTEM = 0
"""The user that installs programs for all."""


def stamp_of(function: Callable[..., Any]) -> bytes | None:
    """`digest` of the package that a function stands in, as this process first saw it; None where that cannot be."""
    return _first_digest(_package_of(_code_of(function).co_filename))


def is_current(function: Callable[..., Any], stamp: bytes) -> bool:
    """Whether all source is still as it was stamped, so that what was compiled since then is of that source."""
    return digest(_package_of(_code_of(function).co_filename)) == stamp


def digest(package: str) -> bytes | None:
    """Of all source in a package's folder that compiled code can be made of, or of one file: of modules that hold
    compiled functions, and of what these import, directly or not. None where any source cannot be read.
    """
    try:
        source = {name: Path(path).read_bytes() for name, path in _modules(package).items()}
    except OSError:
        return None
    pending = [name for name, content in source.items() if _COMPILES in content or len(source) == 1]
    imports = rb"\n(?:from|import) (%s[\w.]*)(?: import (\([^)]*\)|.*))?" % os.path.basename(package).encode()
    of_compiled: set[str] = set()
    while pending:
        name = pending.pop()
        if name in source and name not in of_compiled:
            of_compiled.add(name)
            pending.append(name.rpartition(".")[0])
            for module, names in re.findall(imports, source[name]):
                pending += [module.decode(), *(f"{module.decode()}.{word.decode()}" for word in _NAME.findall(names))]
    found = hashlib.blake2b(digest_size=16)
    for name in sorted(of_compiled):
        found.update(f"{name} {len(source[name])}\n".encode() + source[name])
    return found.digest()


_first_digest = functools.cache(digest)
_COMPILES = b".kernels import "
_NAME = re.compile(rb"\w+")


def _modules(package: str) -> dict[str, str]:
    """Files by the names of their modules."""
    if not os.path.isdir(package):
        return {os.path.basename(package): package}
    above = len(os.path.dirname(package)) + 1
    paths = [f"{at}/{name}" for at, _, names in os.walk(package) for name in names if name.endswith(".py")]
    return {path[above:-3].removesuffix("/__init__").replace("/", "."): path for path in paths}


@functools.cache
def _package_of(path: str) -> str:
    """The outermost folder of the package that a file is a module of; the file itself where it is of none."""
    outermost, folder = path, os.path.dirname(path)
    while os.path.exists(f"{folder}/__init__.py"):
        outermost, folder = folder, os.path.dirname(folder)
    return outermost


def opened(path: str | Path) -> BinaryIO:
    """A file of kept code, open to be read.

    Raises:
        OSError: it cannot be read; or it is a link, or somebody else could have written it (PermissionError).
    """
    file = os.fdopen(os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK), "rb")
    status = os.fstat(file.fileno())
    own = status.st_uid in (os.geteuid(), _SYSTEM)
    if not own or not stat.S_ISREG(status.st_mode) or status.st_mode & _OTHERS_WRITE:
        file.close()
        raise PermissionError(f"{path}: somebody else can have written it")
    return file


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
            with opened(self._path) as file:
                content = file.read()
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
            beside.chmod(OWN_MODE)
            beside.replace(self._path)
        except OSError:
            with contextlib.suppress(OSError):
                beside.unlink(missing_ok=True)


def _validity(function: Callable[..., Any], stamp: bytes, version: str) -> Any:
    """All that kept code holds for; None where not all of it can be told."""
    code = _code_of(function)
    named = (os.path.basename(code.co_filename), function.__qualname__, code.co_firstlineno)
    closed_over = tuple(cell.cell_contents for cell in function.__closure__ or ())
    processor = _processor()
    if processor is None or not all(type(value) in _PLAIN for value in closed_over):
        return None
    return (stamp, named, repr(closed_over), version, sys.version, processor)


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
