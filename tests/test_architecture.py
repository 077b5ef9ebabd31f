"""The rules of the layout: which package may import which, and what must not know sockets, clocks and threads."""

from __future__ import annotations

import ast
import functools
import re
from collections import Counter
from pathlib import Path

import networkx as nx
import pytest

ROOT = Path(__file__).resolve().parents[1]

PACKAGES = {
    "simvehicle": [
        "world",
        "law",
        "autopilot",
        "fleet",
        "mavlink",
        "sitl",
        "paper",
        "cli",
        "__main__",
    ],
    "gcs": [
        "extras html_table missions",
        "mavlink scenario",
        "link telemetry",
        "planner refuelling",
        "recording",
        "processes supervisor",
        "session",
        "web",
        "console report",
        "campaign environments",
        "cli learning",
        "__init__ __main__ pytest_plugin",
    ],
}
"""Each package imports only from those in the lines above its own, and from itself."""
MOST_MODULES = 25
SANS_IO = ["simvehicle/mavlink", "gcs/mavlink", "gcs/missions"]
PURE = [
    "simvehicle/autopilot/modes.py",
    "simvehicle/autopilot/energy_transfer.py",
    "simvehicle/autopilot/vehicle.py",
    "simvehicle/autopilot/body.py",
    "simvehicle/autopilot/mission.py",
    "simvehicle/autopilot/geofence.py",
    "simvehicle/autopilot/follow.py",
    "gcs/telemetry/energy.py",
    "gcs/refuelling/scheduler.py",
    "gcs/refuelling/service.py",
    "gcs/refuelling/tanker_service.py",
    "gcs/refuelling/base_service.py",
    "gcs/refuelling/capability.py",
    "gcs/refuelling/bidding.py",
    "gcs/refuelling/target_assignment.py",
    "gcs/telemetry/health.py",
    "gcs/session/messages.py",
    "gcs/refuelling/explain.py",
    "gcs/telemetry/changes.py",
    "gcs/processes/startup.py",
    "gcs/supervisor/external_fleet.py",
    "gcs/supervisor/arming_external.py",
    "gcs/supervisor/operator.py",
    "gcs/telemetry/message_inspector.py",
]
WORLD = {"socket", "time", "threading", "select", "selectors", "subprocess", "asyncio"}


def modules(package: str) -> dict[str, Path]:
    files = (ROOT / package).rglob("*.py")
    names = {".".join(path.relative_to(ROOT).with_suffix("").parts[1:]): path for path in files}
    return {name: path for name, path in names.items() if not name.endswith("__init__")}


@functools.cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


