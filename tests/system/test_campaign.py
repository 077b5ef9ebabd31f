"""Campaigns of whole sessions: the same rows however they are flown, and nothing left behind."""

from __future__ import annotations

import json
import os
import re
import resource
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import Any

import dask
import psutil
import pytest
import yaml
from commands import gcs
from distributed.security import Security
from sessions import GCS

from gcs.campaign import table
from gcs.campaign.cluster import EngineError
from gcs.campaign.engine import Progress
from gcs.campaign.file import from_data
from gcs.campaign.plan import Plan, make
from gcs.campaign.runner import Runner, make_folder

pytestmark = pytest.mark.filterwarnings("default")  # Dask's own, of sockets that a lost scheduler leaves open

CAMPAIGN: dict[str, Any] = {
    "schema": 1,
    "name": "small",
    "scenario": "paper/example1",
    "sessions": 3,
    "seed": 7,
    "set": {"goal.duration_s": 4},
    "vary": {"planner.cruise_m_s": [1.0, 1.5]},
    "draw": {"radio.loss": {"uniform": [0.0, 0.3]}},
    "keep": "none",
}
ROWS = 6
"""Of its sessions, each at two speeds."""
ROLES = ("client", "scheduler", "worker")
RESULT = ("row", "session", "combination", "seed", "radio.loss", "min_clearance_m", "ok", "error", "digest")


def plan(**changes: Any) -> Plan:
    return make(from_data({**CAMPAIGN, **changes}), [])


def rows(folder: Path, flown: Plan) -> list[dict[str, Any]]:
    return table.read(folder, flown.campaign).select(RESULT).to_pylist()


def fly(folder: Path, flown: Plan, notify: Callable[[Progress, Any], None] = lambda *_: None, **options: Any) -> Runner:
    runner = Runner(folder, flown, notify=notify, **options)
    runner.run()
    return runner


def descendants(name: str) -> list[psutil.Process]:
    found = []
    for process in psutil.Process().children(recursive=True):
        try:
            if any(name in word for word in process.cmdline()):
                found.append(process)
        except psutil.NoSuchProcess:
            continue
    return found


