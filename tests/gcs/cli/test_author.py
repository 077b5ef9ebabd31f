"""`gcs init`, `validate`, `schema`, `doctor`, as a person meets them."""

from __future__ import annotations

import contextlib
import io
import json
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from gcs.cli import doctor
from gcs.cli.main import run_argv
from gcs.scenario import file
from gcs.scenario.document import read
from gcs.scenario.file import find, shipped_names
from gcs.scenario.json_schema import editor_schema


@pytest.fixture(autouse=True)
def _elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


@dataclass
class Result:
    exit_code: int
    output: str


def gcs(*words: str) -> Result:
    said = io.StringIO()
    with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
        status = run_argv(list(words))
    return Result(status, said.getvalue())


@pytest.mark.parametrize("words", [("init",), ("init", "7"), ("init", "a b.yaml"), ("init", "true")])
def test_what_init_writes_is_a_valid_scenario_that_is_named_after_its_file(words: tuple[str, ...]) -> None:
    done = gcs(*words)
    assert done.exit_code == 0
    (path,) = Path().iterdir()
    checked = gcs("validate", str(path))
    assert checked.exit_code == 0, checked.output
    assert f"{path}: valid" in checked.output
    jsonschema.Draft202012Validator(editor_schema()).validate(read(path).data)


def test_init_leaves_a_file_as_it_is_and_says_so() -> None:
    Path("mine.yaml").write_text("here")
    done = gcs("init", "mine")
    assert done.exit_code == 2
    assert "mine.yaml exists already" in done.output
    assert Path("mine.yaml").read_text() == "here"
    assert "in a folder that exists" in gcs("init", "no/such/folder").output


def test_the_drawing_has_everyone_in_their_place() -> None:
    gcs("init")
    lines = gcs("validate", "my-scenario.yaml").output.splitlines()
    plan = lines[: next(i for i, line in enumerate(lines) if "north is up" in line)]
    row = {mark: [i for i, line in enumerate(plan) if mark in line] for mark in "PTK#"}
    assert row["P"][0] < row["T"][0] < row["P"][1] < row["K"][0]  # starts 2, 0, -2 and -5 m north
    assert len({plan[i].index(mark) for mark in "PK" for i in row[mark]}) == 1  # all at 0 m east
    assert "pursuer 2: starts at N -2.0 E 0.0, 0.0 m high, hovers for 57 s" in "\n".join(lines)  # 12 kJ / 210 W


WITH_STRANGERS = """\
schema: 1
name: strangers
axes: ned
origin: {lat_deg: 47.0, lon_deg: 8.0, alt_m: 400.0}
goal: {duration_s: 30.0}
bases:
  - {name: pad, position_m: [8.0, -6.0, 0.0], stock_j: 200000, rate_w: 1500}
vehicles:
  pursuers:
    - {external: {connect: "udpin:127.0.0.1:14550", sysid: 1, capacity_j: 1e5}, waypoints_m: [[4, 3, -2.5], [0, 3, -2]]}
    - {external: {connect: "udpin:127.0.0.1:14550", sysid: 2, capacity_j: 1e5}}
  targets:
    - {external: {connect: "udpin:127.0.0.1:14550", sysid: 101, capacity_j: 1e5}, path_m: [[0, 0, -2]], speed_m_s: 0.5}
  tankers:
    - {external: {connect: "udpin:127.0.0.1:14550", sysid: 201, capacity_j: 1e5}, home_m: [-4, 0, -3]}
"""


