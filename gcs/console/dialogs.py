"""Modal dialogs of the console: confirmation, choice of a vehicle, help page, search words for events."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from typing import ClassVar, TypeVar

from textual.app import ComposeResult
from textual.binding import Binding, BindingType
from textual.containers import Vertical
from textual.screen import ModalScreen
from textual.widgets import Input

from gcs.console.drawing.panel import Panel
from gcs.console.text import Glyphs, StyledLine, StyledLines, fitted, width_of, wrapped

Answer = TypeVar("Answer")


class Dialog(ModalScreen[Answer]):
    """A box in the middle; its frame is drawn with what the terminal can show."""

    DEFAULT_CSS = """
    Dialog { align: center middle; background: $ground 60%; }
    Dialog > #box { width: 64; max-width: 96%; height: auto; max-height: 96%; padding: 1 2; background: $raised; }
    Dialog > #box { border: round $frame; }
    Dialog.-ascii > #box { width: 64; border: ascii $frame; }
    Dialog #lines { height: auto; }
    Dialog Input, Dialog Input:focus { border: none; height: 1; padding: 0; }
    """

    def __init__(self, glyphs: Glyphs) -> None:
        super().__init__(classes="" if glyphs.unicode else "-ascii")
        self.glyphs = glyphs

    def compose(self) -> ComposeResult:
        """One panel in the box."""
        with Vertical(id="box"):
            yield Panel(self.paint, id="lines", ground="raised")

    @abstractmethod
    def paint(self, width: int, height: int) -> StyledLines:
        """Text of the box."""

    def on_mount(self) -> None:
        """Give the box the height of what it says."""
        self.call_after_refresh(self.fit)

    def fit(self) -> None:
        """Take the height that the lines need, as far as there is room."""
        panel = self.query_one("#lines", Panel)
        width = max(panel.size.width, 20)
        panel.styles.height = min(len(self.paint(width, 1000)), max(3, self.size.height - 8))
        panel.redraw()

    def redraw(self) -> None:
        """Show what has changed; before it is mounted nothing is shown yet."""
        if self.is_mounted:
            self.query_one("#lines", Panel).redraw()


class Confirm(Dialog[bool]):
    """A question and the state of what it is about, as it changes; `insist` also takes a second Ctrl-C as yes."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("y,enter", "dismiss(True)"),
        Binding("n,escape,q", "dismiss(False)"),
        Binding("ctrl+c", "interrupt", priority=True),
    ]

    def __init__(self, question: str, detail: Callable[[], str], glyphs: Glyphs, *, insist: bool = False) -> None:
        super().__init__(glyphs)
        self._question, self._detail, self._insist = question, detail, insist

    def paint(self, width: int, height: int) -> StyledLines:
        """The question, what it means, and the keys."""
        lines: StyledLines = [[(text, "name")] for text in wrapped(self._question, width)]
        if detail := self._detail():
            lines += [[(text, "dim")] for text in wrapped(detail, width)]
        yes = "y, Enter or Ctrl-C" if self._insist else "y or Enter"
        return [*lines, [], [(yes, "key"), (" yes    ", ""), ("n or Esc", "key"), (" no", "")]]

    def action_interrupt(self) -> None:
        """A second Ctrl-C confirms the first; anywhere else it cancels."""
        self.dismiss(self._insist)


