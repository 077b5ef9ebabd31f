"""Machine code as numba compiles it, an ELF file for x86-64, made ready to be loaded in a moment.

numba has LLVM read and link its code whenever it is loaded. Here it is laid out once (`link`), and what is left for
`load` is to add addresses: of where it stands now, and of what it calls.
"""

from __future__ import annotations

import builtins
import ctypes
import functools
import mmap
import pickle
import struct
import sys
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

import numpy as np

from simvehicle.kernels.extensions import Extensions

_PAGE = mmap.PAGESIZE
_READ, _EXECUTE = 1, 4  # of mprotect
_ELF = b"\x7fELF\x02\x01\x01"  # 64 bits, the least byte first
_RELOCATABLE, _X86_64 = 1, 62
_SYMBOLS, _RELOCATIONS, _NO_BITS = 2, 4, 8  # types of sections
_ALLOCATED, _EXECUTABLE = 2, 4  # flags of sections
_UNDEFINED, _COMMON = 0, 0xFFF2  # numbers of sections
_NOWHERE = -1
_ABSOLUTE = 1  # R_X86_64_64: an address in eight bytes
_UNWINDING = ".eh_frame"  # only read where C++ throws, which this code never lets happen


class Unfit(Exception):
    """Code of a kind that is left to numba."""


class Image(NamedTuple):
    """Code of a kernel for arguments of some types; only bytes, numbers and text."""

    content: bytes
    """code from the beginning, data from `data_at` on"""
    data_at: int
    size: int
    """with the zeros behind its content"""
    places: bytes
    """offsets of eight bytes (<u4) to which addresses are added,"""
    whose: bytes
    """and whose address each takes (<u2): 0 the image's, k that of names[k - 1]"""
    names: tuple[str, ...]
    entry: int
    """offset of the function that the interpreter calls"""
    environments: tuple[tuple[int, bytes], ...]
    """offset of each pointer to an environment, and its constants, pickled if any; the first is the entry's"""


class _Section(NamedTuple):
    name: str
    type: int
    flags: int
    at: int
    size: int
    link: int
    info: int
    alignment: int


def link(elf: bytes, entry: str, environments: Iterable[tuple[str, list[Any]]]) -> Image:
    """Lay out code as it will stand in memory.

    Args:
        elf: a relocatable file.
        entry: name of the function that the interpreter calls.
        environments: name and constants of each, the entry's first.

    Raises:
        Unfit: for another machine, or of parts that are not known here.
    """
    try:
        return _link(elf, entry, environments)
    except (struct.error, IndexError, KeyError, ValueError, pickle.PicklingError) as error:
        raise Unfit(str(error)) from None


def _link(elf: bytes, entry: str, environments: Iterable[tuple[str, list[Any]]]) -> Image:
    if elf[: len(_ELF)] != _ELF or struct.unpack_from("<HH", elf, 16) != (_RELOCATABLE, _X86_64):
        raise Unfit("no code of this kind of machine")
    sections = _sections(elf)
    starts, data_at, end = _layout(sections)
    symbols, size = _symbols(elf, sections, starts, end)
    content = bytearray(end)
    for number, start in starts.items():
        section = sections[number]
        if section.type != _NO_BITS:
            content[start : start + section.size] = elf[section.at : section.at + section.size]
    names: dict[str, int] = {}
    places, whose = [], []
    for section in sections:
        if section.type != _RELOCATIONS or section.info not in starts:
            continue
        for at in range(section.at, section.at + section.size, 24):
            offset, kind, symbol, addend = struct.unpack_from("<QIIq", elf, at)
            if kind != _ABSOLUTE:
                raise Unfit(f"a relocation of kind {kind}")
            name, defined_at = symbols[symbol]
            if defined_at == _NOWHERE:
                raise Unfit(f"a relocation to {name or 'a section'} that is not loaded")
            place = starts[section.info] + offset
            struct.pack_into("<q", content, place, addend + (0 if defined_at is None else defined_at))
            places.append(place)
            whose.append(0 if defined_at is not None else names.setdefault(name, len(names) + 1))
    defined = {name: at for name, at in symbols if at is not None}
    return Image(
        content=bytes(content),
        data_at=data_at,
        size=size,
        places=np.array(places, "<u4").tobytes(),
        whose=np.array(whose, "<u2").tobytes(),
        names=tuple(names),
        entry=defined[entry],
        environments=tuple(
            (defined[name], pickle.dumps(constants) if constants else b"") for name, constants in environments
        ),
    )


def _sections(elf: bytes) -> list[_Section]:
    (table,) = struct.unpack_from("<Q", elf, 40)
    size, count, names = struct.unpack_from("<HHH", elf, 58)
    rows = [struct.unpack_from("<IIQQQQIIQQ", elf, table + i * size) for i in range(count)]
    names_at = rows[names][4]
    return [
        _Section(_text(elf, names_at + name), kind, flags, at, length, linked, info, max(alignment, 1))
        for name, kind, flags, _, at, length, linked, info, alignment, _ in rows
    ]