def test_bases_are_drawn_and_external_vehicles_where_they_are_sent_first() -> None:
    Path("strangers.yaml").write_text(WITH_STRANGERS)
    done = gcs("validate", "strangers.yaml")
    assert done.exit_code == 0, done.output
    lines = done.output.splitlines()
    plan = lines[: next(i for i, line in enumerate(lines) if "north is up" in line)]
    (base, pursuer, target, tanker) = (
        next((i, line.index(m)) for i, line in enumerate(plan) if m in line) for m in "BPTK"
    )
    assert base[0] < pursuer[0] < target[0] < tanker[0]  # 8, 4, 0 and -4 m north
    assert base[1] < target[1] == tanker[1] < pursuer[1]  # -6, 0, 0 and 3 m east
    assert sum(line.count("P") for line in plan) == 1  # nobody knows where pursuer 2 will be
    assert "B base" in done.output
    for said in (
        "B base pad: at N 8.0 E -6.0, 0.0 m high, holds 200 kJ and gives 1500 W",
        "expected at udpin:127.0.0.1:14550, wherever it stands; drawn at N 4.0 E 3.0, 2.5 m high, where it is sent",
        "P pursuer 2: expected at udpin:127.0.0.1:14550, wherever it stands\n",
    ):
        assert said in done.output
    image = gcs("validate", "strangers.yaml", "--image", "plan.svg")
    assert image.exit_code == 0, image.output
    assert Path("plan.svg").read_bytes().startswith(b"<?xml")
    assert all(f"<!-- {text} -->" in Path("plan.svg").read_text() for text in ("pad", "base pad", "201"))


def test_the_plan_can_be_an_image_and_one_of_an_unknown_kind_is_one_sentence() -> None:
    done = gcs("validate", "demo", "--image", "plan.png")
    assert done.exit_code == 0, done.output
    assert Path("plan.png").read_bytes()[:5] == b"\x89PNG\r"
    done = gcs("validate", "demo", "--image", "plan.xyz")
    assert done.exit_code == 1
    (line,) = done.output.splitlines()
    assert line.startswith("plan.xyz: the plan cannot be drawn there: ")


def test_a_mistake_is_told_with_its_place_and_status_2() -> None:
    gcs("init")
    path = Path("my-scenario.yaml")
    path.write_text(path.read_text().replace("policy: winner_take_all", "policy: winner_takes_all"))
    done = gcs("validate", str(path))
    assert done.exit_code == 2
    (line,) = done.output.splitlines()
    assert line.startswith("my-scenario.yaml:68:11: competition.policy must be winner_take_all, ")
    assert line.endswith(" or MODULE:CLASS, not the text 'winner_takes_all'; did you mean 'winner_take_all'?")


@pytest.mark.parametrize(
    ("old", "new", "sentence"),
    [
        ("potential_field", "nowhere:Planner", "planner.method: there is no module 'nowhere'"),
        ("potential_field", "no_python:Planner", "no_python cannot be imported: SyntaxError at no_python.py:2: "),
        ("potential_field", "hollow:Planer", "has no 'Planer'; did you mean 'Planner'?"),
        ("winner_take_all", "hollow:Planner", "competition.policy: hollow:Planner has no method 'choose'"),
        ("winner_take_all", "lacking:Policy", "lacking needs the package 'no_such_package', which is not installed"),
    ],
)  # fmt: skip
def test_an_implementation_that_cannot_be_used_is_told_before_anything_flies(old: str, new: str, sentence: str) -> None:
    gcs("init")
    Path("no_python.py").write_text("\ndef f(:\n")
    Path("hollow.py").write_text("class Planner: pass\n")
    Path("lacking.py").write_text("import no_such_package\n")
    path = Path("my-scenario.yaml")
    path.write_text(path.read_text().replace(f": {old} ", f": {new} "))
    done = gcs("run", str(path), "--trust")
    assert done.exit_code == 2
    assert sentence in done.output
    line = path.read_text()[: path.read_text().index(f": {new} ")].count("\n") + 1
    assert done.output.startswith(f"my-scenario.yaml:{line}:11: ")
    assert not Path("sessions").exists()


def test_an_older_scenario_is_told_what_changed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(file, "CHANGED", {0: "write `axes`", -1: "rename a to b"})
    assert file.refusal(1) is None
    older = file.refusal(-1)
    assert older is not None
    assert older.endswith("-1 to 0: rename a to b; 0 to 1: write `axes`")
    assert "install a newer Skytender" in (file.refusal(2) or "")
    gcs("init")
    path = Path("my-scenario.yaml")
    path.write_text(path.read_text().replace("schema: 1", "schema: 0"))
    done = gcs("validate", str(path))
    assert done.exit_code == 2
    assert done.output.startswith("my-scenario.yaml:11:9: schema 0 is an older format; change the file")


