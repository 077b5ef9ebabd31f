"""Pages for tests: a server of a source in this process, a cable that can be cut, Debian's Chromium by Playwright."""

from __future__ import annotations

import contextlib
import io
import queue
import shutil
import socket
import threading
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from feed import Fed
from patience import PATIENCE_S
from PIL import Image
from playwright.sync_api import Browser, Page, expect, sync_playwright
from sessions import small

from gcs.scenario.model import Scenario
from gcs.session.client import MessageSource
from gcs.session.messages import session_message
from gcs.web.serve import serve

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
MISSING = "Chromium is not installed (Debian: apt-get install chromium)"
ARGUMENTS = [
    "--no-sandbox",
    "--enable-unsafe-swiftshader",
    "--disable-dev-shm-usage",
]  # tests run as root, without a card


class Script(Fed):
    """A source that takes every command."""

    def send(self, command: Mapping[str, Any]) -> None:
        super().send(command)
        self.feed({"type": "reply", "id": command.get("id"), "ok": True, "text": f"{command['command']} is taken."})


def row(sysid: int, t_s: float, **changed: Any) -> dict[str, Any]:
    """A vehicle on a circle."""
    return {
        "sysid": sysid, "role": "pursuer", "label": f"pursuer {sysid}", "alive": True, "stage": "fly",
        "mode": "offboard", "mode_name": "Offboard", "armed": True, "landed": False, "autopilot": "px4",
        "p_ned": [sysid % 16 + 0.2 * t_s, sysid // 16, -5.0], "v_ned": [0.2, 0.0, 0.0],
        "speed_m_s": 0.2, "height_m": 5.0, "heading_rad": 0.3, "roll_rad": 0.05,
        "pitch_rad": -0.05, "aim_ned": None, "margin_m": None, "age_s": 0.0, "heard_s": 0.1, "lost": 0,
        "lost_share": 0.0, "target_m": 2.0, "battery": 0.8, "remaining_j": 8e3, "power_w": 100.0, "endurance_s": 80.0,
        "energy_source": "energy_consumed", "v": None, "tau": None, "state": "idle", "trouble": [], "severity": 0,
        "condition": "", "figure": "", "urgency": 0.0, "note": "", **changed,
    }  # fmt: skip


def snapshot(t_s: float, rows: list[dict[str, Any]], *events: dict[str, Any]) -> dict[str, Any]:
    goal = {
        "separation_m": None, "clearance_m": None, "traffic_m": None, "pursue_within_m": None, "pursue_for_s": None,
        "refuelled_at_least": 0, "pursue_held_s": None, "broken": [],
    }  # fmt: skip
    nobody = {"v": {}, "tau": {}, "leader": None, "share": None, "runner_up": None, "threshold": 0.9}
    return {
        "type": "snapshot", "t_s": t_s, "duration_s": 120.0, "speed": 1.0, "phase": "flying", "vehicles": rows,
        "traffic": [], "competition": nobody, "services": [], "history": [], "refuelled": 0, "goal": goal,
        "inspected": {}, "events": list(events),
    }  # fmt: skip


def session(rows: list[dict[str, Any]], **changed: Any) -> dict[str, Any]:
    members = [
        {"sysid": r["sysid"], "role": r["role"], "label": r["label"], "capacity_j": 1e4, "path_ned": [], "colour": k}
        for k, r in enumerate(rows)
    ]
    told = session_message(Scenario.model_validate(small()), None)
    return {**told, "vehicles": members, **changed}


class Stopping:
    """A source that can be made to end."""

    def __init__(self, source: MessageSource) -> None:
        self._source = source
        self.over = False
        self.connected = True

    def receive(self) -> list[Mapping[str, Any]]:
        end = [{"type": "end", "outcome": "met", "text": "met", "exit": 0}] if self.over else []
        return [*self._source.receive(), *end]

    def send(self, command: Mapping[str, Any]) -> None:
        self._source.send(command)

    def close(self) -> None:
        self._source.close()


@contextlib.contextmanager
def served(source: MessageSource, tiles: str | None = None, report: Path | None = None) -> Iterator[dict[str, str]]:
    """The links of a source's page, while in the context; a server with a report ends there only if no page came."""
    links: queue.SimpleQueue[dict[str, str]] = queue.SimpleQueue()
    stopping = Stopping(source)
    thread = threading.Thread(target=serve, args=(stopping, lambda told: links.put(dict(told)), tiles, report))
    thread.start()
    try:
        yield links.get(timeout=30)
    finally:
        stopping.over = True
        thread.join(timeout=30)
        assert not thread.is_alive()


class Cable:
    """Passes bytes on between a port of its own and a server's; it can be cut, and mended."""

    def __init__(self, port: int) -> None:
        self._to = ("127.0.0.1", port)
        self._server = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._server.getsockname()[1]
        self._ends: list[socket.socket] = []
        self._whole = True
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self) -> None:
        while True:
            try:
                near, _ = self._server.accept()
            except OSError:
                return
            if not self._whole:
                near.close()
                continue
            far = socket.create_connection(self._to)
            self._ends += [near, far]
            for a, b in ((near, far), (far, near)):
                threading.Thread(target=_pump, args=(a, b), daemon=True).start()

    def cut(self) -> None:
        self._whole = False
        for end in self._ends:
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
        self._ends.clear()

    def mend(self) -> None:
        self._whole = True

    def close(self) -> None:
        self.cut()
        self._server.close()


