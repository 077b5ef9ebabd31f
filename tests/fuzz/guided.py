"""Attack one reader of files, or the splitting and decoding of datagrams, guided by coverage (libFuzzer by Atheris).

    python guided.py --target replay --runs 10000 [--seed 1] [--kept DIR]

Branches of our own modules are what it looks for; what reaches a new one is kept in DIR and mutated on. It ends with
libFuzzer's report, and at the first exception, with the input in the working directory.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import shutil
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import atheris

ROOT = Path(__file__).resolve().parents[2]


def compiled() -> list[str]:
    """Modules that hold kernels, which cannot be compiled once they are instrumented."""
    files = [path for package in ("gcs", "simvehicle") for path in (ROOT / package).rglob("*.py")]
    kept = [path for path in files if "kernels import" in path.read_text(encoding="utf-8")]
    return [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in kept]


with atheris.instrument_imports(include=["gcs", "simvehicle"], exclude=compiled()):
    from targets import CORPUS, IN_MEMORY, READERS, read_once

    from gcs.mavlink import codec
    from simvehicle.mavlink import codec as vehicle_codec

DATAGRAMS = "datagrams"
LARGEST = 1 << 16
HANG_S = 20
"""On the wall clock, and so longer than what the unguided attack allows of CPU time."""


def datagram(data: bytes) -> None:
    """Split and decode as both programs do."""
    for frame in codec.split(data).frames:
        with contextlib.suppress(ValueError):  # of an id that the dialect lacks, which nobody decodes
            codec.fields(frame)
    for received in vehicle_codec.split(data):
        vehicle_codec.decode(received)


def file_of(name: str, folder: Path) -> Callable[[bytes], None]:
    """The reader on a session, one file of which, chosen by the first byte, is the rest."""
    files, read = READERS[name]
    session = CORPUS / "session"

    def attack(data: bytes) -> None:
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(session, folder)
        (folder / files[data[0] % len(files) if data else 0]).write_bytes(data[1:])
        try:
            read(folder)
        except OSError as error:
            if error.errno is None:
                raise

    return attack


def seeds(name: str, place: Path) -> None:
    """The corpus as libFuzzer takes it: a file for each input."""
    place.mkdir(parents=True, exist_ok=True)
    if name == DATAGRAMS:
        for number, line in enumerate((CORPUS / "frames.hex").read_text().split()):
            (place / f"frame-{number}").write_bytes(bytes.fromhex(line))
        return
    for number, file in enumerate(READERS[name][0]):
        (place / f"file-{number}").write_bytes(bytes([number]) + (CORPUS / "session" / file).read_bytes())


def main() -> None:
    """Ends the process with libFuzzer's status."""
    says = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    says.add_argument("--target", choices=[DATAGRAMS, *READERS], required=True)
    says.add_argument("--runs", type=int, default=10_000)
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--kept", type=Path, help="folder of inputs that reach something new  [default: a temporary one]")
    options = says.parse_args()
    place = Path(tempfile.mkdtemp(dir=IN_MEMORY))
    kept = options.kept or place / "kept"
    seeds(options.target, kept)
    attack = datagram if options.target == DATAGRAMS else file_of(options.target, place / "session")
    limits = [f"-runs={options.runs}", f"-seed={options.seed}", f"-max_len={LARGEST}", f"-timeout={HANG_S}"]
    os.environ.setdefault("PYTHONWARNINGS", "ignore")
    with read_once():
        atheris.Setup([sys.argv[0], *limits, "-print_final_stats=1", str(kept)], attack)
        atheris.Fuzz()


if __name__ == "__main__":
    main()
