"""The pages between the lines at the top and the keys at the bottom, and what each key does there."""

from __future__ import annotations

from collections.abc import Callable
from typing import ClassVar

from textual import events
from textual.app import ComposeResult
from textual.binding import BindingType
from textual.containers import Container, Horizontal, Vertical
from textual.geometry import Size
from textual.screen import Screen

from gcs.console import layout
from gcs.console.dialogs import Choose, Help, Look
from gcs.console.drawing.canvas import Canvas
from gcs.console.drawing.panel import Paint, Panel
from gcs.console.model import SessionModel, Vehicle
from gcs.console.operator_controls import OperatorControls
from gcs.console.pages import competition, heading, help_text, map_view, vehicle
from gcs.console.pages.events import EventsPage
from gcs.console.pages.fleet_page import FleetPage
from gcs.console.shell import Shell
from gcs.console.text import StyledLines, fitted, titled

LEAST = Size(80, 24)
WIDE = Size(120, 30)
NOTICE_S = 8.0
INTERRUPTED = 130  # the exit status when the operator wants the end of a session that cannot be asked yet


class MainScreen(Screen[None]):
    """Everything but the dialogs."""

    app: Shell

    DEFAULT_CSS = layout.CSS
    BINDINGS: ClassVar[list[BindingType]] = layout.KEYS

    def __init__(self) -> None:
        super().__init__()
        self.page = "fleet"
        self.chosen: int | None = None
        self.fleet_page = FleetPage()
        self.events_page = EventsPage()
        self.plan = map_view.MapView()
        self.small_plan = map_view.MapView()
        self._scrolled = self._most = 0
        self._notice: tuple[str, str, float] | None = None
        self._arranged_for = (0, False)
        self._inspected: int | None = None

    def compose(self) -> ComposeResult:
        """The same panels always; which of them show depends on page and size."""
        yield Panel(self._session, id="session")
        yield Panel(lambda width, _: [heading.goal_line(self.seen, self.page, width, self.app.glyphs)], id="goal")
        yield Panel(lambda width, _: [heading.health_line(self.seen, width, self.app.glyphs)], id="trouble")
        with Container(id="body"):
            with Horizontal(id="page-fleet", classes="page"):
                with Vertical(id="left"):
                    yield Panel(self._fleet, id="fleet", pointed=self._point_fleet)
                    yield Panel(self._seen_by(self.events_page.recent), id="recent")
                with Vertical(id="right"):
                    yield Panel(self._small_map, id="small-map")
                    yield Panel(self._course, id="course")
            yield Panel(self._map, id="page-map", classes="page", pointed=self._point_map)
            yield Panel(self._seen_by(competition.page), id="page-competition", classes="page")
            events_panel = self._seen_by(self.events_page.page)
            yield Panel(events_panel, id="page-events", classes="page", pointed=self._point_lines)
            yield Panel(self._vehicle, id="page-vehicle", classes="page", pointed=self._point_lines)
        yield Panel(self._keys, id="keys")
        yield Panel(self._too_small, id="small")

    def on_mount(self) -> None:
        """Show the first page."""
        self.controls = OperatorControls(self.app, self.notice)
        self._arrange()

    # what is shown

    @property
    def seen(self) -> SessionModel:
        """State from the messages received."""
        return self.app.seen

    def beat(self, changed: bool) -> None:
        """Show what has changed."""
        for reply in self.seen.replies:
            if self.controls.concerns(reply):
                self.notice(*self.controls.answered(reply))
        self.seen.replies.clear()
        if self.chosen not in self.seen.vehicles:
            fleet = self._ordered()
            self.chosen = fleet[0]["sysid"] if fleet else None
        self._inspect()
        needs = len(self._ordered()), self.seen.monitors
        if needs != self._arranged_for:
            self._arranged_for = needs
            self._arrange()
        self.redraw()

    def redraw(self) -> None:
        """Paint every panel that can be seen."""
        for panel in self.query(Panel):
            if panel.display and panel.region.size:
                panel.redraw()

    def notice(self, text: str, style: str = "info") -> None:
        """Say something for a few seconds, in place of the keys."""
        self._notice = (text, style, self.app.clock() + NOTICE_S)
        self.redraw()

    def too_small(self, size: Size) -> bool:
        """Whether there is no room for the pages."""
        return size.width < LEAST.width or size.height < LEAST.height

    def check_action(self, action: str, parameters: tuple[object, ...]) -> bool:
        """In a terminal that is too small nothing can be seen, and nothing asked for, but the end."""
        return action in ("close", "interrupt", "app.suspend_process") or not self.too_small(self.size)

    def on_resize(self, event: events.Resize) -> None:
        """Lay the panels out anew."""
        self._arrange(event.size)

    def _arrange(self, size: Size | None = None) -> None:
        size = size or self.size
        small = self.too_small(size)
        for panel in ("session", "goal", "trouble", "body", "keys"):
            self.query_one(f"#{panel}").display = not small
        self.query_one("#small").display = small
        for name in heading.PAGES:
            self.query_one(f"#page-{name}").display = name == self.page
        wide = size.width >= WIDE.width and size.height >= WIDE.height
        self.query_one("#right").display = wide
        self.query_one("#right").styles.width = max(44, size.width - 104)
        # A monitor knows of no competition.
        self.query_one("#course").display = not self.seen.monitors
        self._share_left(size)
        self.call_after_refresh(self.redraw)

    def _share_left(self, size: Size) -> None:
        """The fleet has the lines that it needs, and leaves the events at least six."""
        body = size.height - 4
        needed = self.fleet_page.lines(self.seen) + 1
        self.query_one("#fleet").styles.height = max(4, min(needed, body - max(6, body // 5)))

    def _seen_by(self, page: Callable[..., StyledLines]) -> Paint:
        return lambda width, height: page(self.seen, width=width, height=height, glyphs=self.app.glyphs)

    def _session(self, width: int, height: int) -> StyledLines:
        app = self.app
        silent_s = app.clock() - app.last_received_s
        return [heading.session_line(self.seen, app.title, app.source.connected, silent_s, width, app.glyphs)]

    def _keys(self, width: int, height: int) -> StyledLines:
        glyphs = self.app.glyphs
        if self._notice is not None and self.app.clock() < self._notice[2]:
            text, style, _ = self._notice
            return [[(t, f"notice {style} raised") for t, _ in fitted([(f" {text}", "")], width, glyphs)]]
        keys = help_text.bottom(self.page, **self._takes)
        return [heading.keys_line(keys, width)]

    @property
    def _takes(self) -> dict[str, bool]:
        """Facts that the help page and the last line depend on."""
        seen = self.seen
        return {"control": seen.control, "replay": seen.replay is not None, "monitor": seen.monitors}

    def _too_small(self, width: int, height: int) -> StyledLines:
        return heading.too_small(width, height, (LEAST.width, LEAST.height), flies=self.seen.replay is None)

    def _ordered(self) -> list[Vehicle]:
        return self.fleet_page.ordered(self.seen)

    def _fleet(self, width: int, height: int) -> StyledLines:
        return self.fleet_page.table(self.seen, self.chosen, width=width, height=height, glyphs=self.app.glyphs)

    def _small_map(self, width: int, height: int) -> StyledLines:
        glyphs = self.app.glyphs
        drawn = map_view.draw(
            self.seen, self.small_plan, width=width, height=height - 1, glyphs=glyphs, chosen=self.chosen
        )
        return [titled("map", width, glyphs), *drawn]

    def _course(self, width: int, height: int) -> StyledLines:
        glyphs = self.app.glyphs
        rest = competition.compact(self.seen, width=width, height=height - 1, glyphs=glyphs)
        return [titled("competition", width, glyphs), *rest]

    def _map(self, width: int, height: int) -> StyledLines:
        return map_view.draw(
            self.seen, self.plan, width=width, height=height, glyphs=self.app.glyphs, chosen=self.chosen
        )

    def _vehicle(self, width: int, height: int) -> StyledLines:
        lines, self._most = vehicle.page(
            self.seen, self.chosen, width=width, height=height, back=self._scrolled, glyphs=self.app.glyphs
        )
        self._scrolled = min(self._scrolled, self._most)
        return lines

    def _inspect(self) -> None:
        """Ask for all that the shown vehicle sends, and for nothing any more when its page is left."""
        wanted = self.chosen if self.page == "vehicle" else None
        if wanted != self._inspected and self.app.source.connected:
            self._inspected = wanted
            self.app.source.send({"command": "inspect", "sysid": wanted})

    # where to look

    def action_page(self, name: str) -> None:
        """Show a page."""
        self.page = name
        self._scrolled = 0
        self._inspect()
        self._arrange()

    def action_turn(self, step: int) -> None:
        """The next page."""
        pages = heading.PAGES
        self.action_page(pages[(pages.index(self.page) + step) % len(pages)])

    def action_choose(self, step: int) -> None:
        """The next vehicle in the table's order."""
        fleet = [vehicle["sysid"] for vehicle in self._ordered()]
        if fleet:
            at = fleet.index(self.chosen) if self.chosen in fleet else -1
            self._choose(fleet[(at + step) % len(fleet)])

    def _choose(self, sysid: int) -> None:
        self.chosen, self._scrolled = sysid, 0
        if self.plan.follow is not None:
            self.plan.follow = sysid
        self._inspect()
        self.redraw()

    def action_move(self, down: int, across: int) -> None:
        """Arrows: along the fleet, over the map, through events and messages; across in a replay: in time."""
        if across and self.seen.replay is not None:
            self.controls.seek(across)
        elif self.page == "map":
            self.action_pan(-down, across)
        elif down:
            self._go(down)

    def action_leaf(self, step: int) -> None:
        """A page's height at once."""
        self._go(step * max(1, self.size.height - 8))

    def action_end(self, where: int) -> None:
        """To the first or the last."""
        self._go(where * 1_000_000)

    def _go(self, down: int) -> None:
        if self.page == "events":
            self.events_page.scroll(down)
        elif self.page == "vehicle":
            self._scrolled = min(max(0, self._scrolled + down), self._most)
        elif self.page == "fleet":
            fleet = [vehicle["sysid"] for vehicle in self._ordered()]
            if fleet:
                at = fleet.index(self.chosen) if self.chosen in fleet else 0
                self.chosen = fleet[min(max(at + down, 0), len(fleet) - 1)]
        self.redraw()

    def action_order_by(self) -> None:
        """Another order of the fleet."""
        self.fleet_page.next_order()
        self.notice(f"the fleet is ordered by {self.fleet_page.order_by}; trouble comes first")

    def action_go_to(self) -> None:
        """Choose a vehicle by its id."""

        def go(sysid: int | None) -> None:
            if sysid is not None:
                self._choose(sysid)

        if options := [(sysid, self.seen.name(sysid)) for sysid in sorted(self.seen.vehicles)]:
            self.app.push_screen(Choose("Go to which vehicle?", options, self.app.glyphs), go)

    def action_look(self) -> None:
        """Dark or light."""
        self.app.turn_look()
        for panel in self.query(Panel):
            panel.again()

    def action_fold(self) -> None:
        """Each event on its own, or what follows from another under it."""
        self.events_page.folds = not self.events_page.folds
        self.notice(
            "what follows from an event is folded into it" if self.events_page.folds else "every event is shown"
        )
        self.redraw()

    def action_pan(self, north: int, east: int) -> None:
        """Move the map."""
        if self.page == "map":
            size = self.query_one("#page-map").size
            canvas = Canvas(size.width, size.height, self.app.glyphs)
            self.plan.pan(north, east, (canvas.width, canvas.height))
            self.redraw()

    def action_zoom(self, steps: int) -> None:
        """Nearer or farther."""
        if self.page == "map":
            self.plan.zoom(steps)
            self.redraw()

    def action_follow(self) -> None:
        """Keep the chosen vehicle in the middle of the map, or no longer."""
        self.plan.follow = None if self.plan.follow is not None else self.chosen
        if self.plan.follow is not None:
            self.plan.fit = False
        said = f"follows {self.seen.name(self.chosen)}" if self.plan.follow is not None else "follows no vehicle"
        self.notice(f"the map {said}")

    def action_fit(self) -> None:
        """Show everything on the map."""
        self.plan.fit, self.plan.follow = True, None
        self.redraw()

    def action_filter(self, what: str) -> None:
        """Change which events are shown."""
        self.events_page.change(what, self.chosen)
        if self.page != "events":
            self.notice(f"events shown: {self.events_page.filter.said()}")
        self.redraw()

    def action_words(self) -> None:
        """Ask for words that the vehicles shown must have; on the page of events, the events."""
        vehicles = self.page == "fleet"

        def accept(words: str | None) -> None:
            if words is None:
                return
            if vehicles:
                self.fleet_page.words = words
                self._arrange()
            else:
                self.events_page.look_for(words)
            self.redraw()

        before = self.fleet_page.words if vehicles else self.events_page.filter.words
        what = "vehicles" if vehicles else "events"
        self.app.push_screen(Look(f"Show only {what} with these words:", before, self.app.glyphs), accept)

    def action_help(self) -> None:
        """The help page."""
        app = self.app
        lines = help_text.page(**self._takes, owner=app.owner, lost=app.lost(), glyphs=app.glyphs)
        app.push_screen(Help(lines, app.glyphs))

    def _point_fleet(self, column: int, row: int, turn: int) -> None:
        if turn:
            self._go(turn)
        elif (sysid := self.fleet_page.at(row)) is not None:
            self.chosen = sysid
            self.redraw()

    def _point_map(self, column: int, row: int, turn: int) -> None:
        if turn:
            self.action_zoom(-turn)

    def _point_lines(self, column: int, row: int, turn: int) -> None:
        self._go(3 * turn)

    # what is sent

    def action_play(self) -> None:
        """Pause the replay, or go on."""
        self.controls.play()

    def action_faster(self, step: int) -> None:
        """The next speed of a replay; on the map of a running session, zoom."""
        if self.seen.replay is None:
            self.action_zoom(step)
        else:
            self.controls.hurry(step)

    def action_ask(self, name: str) -> None:
        """An operator's key: ask, then send."""
        self.controls.ask(name, self.chosen)

    def action_interrupt(self) -> None:
        """Ctrl-C: the session's own console asks to stop it, any other closes."""
        if self.app.owner and self.app.source.connected:
            self.controls.ask("stop", None, insist=True)
        else:
            self.app.exit(0, return_code=INTERRUPTED if self.app.owner else 0)

    def action_close(self) -> None:
        """Close the console."""
        self.app.exit(0)
