"""The README's picture of the console: flies the demo at five times the speed, and draws the console of it.

python docs/.site/console_picture.py [--out .readme/demo.svg]
"""

from __future__ import annotations

import argparse
import asyncio
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from gcs.console.app import ConsoleApp
from gcs.console.text import UNICODE
from gcs.session.client import SOCKET, SessionSource

ROOT = Path(__file__).resolve().parents[2]
SIZE = (132, 36)
AT_S, SPEED = 52.5, 5.0
PATIENCE_S = 120.0


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0] if __doc__ else None)
    parser.add_argument("--out", type=Path, default=ROOT / ".readme" / "demo.svg")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "session"
        command = [sys.executable, "-m", "gcs", "run", "demo", "--speed", str(SPEED), "--plain", "--no-report"]
        session = subprocess.Popen([*command, "--out", folder], stdout=subprocess.DEVNULL)
        try:
            until_s = time.monotonic() + PATIENCE_S
            while not (folder / SOCKET).is_socket():
                if session.poll() is not None or time.monotonic() > until_s:
                    sys.exit("the demo did not start")
                time.sleep(0.05)
            svg = asyncio.run(drawn(ConsoleApp(SessionSource(folder), "demo", glyphs=UNICODE), AT_S))
        finally:
            session.terminate()
            session.wait()
    options.out.write_text(svg, encoding="utf-8")
    print(f"{options.out}: {len(svg) / 1e3:.0f} kB")


async def drawn(app: ConsoleApp, t_s: float) -> str:
    """SVG of the console at a time of its session."""
    async with app.run_test(size=SIZE) as pilot:
        while app.seen.snapshot.get("t_s", 0.0) < t_s:
            await pilot.pause(0.1)
        return app.export_screenshot(title="demo")


if __name__ == "__main__":
    main()
