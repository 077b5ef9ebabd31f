"""The walks of docs/contributing/architecture.md: each function is where the page says, and its caller names it."""

from __future__ import annotations

import ast
import functools
import re
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "contributing" / "architecture.md"
STEP = re.compile(r"^(?P<indent> *)- `(?P<file>[\w/.]+)` `(?P<function>[\w.]+)`(?: \(by `(?P<by>\w+)`\))?", re.M)
INDENT = 4


class Step(NamedTuple):
    """A function of a walk, and the one that calls it; none for a root, which takes up what `by` names."""

    file: str
    function: str
    by: str | None
    caller: Step | None

    @property
    def name(self) -> str:
        """The function's name without its class."""
        return self.function.rpartition(".")[2]


def walks() -> dict[str, str]:
    """Text of each walk by its title."""
    section = PAGE.read_text(encoding="utf-8").partition("\n## Walks\n")[2].partition("\n## ")[0]
    parts = re.split(r"^### (.+)$", section, flags=re.M)[1:]
    return dict(zip(parts[::2], parts[1::2], strict=True))


def module_of(file: str) -> str:
    """`gcs.link.link` of `gcs/link/link.py`."""
    return file.removesuffix(".py").replace("/", ".")


WALKS = walks()
SOURCES = {
    module_of(str(path.relative_to(ROOT))): str(path.relative_to(ROOT))
    for package in ("gcs", "skytender")
    for path in (ROOT / package).rglob("*.py")
}


def steps(title: str) -> list[Step]:
    """The steps of a walk, in order."""
    found: list[Step] = []
    above: list[Step] = []
    for match in STEP.finditer(WALKS[title]):
        depth = len(match["indent"]) // INDENT
        assert depth <= len(above), f"{match[0]} is indented too far"
        step = Step(match["file"], match["function"], match["by"], above[depth - 1] if depth else None)
        above[depth:] = [step]
        found.append(step)
    return found


@functools.cache
def tree(file: str) -> ast.Module:
    return ast.parse((ROOT / file).read_text(encoding="utf-8"))


@functools.cache
def names(file: str) -> frozenset[str]:
    """Everything that a source names: variables, attributes, imports; words of a script."""
    if not file.endswith(".py"):
        return frozenset(re.findall(r"\w+", (ROOT / file).read_text(encoding="utf-8")))
    found: set[str] = set()
    for node in ast.walk(tree(file)):
        match node:
            case ast.Name(id=name) | ast.Attribute(attr=name):
                found.add(name)
            case ast.alias(name=name):
                found.add(name.rpartition(".")[2])
    return frozenset(found)


@functools.cache
def imports(file: str) -> frozenset[str]:
    """Modules that a source imports, compiled ones too."""
    found: set[str] = set()
    for node in ast.walk(tree(file)):
        match node:
            case ast.Import(names=aliases):
                found |= {alias.name for alias in aliases}
            case ast.ImportFrom(module=str(module), names=aliases):
                found |= {module} | {f"{module}.{alias.name}" for alias in aliases}
    return frozenset(name.removeprefix("cython.cimports.") for name in found)


def members(body: list[ast.stmt]) -> dict[str, ast.AST]:
    """What a module or a class defines, by name."""
    found: dict[str, ast.AST] = {}
    for node in body:
        match node:
            case ast.FunctionDef(name=name) | ast.AsyncFunctionDef(name=name) | ast.ClassDef(name=name):
                found[name] = node
            case ast.Assign(targets=targets):
                found |= {target.id: node for target in targets if isinstance(target, ast.Name)}
            case ast.AnnAssign(target=ast.Name(id=name)):
                found[name] = node
    return found


def definition(step: Step) -> ast.AST | None:
    """The node that defines a step's function; the module for a class of a script."""
    if not step.file.endswith(".py"):
        text = (ROOT / step.file).read_text(encoding="utf-8")
        return ast.Module() if re.search(rf"\b(?:class|function) {step.name}\b", text) else None
    node: ast.AST | None = tree(step.file)
    for name in step.function.split("."):
        node = members(node.body).get(name) if isinstance(node, ast.Module | ast.ClassDef) else None
    return node


def knows(caller: str, step: Step) -> bool:
    """Whether a source imports a step's module, or a module that makes its objects, or names a class that the step's
    own derives from."""
    module = module_of(step.file)
    if caller == step.file or module in imports(caller):
        return True
    if any(module in imports(SOURCES[name]) for name in imports(caller) & SOURCES.keys()):
        return True
    owner = members(tree(step.file).body).get(step.function.partition(".")[0])
    bases = (
        {base.id for base in owner.bases if isinstance(base, ast.Name)} if isinstance(owner, ast.ClassDef) else set()
    )
    return bool(bases & names(caller))


@pytest.mark.parametrize("title", WALKS)
def test_each_function_of_a_walk_is_defined_in_its_file(title: str) -> None:
    assert steps(title)
    missing = [f"{step.file}: {step.function}" for step in steps(title) if definition(step) is None]
    assert missing == []


@pytest.mark.parametrize("title", WALKS)
def test_each_caller_of_a_walk_names_what_it_calls(title: str) -> None:
    wrong = [
        f"{step.caller.file} does not call {step.function} of {step.file}"
        for step in steps(title)
        if step.caller and not (step.name in names(step.caller.file) and knows(step.caller.file, step))
    ]
    assert wrong == []


@pytest.mark.parametrize("title", WALKS)
def test_a_walk_goes_on_by_what_both_sides_name(title: str) -> None:
    branches: list[list[Step]] = []
    for step in steps(title):
        if step.caller is None:
            branches.append([])
        branches[-1].append(step)
    for before, after in pairwise(branches):
        by = after[0].by
        assert by is not None, f"{after[0].file}: by what does the value come there?"
        for branch in (before, after):
            assert any(by in names(step.file) for step in branch), f"{by}: {[step.file for step in branch]}"


@pytest.mark.parametrize("title", WALKS)
def test_the_number_of_a_walks_files_is_right(title: str) -> None:
    stated = re.search(r"(\d+) files", WALKS[title])
    assert stated is not None
    assert int(stated[1]) == len({step.file for step in steps(title)})
