"""Kernels on disk: compiled once, called without numba, compiled anew when their source changes."""

import os
import re
import shutil
import subprocess
import sys
from collections import namedtuple
from enum import IntEnum
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numba import njit
from numba.core.errors import TypingError

from gcs.kernels import kept_code
from gcs.kernels.argument_types import ArgumentTypes
from simvehicle.kernels import UNCOUNTED
from simvehicle.kernels import kept_code as kept_code_of_vehicles

SOURCE = """
from collections import namedtuple
from {package}.kernels import inner, kernel, overload

Pair = namedtuple("Pair", "first second")

def chosen(value):
    raise NotImplementedError

@overload(chosen)
def _choose(value):
    return lambda value: value + {offset}

@inner(inline="always")
def raised(value):
    return chosen(value)

@kernel()
def least(values):
    return raised(values.min())

@kernel()
def split(pair, more, by=2.0):
    return pair.first[more[0]:] / by, more[1]

@kernel()
def refused(value):
    if value > 1:
        raise ValueError("more than one")
    return value

@kernel()
def size(row, data):
    row.count += 1
    return row.count + len(data)
"""
PROGRAM = """
import sys
import numpy as np
from source import Pair, least, refused, size, split

def loaded():
    return "numba" in sys.modules or "llvmlite" in sys.modules

{calls}
"""
ALL = """
row = np.array([(5, 1.0)], [("count", "i8"), ("weight", "f4")])[0:1]
print(least(np.array([3.0, 2.0])), size(row[0], b"12"), row["count"][0], end=" ")
print(*split(Pair(np.arange(3.0), 1.0), (1, True)), *split(Pair(np.arange(3.0), 1.0), (1, True), by=4.0), end=" ")
print(refused(1), loaded(), end=" ")
"""


class Programs:
    """Runs programs that call the kernels of SOURCE, which are kept in a folder."""

    def __init__(self, folder: Path, package: str) -> None:
        self.folder, self.package, self.offset = folder, package, 1.5

    def printed(self, calls: str, **settings: str) -> str:
        """Output of a program."""
        (self.folder / "source.py").write_text(SOURCE.format(package=self.package, offset=self.offset))
        environment = os.environ | {
            "NUMBA_CACHE_DIR": str(self.folder / "kept"),
            "PYTHONPATH": os.pathsep.join([str(self.folder), *filter(None, [os.environ.get("PYTHONPATH")])]),
        }
        command = [sys.executable, "-c", PROGRAM.format(calls=calls)]
        done = subprocess.run(
            command, cwd=self.folder, env=environment | settings, capture_output=True, text=True, check=False
        )
        assert done.returncode == 0, done.stderr
        return done.stdout.strip()


@pytest.fixture
def programs(tmp_path: Path) -> Programs:
    return Programs(tmp_path, "gcs")


@pytest.mark.parametrize("package", ["gcs", "simvehicle"])
def test_a_kernel_is_compiled_once_and_again_when_its_source_changes(package: str, tmp_path: Path) -> None:
    programs = Programs(tmp_path, package)
    right = "3.5 8 6 [0.5 1. ] True [0.25 0.5 ] True 1"
    assert programs.printed(ALL) == f"{right} True"
    assert programs.printed(ALL) == f"{right} False"
    programs.offset = -1.5
    assert programs.printed(ALL) == f"{right.replace('3.5', '0.5')} True"
    assert programs.printed(ALL) == f"{right.replace('3.5', '0.5')} False"


ARRAYS = {
    "floats": "np.array([4.0, 2.0])",
    "ints": "np.array([3, 2])",
    "small ints": "np.array([3, 2], np.int8)",
    "small floats": "np.array([3, 2], np.float32)",
    "strided": "np.array([9.0, 3.0, 1.0, 2.0])[1::2]",
    "only to be read": "np.broadcast_to(np.array([2.0]), 1)",
    "table": "np.array([[3.0, 2.0]]).repeat(2, 0)",
    "of Fortran": "np.asfortranarray([[3.0, 2.0], [5.0, 2.5]])",
}


