"""Attack both programs with hostile input: `make fuzz`.

Each target takes so many frames or mutated files, by seed, in a process of its own. Nothing may raise, take over two
seconds, or grow by more than 5 MB once warm. What does is told with its seed, which makes it again. After that the
readers, and what takes frames, lines and answers, are attacked guided by coverage where Atheris is installed; what
reaches something new is kept, and the next campaign begins with it.
"""

from __future__ import annotations

import argparse
import ctypes
import gc
import importlib.util
import re
import resource
import shutil
import subprocess
import sys
import tempfile
import time
import traceback
from pathlib import Path

from hostile import Hostile
from readers import CORPUS, READERS, distil, reader
from targets import FRAMES

HANG_S = 2.0
GROWTH_BYTES = 5 << 20
AT_ONCE = 50
WARM_SHARE = 0.2
KEPT = Path(__file__).resolve().parents[2] / ".fuzz"
BYTES = ("datagrams", "answers", "signed frames", "lines")
"""Targets of guided.py that are no readers."""
SEEDS = 20
"""A campaign is so many streams, one after the other in one process, so that what is found is made again quickly."""


def attack(name: str, kind: str, count: int, seed: int) -> str:
    """Attack one target; how many inputs it took, the longest one, how much it grew, and what went wrong or `ok`."""
    corpus = [bytes.fromhex(line) for line in (CORPUS / "frames.hex").read_text().split()]
    step = AT_ONCE if kind == "frames" else 1
    stream = max(count // SEEDS, step)
    done, longest_s, warm_bytes, wrong = 0, 0.0, 0, ""
    for number in range(seed * SEEDS, (seed + 1) * SEEDS):
        hostile = Hostile(number, corpus)
        with FRAMES[name](hostile) if kind == "frames" else reader(name, hostile) as once:
            for n in range(0, stream, step):
                begun_s = time.process_time()
                try:
                    once(n)
                except Exception:
                    wrong = f"seed {number}, input {n}: {traceback.format_exc()}"
                took_s = time.process_time() - begun_s
                done += step
                if warm_bytes:  # what comes first also loads and compiles
                    longest_s = max(longest_s, took_s)
                if longest_s > HANG_S:
                    wrong = f"seed {number}, input {n} took {took_s:.1f} s"
                if wrong:
                    return f"{wrong}\n{name} failed after {done}"
        if not warm_bytes and number - seed * SEEDS >= WARM_SHARE * SEEDS:
            warm_bytes = held_bytes()
    grown = held_bytes() - warm_bytes
    verdict = "ok" if grown <= GROWTH_BYTES else "GREW"
    return f"{done:>9} {kind}  longest {longest_s:.3f} s  {grown / 1e6:+.2f} MB  {verdict}"


def held_bytes() -> int:
    """Memory that this process has, once what is free has been given back."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize()


def main() -> int:
    """Run the campaign; 0 where nothing was found."""
    says = argparse.ArgumentParser(description=__doc__)
    says.add_argument("--frames", type=int, default=1_000_000, help="for each target of datagrams")
    says.add_argument("--files", type=int, default=100_000, help="for each reader")
    says.add_argument("--runs", type=int, default=100_000, help="guided ones, for each target of these")
    says.add_argument("--seconds", type=int, default=0, help="at most for each guided target; 0: as long as they take")
    says.add_argument("--kept", type=Path, default=KEPT, help="folder of what the guided ones found  [default: .fuzz]")
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--within", action="store_true", help="in this process, as it is called by itself")
    says.add_argument("--only", default="", help="some targets, by name with commas")
    says.add_argument("--distil", action="store_true", help="only write what was kept to corpus/reached")
    options = says.parse_args()
    if options.distil:
        distil(options.kept)
        return 0
    only = options.only.split(",") if options.only else [*FRAMES, *READERS, *BYTES]
    jobs = [(name, "frames", options.frames) for name in FRAMES if name in only]
    jobs += [(name, "files", options.files) for name in READERS if name in only]
    if options.within:
        said = [f"{name:<16} {attack(name, kind, count, options.seed)}" for name, kind, count in jobs]
        print(*said, sep="\n")
        return 0 if all(line.endswith("  ok") for line in said) else 1
    found = 0
    for name, _, count in jobs:
        begun_s = time.monotonic()
        counts = ["--frames", str(count), "--files", str(count), "--seed", str(options.seed)]
        command = [sys.executable, str(Path(__file__).parent), "--within", "--only", name, *counts]
        done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
        said = done.stdout.strip().splitlines() or [f"ended with status {done.returncode}"]
        found += done.returncode != 0
        print(f"{time.monotonic() - begun_s:5.0f} s  {said[-1]}", *said[:-1], sep="\n", flush=True)
    if importlib.util.find_spec("atheris") is None:
        print("guided: not attacked, for Atheris is not installed (pip install atheris)")
        return 1 if found else 0
    for name in only:
        if name not in FRAMES:
            found += guided(name, options)
    return 1 if found else 0


def guided(name: str, options: argparse.Namespace) -> int:
    """Attack one target guided by coverage; 1 where something was found."""
    begun_s, kept = time.monotonic(), (options.kept / name.replace(" ", "-")).absolute()
    kept.mkdir(parents=True, exist_ok=True)
    before = len(list(kept.iterdir()))
    command = [sys.executable, str(Path(__file__).resolve().with_name("guided.py")), "--target", name]
    command += [
        "--kept",
        str(kept),
        "--runs",
        str(options.runs),
        "--seconds",
        str(options.seconds),
        "--seed",
        str(options.seed),
    ]
    with tempfile.TemporaryDirectory() as place:
        done = subprocess.run(command, cwd=place, capture_output=True, text=True, errors="replace", check=False)
        for crash in Path(place).iterdir():
            shutil.copy(crash, options.kept / f"found-{name.replace(' ', '-')}-{crash.name}")
    covered = re.findall(r"cov: (\d+)", done.stderr)
    runs = re.findall(r"Done (\d+) runs", done.stderr) or ["0"]
    reached = f"{covered[0]} to {covered[-1]} branches" if covered else "nothing reached"
    grown = f"{before} to {len(list(kept.iterdir()))} inputs kept"
    verdict = "ok" if done.returncode == 0 else f"FOUND\n{done.stderr[-4000:]}"
    print(
        f"{time.monotonic() - begun_s:5.0f} s  {name:<16} {runs[-1]:>9} guided  {reached}  {grown}  {verdict}",
        flush=True,
    )
    return int(done.returncode != 0)


if __name__ == "__main__":
    sys.exit(main())
