"""The YAML of scenario files: scalars of YAML 1.2's core schema, no tags, and syntax errors in words.

`on`, `no` and `1:30` are text here, unlike in YAML 1.1, `1e5` is a number, `010` is ten.
"""

from __future__ import annotations

import contextlib
import math
import re
from collections.abc import Callable
from typing import Any

import yaml
from yaml.composer import Composer
from yaml.resolver import Resolver

MAX_DEPTH = 32
MAX_NODES = 100_000
"""Values and keys of a text: PyYAML takes up to 0.1 ms for each."""
MAX_DIGITS = 300
"""A longer whole number is beyond every float and counts as infinite."""


class YamlRefused(yaml.MarkedYAMLError):
    """Well-formed YAML that a scenario may not use."""

    def __init__(self, message: str, mark: yaml.Mark) -> None:
        super().__init__(problem=message, problem_mark=mark)


class _Dialect(Composer, Resolver):
    """Nodes with marks out of a parser's events; tags and deep nesting raise YamlRefused."""

    yaml_implicit_resolvers: dict[str, Any] = {}  # noqa: RUF012 (PyYAML's own name; emptied, or 1.1's scalars are inherited)
    _depth = _nodes = 0

    def compose_node(self, parent: yaml.Node | None, index: Any) -> yaml.Node | None:
        event = self.peek_event()  # type: ignore[attr-defined]
        if getattr(event, "tag", None) not in {None, "!"}:
            raise YamlRefused(f"the tag {event.tag!r} is not allowed; write the plain value", event.start_mark)
        if self._depth > MAX_DEPTH:
            raise YamlRefused(f"nested more than {MAX_DEPTH} deep", event.start_mark)
        self._nodes += 1
        if self._nodes > MAX_NODES:
            raise YamlRefused(f"more than {MAX_NODES} values", event.start_mark)
        self._depth += 1
        node = super().compose_node(parent, index)
        self._depth -= 1
        return node


class Loader(_Dialect, yaml.SafeLoader):
    """Reads any text in Python."""


if yaml.__with_libyaml__:
    from yaml._yaml import CParser

    class FastLoader(_Dialect, CParser):
        """Reads the same by libyaml's parser, five times as fast; its errors are in other words."""

        def __init__(self, text: str) -> None:
            CParser.__init__(self, text)
            Composer.__init__(self)
            Resolver.__init__(self)


_READ_OTHERWISE = re.compile("(?m)^(?:---|[.]{3}|%)|[\t\r?!\x85\u2028\u2029\ufeff]|: *[,\\]}]|[,{\\[] *:")
"""In such a text the two parsers may differ: on what is a space, a break or a key."""


def node_of(text: str) -> yaml.Node | None:
    """The text's one document as nodes with marks; None where it is empty.

    Raises yaml.MarkedYAMLError, yaml.reader.ReaderError, ValueError and OverflowError.
    """
    if yaml.__with_libyaml__ and not _READ_OTHERWISE.search(text):
        with contextlib.suppress(yaml.YAMLError, ValueError, OverflowError):  # the other says what is wrong
            return FastLoader(text).get_single_node()
    return Loader(text).get_single_node()


class Dumper(yaml.SafeDumper):
    """Writes what Loader reads back equal."""

    yaml_implicit_resolvers: dict[str, Any] = {}  # noqa: RUF012


for _tag, _pattern, _first in (
    ("null", r"~|null|Null|NULL|", ["~", "n", "N", ""]),
    ("bool", r"true|True|TRUE|false|False|FALSE", list("tTfF")),
    ("int", r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+", list("-+0123456789")),
    ("float", r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?", list("-+.0123456789")),
    ("float", r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)", list("-+.")),
):
    for _class in (_Dialect, Dumper):
        _class.add_implicit_resolver(f"tag:yaml.org,2002:{_tag}", re.compile(rf"(?:{_pattern})\Z"), _first)


def _whole(text: str) -> float:
    return int(text, 0 if text[:2] in {"0x", "0o"} else 10) if len(text) <= MAX_DIGITS else math.inf


def _real(text: str) -> float:
    return float(text.replace(".", "") if text[-1] in "fFnN" else text)


SCALARS: dict[str, Callable[[str], Any]] = {
    "null": lambda _: None,
    "bool": lambda text: text.lower() == "true",
    "int": _whole,
    "float": _real,
    "str": str,
}


def syntax(error: yaml.MarkedYAMLError, text: str = "") -> str:
    """Fault of a text that is no YAML, or none that a scenario may use, in words for a person."""
    message = error.problem or "cannot be read"
    if message.startswith("mapping values") and (both := _value_and_keys(text, error.problem_mark)):
        return both
    if isinstance(error, YamlRefused):
        return message
    if "another document" in message:
        return "a second document begins here; a scenario is one document"
    if "'\\t'" in message:
        return "YAML syntax: a tab stands here; indent with spaces, not tabs"
    for token, words in _TOKENS.items():
        message = message.replace(f"'{token}'", words).replace(token, words)
    began = error.context_mark
    context = f"{error.context}{f', which begins on line {began.line + 1}' if began else ''}: " if error.context else ""
    hint = next((hint for words, hint in _HINTS.items() if message.startswith(words)), "")
    return f"YAML syntax: {context}{message}{hint}"


def _value_and_keys(text: str, mark: yaml.Mark | None) -> str | None:
    """The sentence for a key that has a value on its line and keys below; None where `mark` shows something else."""
    lines = text.splitlines()[: mark.line + 1] if mark else []
    above = [(i, line) for i, line in enumerate(lines[:-1], 1) if line.strip()]
    found = _VALUE.match(above[-1][1]) if above else None
    if found is None or mark is None:
        return None
    below, indent = lines[-1], len(above[-1][1]) - len(above[-1][1].lstrip())
    if len(below) - len(below.lstrip()) <= indent or below.find(":") != mark.column:
        return None  # a colon too many in a value is another mistake
    key, value = found["key"], found["value"].strip("\"'")
    sentence = f"YAML syntax: {key} on line {above[-1][0]} has the value {value} and keys below it; one of them must go"
    return f'{sentence}, or write {SHORT[key]}: "{value}" below {key}:' if key in SHORT else sentence


_VALUE = re.compile(r"\s*(?P<key>\w+): +(?P<value>[^\s#{\[|>&*][^#]*?)\s*(#.*)?$")
SHORT = {"planner": "method", "competition": "policy"}
"""Keys whose value alone stands for a block with this key."""
_TOKENS = {
    "<scalar>": "a value",
    "<block end>": "the block's end",
    "<block mapping start>": "a key",
    "<stream end>": "the file's end",
}
_HINTS = {
    "expected ": "; is a quote, a bracket or the indentation before it wrong?",
    "mapping values": "; a text with a colon in it needs quotes",
}