def test_arrays_of_other_types_get_code_of_their_own(programs: Programs) -> None:
    def right(array: str) -> str:
        return str(eval(array, {"np": np}).min() + 1.5)

    first, *others = ARRAYS.values()
    programs.printed(f"least({first})")
    calls = f"print(least({first}), loaded(), " + ", ".join(f"least({array})" for array in others) + ", loaded())"
    rights = " ".join(right(array) for array in others)
    assert programs.printed(calls) == f"{right(first)} False {rights} True"
    assert programs.printed(calls) == f"{right(first)} False {rights} False"


def test_no_two_types_of_arguments_are_taken_for_each_other() -> None:
    types = ArgumentTypes()
    records = [np.zeros(1, [("a", "f8"), ("b", kind)]) for kind in ("i4", "f4")]
    swapped = np.zeros(1, ">f8")
    arrays = [eval(array, {"np": np}) for array in ARRAYS.values()]
    pairs = [namedtuple(name, "a b")(1, 2) for name in ("One", "Other")]
    values = [*arrays, *records, records[0][0], *pairs, (1, 2), (1, 2.0), (1,), 1, 1.0, True, 1j, b"1", np.int8(1)]
    codes = [types[types.key_of(value)]._code for value in values]
    assert len(set(codes)) == len(values)
    strange = [swapped, "1", None, [1], {1}, np.array("1"), np.ma.array([1.0]), IntEnum("Small", "one").one, (1, "1")]
    assert {types.key_of(value) for value in strange} == {None}
    same = [(1, np.int64(1)), (1.0, np.float64(1.0)), (True, np.bool_(True)), (arrays[0], arrays[0][:1].copy())]
    assert [types.key_of(one) == types.key_of(other) for one, other in same] == [True] * len(same)


def test_a_float_is_never_taken_for_a_whole_number(programs: Programs) -> None:
    calls = "print(refused(1), refused(0.5), refused(np.float32(0.25)), refused(True), refused(np.int64(1)))"
    assert programs.printed("refused(1)") == ""
    for _ in range(2):
        assert programs.printed(calls) == "1 0.5 0.25 True 1"


def test_what_kept_code_raises_is_raised(programs: Programs) -> None:
    calls = """
try:
    refused(2)
except ValueError as error:
    print(error, refused(1))
"""
    for _ in range(2):
        assert programs.printed(calls) == "more than one 1"


def test_numba_may_be_loaded_by_others_at_any_time(programs: Programs) -> None:
    calls = """
values = np.array([3.0, 2.0])
print(least(values), loaded(), end=" ")
import numba
@numba.njit
def doubled(values):
    return 2 * least(values)
print(doubled(values), least(values), doubled(np.array([3, 2])), type(least).__module__.split(".")[0])
"""
    programs.printed("least(np.array([3.0, 2.0]))")
    assert programs.printed(calls) == "3.5 False 7.0 3.5 7.0 numba"


def test_both_programs_call_kept_code_in_one_process(programs: Programs) -> None:
    calls = """
import other
values = np.arange(4.0)
print(least(values), other.least(values[::2]), least(values[:2]), other.least(values[::2]), loaded(), end=" ")
print(other.least(values), least(values[::2]), loaded())
"""
    source = SOURCE.format(package="simvehicle", offset=2.5)
    (programs.folder / "other.py").write_text(source)
    programs.printed("import other\nleast(np.arange(4.0)), other.least(np.arange(4.0)[::2])")
    assert programs.printed(calls) == "1.5 2.5 1.5 2.5 False 2.5 1.5 True"


@pytest.mark.parametrize("content", [b"", b"kept code 1\n", None], ids=["empty", "cut", "of another day"])
def test_a_broken_file_is_passed_over(content: bytes | None, programs: Programs) -> None:
    programs.printed("least(np.array([3.0, 2.0]))")
    (path,) = programs.folder.glob("kept/*/*.kept")
    whole = path.read_bytes()
    path.write_bytes(whole[:500] + bytes([whole[500] ^ 1]) + whole[501:] if content is None else content)
    calls = "print(least(np.array([3.0, 2.0])), loaded())"
    assert programs.printed(calls) == "3.5 True"
    assert programs.printed(calls) == "3.5 False"