@functools.cache
def imports(path: Path) -> set[str]:
    """Absolute names that a module imports anywhere, `from a import b` as both `a` and `a.b`."""
    found: set[str] = set()
    for node in ast.walk(tree(path)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            home = (node.module or "").removeprefix("cython.cimports.")  # compiled into another compiled module
            found |= {home} | {f"{home}.{alias.name}" for alias in node.names}
    return found


@functools.cache
def graph(program: str) -> nx.DiGraph[str]:
    """Modules of a program, and an edge from each to every module that it imports."""
    found = modules(program)
    edges = nx.DiGraph()
    edges.add_nodes_from(found)
    for name, path in found.items():
        imported = imports(path) - {f"{program}.{name}"}
        edges.add_edges_from((name, other) for other in found if f"{program}.{other}" in imported)
    return edges


@pytest.mark.parametrize("program", PACKAGES)
def test_packages_import_only_from_those_below_them(program: str) -> None:
    level = {name: i for i, line in enumerate(PACKAGES[program]) for name in line.split()}
    wrong = []
    for name, other in graph(program).edges:
        package, below = name.split(".")[0], other.split(".")[0]
        if package in level and below in level and package != below and level[below] >= level[package]:
            wrong.append(f"{name} imports {other}")
    assert not wrong


@pytest.mark.parametrize("program", PACKAGES)
def test_no_modules_import_each_other_in_a_circle(program: str) -> None:
    assert not list(nx.simple_cycles(graph(program)))


def test_no_folder_is_crowded() -> None:
    for folder in {path.parent for program in PACKAGES for path in modules(program).values()}:
        if folder.name not in ("gcs", "simvehicle"):
            assert len(list(folder.glob("*.py"))) <= MOST_MODULES, folder


def test_vehicle_and_ground_station_never_import_each_other() -> None:
    others = {"gcs": {"simvehicle"}, "simvehicle": {"gcs"}, "skytender": {"gcs", "simvehicle"}}
    for package, foreign in others.items():
        for path in modules(package).values():
            assert not [name for name in imports(path) if name.split(".")[0] in foreign], path


@pytest.mark.parametrize("folder", SANS_IO)
def test_protocol_modules_have_no_socket_clock_or_thread(folder: str) -> None:
    for path in (ROOT / folder).glob("*.py"):
        assert not imports(path) & WORLD, path


@pytest.mark.parametrize("file", PURE)
def test_logic_has_no_socket_clock_or_thread(file: str) -> None:
    assert not imports(ROOT / file) & WORLD


def test_no_mode_number_stands_outside_the_table_of_autopilots() -> None:
    for name, path in modules("gcs").items():
        text = path.read_text(encoding="utf-8")
        assert name == "mavlink.autopilots" or not re.search(r"custom_mode == \d|custom_mode == [A-Z]", text), name


def test_top_level_holds_nothing_else() -> None:
    allowed = {
        "pyproject.toml",
        "gcs",
        "simvehicle",
        "tests",
        "configs",
        "docs",
        "README.md",
        "Makefile",
        "LICENSE",
        "CHANGELOG.md",
        "CITATION.cff",
        "CONTRIBUTING.md",
        "Dockerfile",
        "MANIFEST.in",
        "SECURITY.md",
        "action.yml",
        "conda",
        "setup.py",
        "skytender",
    }
    found = {path.name for path in ROOT.iterdir() if not path.name.startswith(".")}
    made = {"sessions", "dist", "build", "bench.json", "skytender.egg-info"}
    assert found - made <= allowed


@functools.cache
def definitions(program: str) -> list[tuple[str, ast.AST]]:
    """(module, node) of every syntax node of a program."""
    return [(name, node) for name, path in modules(program).items() for node in ast.walk(tree(path))]


def test_no_two_classes_have_one_name() -> None:
    found = Counter(
        node.name for program in PACKAGES for name, node in definitions(program) if isinstance(node, ast.ClassDef)
    )
    assert [name for name, count in found.items() if count > 1] == []


RETIRED = re.compile(
    r"(?:^|_)(?:told|tell|tells|telling|heard|hears?|hearing|overhear|nobody|somebody|someone|strangers?|news|lacking|"
    r"leaving|quiet|quieter|troubles?|crew|story|scenes?|pictures?|beacon|desk|wish|wishes|outbox|ears?)(?:_|$)"
)
"""Words of ours for which the field has its own: received, reported, unknown sender, notice, health, snapshot, …"""
KEPT = {
    "heard_s": "key of session.sock",
    "quiet": "--quiet",
    "_quiet": "--quiet",
    "QUIET": "--quiet",
    "told": "key of session.sock",
    "trouble": "key of session.sock",
}


def test_identifiers_use_the_words_of_the_field() -> None:
    wrong = set()
    for program in PACKAGES:
        for module, node in definitions(program):
            match node:
                case ast.Name(id=name, ctx=ast.Store()) | ast.arg(arg=name) | ast.Attribute(attr=name, ctx=ast.Store()):
                    pass
                case ast.ClassDef(name=name) | ast.FunctionDef(name=name):
                    pass
                case _:
                    continue
            if RETIRED.search(re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).lower()) and name not in KEPT:
                wrong.add(f"{program}.{module}: {name}")
    assert not wrong


def test_docstrings_open_in_plain_words() -> None:
    openings = [
        f"{program}.{module}:{node.lineno}"
        for program in PACKAGES
        for module, node in definitions(program)
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
        if re.match(r"\s*(What|Who|Whom|Whose)\b", node.value.value)
    ]
    assert not openings