class Choose(Dialog[int | None]):
    """One of several vehicles, by arrows or by typing its id."""

    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("up,k", "move(-1)"),
        Binding("down,j", "move(1)"),
        Binding("enter,y", "take"),
        Binding("escape,n,q,ctrl+c", "dismiss", priority=True),
    ]

    def __init__(self, question: str, options: Sequence[tuple[int, str]], glyphs: Glyphs) -> None:
        super().__init__(glyphs)
        self._question, self._options = question, options
        self._at = 0
        self._typed = ""

    def paint(self, width: int, height: int) -> StyledLines:
        """The question, the options around the present one, and the keys."""
        lines: StyledLines = [[(text, "name")] for text in wrapped(self._question, width)]
        room = min(12, max(1, height - len(lines) - 2))  # below them an empty line and the keys
        top = min(max(0, self._at - room // 2), max(0, len(self._options) - room))
        for order, (_, text) in enumerate(self._options[top : top + room], top):
            chosen = order == self._at
            line: StyledLine = [(f" {self.glyphs.chosen if chosen else ' '} {text}", "")]
            lines.append([(t, "chosen" if chosen else "") for t, _ in fitted(line, width, self.glyphs)])
        keys = [("Enter", "key"), (" yes    ", ""), ("Esc", "key"), (" no    ", "")]
        return [*lines, [], [*keys, ("up down", "key"), (" or an id", "")]]

    def action_move(self, step: int) -> None:
        """The next option."""
        self._at = (self._at + step) % len(self._options)
        self._typed = ""
        self.redraw()

    def on_key(self, event: object) -> None:
        """A digit of an id."""
        letter = getattr(event, "character", None)
        if letter and letter.isdigit():
            for typed in (self._typed + letter, letter):
                found = [i for i, (sysid, _) in enumerate(self._options) if str(sysid).startswith(typed)]
                if found:
                    self._typed, self._at = typed, found[0]
                    self.redraw()
                    return

    def action_take(self) -> None:
        """Close with the present option."""
        self.dismiss(self._options[self._at][0])


def _hanging(line: StyledLine, width: int) -> StyledLines:
    """The line over as many as it needs; its last span goes on below itself."""
    if width_of(line) <= width:
        return [line]
    *head, (text, style) = line
    indent = width_of(head) or len(text) - len(text.lstrip())
    first, *rest = wrapped(text, max(width - indent, 1))
    lead: StyledLine = head or [(" " * indent, "")]
    return [[*lead, (first, style)], *([(" " * indent, ""), (more, style)] for more in rest)]


class Help(Dialog[None]):
    """The help page; it scrolls where it does not fit."""

    DEFAULT_CSS = "Help > #box { width: 78; }"
    BINDINGS: ClassVar[list[BindingType]] = [
        Binding("escape,q,question_mark,enter,ctrl+c", "dismiss", priority=True),
        Binding("up,k", "move(-1)"),
        Binding("down,j,space", "move(1)"),
    ]

    def __init__(self, lines: StyledLines, glyphs: Glyphs) -> None:
        super().__init__(glyphs)
        self._shown, self._at = lines, 0

    def paint(self, width: int, height: int) -> StyledLines:
        """The lines that there is room for."""
        shown = [part for line in self._shown for part in _hanging(line, width)]
        room = height if height >= len(shown) else height - 1
        self._at = max(0, min(self._at, len(shown) - room))
        lines = shown[self._at : self._at + room]
        if room == height:
            return lines
        return [
            *lines,
            [(f"lines {self._at + 1}-{self._at + room} of {len(shown)}  ", "dim"), ("up down", "key")],
        ]

    def action_move(self, step: int) -> None:
        """Scroll."""
        self._at += step
        self.redraw()


class Look(Dialog[str | None]):
    """Words to look for."""

    BINDINGS: ClassVar[list[BindingType]] = [Binding("escape,ctrl+c", "dismiss", priority=True)]

    def __init__(self, question: str, words: str, glyphs: Glyphs) -> None:
        super().__init__(glyphs)
        self._question, self._words = question, words

    def compose(self) -> ComposeResult:
        """The prompt and a line to write in."""
        with Vertical(id="box"):
            yield Panel(self.paint, id="lines", ground="raised")
            yield Input(self._words)

    def paint(self, width: int, height: int) -> StyledLines:
        """Keys of the dialog."""
        keys: StyledLine = [
            ("Enter", "key"),
            (" yes, without a word all are shown    ", ""),
            ("Esc", "key"),
            (" no", ""),
        ]
        return [*([(text, "name")] for text in wrapped(self._question, width)), keys]

    def on_mount(self) -> None:
        """Let the keys go to the line."""
        super().on_mount()
        self.query_one(Input).focus()

    def on_input_submitted(self, event: Input.Submitted) -> None:
        """Close with the words."""
        self.dismiss(event.value.strip())
