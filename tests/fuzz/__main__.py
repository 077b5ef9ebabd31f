"""Attack both programs with hostile input: `make fuzz`.

Each target takes so many frames or mutated files, by seed, in a process of its own. Nothing may raise, take over two
seconds, or grow by more than 5 MB once warm. What does is told with its seed, which makes it again.
"""

from __future__ import annotations

import argparse
import gc
import subprocess
import sys
import time
import traceback
import tracemalloc
from pathlib import Path

from hostile import Hostile
from targets import CORPUS, FRAMES, READERS, reader

HANG_S = 2.0
GROWTH_BYTES = 5 << 20
AT_ONCE = 50
WARM_SHARE = 0.2
SEEDS = 20
"""A campaign is so many streams, one after the other in one process, so that what is found is made again quickly."""


def attack(name: str, kind: str, count: int, seed: int) -> str:
    """Attack one target; how many inputs it took, the longest one, how much it grew, and what went wrong or `ok`."""
    corpus = [bytes.fromhex(line) for line in (CORPUS / "frames.hex").read_text().split()]
    step = AT_ONCE if kind == "frames" else 1
    stream = max(count // SEEDS, step)
    done, longest_s, warm_bytes, wrong = 0, 0.0, 0, ""
    tracemalloc.start()
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
        gc.collect()
        if not warm_bytes and number - seed * SEEDS >= WARM_SHARE * SEEDS:
            warm_bytes = tracemalloc.get_traced_memory()[0]
    grown = tracemalloc.get_traced_memory()[0] - warm_bytes
    verdict = "ok" if grown <= GROWTH_BYTES else "GREW"
    return f"{done:>9} {kind}  longest {longest_s:.3f} s  {grown / 1e6:+.2f} MB  {verdict}"


def main() -> int:
    """Run the campaign; 0 where nothing was found."""
    says = argparse.ArgumentParser(description=__doc__)
    says.add_argument("--frames", type=int, default=1_000_000, help="for each target of datagrams")
    says.add_argument("--files", type=int, default=10_000, help="for each reader")
    says.add_argument("--seed", type=int, default=1)
    says.add_argument("--within", action="store_true", help="in this process, as it is called by itself")
    says.add_argument("--only", default="", help="some targets, by name with commas")
    options = says.parse_args()
    only = options.only.split(",") if options.only else [*FRAMES, *READERS]
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
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
