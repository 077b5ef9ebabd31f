"""The help page, and the keys at the bottom of each page."""

from __future__ import annotations

from gcs.console.text import Glyphs, StyledLine, StyledLines
from gcs.session.order_table import orders

Keys = tuple[tuple[str, str], ...]

EVERYWHERE: Keys = (
    ("1-5 tab", "page: fleet, map, competition, events, vehicle"),
    ("n N", "choose the next vehicle, the one before"),
    ("g", "go to a vehicle by its id"),
    ("enter", "all about the chosen vehicle"),
    ("esc", "back to the fleet"),
    ("d", "dark or light"),
)
EXIT_KEYS: Keys = (
    ("q", "close the console; the session goes on"),
    ("ctrl-z", "suspend the console; the session flies on, fg comes back"),
)
STOPPING = ("ctrl-c", "stop the session and save it: asks first; press again to confirm")
REPLAY_EXIT_KEYS: Keys = (("q", "close the replay"), ("ctrl-z", "suspend the console; fg comes back"))
PAGE_KEYS: dict[str, Keys] = {
    "fleet": (
        ("up down", "choose a vehicle; page up/down, home, end"),
        ("o", "order: by id, battery, competition; trouble is always first"),
        ("/", "only vehicles with some words: tanker, served, 12, battery"),
    ),
    "map": (
        ("arrows", "pan (in a replay: shift and arrows)"),
        ("z Z", "zoom in, out (also + -, the wheel)"),
        ("c", "follow the chosen vehicle, or stop that"),
        ("a", "show everything"),
    ),
    "events": (
        ("w", "level: all, warnings and worse, critical"),
        ("k", "kind: text, mode, failsafe, ack, decision, operator, fault, ..."),
        ("v", "only the chosen vehicle, or all"),
        ("/", "only events with some words"),
        ("0", "no filter"),
        ("e", "fold what follows from an event into it, or show all"),
        ("up down", "back in time; end is now"),
    ),
    "vehicle": (("up down", "scroll through what it sends"),),
    "competition": (),
}
REPLAY: Keys = (
    ("space", "pause, or go on; at the end: from the beginning"),
    ("left right", "10 s back, forward"),
    ("+ -", "faster, slower"),
)
LEGEND = (
    ("trouble", "{act} act now   {look} look at it   the words say what; such vehicles come first"),
    ("map", "arrow: a vehicle's heading   {meet}: rendezvous   {wall}: obstacle   {traffic}: traffic"),
    ("energy", "leads, v 0.93: its value in the competition   served, serves: in a refuelling   waits"),
)
BOTTOM: dict[str, Keys] = {
    "fleet": (("enter", "vehicle"), ("/", "filter")),
    "map": (("arrows", "pan"), ("z Z", "zoom"), ("c", "follow"), ("a", "all"), ("n", "next")),
    "competition": (("n", "next"),),
    "events": (("w", "level"), ("k", "kind"), ("v", "vehicle"), ("/", "words"), ("0", "all")),
    "vehicle": (("n N", "next, before"), ("up down", "scroll")),
}


def bottom(page: str, *, control: bool, replay: bool, monitor: bool) -> Keys:
    """The keys that the last line shows, the most wanted first."""
    taken = orders(monitor=monitor) if control else ()
    stop = [(order.key, order.name) for order in taken if order.command == "stop"]
    keys: list[tuple[str, str]] = [("?", "help"), ("q", "close"), *stop, *BOTTOM[page]]
    if replay:
        keys += [("space", "pause"), ("left right", "seek"), ("+ -", "speed")]
    keys += [(order.key, order.name) for order in taken if order.command != "stop"]
    return tuple(keys)


def page(*, control: bool, replay: bool, monitor: bool, owner: bool, lost: list[str], glyphs: Glyphs) -> StyledLines:
    """Everything; `owner`: Ctrl-C here stops the session; `lost` says what this terminal cannot show."""
    lines: StyledLines = []
    if lost:
        lines += [[("This terminal", "name")], *([(f"  {text}", "look")] for text in lost), []]
    lines.append([("Keys", "name")])
    exit_keys = REPLAY_EXIT_KEYS if replay else (*EXIT_KEYS, STOPPING) if owner else EXIT_KEYS
    lines += [_entry(*entry) for entry in (*EVERYWHERE, *exit_keys)]
    if replay:
        lines += [[], [("Replay", "name")], *(_entry(*entry) for entry in REPLAY)]
    if control:
        lines += [[], [("Operator (each key asks first; what the vehicle answers is an event)", "name")]]
        lines += [_entry(order.key, order.what) for order in orders(monitor=monitor)]
    elif not replay:
        off = "The operator's keys are off: start the monitor with --control to give orders."
        lines += [[], [(off, "info")]]
    for name, entries in PAGE_KEYS.items():
        if entries:
            lines += [[], [(f"On the {name} page", "name")], *(_entry(*entry) for entry in entries)]
    lines += [[], [("Signs", "name")], *(_entry(name, text.format(**vars(glyphs))) for name, text in LEGEND)]
    return lines


def _entry(key: str, meaning: str) -> StyledLine:
    return [(f"  {key:<11} ", "info"), (meaning, "")]
