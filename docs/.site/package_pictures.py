"""The pages and the pictures of the packages: which module imports which, and what each holds, read from the code."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from cells import UP, cell, escaped, prose

PROGRAMS = ("gcs", "simvehicle")
SHARED = "skytender"
"""The package that both programs import; one box in their pictures."""
MOST_IN_A_ROW = 6
"""Boxes side by side in a picture of modules; a floor with more of them has several rows."""


def pages(root: Path) -> dict[str, str]:
    """Text of each page and picture, by the file's name; `root` is the folder of the packages."""
    modules = modules_of(root, (*PROGRAMS, SHARED))
    imports = imports_by_module(modules)
    graph = imports_by_package(imports)
    pictures = {
        f"packages-{program}.svg": drawing(
            {a: below for a, below in graph.items() if a.partition(".")[0] in (program, SHARED)}
        )
        for program in PROGRAMS
    }
    for package in graph:
        if len(own := inside(imports, package)) > 1:
            pictures[picture_of(package)] = drawing(own, most_in_a_row=MOST_IN_A_ROW)
    with_page = sorted(name for name in graph if modules[name].name == "__init__.py")
    texts = {
        page_of(name): package_page(root, name, graph, modules, drawn=picture_of(name) in pictures)
        for name in with_page
    }
    return {"index.md": overview(graph, with_page), **texts, **pictures}


def page_of(package: str) -> str:
    """Name of a package's page."""
    return f"{package.replace('.', '-')}.md"


def picture_of(package: str) -> str:
    """Name of the picture of a package's modules."""
    return f"modules-{package.replace('.', '-')}.svg"


def modules_of(root: Path, names: Sequence[str]) -> dict[str, Path]:
    """Module → its file, of these packages and all that they hold."""
    return {
        ".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__"): path
        for name in names
        for path in sorted((root / name).rglob("*.py"))
    }


def package_of(module: str) -> str:
    """The box in which a module stands in the pictures: a folder directly in a program, or the program itself."""
    program, _, rest = module.partition(".")
    below = rest.split(".")[0]
    return program if program == SHARED or below in ("", "__main__", "pytest_plugin") else f"{program}.{below}"


def imports_by_module(modules: Mapping[str, Path]) -> dict[str, set[str]]:
    """Module → modules that it imports, itself left out. Imports for type checking only do not count."""
    return {
        module: set(imported_modules(ast.parse(path.read_text(encoding="utf-8")), modules)) - {module}
        for module, path in modules.items()
    }


def imports_by_package(imports: Mapping[str, set[str]]) -> dict[str, set[str]]:
    """Package → packages that it imports, itself left out."""
    graph: dict[str, set[str]] = {package_of(module): set() for module in imports}
    for module, below in imports.items():
        graph[package_of(module)] |= {package_of(other) for other in below} - {package_of(module)}
    return graph


def inside(imports: Mapping[str, set[str]], package: str) -> dict[str, set[str]]:
    """Module → modules that it imports, of one package alone, by their names in it."""
    own = {module for module in imports if package_of(module) == package and module != package}

    def name(module: str) -> str:
        return module.removeprefix(f"{package}.")

    return {name(module): {name(other) for other in imports[module] & own} for module in own}


def imported_modules(tree: ast.AST, modules: Iterable[str]) -> Iterator[str]:
    """Modules of the project that a file imports when it runs, also within functions."""
    known = set(modules)
    waiting = [tree]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.dump(node.test):
            waiting += node.orelse
            continue
        waiting += ast.iter_child_nodes(node)
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            names = [f"{node.module}.{alias.name}" for alias in node.names] + [node.module]
        else:
            continue
        compiled = (name.removeprefix("cython.cimports.") for name in names)
        yield from (name for name in compiled if name in known)


def overview(graph: Mapping[str, set[str]], with_page: Collection[str]) -> str:
    """The page of all packages: the pictures of the programs, and the same as a table."""
    lines = [
        "# Packages",
        "",
        "Which package imports which, read from the code; each package's own page says what its modules hold. Each box",
        "stands above what it imports; lines that follow from others are left out, and red ones close a circle. `gcs`",
        "and `simvehicle` never import each other; by these two names the pictures mean their `__init__`, `__main__`",
        f"and, in `gcs`, the pytest plugin. [Architecture]({UP}contributing/architecture.md) explains how the parts",
        "work together.",
        "",
        *(line for program in PROGRAMS for line in (f"![Packages of {program}](packages-{program}.svg)", "")),
        "| package | imports |",
        "|---|---|",
    ]
    for name in sorted(graph):
        shown = f"[`{name}`]({page_of(name)})" if name in with_page else f"`{name}`"
        lines.append(f"| {shown} | {', '.join(f'`{other}`' for other in sorted(graph[name]))} |")
    return "\n".join(lines) + "\n"


