"""Compile what flies, plans and speaks: every Python file that has declarations of its C types (.pxd) beside it."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

from Cython.Build import cythonize
from Cython.Compiler import Options
from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py

ROOT = Path(__file__).resolve().parent
sys.path.insert(0, str(ROOT))  # an isolated build does not look there

from skytender.compiled import LIST, PACKAGES, changed, compiled_sources, listing  # noqa: E402

# Equal bytes on every processor: no fused operations, no order of sums but the source's.
FLAGS = ["-ffp-contract=off", "-fno-math-errno", "-fno-strict-aliasing", "-g0", "-w"]
FLOWN = ["-O3"]
# Nine tenths of the machine code of these, and all of Cython's own, handle Python's objects: -O3 would take twice the
# time to compile it and make it no faster. What the arithmetic in it gains by is that short functions become part of
# their callers and that loops over three axes are laid out.
PYTHONIC = ("gcs.", "simvehicle.autopilot.", "simvehicle.mavlink.", "simvehicle.sitl.")
AROUND_PYTHON = ["-O1", "-finline-functions", "-finline-small-functions", "-fpeel-loops"]
DIRECTIVES = {
    "language_level": 3,
    "annotation_typing": False,  # types stand in the .pxd
    "boundscheck": False,
    "cdivision": True,
    "cpow": True,
    "emit_code_comments": False,
    "infer_types": True,
    "initializedcheck": False,
    "wraparound": False,
}


MEMORYVIEWS = "skytender.memoryviews"
"""Cython's own code for arrays, once for all modules: each would take six seconds more to compile."""


Options.warning_errors = True


def extensions() -> list[Extension]:
    """One for each compiled source, and Cython's own."""
    sources = {".".join(source.with_suffix("").parts): str(source) for source in compiled_sources(ROOT)}
    sources[MEMORYVIEWS] = "skytender/memoryviews.c"
    around_python = {name for name in sources if name.startswith(PYTHONIC)} | {MEMORYVIEWS}
    return [
        Extension(name, [source], extra_compile_args=[*(AROUND_PYTHON if name in around_python else FLOWN), *FLAGS])
        for name, source in sources.items()
    ]


class BuildExtensions(build_ext):
    """Compiles into one folder, for a checkout and for a wheel, and again only what has changed. Keeps on record what
    it has compiled, by which a start knows old code."""

    def run(self) -> None:
        if self.editable_mode:  # pip gives a folder of its own, in which all would be compiled once more
            self.build_lib, self.build_temp = FOLDERS["build_lib"], FOLDERS["build_temp"]
        listed = {package: listing(ROOT, package) for package in PACKAGES}  # a source may change meanwhile
        self._write_c()
        super().run()
        beside = ROOT if self.inplace else Path(self.build_lib)
        made = {Path(self.get_ext_filename(one.name)) for one in self.extensions}
        for package in PACKAGES:
            for old in (beside / package).rglob("*.so"):
                if old.relative_to(beside) not in made:
                    old.unlink()  # Python would prefer it to the source that is no longer compiled
            kept = [line for line in listed[package] if (beside / line.split(maxsplit=1)[1]).exists()]
            (beside / package / LIST).write_text("".join(f"{line}\n" for line in kept))

    def _write_c(self) -> None:
        """The C of each source that is not what was compiled."""
        records = [package for package in PACKAGES if (ROOT / package / LIST).exists()]
        for source in (Path(path) for package in records for path in changed(package, str(ROOT))):
            if source.exists():
                source.touch()  # one that was put back from a copy may be older than its C
        made = cythonize(
            self.extensions,
            build_dir="build",
            compiler_directives=DIRECTIVES,
            force=any((ROOT / package / LIST).stat().st_mtime < Path(__file__).stat().st_mtime for package in records),
            nthreads=os.cpu_count() or 1,
            shared_utility_qualified_name=MEMORYVIEWS,
        )
        sources = {one.name: one.sources for one in made}
        for one in self.extensions:
            one.sources = sources[one.name]
        # The longest first: no processor waits for one that began last.
        self.extensions.sort(key=lambda one: os.path.getsize(one.sources[0]), reverse=True)


class BuildPackages(build_py):
    """Puts the shipped scenarios into `gcs`, where a wheel keeps them, and nothing that an earlier build has left."""

    def run(self) -> None:
        if not self.editable_mode:
            for package in PACKAGES:
                for old in (Path(self.build_lib) / package).rglob("*"):
                    if old.is_file() and old.suffix != ".so":
                        old.unlink()
        super().run()
        if not self.editable_mode:
            shutil.copytree(ROOT / "configs", Path(self.build_lib) / "gcs" / "configs", dirs_exist_ok=True)


FOLDERS = {"build_lib": "build/lib", "build_temp": "build/temp"}

setup(
    cmdclass={"build_ext": BuildExtensions, "build_py": BuildPackages},
    ext_modules=extensions(),
    options={"build": FOLDERS, "build_ext": {**FOLDERS, "parallel": os.cpu_count()}},
)
