"""Attack what takes bytes, guided by coverage (libFuzzer by Atheris): readers of files, frames, lines, answers.

    python guided.py --target replay --runs 10000 [--seconds 60] [--seed 1] [--kept DIR]
    python guided.py --target replay:100 --target lines:500

Branches of our own modules are what it looks for; what reaches a new one is kept in DIR and mutated on. It ends with
libFuzzer's report, and at the first exception, with the input in the working directory. FUZZ_LOOKS_INTO=simvehicle is
for a short run, most of whose time would go into the import of what is looked into.
"""

from __future__ import annotations

import argparse
import contextlib
import itertools
import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import atheris

with atheris.instrument_imports(include=os.environ.get("FUZZ_LOOKS_INTO", "gcs,simvehicle").split(",")):
    from dialogues import new_clients, sent_to
    from hostile import Hostile
    from readers import CORPUS, IN_MEMORY, READERS, Copy, reached, read_once
    from targets import session_sock

    from gcs.link.keys import SignatureGate, new_key
    from gcs.mavlink import codec
    from simvehicle.mavlink import codec as vehicle_codec
    from skytender.signing import SETUP_SIGNING

LARGEST = 1 << 16
HANG_S = 20
"""On the wall clock, and so longer than what the unguided attack allows of CPU time."""
Attack = Callable[[bytes], None]


def datagrams(_: Path) -> Attack:
    """Split and decode as both programs do."""

    def attack(data: bytes) -> None:
        for frame in codec.split(data).frames:
            with contextlib.suppress(ValueError):  # of an id that the dialect lacks, which nobody decodes
                codec.fields(frame)
        for received in vehicle_codec.split(data):
            vehicle_codec.decode(received)

    return attack


def answers(_: Path) -> Attack:
    """A vehicle's frames, in their order, to each dialogue about logs, files, parameters and plans."""

    def attack(data: bytes) -> None:
        frames = codec.split(data).frames
        for client in new_clients():
            for number, frame in enumerate(frames):
                client.poll(0.5 * number)
                sent_to(client, frame, 0.5 * number)

    return attack


def signed_frames(folder: Path) -> Attack:
    """A gate with a key and one without, and what they let through."""
    new_key(folder / "own.key")
    gate, plain = SignatureGate(folder / "own.key"), SignatureGate(None)

    def attack(data: bytes) -> None:
        frames = codec.split(data).frames
        gate.accepted(frames)
        plain.accepted(frames)
        for frame in frames:
            with contextlib.suppress(ValueError):  # of a message that the dialect lacks, which nobody signs
                codec.fields(frame)
                if not frame.raw[2] & codec.SIGNED:
                    (signed,) = codec.split(gate.signed(frame.raw)).frames
                    assert gate.accepted([signed]) or frame.msgid == SETUP_SIGNING

    return attack


def lines(_: Path) -> Attack:
    """Lines on session.sock, whose commands a supervisor takes."""

    class Given(Hostile):
        """Hostile input that is given."""

        given: itertools.cycle[bytes] = itertools.cycle([b"\n"])

        def line(self) -> bytes:
            return next(self.given) + b"\n"

    given = Given(1)
    kept = contextlib.ExitStack()
    once = kept.enter_context(session_sock(given))
    numbers = itertools.count()

    def attack(data: bytes) -> None:
        _ = kept
        given.given = itertools.cycle(data.split(b"\n"))
        once(50 * next(numbers))

    return attack


def file_of(name: str, folder: Path) -> Attack:
    """The reader on a session, one file of which, chosen by the first byte, is the rest."""
    files, read = READERS[name]
    copy = Copy(folder)

    def attack(data: bytes) -> None:
        (folder / files[data[0] % len(files) if data else 0]).write_bytes(data[1:])
        try:
            read(folder)
        except OSError as error:
            if error.errno is None:
                raise
        finally:
            copy.restore()

    return attack


BYTES: dict[str, Callable[[Path], Attack]] = {
    "datagrams": datagrams,
    "answers": answers,
    "signed frames": signed_frames,
    "lines": lines,
}


def seeds(name: str, place: Path) -> None:
    """The corpus as libFuzzer takes it: a file for each input."""
    place.mkdir(parents=True, exist_ok=True)
    inputs: list[Any] = []
    if name == "lines":
        hostile = Hostile(1)
        inputs = [b"".join(hostile.line() for _ in range(5)) for _ in range(50)]
    elif name in BYTES:
        inputs = [bytes.fromhex(line) for line in (CORPUS / "frames.hex").read_text().split()]
    else:
        for number, file in enumerate(READERS[name][0]):
            inputs.append(bytes([number]) + (CORPUS / "session" / file).read_bytes())
    inputs += reached(name)
    for number, one in enumerate(inputs):
        (place / f"seed-{number}").write_bytes(one)


def guide(target: str, runs: int, options: argparse.Namespace) -> None:
    """Attack one target; ends the process with libFuzzer's status."""
    place = Path(tempfile.mkdtemp(dir=IN_MEMORY))
    kept = options.kept or place / "kept"
    seeds(target, kept)
    make = BYTES.get(target)
    attack = file_of(target, place / "session") if make is None else make(place)
    limits = [f"-runs={runs}", f"-seed={options.seed}", f"-max_len={LARGEST}", f"-timeout={HANG_S}"]
    limits += [f"-max_total_time={options.seconds}"] if options.seconds else []
    os.environ.setdefault("PYTHONWARNINGS", "ignore")
    with read_once():
        for seed in sorted(kept.glob("seed-*")):
            attack(seed.read_bytes())  # it loads and compiles, which is no hang
        atheris.Setup([sys.argv[0], *limits, "-print_final_stats=1", str(kept)], attack)
        atheris.Fuzz()


def targets_of(words: list[str], runs: int) -> list[tuple[str, int]]:
    """Targets and their runs, where a word NAME:RUNS has runs of its own. Raises ValueError."""
    found = []
    for word in words:
        name, _, own = word.partition(":")
        if name not in {*BYTES, *READERS}:
            raise ValueError(f"there is no target {name!r}; there are: {', '.join([*BYTES, *READERS])}")
        found.append((name, int(own or runs)))
    return found


def main() -> int:
    """Attack one target in this process; several, each in a fork of it, which has everything imported."""
    says = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    says.add_argument("--target", action="append", metavar="NAME[:RUNS]", required=True)
    says.add_argument("--runs", type=int, default=10_000)
    says.add_argument("--seconds", type=int, default=0, help="at most; 0: as long as the runs take")
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--kept", type=Path, help="folder of inputs that reach something new  [default: a temporary one]")
    options = says.parse_args()
    try:
        targets = targets_of(options.target, options.runs)
    except ValueError as error:
        says.error(str(error))
    if len(targets) == 1:
        guide(*targets[0], options)
    for target, runs in targets:
        fork = os.fork()
        if not fork:
            guide(target, runs, options)
        if status := os.waitstatus_to_exitcode(os.waitpid(fork, 0)[1]):
            return abs(status)
    return 0


if __name__ == "__main__":
    sys.exit(main())
