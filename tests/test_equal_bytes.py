"""What flies gives the same bytes on every processor: no function whose result depends on the C library, on NumPy's or
the compiler's choice of instructions (docs/contributing/native.md#equal-bytes)."""

from __future__ import annotations

import ast
import subprocess
import sysconfig
from collections.abc import Iterator
from pathlib import Path

from skytender import compiled

ROOT = Path(__file__).resolve().parents[1]
SUFFIX = sysconfig.get_config_var("EXT_SUFFIX")
AFTERWARDS = (
    *("gcs/report", "gcs/console", "gcs/web", "gcs/cli", "gcs/recording", "simvehicle/paper"),
    *("gcs/scenario/plot.py", "gcs/campaign/statistics.py"),
)
"""Packages that judge and show what has flown."""
EXACT = {"ceil", "copysign", "fabs", "floor", "fmod", "frexp", "ldexp", "rint", "round", "scalbn", "sqrt", "trunc"}
"""Functions of libm that IEEE 754 defines to the last bit."""
OF_MATH = EXACT | {
    "degrees", "inf", "isclose", "isfinite", "isinf", "isnan", "isqrt", "nan", "nextafter", "pi", "prod", "radians",
    "remainder", "tau", "ulp",
}  # fmt: skip
OF_LIBC = {"M_PI", "NAN", "INFINITY", "signbit"}
NOT_OF_NUMPY = {
    "arccos", "arcsin", "arctan", "arctan2", "argpartition", "cbrt", "convolve", "correlate", "cos", "cosh", "dot",
    "einsum", "exp", "exp2", "expm1", "float_power", "hypot", "inner", "interp", "log", "log10", "log1p", "log2",
    "logaddexp", "matmul", "partition", "polyfit", "polyval", "power", "sin", "sinh", "tan", "tanh", "tensordot",
    "vdot",
}  # fmt: skip
OF_LINALG = {"norm"}
"""Along an axis it is a sum of squares; of a whole array it is BLAS's."""
NOT_OF_GENERATORS = {
    "beta", "binomial", "chisquare", "exponential", "gamma", "gauss", "lognormal", "multivariate_normal", "normal",
    "normalvariate", "poisson", "standard_exponential", "standard_gamma", "standard_normal",
}  # fmt: skip


def of_libm() -> set[str]:
    """Names that the C library of mathematics gives out."""
    asked = subprocess.run(["cc", "-print-file-name=libm.so.6"], capture_output=True, text=True, check=True)
    return set(names("--defined-only", Path(asked.stdout.strip()))) - EXACT


def names(which: str, file: Path) -> Iterator[str]:
    said = subprocess.run(["nm", "-D", which, str(file)], capture_output=True, text=True, check=True).stdout
    return (line.split()[-1].split("@")[0] for line in said.splitlines())


def flown() -> list[Path]:
    files = (file for package in compiled.PACKAGES for file in sorted((ROOT / package).rglob("*.py")))
    return [file for file in files if not file.relative_to(ROOT).as_posix().startswith(AFTERWARDS)]


def test_compiled_modules_take_only_exact_functions_from_the_c_library() -> None:
    inexact, taken = of_libm(), {}
    for source in compiled.compiled_sources(ROOT):
        if not source.as_posix().startswith(AFTERWARDS):
            wanted = inexact & set(names("--undefined-only", (ROOT / source).with_suffix(SUFFIX)))
            taken.update({source.as_posix(): wanted} if wanted else {})
    assert "pow" in inexact
    assert taken == {}


def _dotted(node: ast.expr) -> str:
    """`np.linalg` and the like; what is no name is empty."""
    if isinstance(node, ast.Attribute):
        return f"{_dotted(node.value)}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def _called(tree: ast.Module) -> Iterator[str]:
    """Functions in a module that are not exact, each with its line."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and not _is_exact(_dotted(node.value), node.attr):
            yield f"{node.lineno}: {ast.unparse(node)}"
        elif isinstance(node, ast.Call) and _dotted(node.func) == "np.linalg.norm":
            if not any(keyword.arg == "axis" for keyword in node.keywords):
                yield f"{node.lineno}: np.linalg.norm without an axis"
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "argsort":
            if not any(word.arg == "kind" and ast.unparse(word.value) == "'stable'" for word in node.keywords):
                yield f"{node.lineno}: argsort that is not stable, which orders equal values by the processor"
        elif isinstance(node, ast.Import) and "pymap3d" in {name.name for name in node.names}:
            yield f"{node.lineno}: pymap3d, whose sines are NumPy's; skytender/geodesy.py has it"
        elif isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow) and not _is_whole(node):
            yield f"{node.lineno}: {ast.unparse(node)}"


def _is_exact(of: str, name: str) -> bool:
    if of == "math":
        return name in OF_MATH | OF_LIBC
    if of == "np":
        return name not in NOT_OF_NUMPY
    if of == "np.linalg":
        return name in OF_LINALG
    return not (of.endswith(("rng", "random", "generator")) and name in NOT_OF_GENERATORS)


def _is_whole(power: ast.BinOp) -> bool:
    return isinstance(power.left, ast.Constant) and isinstance(power.left.value, int)


def test_python_takes_only_exact_functions() -> None:
    found = []
    for file in flown():
        compiled_too = file.with_suffix(".pxd").exists()  # a square is a product; the test above finds other powers
        called = [one for one in _called(ast.parse(file.read_text())) if not (compiled_too and "**" in one)]
        found += [f"{file.relative_to(ROOT)}:{one}" for one in called]
    assert found == []