PARTS = {
    "__init__": "",
    "sizes": "SURFACE_M = {surface}\n",
    "inner": """
from gcs.kernels import inner
from part.sizes import SURFACE_M

@inner()
def distance(x):
    return x - SURFACE_M
""",
    "entry": """
from gcs.kernels import kernel
from part.inner import distance

@kernel()
def clearance(x):
    return 2.0 * distance(x)
""",
}


def test_code_is_compiled_anew_when_any_file_that_it_is_made_of_changes(tmp_path: Path) -> None:
    """A kernel takes a constant from a module without a kernel, through a compiled function of a third one."""
    (tmp_path / "part").mkdir()
    program = "import sys; from part.entry import clearance; print(clearance(10.0), 'numba' in sys.modules)"

    def printed(surface: float) -> str:
        for name, source in PARTS.items():
            (tmp_path / "part" / f"{name}.py").write_text(source.format(surface=surface))
        # Python takes a .pyc for new where the source has the same size and second as before, as these two have.
        command = [sys.executable, "-B", "-c", program]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
        return done.stdout.strip()

    assert [printed(1.0), printed(1.0)] == ["18.0 True", "18.0 False"]
    assert [printed(1.5), printed(1.5)] == ["17.0 True", "17.0 False"]


FIRST = {"gcs": kept_code, "simvehicle": kept_code_of_vehicles}
LOADED = """
import importlib, sys
from pathlib import Path
for name in sys.argv[2:]:
    importlib.import_module(name)
print(*sorted(name for name in sys.modules if name.split(".")[0] == sys.argv[1]))
"""


@pytest.mark.parametrize("package", ["gcs", "simvehicle"])
def test_every_module_that_compiled_code_is_made_of_is_in_its_key(package: str, tmp_path: Path) -> None:
    """All that Python loads with the modules that hold kernels, one at a time, gets other numbers in its source."""
    whole = Path(str(FIRST[package].__file__)).parents[1]
    copy = tmp_path / package
    shutil.copytree(whole, copy, ignore=shutil.ignore_patterns("__pycache__", "node_modules"))
    usual = kept_code.digest(str(copy))
    assert usual == kept_code.digest(str(whole)) == kept_code.stamp_of(FIRST[package].is_current)
    paths = {".".join(p.relative_to(tmp_path).with_suffix("").parts).removesuffix(".__init__"): p
             for p in copy.rglob("*.py")}  # fmt: skip
    compiled = [name for name, path in paths.items() if re.search(r"@(kernel|inner)\(|= kernel\(", path.read_text())]
    command = [sys.executable, "-c", LOADED, package, *compiled]
    loaded = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert len(set(compiled) & set(loaded)) == len(compiled) > 15
    for name in loaded:
        source = paths[name].read_text(encoding="utf-8")
        paths[name].write_text(f"{source}\nEXTRA = 1\n", encoding="utf-8")
        assert kept_code.digest(str(copy)) != usual, name
        paths[name].write_text(source, encoding="utf-8")
    assert kept_code.digest(str(copy)) == usual


def test_code_that_somebody_else_can_have_written_is_not_loaded(programs: Programs) -> None:
    calls = "print(least(np.array([3.0, 2.0])), loaded())"
    assert [programs.printed(calls), programs.printed(calls)] == ["3.5 True", "3.5 False"]
    files = [path for path in programs.folder.glob("kept/*/*") if "least" in path.name]
    assert {path.suffix for path in files} == {".kept", ".nbi", ".nbc"}
    assert {path.stat().st_mode & 0o777 for path in files} == {0o644}
    for path in files:
        path.chmod(0o666)
        with pytest.raises(PermissionError):
            kept_code.opened(path)
        path.chmod(0o664)
        with pytest.raises(PermissionError):
            kept_code.opened(path)
        path.chmod(0o644)
        link = path.with_name("link")
        link.symlink_to(path)
        with pytest.raises(OSError, match="symbolic links"):
            kept_code.opened(link)
        link.unlink()
        kept_code.opened(path).close()
    for path in files:  # each is compiled anew, and its file replaced
        path.chmod(0o666)
    assert [programs.printed(calls), programs.printed(calls)] == ["3.5 True", "3.5 False"]
    assert {path.stat().st_mode & 0o777 for path in files} == {0o644}


