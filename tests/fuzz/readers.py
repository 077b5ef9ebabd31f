"""Readers of files that are attacked: each takes copies of the corpus's folder in which a file is not as it was."""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from unittest import mock

from hostile import Hostile

from gcs.campaign import file as campaign_file
from gcs.campaign import statistics, table
from gcs.campaign.plan import make
from gcs.link.keys import LinkSigning
from gcs.mavlink import codec
from gcs.mavlink.parameters import file as parameter_file
from gcs.mavlink.parameters import pack
from gcs.recording import export, series, session_folder
from gcs.recording.recorder import DECISIONS, TLOG
from gcs.recording.summary import FILE as SUMMARY
from gcs.recording.tables import tables
from gcs.scenario.file import load
from gcs.scenario.model import Scenario, ScenarioError
from gcs.session import replay as replay_module
from gcs.session.replay import Replay, ReplayError
from gcs.supervisor import redecide as redecide_module
from gcs.supervisor.redecide import RedecideError, redecide
from skytender.key_files import KeyRefused

CORPUS = Path(__file__).parent / "corpus"
IN_MEMORY = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
"""Where copies of the corpus are made; None: where temporary files go."""
REACHED = CORPUS / "reached"
"""Inputs of earlier campaigns that reached new branches, a file of hexadecimal lines for each guided target."""
REACHED_BYTES = 12_000
"""So much of a target's is committed, the shortest inputs."""
WANTED = (TLOG, DECISIONS, SUMMARY, "scenario.yaml", "vehicles/1.truth")
KNOWN = (CORPUS / "session" / "scenario.yaml").read_bytes()


def reached(name: str) -> list[bytes]:
    """Inputs that earlier campaigns found for a target."""
    path = REACHED / f"{name.replace(' ', '-')}.hex"
    return [bytes.fromhex(line) for line in path.read_text().split()] if path.exists() else []


def distil(kept: Path) -> None:
    """Put what campaigns have kept into the corpus, where the next one anywhere begins with it."""
    REACHED.mkdir(exist_ok=True)
    for folder in sorted(path for path in kept.iterdir() if path.is_dir()):
        name = folder.name.replace("-", " ")
        found = {*reached(name), *(path.read_bytes() for path in folder.iterdir() if not path.name.startswith("seed-"))}
        lines, left = [], REACHED_BYTES
        for one in sorted(found - {b""}, key=lambda one: (len(one), one)):
            left -= len(one)
            if left < 0:
                break
            lines.append(one.hex())
        if lines:
            (REACHED / f"{folder.name}.hex").write_text("\n".join(lines) + "\n")


@contextlib.contextmanager
def read_once() -> Iterator[None]:
    """Readers take the scenario of the corpus as read where it is as it was: half of their time, and not attacked."""
    known = load(CORPUS / "session" / "scenario.yaml")

    def remembered(path: Path) -> Scenario:
        return known if path.read_bytes() == KNOWN else load(path)

    with contextlib.ExitStack() as patched:
        for module in (replay_module, redecide_module, session_folder, export):
            patched.enter_context(mock.patch.object(module, "load", remembered))
        yield


def _report(folder: Path) -> None:
    recorded = session_folder.read(folder)
    flown = series.tracks(recorded)
    for made in (series.vehicles, series.traffic, series.attitudes, series.batteries, series.competition, series.texts):
        made(recorded)
    series.links(recorded, flown)


def _replay(folder: Path) -> None:
    with contextlib.suppress(ReplayError):
        replay = Replay(folder)
        for share in (0.0, 0.5, 1.0):
            replay.seek(replay.from_s + share * (replay.to_s - replay.from_s))
            json.dumps(replay.snapshot(speed=1.0), allow_nan=False)


def _export(folder: Path) -> None:
    out = folder / "tables"
    out.mkdir()
    written = tables("csv", out)
    try:
        with contextlib.suppress(export.ExportError):
            export.export(folder, written)
    finally:
        written.close()


