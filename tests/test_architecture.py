"""The house's rules about who may import whom; a new module must find its place in these lists."""

from __future__ import annotations

import ast
import functools
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]

HOUSE = {
    "simvehicle": [
        "exit_status geo params",
        "dynamics differentiator comparators energy",
        "guidance controller",
        "flight",
        "modes transfer failures fence follow mission state",
        "mavlink.codec",
        "mavlink.identity mavlink.parameters mavlink.commands mavlink.plans mavlink.replies",
        "mavlink.snapshot mavlink.missions",
        "mavlink.telemetry",
        "mavlink.streams",
        "mavlink.connection",
        "mavlink.lockstep",
        "link",
        "maneuvers",
        "body",
        "vehicle",
        "microservices.desk",
        "microservices.asking microservices.flying microservices.planning",
        "microservices.service microservices.setpoints microservices.tuning",
        "truth services traffic",
        "unit",
        "process preload hatch",
        "block",
        "paper_figures",
        "paper",
        "cli",
        "__main__",
    ],
    "gcs": [
        "addresses exit_status reserve yaml_dialect",
        "yaml_source",
        "leaving scenario_values udp",
        "scenario_external",
        "scenario_parts scenario_rules scenario_versions",
        "scenario_grid scenario_bases",
        "scenario configs arrivals",
        "drawing editor_schema doctor",
        "launch guard plugins energy",
        "mavlink.codec mavlink.identities",
        "mavlink.sequence mavlink.commands mavlink.batch mavlink.boot_clock mavlink.battery mavlink.statustext",
        "mavlink.quiet",
        "mavlink.older mavlink.station",
        "mavlink.streams",
        "profiles",
        "clock impairment recorder tlog",
        "units tables lacking",
        "export",
        "link air",
        "external",
        "mixed_link",
        "views events quality inspection relays",
        "fleet",
        "pilot trouble news scene ears recording",
        "external_pilot externals rows service",
        "crew outbox observe tanker_service base_service ability beacons",
        "monitor",
        "planner.obstacles planner.formation",
        "planner.potential_field planner.neighbours",
        "planner.fuzzy",
        "planner.leader",
        "planner.plan",
        "planner.own",
        "competition_steps",
        "competition",
        "contest pursuit policies",
        "policy_contest refuelling explain",
        "metrics operator",
        "rehearsal records",
        "supervisor story",
        "summary picture publish reader",
        "clients redecide",
        "supervise",
        "console.source",
        "console.client console.plain console.earlier",
        "console.ink console.job console.palette console.client_source",
        "console.watch console.canvas console.panel",
        "console.chart console.plan_view console.fleet_table console.heading console.events_log console.orders",
        "console.shell console.layout console.contest_page console.vehicle_page console.help_page console.dialogs",
        "console.events_page",
        "console.desk",
        "console.main_screen",
        "console.app console.follow",
        "console.__main__ run",
        "terminal launch_only",
        "arrays junit session_log",
        "session",
        "report.set_points",
        "report.recorded",
        "report.series",
        "report.pursuit",
        "report.nearness report.decimate replay",
        "report.findings report.pack",
        "report.charts report.tables",
        "report.page",
        "report.make",
        "cli_report",
        "pytest_plugin",
        "paper.claims paper.figures",
        "paper.session paper.study",
        "paper.tracking paper.races paper.theory paper.vehicle paper.page",
        "paper.examples",
        "paper.robustness",
        "paper.make",
        "check.dialogue",
        "check.judges check.report",
        "check.asking",
        "check.presence check.connect check.parameters check.preparation",
        "check.questions check.wire",
        "cli_author cli_check cli_paper cli_recorded cli_watch",
        "cli",
        "__main__",
    ],
}
SANS_IO = ["simvehicle/mavlink", "simvehicle/microservices", "gcs/mavlink"]
PURE = [
    "simvehicle/modes.py",
    "simvehicle/transfer.py",
    "simvehicle/vehicle.py",
    "simvehicle/body.py",
    "simvehicle/mission.py",
    "simvehicle/fence.py",
    "simvehicle/follow.py",
    "gcs/energy.py",
    "gcs/refuelling.py",
    "gcs/service.py",
    "gcs/tanker_service.py",
    "gcs/base_service.py",
    "gcs/ability.py",
    "gcs/contest.py",
    "gcs/pursuit.py",
    "gcs/trouble.py",
    "gcs/rows.py",
    "gcs/scene.py",
    "gcs/explain.py",
    "gcs/news.py",
    "gcs/arrivals.py",
    "gcs/externals.py",
    "gcs/external_pilot.py",
    "gcs/operator.py",
    "gcs/inspection.py",
]
WORLD = {"socket", "time", "threading", "select", "selectors", "subprocess", "asyncio"}


def modules(package: str) -> dict[str, Path]:
    files = (ROOT / package).rglob("*.py")
    names = {".".join(path.relative_to(ROOT).with_suffix("").parts[1:]): path for path in files}
    return {name: path for name, path in names.items() if not name.endswith("__init__")}


@functools.cache
def imports(path: Path) -> set[str]:
    """Absolute names that a module imports anywhere, `from a import b` as both `a` and `a.b`."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f"{path}: relative import"
            found.add(node.module or "")
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
    return found


@pytest.mark.parametrize("package", HOUSE)
def test_every_module_has_its_floor(package: str) -> None:
    placed = [name for floor in HOUSE[package] for name in floor.split()]
    assert sorted(placed) == sorted(modules(package))


@pytest.mark.parametrize("package", HOUSE)
def test_modules_import_only_from_floors_above_them(package: str) -> None:
    floor_of = {name: i for i, floor in enumerate(HOUSE[package]) for name in floor.split()}
    wrong = [
        f"{name} imports {other}"
        for name, path in modules(package).items()
        for found in [imports(path)]
        for other in floor_of
        if f"{package}.{other}" in found and floor_of[other] >= floor_of[name]
    ]
    assert not wrong


def test_vehicle_and_ground_station_never_import_each_other() -> None:
    for package, foreign in (("gcs", "simvehicle"), ("simvehicle", "gcs")):
        for path in modules(package).values():
            assert not [name for name in imports(path) if name.split(".")[0] == foreign], path


@pytest.mark.parametrize("folder", SANS_IO)
def test_protocol_modules_have_no_socket_clock_or_thread(folder: str) -> None:
    for path in (ROOT / folder).glob("*.py"):
        assert not imports(path) & WORLD, path


@pytest.mark.parametrize("file", PURE)
def test_logic_has_no_socket_clock_or_thread(file: str) -> None:
    assert not imports(ROOT / file) & WORLD


def test_no_mode_number_stands_outside_the_profiles() -> None:
    for name, path in modules("gcs").items():
        text = path.read_text(encoding="utf-8")
        assert name == "profiles" or "custom_mode ==" not in text, name


def test_top_level_holds_nothing_else() -> None:
    allowed = {
        "pyproject.toml",
        "gcs",
        "simvehicle",
        "tests",
        "configs",
        "README.md",
        "Makefile",
        "LICENSE",
        "CHANGELOG.md",
    }
    found = {path.name for path in ROOT.iterdir() if not path.name.startswith(".")}
    assert found - {"sessions", "dist", "build", "bench.json"} <= allowed