def _layout(sections: list[_Section]) -> tuple[dict[int, int], int, int]:
    """Where each section that is needed begins, where data begin, and where all ends."""
    starts: dict[int, int] = {}
    end = data_at = 0
    for executable in (_EXECUTABLE, 0):
        data_at = end = -(-end // _PAGE) * _PAGE
        for number, section in enumerate(sections):
            needed = section.flags & _ALLOCATED and section.name != _UNWINDING
            if needed and section.flags & _EXECUTABLE == executable:
                starts[number] = -(-end // section.alignment) * section.alignment
                end = starts[number] + section.size
    return starts, data_at, end


def _symbols(
    elf: bytes, sections: list[_Section], starts: dict[int, int], end: int
) -> tuple[list[tuple[str, int | None]], int]:
    """Name and offset of each symbol, None for one from elsewhere; and the end of all, with what has no content."""
    (table,) = (section for section in sections if section.type == _SYMBOLS)
    names_at = sections[table.link].at
    symbols: list[tuple[str, int | None]] = []
    for at in range(table.at, table.at + table.size, 24):
        name, _, _, section, value, size = struct.unpack_from("<IBBHQQ", elf, at)
        offset = None
        if section == _COMMON:  # `value` is its alignment
            offset = -(-end // value) * value
            end = offset + size
        elif section != _UNDEFINED:
            offset = starts[section] + value if section in starts else _NOWHERE
        symbols.append((_text(elf, names_at + name), offset))
    return symbols, end


def _text(elf: bytes, at: int) -> str:
    return elf[at : elf.index(b"\0", at)].decode("ascii")


def load(image: Image, function: Callable[..., Any], extensions: Extensions) -> Any:
    """The compiled function, which takes arguments of its types unchecked.

    Args:
        image: from `link`.
        function: of which it was compiled.

    Raises:
        OSError: the system lends no memory to run code in.
        AttributeError: it calls a function that is not there.
    """
    memory = mmap.mmap(-1, image.size, mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
    start = ctypes.addressof(ctypes.c_char.from_buffer(memory))
    memory.write(image.content)
    addresses = np.array([start, *(_address(name, extensions) for name in image.names)], np.uint64)
    places = np.frombuffer(image.places, "<u4")[:, None] + np.arange(8, dtype=np.uint32)
    content = np.frombuffer(memory, np.uint8)
    sums = content[places].view(np.uint64)[:, 0] + addresses[np.frombuffer(image.whose, "<u2")]
    content[places] = sums[:, None].view(np.uint8)
    environments = []
    for at, constants in image.environments:
        environment = extensions.dynfunc.Environment(function.__globals__)
        if constants:
            environment.consts[:] = pickle.loads(constants)
        struct.pack_into("<Q", memory, at, id(environment))
        environments.append(environment)
    if _PROCESS.mprotect(ctypes.c_void_p(start), ctypes.c_size_t(image.data_at), _READ | _EXECUTE):
        raise OSError(ctypes.get_errno(), "mprotect")
    module, text, entry = sys.modules[function.__module__], function.__doc__ or "", start + image.entry
    loaded = extensions.dynfunc.make_function(module, function.__name__, text, entry, environments[0], ())
    _LOADED.append((loaded, memory, environments))
    return loaded


_LOADED: list[Any] = []
"""Code stays: numba's dispatcher borrows it, and so does whoever runs it now."""


@ctypes.PYFUNCTYPE(ctypes.py_object, ctypes.c_void_p, ctypes.c_int, ctypes.c_void_p)
def _unpickle(at: int, size: int, _: int) -> Any:
    """An object that compiled code makes by its pickle, such as the class of an array that it returns."""
    if at not in _UNPICKLED:
        _UNPICKLED[at] = pickle.loads(ctypes.string_at(at, size))
    return _UNPICKLED[at]


_UNPICKLED: dict[int, Any] = {}


_PROCESS = ctypes.CDLL(None, use_errno=True)
"""All that the interpreter is linked with."""


@functools.cache  # kernels call much the same
def _address(name: str, extensions: Extensions) -> int:
    """Of a function or an object, by the name that numba gives it."""
    if name == "numba_unpickle":  # numba's own would load numba
        return ctypes.cast(_unpickle, ctypes.c_void_p).value or 0
    if name == "_Py_NoneStruct":
        return id(None)
    if name.startswith("PyExc_"):
        return id(getattr(builtins, name.removeprefix("PyExc_")))
    for prefix, helpers in (
        ("numba_", extensions.helpers.c_helpers),
        ("numba_", extensions.dynfunc.c_helpers),
        ("NRT_", extensions.runtime.c_helpers),
        ("", extensions.helpers.c_helpers),  # of mathematics
    ):
        if name.startswith(prefix) and name.removeprefix(prefix) in helpers:
            return int(helpers[name.removeprefix(prefix)])
    return ctypes.cast(_PROCESS[name], ctypes.c_void_p).value or 0