@pytest.fixture(scope="module")
def reference(tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    """The rows as one worker flies them."""
    flown = plan()
    folder = make_folder(flown, tmp_path_factory.mktemp("reference") / "campaign")
    fly(folder, flown, workers=1)
    found = rows(folder, flown)
    assert [row["row"] for row in found] == list(range(ROWS))
    assert all(row["error"] is None for row in found)
    return found


def test_a_row_has_the_digest_of_gcs_run(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    row = reference[3]
    settings = {"goal.duration_s": 4, "planner.cruise_m_s": 1.5, "radio.loss": row["radio.loss"]}
    words = [word for key, value in settings.items() for word in ("--set", f"{key}={value!r}")]
    out = tmp_path / "session"
    options = ["--lockstep", "--quiet", "--no-report", "--seed", str(row["seed"]), "--out", str(out)]
    gcs("run", "paper/example1", *words, *options)
    assert json.loads((out / "summary.json").read_text(encoding="utf-8"))["digest"] == row["digest"]


def test_workers_killed_three_times_leave_one_row_per_session(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    killed: set[int] = set()

    def kill(_: Progress, row: Any) -> None:
        if row is None or len(killed) == 3:
            return
        for warm in descendants("gcs sessions"):
            worker = warm.parent()
            if worker is not None and worker.pid not in killed:
                killed.add(worker.pid)
                worker.kill()
                return

    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    fly(folder, flown, kill, workers=2)
    assert len(killed) == 3
    assert rows(folder, flown) == reference
    assert not descendants("gcs session")
    assert not descendants("simvehicle")


def test_a_fork_server_that_is_killed_is_replaced(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    killed: set[int] = set()

    def kill(_: Progress, row: Any) -> None:
        for server in descendants("gcs sessions") if row is not None and not killed else ():
            killed.add(server.pid)
            server.kill()

    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    fly(folder, flown, kill, workers=2)
    assert killed
    assert rows(folder, flown) == reference
    assert not descendants("gcs session")
    assert not descendants("simvehicle")


def test_all_that_flies_may_be_stopped_for_a_while(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    stopped: list[psutil.Process] = []
    since_s = 0.0

    def stop(progress: Progress, row: Any) -> None:
        nonlocal since_s
        if progress.done == 2 and row is not None and not stopped:
            since_s = time.monotonic()
            stopped.extend(psutil.Process().children(recursive=True))
            for process in stopped:
                with suppress(psutil.NoSuchProcess):  # one of a session that has just ended
                    process.suspend()
        elif stopped and since_s and time.monotonic() - since_s >= 3.0:
            since_s = 0.0
            for process in reversed(stopped):
                with suppress(psutil.NoSuchProcess):
                    process.resume()

    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    fly(folder, flown, stop, workers=2)
    assert stopped
    assert since_s == 0.0
    assert rows(folder, flown) == reference


def test_a_full_disk_is_one_sentence_and_resume_goes_on(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    """This process alone writes the table: no file of its own may grow any more once two rows have come."""
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)

    def fill(progress: Progress, row: Any) -> None:
        if progress.done == 2 and row is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, limits[1]))

    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    try:
        with pytest.raises(EngineError, match=r"campaign cannot be written: File too large; make room there"):
            fly(folder, flown, fill, workers=1)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert len(rows(folder, flown)) < ROWS
    assert not list((folder / "rows").glob(".*"))
    assert not descendants("gcs session")
    fly(folder, flown, workers=1)
    assert rows(folder, flown) == reference


def test_an_interrupted_campaign_is_resumed(reference: list[dict[str, Any]], tmp_path: Path) -> None:
    def interrupt(progress: Progress, row: Any) -> None:
        if progress.done == 2 and row is not None:
            os.kill(os.getpid(), signal.SIGINT)

    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    runner = fly(folder, flown, interrupt, workers=1)
    assert runner.interrupted == signal.SIGINT
    assert 2 <= len(rows(folder, flown)) < ROWS
    assert not descendants("gcs session")
    before = {path: path.stat().st_mtime_ns for path in (folder / "rows").iterdir()}
    fly(folder, flown, workers=1)
    assert rows(folder, flown) == reference
    assert {path: path.stat().st_mtime_ns for path in before} == before


def test_no_other_user_can_reach_a_campaign_that_flies_here(tmp_path: Path) -> None:
    """Pickles are read from pipes alone: what listens is files in folders that are closed to others."""
    listening: list[Any] = []

    def look(_: Progress, __: Any) -> None:
        for process in (psutil.Process(), *psutil.Process().children(recursive=True)):
            with suppress(psutil.NoSuchProcess):
                listening.extend(one for one in process.net_connections("tcp") if one.status == psutil.CONN_LISTEN)
                paths = {one.laddr for one in process.net_connections("unix")} - {""}
                listening.extend(one for one in paths if not closed(Path(str(one))))

    def closed(at: Path) -> bool:
        return any(folder.exists() and not folder.stat().st_mode & 0o077 for folder in at.parents)

    flown = plan(sessions=1)
    folder = make_folder(flown, tmp_path / "campaign")
    fly(folder, flown, look, workers=1)
    assert not listening
    assert [row["error"] for row in rows(folder, flown)] == [None, None]


@pytest.fixture
def secured(tmp_path: Path) -> Iterator[Path]:
    """Dask's configuration with certificates of one authority, for processes; it holds in this one too."""
    made = tmp_path / "tls"
    made.mkdir()
    for words in (
        "req -x509 -newkey rsa:2048 -nodes -keyout ca.key -out ca.pem -days 2 -subj /CN=ca",
        "req -newkey rsa:2048 -nodes -keyout us.key -out us.csr -subj /CN=us",
        "x509 -req -in us.csr -CA ca.pem -CAkey ca.key -CAcreateserial -out us.pem -days 2",
    ):
        subprocess.run(["openssl", *words.split()], cwd=made, check=True, capture_output=True)
    ours = {"cert": str(made / "us.pem"), "key": str(made / "us.key")}
    tls = {"ca-file": str(made / "ca.pem"), **{role: dict(ours) for role in ROLES}}
    (made / "dask.yaml").write_text(json.dumps({"distributed": {"comm": {"tls": tls, "require-encryption": True}}}))
    given = {f"{role}.{name}": at for role in ROLES for name, at in ours.items()} | {"ca-file": str(made / "ca.pem")}
    with dask.config.set({f"distributed.comm.tls.{name}": at for name, at in given.items()}):
        assert Security().get_tls_config_for_role("client")["ca_file"] == str(made / "ca.pem")  # over Dask's defaults
        yield made / "dask.yaml"


@pytest.mark.usefixtures("secured")
def test_a_scheduler_that_is_not_there_is_one_sentence(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("gcs.campaign.cluster.CONNECT_WITHIN_S", 1.0)
    flown = plan()
    folder = make_folder(flown, tmp_path / "campaign")
    with pytest.raises(EngineError, match="no scheduler can be reached at tls:"):
        fly(folder, flown, scheduler="tls://127.0.0.1:9")


def test_a_session_that_cannot_be_flown_or_takes_too_long_is_a_row(tmp_path: Path) -> None:
    flown = plan(
        sessions=1,
        vary={"vehicles.pursuers.0.sysid": [1, 2], "goal.duration_s": [4, 86_000]},
        set={},
        limits={"wall_s": 5.0},
    )
    folder = make_folder(flown, tmp_path / "campaign")
    fly(folder, flown, workers=1)
    found = rows(folder, flown)
    errors = [row["error"] for row in found]
    assert errors[0] is None
    assert errors[1] == "it took longer than 5 s of wall time and was ended"
    assert found[0]["min_clearance_m"] > 0.0
    assert found[0]["digest"]
    assert (found[1]["min_clearance_m"], found[1]["digest"]) == (None, None), "where it was ended is no finding"
    assert errors[2] is not None
    assert "the sysid 2 is given twice" in errors[2]
    assert errors[3] == errors[2]


def test_the_command_flies_keeps_tells_and_repeats(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    content = {**CAMPAIGN, "sessions": 1, "expect": {"min_clearance_m": {"at_least": 50.0}}, "keep": "failed"}
    (tmp_path / "small.yaml").write_text(yaml.safe_dump(content), encoding="utf-8")
    run = [*GCS, "campaign", "run", "small.yaml", "--workers", "1", "--out", "out", "--plain"]
    done = subprocess.run(run, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (1, "")
    assert "row 0: min_clearance_m is " in done.stdout
    assert "below 50" in done.stdout
    assert "cruise_m_s 1.5  0 of 1" in done.stdout
    assert (tmp_path / "out" / "sessions" / "1" / "session.tlog").is_file()
    monkeypatch.chdir(tmp_path)
    status = gcs("campaign", "status", "out")
    assert (status.returncode, status.stdout.splitlines()[0]) == (0, "small: 2 of 2 sessions")
    assert gcs("campaign", "fly", "out", "1", "--out", "again", "--quiet").returncode in (0, 1)
    first, second = (
        json.loads((tmp_path / folder / "summary.json").read_text(encoding="utf-8"))["digest"]
        for folder in ("out/sessions/1", "again")
    )
    assert first == second


def test_ctrl_c_which_a_terminal_sends_to_the_workers_too_ends_it_with_a_sentence(tmp_path: Path) -> None:
    (tmp_path / "small.yaml").write_text(yaml.safe_dump({**CAMPAIGN, "sessions": 500}), encoding="utf-8")
    run = [*GCS, "campaign", "run", "small.yaml", "--workers", "1", "--out", "out", "--plain"]
    with subprocess.Popen(
        run, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, start_new_session=True
    ) as process:
        assert process.stdout is not None
        for line in process.stdout:
            if re.match(r"[1-9]\d* of 1000", line):
                break
        os.killpg(process.pid, signal.SIGINT)
        shown = process.stdout.read()
    assert process.returncode == 130, shown
    assert shown.splitlines()[-1].startswith("stopped; gcs campaign resume out flies the other ")
    assert "Traceback" not in shown


@contextmanager
def network(machines: Sequence[str]) -> Iterator[Sequence[str]]:
    """Network namespaces `machines`, each with an address 10.89.7.2, .3, … on a bridge; none of them where they cannot
    be had: they need root."""
    bridge = f"gcs{os.getpid()}"

    def ip(command: str) -> None:
        done = subprocess.run(["ip", *command.split()], capture_output=True, text=True, check=False)
        if done.returncode:
            raise OSError(f"ip {command}: {done.stderr.strip()}")

    with ExitStack() as stack:
        try:
            ip(f"link add {bridge} type bridge")
            stack.callback(ip, f"link del {bridge}")
            ip(f"addr add 10.89.7.1/24 dev {bridge}")
            ip(f"link set {bridge} up")
            for i, machine in enumerate(machines):
                ip(f"netns add {machine}")
                stack.callback(ip, f"netns del {machine}")
                ip(f"link add {bridge}v{i} type veth peer name eth0 netns {machine}")
                ip(f"link set {bridge}v{i} master {bridge} up")
                ip(f"-n {machine} addr add 10.89.7.{2 + i}/24 dev eth0")
                ip(f"-n {machine} link set eth0 up")
                ip(f"-n {machine} link set lo up")
        except OSError:
            machines = ()
        yield machines


@pytest.mark.slow
def test_machines_that_share_nothing_but_a_network_fly_the_same_rows_and_a_lost_scheduler_is_one_sentence(
    reference: list[dict[str, Any]], tmp_path: Path, secured: Path
) -> None:
    """A scheduler and two workers, each in a network namespace and a folder of its own, where those can be had."""
    flown = plan()
    whole, lost = (make_folder(flown, tmp_path / name) for name in ("whole", "lost"))
    names = [f"gcs{os.getpid()}{letter}" for letter in "abc"]
    with network(names) as machines, Cluster(tmp_path / "cluster", secured, machines) as cluster:

        def kill(progress: Progress, row: Any) -> None:
            if progress.done == 2 and row is not None:
                cluster.scheduler.kill()

        assert cluster.address == "tls://10.89.7.2:8786" or not machines
        fly(whole, flown, scheduler=cluster.address)
        with pytest.raises(EngineError, match="the scheduler is lost"):
            fly(lost, flown, kill, scheduler=cluster.address)
    assert rows(whole, flown) == reference
    assert 2 <= len(rows(lost, flown)) < ROWS
    fly(lost, flown, workers=1)
    assert rows(lost, flown) == reference


class Cluster:
    """A scheduler and workers of Dask, started by hand; here, or in network namespaces, one for each."""

    def __init__(self, folder: Path, secured: Path, machines: Sequence[str], *, workers: int = 2) -> None:
        folder.mkdir()
        self._processes: list[subprocess.Popen[str]] = []
        self._machines = list(machines)
        self._environment = {**os.environ, "DASK_CONFIG": str(secured)}
        here = (
            ("--protocol", "tls", "--host", "10.89.7.2", "--port", "8786")
            if machines
            else ("--protocol", "tls", "--port", "0")
        )
        self.scheduler = self._start(folder, "dask_scheduler", *here, "--no-dashboard")
        assert self.scheduler.stderr is not None
        said = next(line for line in self.scheduler.stderr if "Scheduler at:" in line)
        self.address = said.split()[-1]
        for _ in range(workers):
            self._start(folder, "dask_worker", self.address, "--nthreads", "1", "--no-dashboard")
        for _ in range(workers):  # a busy machine starts them in more time than a campaign waits for one
            next(line for line in self.scheduler.stderr if "Register worker" in line)

    def _start(self, folder: Path, module: str, *arguments: str) -> subprocess.Popen[str]:
        count = len(self._processes)
        inside = ["ip", "netns", "exec", self._machines[count]] if self._machines else []
        local = ["--local-directory", str(folder / f"worker{count}")] if module == "dask_worker" else []
        process = subprocess.Popen(
            [*inside, sys.executable, "-m", f"distributed.cli.{module}", *arguments, *local],
            env=self._environment,
            stderr=subprocess.PIPE if module == "dask_scheduler" else subprocess.DEVNULL,
            text=True,
        )
        self._processes.append(process)
        return process

    def __enter__(self) -> Cluster:
        return self

    def __exit__(self, *_: object) -> None:
        for process in self._processes[::-1]:
            process.terminate()
        for process in self._processes:
            try:
                process.wait(timeout=60.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
            if process.stderr is not None:
                process.stderr.close()


SEARCH = {
    "search": {"minimise": "min_clearance_m", "trials": 4, "batch": 2},
    "vary": {},
    "draw": {"planner.cruise_m_s": {"uniform": [0.8, 2.0]}},
    "set": {"goal.duration_s": 8},
}


@pytest.mark.slow
def test_a_search_is_the_same_with_one_worker_and_with_two(tmp_path: Path) -> None:
    (tmp_path / "small.yaml").write_text(yaml.safe_dump({**CAMPAIGN, **SEARCH}), encoding="utf-8")
    worst = []
    for workers in ("1", "2"):
        command = [*GCS, "campaign", "search", "small.yaml", "--workers", workers, "--out", workers, "--quiet"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
        assert (done.stdout, done.stderr) == ("", "")
        worst.append((tmp_path / workers / "worst.yaml").read_text(encoding="utf-8"))
    assert worst[0] == worst[1]


def test_ten_vehicles_and_twenty_obstacles_shrink_to_the_two_that_meet(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """1 and 2 fly head on without the filter; everybody and everything else is far away."""
    others = [(i, 8.0 + 4.0 * i) for i in range(3, 11)]
    ways = [(1, [-6.0, 0.0, -5.0], [6.0, 0.0, -5.0]), (2, [6.0, 0.05, -5.0], [-6.0, 0.05, -5.0])]
    ways += [(i, [-6.0, east, -5.0], [6.0, east, -5.0]) for i, east in others]
    scenario = {
        "schema": 1, "name": "ten", "axes": "ned", "clock": {"mode": "lockstep"},
        "origin": {"lat_deg": 47.0, "lon_deg": 8.0, "alt_m": 400.0}, "goal": {"duration_s": 5.0, "waypoints": "none"},
        "vehicles": {
            "defaults": {"battery": {"capacity_j": 60000}, "airborne": True},
            "pursuers": [{"sysid": i, "start_m": start, "waypoints_m": [end]} for i, start, end in ways],
        },
        "obstacles": [{"sphere_m": [float(k), -10.0 - k, -5.0], "radius_m": 0.5} for k in range(20)],
        "planner": {"cruise_m_s": 3.0, "safety": False},
    }  # fmt: skip
    (tmp_path / "ten.yaml").write_text(yaml.safe_dump(scenario), encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    done = gcs("campaign", "shrink", "ten.yaml", "--expect", "min_separation_m>=0.6", "--out", "small.yaml")
    assert done.returncode == 0, done.stderr
    assert "still fails: 2 pursuers\n" in done.stdout
    small = yaml.safe_load((tmp_path / "small.yaml").read_text(encoding="utf-8"))
    assert {pursuer["sysid"] for pursuer in small["vehicles"]["pursuers"]} == {1, 2}
    assert small["obstacles"] == []