def test_errors_begin_with_the_programs_name_or_with_the_place_in_the_file() -> None:
    assert gcs("run", "demo", "--speed", "-1").output.splitlines()[-1].startswith("gcs: Invalid value for '--speed'")
    assert gcs("validate", "dmeo").output.startswith("gcs: dmeo: no such file")
    Path("bad.yaml").write_text("schema: 1\n")
    assert gcs("validate", "bad.yaml").output.startswith("bad.yaml:1:1: ")
    for words in (["run"], ["fly"], ["run", "demo", "--quiet", "--json"]):
        *_, usage, last = gcs(*words).output.splitlines()
        assert "--help" in usage or "-h" in usage
        assert last.startswith("gcs: ")


def test_every_shipped_scenario_keeps_to_the_schema_that_editors_get() -> None:
    printed: dict[str, Any] = json.loads(gcs("schema").output)
    jsonschema.Draft202012Validator.check_schema(printed)
    validator = jsonschema.Draft202012Validator(printed)
    for name in shipped_names():
        validator.validate(read(find(name)).data)


def test_the_schema_refuses_what_validate_refuses() -> None:
    validator = jsonschema.Draft202012Validator(editor_schema())
    good = read(find("demo")).data
    assert validator.is_valid({**good, "planner": "mine:Planner", "competition": "optimal"})
    assert not validator.is_valid({**good, "plannner": {}})
    assert not validator.is_valid({**good, "competition": {"policy": "best"}})
    assert not validator.is_valid({**good, "seed": "one"})


def keys_of(node: Any, path: tuple[str, ...]) -> Iterator[tuple[tuple[str, ...], dict[str, Any]]]:
    """(path, schema) of every key in a piece of JSON Schema."""
    for key, value in node.get("properties", {}).items():
        yield (*path, key), value
        yield from keys_of(value, (*path, key))
    for choice in (*node.get("anyOf", ()), node.get("items"), node.get("additionalProperties")):
        if isinstance(choice, dict):
            yield from keys_of(choice, path)


def test_the_schema_explains_every_key_and_every_block() -> None:
    printed = editor_schema()
    parts = {"scenario": printed, **printed["$defs"]}
    keys = dict(pair for name, part in parts.items() for pair in keys_of(part, (name,)))
    assert {("scenario", "planner"), ("Target", "grid", "columns"), ("Vehicles", "defaults", "battery")} <= keys.keys()
    assert len(keys) > 190
    assert [path for path, value in keys.items() if not value.get("description", "").strip()] == []
    assert [name for name, part in parts.items() if not part.get("description", "").strip()] == []


@pytest.mark.parametrize(("block", "key"), [("planner", "method"), ("competition", "policy")])
def test_a_name_put_over_the_line_of_a_block_is_told_with_the_form_that_works(block: str, key: str) -> None:
    gcs("init", "mine")
    text = Path("mine.yaml").read_text()
    Path("mine.yaml").write_text(text.replace(f"\n{block}:\n", f"\n{block}: mine:Own\n"))
    line = text.splitlines().index(f"{block}:") + 1
    done = gcs("validate", "mine.yaml")
    assert done.exit_code == 2
    assert f"{block} on line {line} has the value mine:Own and keys below it" in done.output
    assert f'or write {key}: "mine:Own" below {block}:' in done.output


def test_the_doctor_finds_nothing_that_keeps_sessions_from_running_here() -> None:
    done = gcs("doctor", "--json")
    findings = [json.loads(line) for line in done.output.splitlines()]
    assert done.exit_code == 0
    assert {"Python", "skytender", "simvehicle", "UDP on 127.0.0.1", "receive buffer", "terminal"} <= {
        finding["what"] for finding in findings
    }
    assert all(finding["advice"] for finding in findings if finding["level"] != "ok")