def test_nor_is_code_of_another_user(monkeypatch: pytest.MonkeyPatch, programs: Programs) -> None:
    programs.printed("least(np.array([3.0, 2.0]))")
    monkeypatch.setattr(kept_code, "_SYSTEM", -1)
    monkeypatch.setattr(os, "geteuid", lambda: os.getuid() + 1)
    for path in programs.folder.glob("kept/*/*"):
        with pytest.raises(PermissionError):
            kept_code.opened(path)


def test_settings_in_the_working_folder_are_not_read(programs: Programs) -> None:
    """Neither when numba is imported nor when it compiles, which is when numba by itself reads them."""
    (programs.folder / ".numba_config.yaml").write_text("cache_dir: planted\nopt: 0\ndisable_jit: 1\n")
    calls = "print(least(np.array([3.0, 2.0])), loaded(), end=' ')"
    others = (
        "least(np.array([3, 2])); from numba import config; print(config.CACHE_DIR, config.DISABLE_JIT, config.OPT)"
    )
    kept = str(programs.folder / "kept")
    assert programs.printed(f"{calls}; {others}") == f"3.5 True {kept} 0 _OptLevel(3)"
    assert programs.printed(calls) == "3.5 False"
    assert not (programs.folder / "planted").exists()


def test_a_full_disk_keeps_nothing_and_ends_nothing(programs: Programs) -> None:
    """The largest file that the program may write is of no byte, as on a disk without room."""
    calls = "print(least(np.array([3.0, 2.0])), loaded())"
    full = "import resource, signal; signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
    full += "resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))\n"
    assert programs.printed(full + calls + "; sys.stdout.flush()") == "3.5 True"
    assert not list(programs.folder.glob("kept/*/*"))
    assert [programs.printed(calls), programs.printed(calls)] == ["3.5 True", "3.5 False"]


def test_a_setting_of_numbas_leaves_all_to_numba(programs: Programs) -> None:
    calls = "print(least(np.array([3.0, 2.0])), loaded(), type(least).__name__)"
    programs.printed(calls)
    assert programs.printed(calls, NUMBA_OPT="2") == "3.5 True CPUDispatcher"
    assert programs.printed("print(refused(1), type(refused).__name__)", NUMBA_DISABLE_JIT="1") == "1 function"
    assert programs.printed(calls, NUMBA_NUM_THREADS="1") == "3.5 False Prepared"


def test_nothing_is_kept_where_nothing_can_be_written(programs: Programs) -> None:
    calls = "print(least(np.array([3.0, 2.0])), loaded())"
    programs.printed(calls)
    (path,) = programs.folder.glob("kept/*/*.kept")
    path.unlink()
    path.mkdir()
    assert programs.printed(calls) == "3.5 True"
    assert list(path.parent.glob("*.kept*")) == [path]


def test_an_uncounted_function_counts_no_references_and_refuses_to_make_an_array() -> None:
    row = np.array([3.0, 2.0])

    def foot(values: Any) -> Any:
        while values.size > 1 and values[0] > values[1]:
            values = values[1:]
        return values[0]

    code = {}
    for name, options in (("usual", {}), ("uncounted", UNCOUNTED)):
        compiled: Any = njit(**options)(foot)
        assert compiled(row) == 2.0
        code[name] = compiled.inspect_llvm(compiled.signatures[0])
    assert "NRT_incref" in code["usual"]
    assert "NRT_incref" not in code["uncounted"]

    @njit(**UNCOUNTED)  # type: ignore[untyped-decorator]
    def longer(values: Any) -> Any:
        return np.zeros(values.size + 1)

    with pytest.raises(TypingError, match="zeros"):
        longer(row)