def _redecide(folder: Path) -> None:
    with contextlib.suppress(RedecideError, ScenarioError):
        redecide(folder)


def _load(folder: Path) -> None:
    with contextlib.suppress(ScenarioError):
        load(folder / "scenario.yaml")


def _parameters(folder: Path) -> None:
    with contextlib.suppress(ValueError):
        parameter_file.read(folder / "vehicle.params")


def _packed(folder: Path) -> None:
    with contextlib.suppress(ValueError):
        pack.unpack((folder / "param.pck").read_bytes())


def _key(folder: Path) -> None:
    with contextlib.suppress(KeyRefused):
        link = LinkSigning(folder / "link.key")
        link.sign(codec.frame(codec.message("SYSTEM_TIME"), 0, 255, 190))
        link.close()


def _campaign(folder: Path) -> None:
    with contextlib.suppress(ScenarioError):
        make(campaign_file.load(folder / "campaign.yaml"), [folder]).checked()


def _rows(folder: Path) -> None:
    rows = table.read(folder, PLAN.campaign)
    assert not table.broken(folder, PLAN.campaign) or rows.num_rows == 0
    statistics.text(PLAN, rows)


PLAN = make(campaign_file.load(CORPUS / "session" / "campaign.yaml"), [])
READERS: dict[str, tuple[tuple[str, ...], Callable[[Path], None]]] = {
    "report": (WANTED, _report),
    "replay": ((TLOG, DECISIONS, SUMMARY, "scenario.yaml"), _replay),
    "export": ((TLOG, DECISIONS, "vehicles/1.truth"), _export),
    "decide": ((TLOG, DECISIONS), _redecide),
    "scenario": (("scenario.yaml",), _load),
    "parameters": (("vehicle.params",), _parameters),
    "packed": (("param.pck",), _packed),
    "key": (("link.key", "link.key.stamps"), _key),
    "campaign": (("campaign.yaml",), _campaign),
    "rows": (("rows/part-00000000-corpus.parquet",), _rows),
}
"""By name: the files of a session of which one at a time is mutated, and what reads them."""


class Copy:
    """A copy of the corpus's session, which is made as it was again: what has changed is, and that is little."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        shutil.copytree(CORPUS / "session", folder)
        self._were = {path: (path.read_bytes(), self._stamp(path)) for path in folder.rglob("*") if path.is_file()}
        self._folders = {folder, *(path.parent for path in self._were)}

    def restore(self) -> None:
        """Make it as it was."""
        for place in self._folders:
            for path in place.iterdir():
                if path.is_dir() and not path.is_symlink() and path not in self._folders:
                    shutil.rmtree(path)
                elif path not in self._were and path not in self._folders:
                    path.unlink()
        for path, (content, stamp) in self._were.items():
            if not path.exists() or self._stamp(path) != stamp:
                path.write_bytes(content)
                self._were[path] = content, self._stamp(path)

    @staticmethod
    def _stamp(path: Path) -> tuple[int, int, int]:
        status = path.stat()
        return status.st_ino, status.st_size, status.st_mtime_ns


@contextlib.contextmanager
def reader(name: str, hostile: Hostile) -> Iterator[Callable[[int], None]]:
    """One reader on copies of the corpus's session, in each of which a file is mutated."""
    files, read = READERS[name]
    with tempfile.TemporaryDirectory(dir=IN_MEMORY) as place, read_once():
        copy = Copy(Path(place) / "session")
        folder = copy.folder

        def attack(n: int) -> None:
            path = folder / files[n % len(files)]
            path.write_bytes(hostile.mutated(path.read_bytes()))
            try:
                read(folder)
            except OSError as error:
                if error.errno is None:
                    raise
            except BaseException:
                shutil.copytree(folder, os.environ.get("FUZZ_FOUND", tempfile.mkdtemp()), dirs_exist_ok=True)
                raise
            finally:
                copy.restore()

        yield attack