def _pump(a: socket.socket, b: socket.socket) -> None:
    with contextlib.suppress(OSError):
        while chunk := a.recv(1 << 16):
            b.sendall(chunk)
    for end in (a, b):
        with contextlib.suppress(OSError):
            end.close()


@contextlib.contextmanager
def chromium() -> Iterator[Browser]:
    """Debian's Chromium, without a window."""
    with sync_playwright() as playwright:
        expect.set_options(timeout=1e3 * PATIENCE_S)
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        try:
            yield browser
        finally:
            browser.close()


class Watched:
    """A page and what went wrong on it: exceptions, errors on its console, what it fetched."""

    def __init__(
        self, browser: Browser, *, width: int = 1280, height: int = 800, dark: bool = False, tour: bool = False
    ) -> None:
        """`tour`: the page is shown for the first time."""
        self.page: Page = browser.new_page(
            viewport={"width": width, "height": height}, color_scheme="dark" if dark else "light"
        )
        if not tour:
            # A sandboxed frame has no storage, and no tour.
            self.page.add_init_script("try { localStorage.setItem('skytender-tour', 'seen') } catch {}")
        self.page.set_default_timeout(1e3 * PATIENCE_S)
        self.wrong: list[str] = []
        self.asked: list[str] = []
        self.page.on("pageerror", lambda error: self.wrong.append(str(error)))
        self.page.on("console", lambda line: self.wrong.append(line.text) if line.type == "error" else None)
        self.page.on("request", lambda request: self.asked.append(request.url))

    def well(self) -> None:
        """Nothing has gone wrong, and axe-core finds nothing on the page that keeps a person from using it."""
        assert barriers(self.page) == []
        assert self.wrong == []

    def look(self, width: int, height: int, *, dark: bool) -> None:
        """Give it another size and another theme."""
        self.page.set_viewport_size({"width": width, "height": height})
        self.page.emulate_media(color_scheme="dark" if dark else "light")
        self.page.evaluate("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))")

    def open(self, url: str) -> Page:
        """Go to a page."""
        self.page.goto(url)
        return self.page

    def flying(self, url: str) -> Page:
        """Go to a page that is served, and wait until it shows vehicles."""
        self.open(url)
        until(self.page, "window.skytender?.current?.vehicles.length > 0")
        return self.page

    def report(self, url: str) -> Page:
        """Go to a report, and wait until all of it is drawn; it is `skytender` then, as on a page that is served."""
        self.open(url)
        until(self.page, "document.documentElement.dataset.all")
        self.page.evaluate("skytender.then((app) => { window.skytender = app; })")
        return self.page


class MapPicture:
    """The map as it is drawn, and where on it a place lies."""

    def __init__(self, page: Page) -> None:
        page.keyboard.press("m")
        expect(page.locator("canvas.map")).to_be_visible()
        drawn(page, "map")
        self.picture = Image.open(io.BytesIO(page.locator("canvas.map").screenshot())).convert("RGB")
        self._frame = page.evaluate("skytender.map.frame")

    def pixel(self, north_m: float, east_m: float) -> tuple[int, int]:
        frame = self._frame
        x = frame["width"] / 2 + (east_m - frame["e"]) * frame["perMetre"]
        y = frame["height"] / 2 - (north_m - frame["n"]) * frame["perMetre"]
        return round(x), round(y)

    def colours(self, north_m: float, east_m: float, within: int = 0) -> list[tuple[int, int, int]]:
        """RGB of a place's pixel, or of all that are so many pixels off at most."""
        x, y = self.pixel(north_m, east_m)
        near = range(-within, within + 1)
        return [self.picture.getpixel((x + u, y + w)) for u in near for w in near]  # type: ignore[misc]


UNTIL = """new Promise((done) => {{
  const end_ms = performance.now() + {1};
  const look = () => (({0}) ? done("") : performance.now() < end_ms ? setTimeout(look, 20) : done(state()));
  const state = () => {{
    const app = window.skytender;
    const seen = {{ hidden: document.hidden, frames: app?.frames, at_s: app?.at_s, shown_s: app?.current?.t_s }};
    return JSON.stringify({{ ...seen, received_s: app?.flight?.newest?.t_s, samples: app?.flight?.count }});
  }};
  look();
}})"""


def until(page: Page, expression: str) -> None:
    """Wait in the page until an expression of JavaScript holds; the page's policy lets nothing else evaluate text."""
    state = page.evaluate(UNTIL.format(expression, 1e3 * PATIENCE_S))
    assert not state, f"{expression} does not hold after {PATIENCE_S:.0f} s: {state}"


def selected(page: Page, *sysids: int) -> None:
    """Wait until these vehicles, and no others, are selected: a busy page takes a click when it has drawn."""
    until(page, f"[...skytender.selected].sort((a, b) => a - b).join() === '{','.join(map(str, sysids))}'")


def drawn(page: Page, view: str) -> None:
    """Wait until a view shows what there is."""
    until(page, f"!skytender.{view}.dirty && !skytender.dirty")


def barriers(page: Page) -> list[str]:
    """What axe-core finds, a sentence each."""
    from axe_playwright_python.sync_playwright import Axe  # noqa: PLC0415 - it takes a while to load

    # What passes need not be listed: with 254 vehicles that takes twice as long as the rest.
    found = Axe().run(page, options={"resultTypes": ["violations"]}).response["violations"]
    return [f"{one['id']}: {one['help']} ({node['html'][:160]})" for one in found for node in one["nodes"]]