def package_page(root: Path, package: str, graph: Collection[str], modules: Mapping[str, Path], drawn: bool) -> str:
    """A package's page: the picture of its modules, if there is one, and what each holds."""
    lines = [f"# {package}", "", summary_of(modules[package]), ""]
    if drawn:
        lines += [f"![Modules of {package}]({picture_of(package)})", ""]
    lines += ["| module | content |", "|---|---|"]
    own = (name for name in modules if name != package and package_of(name) == package)
    beside = (name for name in graph if name.rpartition(".")[0] == package and modules[name].name != "__init__.py")
    for path in (modules[name] for name in sorted((*own, *beside))):
        lines.append(f"| `{path.relative_to(root).as_posix()}` | {summary_of(path)} |")
    return "\n".join(lines) + "\n"


def summary_of(path: Path) -> str:
    """The first paragraph of a module's docstring, as a table's cell can hold it."""
    text = ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) or ""
    first = " ".join(text.split("\n\n")[0].split())
    parts = (part if k % 2 else escaped(part) for k, part in enumerate(first.split("`")))
    return cell(prose("`".join(parts)))


def drawing(graph: Mapping[str, set[str]], *, most_in_a_row: int | None = None) -> str:
    """The import graph as SVG: floors by the longest way down, lines only where no longer way says the same.

    most_in_a_row: boxes in a row at most; any number without it.
    """
    floors = floors_of(graph)
    levels: dict[int, list[str]] = {}
    for name in sorted(graph):
        levels.setdefault(floors[name], []).append(name)
    edges = [(a, b) for a in graph for b in graph[a] if not implied(graph, a, b)]
    place: dict[str, float] = {}
    rows: list[list[str]] = []
    for level in sorted(levels):  # from below: each near the mean of what it imports
        floor = levels[level]
        floor.sort(key=lambda name: (sum(place[b] for a, b in edges if a == name and b in place)
                                     / max(sum(1 for a, b in edges if a == name and b in place), 1), name))  # fmt: skip
        count = -(-len(floor) // (most_in_a_row or len(floor)))
        for k in range(count):
            rows.append(floor[k::count])
            place |= {name: (i + 0.5) / len(rows[-1]) for i, name in enumerate(rows[-1])}
    box_w, box_h, gap_x, gap_y = 24 + 8 * max(map(len, graph), default=0), 30, 24, 58
    width = max(map(len, rows), default=1) * (box_w + gap_x) + gap_x
    height = len(rows) * (box_h + gap_y) + gap_y // 2
    from_top = {name: len(rows) - 1 - k for k, row in enumerate(rows) for name in row}

    def at(name: str) -> tuple[float, float]:
        return place[name] * width, from_top[name] * (box_h + gap_y) + gap_y / 2

    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
        'font-family="system-ui, sans-serif" font-size="13">',
        f'<rect width="{width}" height="{height}" fill="#ffffff"/>',
    ]
    for a, b in sorted(edges):
        (x0, y0), (x1, y1) = at(a), at(b)
        y0, circular = y0 + box_h, floors[a] <= floors[b]
        middle = (y0 + y1) / 2
        colour = "#c0392b" if circular else "#8899a6"
        out.append(
            f'<path d="M{x0:.0f} {y0:.0f} C{x0:.0f} {middle:.0f} {x1:.0f} {middle:.0f} {x1:.0f} {y1:.0f}" fill="none" '
            f'stroke="{colour}" stroke-width="1.3"><title>{a} imports {b}</title></path>'
        )
    for name in sorted(graph):
        x, y = at(name)
        fill = "#eef0f8" if name.startswith("simvehicle") else "#fbf3e2" if name == SHARED else "#e6f2ef"
        out.append(
            f'<rect x="{x - box_w / 2:.0f}" y="{y:.0f}" width="{box_w}" height="{box_h}" rx="5" fill="{fill}" '
            f'stroke="#44606b"/><text x="{x:.0f}" y="{y + 20:.0f}" text-anchor="middle" fill="#1b2a30">{name}</text>'
        )
    return "\n".join([*out, "</svg>"]) + "\n"


def floors_of(graph: Mapping[str, set[str]]) -> dict[str, int]:
    """The longest way down of each package; packages in a circle share a floor as far as they can."""
    floors: dict[str, int] = {}

    def floor(name: str, above: frozenset[str]) -> int:
        if name not in floors:
            below = [floor(other, above | {name}) for other in sorted(graph[name]) if other not in above | {name}]
            floors[name] = max(below, default=-1) + 1
        return floors[name]

    for name in sorted(graph):
        floor(name, frozenset())
    return floors


def implied(graph: Mapping[str, set[str]], a: str, b: str) -> bool:
    """Whether a reaches b by way of another package that it imports."""
    seen, waiting = {a}, [other for other in graph[a] if other != b]
    while waiting:
        name = waiting.pop()
        if name == b:
            return True
        if name not in seen:
            seen.add(name)
            waiting += graph[name]
    return False
