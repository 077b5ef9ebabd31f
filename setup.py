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

from skytender.compiled import LIST, PACKAGES, compiled_sources, listing  # noqa: E402

# Equal bytes on every processor: no fused operations, no order of sums but the source's.
FLAGS = ["-O3", "-ffp-contract=off", "-fno-math-errno", "-fno-strict-aliasing", "-g0", "-Wno-discarded-qualifiers"]
DIRECTIVES = {
    "language_level": 3,
    "annotation_typing": False,  # types stand in the .pxd
    "boundscheck": False,
    "cdivision": True,
    "cpow": True,
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
    return [Extension(name, [source], extra_compile_args=FLAGS) for name, source in sources.items()]


class BuildExtensions(build_ext):
    """Keeps on record what it has compiled, by which a start knows old code."""

    def run(self) -> None:
        if self.inplace or self.editable_mode:  # what was compiled is kept, and only what has changed is compiled anew
            self.build_lib, self.build_temp = "build/lib", "build/temp"
        super().run()
        for package in PACKAGES:
            beside = ROOT / package if self.inplace or self.editable_mode else Path(self.build_lib) / package
            (beside / LIST).write_text(listing(ROOT, package))


class BuildPackages(build_py):
    """Puts the shipped scenarios into `gcs`, where a wheel keeps them, and no second copy of what is compiled."""

    def run(self) -> None:
        super().run()
        if not self.editable_mode:
            shutil.copytree(ROOT / "configs", Path(self.build_lib) / "gcs" / "configs", dirs_exist_ok=True)


setup(
    cmdclass={"build_ext": BuildExtensions, "build_py": BuildPackages},
    ext_modules=cythonize(
        extensions(),
        build_dir="build",
        compiler_directives=DIRECTIVES,
        nthreads=os.cpu_count() or 1,
        shared_utility_qualified_name=MEMORYVIEWS,
    ),
    options={"build_ext": {"parallel": os.cpu_count()}},
)