REQUIRED = [
    "click<9,>=8.1",
    'pyarrow<27,>=17; extra == "parquet"',
    'scipy<2,>=1.13; extra == "paper"',
    'pyarrow<27,>=17; extra == "campaign"',
    'scipy<2,>=1.13; extra == "dev"',
    'mypy>=1.13; extra == "dev"',
]


def test_the_doctor_names_each_package_once_with_the_extras_that_want_it(monkeypatch: pytest.MonkeyPatch) -> None:
    have = {"skytender": "1.0", "click": "8.2", "pyarrow": "20.0"}

    def version(name: str) -> str:
        if name not in have:
            raise PackageNotFoundError(name)
        return have[name]

    monkeypatch.setattr(doctor, "version", version)
    monkeypatch.setattr(doctor, "requires", lambda _: REQUIRED)
    said = [(one.level, one.what, one.found, one.advice) for one in doctor._versions()]
    wanted = "if you want paper: pip install '.[paper]' in Skytender's checkout"
    assert said == [
        ("ok", "skytender", "1.0", ""),
        ("ok", "click", "8.2", ""),
        ("ok", "pyarrow", "20.0 (for the extras parquet, campaign)", ""),
        ("note", "scipy", "not installed (for the extra paper)", wanted),
    ]


def test_the_doctor_says_what_to_do_about_a_missing_program(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr("sys.executable", str(tmp_path / "python"))
    monkeypatch.setenv("PATH", str(tmp_path))
    done = gcs("doctor")
    assert done.exit_code == 1
    lines = done.output.splitlines()
    at = lines.index("problem  simvehicle: not found")
    assert lines[at + 1].strip() == "-> it comes with Skytender: install that again with pip"
    problems, notes = (sum(line.startswith(level) for line in lines) for level in ("problem ", "note "))
    assert lines[-1] == f"{problems} problem{'s' * (problems != 1)}, {notes} note{'s' * (notes != 1)}"
    assert (problems, lines[-1].partition(",")[0]) == (1, "1 problem")


COMMIT = b"b765769f50a0a830d96e3a416a55bd229b0b6bce\0"
"""It stands after a PX4's version; its program holds others, of its own tests."""


@pytest.fixture
def bare(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """A machine without autopilots, and the folder of all its programs."""
    for name in ("PATH", "HOME"):
        monkeypatch.setenv(name, str(tmp_path))
    for name in ("SKYTENDER_ARDUCOPTER", "SKYTENDER_PX4"):
        monkeypatch.delenv(name, raising=False)
    return tmp_path


@pytest.mark.parametrize(
    ("name", "content", "level", "found"),
    [
        ("ArduCopter", b"\0FreeRTOS ArduCopter V4.6.0-dev (0123abcd)\0", "ok", "4.6.0-dev at {}"),
        ("ArduCopter", b"ArduCopter V9.9.1", "ok", "9.9.1 at {} (newer than those flown so far: "),
        ("ArduCopter", b"ArduPlane V4.5.7", "note", "{}"),
        ("ArduCopter", b"", "note", "{}"),
        (
            "PX4",
            b"\0v1.2.3-dirty\0v1.14.0-beta2-4431-gb765769f50\0\0" + COMMIT,
            "ok",
            "1.14.0-beta2-4431-gb765769f50 at {}",
        ),
        ("PX4", b"\0v1.99.0\0" + COMMIT, "ok", "1.99.0 at {} (newer than those flown so far: "),
        ("PX4", b"\0v1.13.3\0" + COMMIT, "ok", "1.13.3 at {} (flown so far: "),
        ("PX4", b"\0v1.2.3-dirty\0v1.18.1\0release/1.18\0\0\0" + COMMIT, "ok", "1.18.1 at {}"),
        ("PX4", b"ArduCopter V4.6.0-dev", "note", "{}"),
        # the commit of 1.18.0-beta1-38-g83c4f4e580, described from another tag; and changes of it
        ("PX4", b"\0v1.18.0-beta1-1-g83c4f4e580\0" + COMMIT, "ok", "1.18.0-beta1-1-g83c4f4e580 at {}|"),
        ("PX4", b"\0v1.18.0-beta1-1-g83c4f4e580-dirty\0" + COMMIT, "ok", "1.18.0-beta1-1-g83c4f4e580-dirty at {} ("),
    ],
)
@pytest.mark.parametrize("by", ["name", "path"])
def test_the_doctor_finds_an_autopilot_and_names_its_version(
    monkeypatch: pytest.MonkeyPatch, bare: Path, by: str, name: str, content: bytes, level: str, found: str
) -> None:
    program = bare / name.lower()
    program.write_bytes(content)
    program.chmod(0o755)
    if by == "name":
        monkeypatch.setenv(f"SKYTENDER_{name.upper()}", str(program))
        monkeypatch.setenv("PATH", "")
    (finding,) = (one for one in doctor._autopilots() if one.what == name)
    assert finding.level == level
    assert f"{finding.found}|".startswith(found.format(program))


def test_the_doctor_finds_a_px4_by_the_folder_of_its_build(monkeypatch: pytest.MonkeyPatch, bare: Path) -> None:
    program = bare / "PX4-Autopilot" / "build" / "px4_sitl_default" / "bin" / "px4"
    program.parent.mkdir(parents=True)
    program.write_bytes(b"\0v1.99.0\0" + COMMIT)
    program.chmod(0o755)
    for named in (None, program.parents[1]):
        if named is not None:
            monkeypatch.setenv("SKYTENDER_PX4", str(named))
        *_, finding = doctor._autopilots()
        assert (finding.level, finding.found.partition(" (")[0]) == ("ok", f"1.99.0 at {program.parents[1]}")


def test_a_version_is_what_the_files_of_a_build_say(monkeypatch: pytest.MonkeyPatch, bare: Path) -> None:
    """In the program the tag may lie anywhere: where depends on its length."""
    program = bare / "px4_sitl_default" / "bin" / "px4"
    header = program.parents[1] / "src" / "lib" / "version" / "build_git_version.h"
    for made in (program, header):
        made.parent.mkdir(parents=True)
    program.write_bytes(b"\0localhost\0v1.98.0\0Linux\0" + COMMIT)
    program.chmod(0o755)
    header.write_text('#define PX4_GIT_VERSION_STR "83c4"\n#define PX4_GIT_TAG_STR "v1.98.0"\n')
    monkeypatch.setenv("SKYTENDER_PX4", str(program.parents[1]))
    *_, finding = doctor._autopilots()
    assert (finding.level, finding.found.partition(" (")[0]) == ("ok", f"1.98.0 at {program.parents[1]}")


@pytest.mark.usefixtures("bare")
def test_the_doctor_says_how_to_build_an_autopilot(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    arducopter, px4 = doctor._autopilots()
    assert {arducopter.level, px4.level} == {"ok"}
    assert "the target copter of ArduPilot for the board sitl" in arducopter.found
    assert "'autopilot: {px4: PATH}'" in px4.found
    assert "the target px4_sitl_default of PX4-Autopilot" in px4.found
    for name in ("ARDUCOPTER", "PX4"):
        monkeypatch.setenv(f"SKYTENDER_{name}", str(tmp_path / "none"))
    assert [finding.level for finding in doctor._autopilots()] == ["note", "note"]


@pytest.mark.parametrize(
    ("have", "limits", "fits"),
    [("2.4.6", ">=2.0,<3", True), ("3.0", ">=2.0,<3", False), ("1.26.4", "<3,>=2", False), ("2", ">=2.0", True)],
)
def test_versions_are_compared_by_their_numbers(have: str, limits: str, fits: bool) -> None:
    assert doctor.satisfies(have, limits) is fits


def test_a_check_that_fails_itself_is_a_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    def _odd() -> Any:
        raise RuntimeError("no")
        yield

    monkeypatch.setattr(doctor, "CHECKS", (_odd,))
    (finding,) = doctor.examine()
    assert (finding.level, finding.found) == ("problem", "RuntimeError: no")
