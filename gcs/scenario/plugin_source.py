"""Look-up of MODULE:CLASS in source files, of which nothing runs."""

from __future__ import annotations

import ast
import importlib.util
import traceback
from collections.abc import Iterator, Sequence
from importlib.machinery import ModuleSpec, PathFinder
from pathlib import Path

from gcs.scenario.document import did_you_mean


def check(name: str, folders: Sequence[Path]) -> None:
    """Raise ValueError, one sentence, where there is no such module, or its source binds no such name."""
    module_name, _, attribute = name.partition(":")
    spec = _find(module_name, folders)
    if spec.origin is None or not spec.origin.endswith(".py"):
        return
    try:
        tree = ast.parse(Path(spec.origin).read_bytes(), spec.origin)
    except (OSError, SyntaxError, ValueError) as error:
        raise ValueError(f"{module_name} cannot be imported: {where(error)}") from None
    bound = set(_bound(tree.body))
    if attribute not in bound and not bound & {"*", "__getattr__"}:
        near = did_you_mean(attribute, (word for word in bound if not word.startswith("_")))
        raise ValueError(f"{module_name} ({spec.origin}) has no {attribute!r}{near}")


def source(module_name: str, folders: Sequence[Path]) -> Path | None:
    """File of a module; None where there is none."""
    try:
        origin = _find(module_name, folders).origin
    except ValueError:
        return None
    return Path(origin) if origin is not None else None


def where(error: BaseException) -> str:
    """`TypeError at FILE:LINE: text`, of the innermost place."""
    if isinstance(error, SyntaxError):  # in a file that has not run, so that it is in no traceback
        file, line, text = error.filename or "?", error.lineno, error.msg
    else:
        place = traceback.extract_tb(error.__traceback__)[-1]
        file, line, text = place.filename, place.lineno, str(error)
    return f"{type(error).__name__} at {Path(file).name}:{line}: {' '.join(text.split())}"


def _find(module_name: str, folders: Sequence[Path]) -> ModuleSpec:
    """The module's spec; packages around it are looked up, too, and not imported."""
    first, *rest = module_name.split(".")
    spec = importlib.util.find_spec(first) or PathFinder.find_spec(first, [str(folder) for folder in folders])
    path = first
    for part in rest:
        if spec is None:
            break
        path = f"{path}.{part}"
        spec = PathFinder.find_spec(path, spec.submodule_search_locations or [])
    if spec is None:
        raise ValueError(f"there is no module {path!r}; put it beside the scenario or install its package")
    return spec


def _bound(body: Sequence[ast.stmt]) -> Iterator[str]:
    """Names that statements of a module may bind, also under a condition; `*` for all names of another module."""
    for statement in body:
        for node in ast.walk(statement):
            if isinstance(node, ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef):
                yield node.name
            elif isinstance(node, ast.Import | ast.ImportFrom):
                yield from ((alias.asname or alias.name).partition(".")[0] for alias in node.names)
            elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
                yield node.id
