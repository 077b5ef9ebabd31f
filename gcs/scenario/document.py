"""YAML reader with source positions: plain data out, and errors as sentences with file, line and column.

Aliases are allowed up to a total size, against "billion laughs". Lines and columns count from 1.
"""

from __future__ import annotations

import difflib
import math
import os
import re
import stat
import sys
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import yaml
from pydantic import ValidationError
from pydantic_core import ErrorDetails, PydanticCustomError

from gcs.scenario.yaml_dialect import MAX_NODES, SCALARS, Dumper, YamlRefused, node_of, syntax

MAX_BYTES = 1 << 20
MAX_CHARACTERS = 1 << 22
"""of all values, aliases written out"""
MAX_SHOWN = 20
MAX_EXPLAINED = 10 * MAX_SHOWN
"""Mistakes that are looked into: what a hint at the nearest known key costs is not for thousands."""
MOST_SPELLED = 6
MEANT = "; did you mean "

KeyPath = tuple[str | int, ...]


@dataclass(frozen=True)
class Problem:
    """One thing wrong with a file; `line` and `column` are None where the file as a whole is meant."""

    file: str
    line: int | None
    column: int | None
    message: str

    def __str__(self) -> str:
        place = "" if self.line is None else f":{self.line}:{self.column}"
        return f"{_printable(self.file)}{place}: {self.message}"


class ScenarioError(Exception):
    """A scenario that cannot be used; `problems` says everything that was found, in the order of the file."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = list(problems)
        super().__init__(self.problems)

    def __str__(self) -> str:
        more = len(self.problems) - MAX_SHOWN
        end = f"\n... and {more} more" if more > 0 else ""
        return "\n".join(str(problem) for problem in self.problems[:MAX_SHOWN]) + end


class Conflict(NamedTuple):
    """Two values that do not go together: where the sentence belongs, and the other place that it concerns; `at_key`:
    the key there is wrong, not its value."""

    path: KeyPath
    message: str
    also: KeyPath | None = None
    at_key: bool = False


def conflict_error(conflicts: Iterable[Conflict]) -> PydanticCustomError:
    """The error by which a model's validator hands its conflicts (paths from the model) to `Document.explain`."""
    found = list(conflicts)
    text = "; ".join(conflict.message for conflict in found)
    return PydanticCustomError("conflict", "{text}", {"text": text, "found": found})


class _Marks(NamedTuple):
    value: tuple[int, int]
    key: tuple[int, int]


@dataclass
class Document:
    """Content of a file, and the place of each value in it.

    `data` is plain (dict, list, str, int, float, bool, None); `origins` maps inherited values to where they stand,
    `given` what was set from outside (gcs/scenario/keys.py) to the words for it.
    """

    file: str
    data: dict[str, Any] = field(default_factory=dict)
    what: str = "the scenario"
    """words for the whole of it"""
    marks: dict[KeyPath, _Marks] = field(default_factory=dict)
    origins: dict[KeyPath, KeyPath] = field(default_factory=dict)
    given: dict[KeyPath, str] = field(default_factory=dict)

    def value(self, path: KeyPath) -> Any:
        """The value at `path`, None where there is none."""
        node: Any = self.data
        for part in path:
            try:
                node = node[part]
            except (KeyError, IndexError, TypeError):
                return None
        return node

    def problem(self, path: KeyPath, message: str, *, at_key: bool = False) -> Problem:
        """`message` at the value (or the key) of `path`, or of the nearest thing around it that the file does say."""
        if (label := self._label(path)) is not None:
            return Problem(label, None, None, message)
        if not self.marks:  # plain data of a program, which has no lines
            return Problem(self.file, None, None, message)
        path = self._written(path)
        while path and path not in self.marks:
            path, at_key = path[:-1], False
        marks = self.marks.get(path, _Marks((1, 1), (1, 1)))
        return Problem(self.file, *(marks.key if at_key else marks.value), message)

    def disagreement(self, conflict: Conflict, path: KeyPath = ()) -> Problem:
        """A conflict where the file has it; its paths count from `path`."""
        line = self.problem(path + conflict.also, "").line if conflict.also else None
        also = "" if line is None else f" (see line {line})"
        return self.problem(path + conflict.path, conflict.message + also, at_key=conflict.at_key)

    def inherit(self, source: KeyPath, heir: KeyPath) -> None:
        """Give the mapping at `heir` what the mapping at `source` has and it lacks, mapping by mapping."""
        given, own = self.value(source), self.value(heir)
        if not isinstance(given, dict) or not isinstance(own, dict):
            return
        for key, value in given.items():
            if key not in own:
                own[key] = {} if isinstance(value, dict) else value
                self.origins[(*heir, key)] = (*source, key)
            self.inherit((*source, key), (*heir, key))

    def explain(self, error: ValidationError, schema: dict[str, Any]) -> list[Problem]:
        """pydantic's errors in the order of the file, each said once; the JSON Schema supplies the known keys."""
        errors = error.errors()
        further = len(errors) - MAX_EXPLAINED
        errors = errors[:MAX_EXPLAINED]
        misspelt = {
            (*details["loc"][:-1], near)
            for details in errors
            if details["type"] == "extra_forbidden"
            and (near := nearest(str(details["loc"][-1]), properties(schema, details["loc"][:-1])))
        }
        errors = [details for details in errors if details["type"] != "missing" or details["loc"] not in misspelt]
        found = {problem for details in errors for problem in self._explain(details, schema)}
        told = sorted(found, key=lambda problem: (problem.line or 0, problem.column or 0, problem.message))
        if further > 0:
            last = told[-1]
            told.append(Problem(self.file, last.line, last.column, f"{further} further mistakes are not looked into"))
        return told

    def _label(self, path: KeyPath) -> str | None:
        """The words for what was set from outside at `path` or around it; None where the file says it."""
        for start in (path, self._written(path)) if self.given else ():
            for length in range(len(start), 0, -1):
                if start[:length] in self.given:
                    return self.given[start[:length]]
        return None

    def _written(self, path: KeyPath) -> KeyPath:
        for length in range(len(path), 0, -1):
            if path[:length] in self.origins:
                return self.origins[path[:length]] + path[length:]
        return path

    def _explain(self, details: ErrorDetails, schema: dict[str, Any]) -> Iterator[Problem]:
        kind, context = details["type"], details.get("ctx", {})
        path = tuple(part for part in details["loc"] if part != "[key]")
        if kind == "conflict":
            for conflict in context["found"]:
                yield self.disagreement(conflict, path)
            return
        written = self._written(path)
        name, parent, last = dotted(written), dotted(written[:-1]), written[-1] if written else ""
        value = self.value(path)
        if kind == "extra_forbidden":
            near = did_you_mean(str(last), properties(schema, path[:-1]))
            place = f"in {parent}" if parent else "at the top level"
            yield self.problem(path, f"unknown key {last!r} {place}{near}", at_key=True)
        elif kind == "missing" and isinstance(last, int):
            yield self.problem(path[:-1], f"{parent} needs more numbers: it has {len(self.value(path[:-1]))}")
        elif kind == "missing":
            choices = properties(schema, path[:-1]).get(str(last), {}).get("enum", [])
            choice = f" ({' or '.join(choices)})" if choices else ""
            yield self.problem(path[:-1], f"{parent or self.what} lacks the key {last!r}{choice}")
        elif value is None and kind.endswith("_type"):
            yield self.problem(path, f"{name} is left empty; give it a value or take the key out")
        elif "[key]" in details["loc"]:
            yield self.problem(path, f"{name} is not named as it must be ({context.get('pattern')})", at_key=True)
        else:
            message = details["msg"].removeprefix("Value error, ").replace(" after validation", "")
            must = _MUST.get(kind) or re.sub(r"^\w+ should", "must", message)
            near = did_you_mean(str(value), re.findall(r"'([^']*)'", must)) if kind == "literal_error" else ""
            must, mark, meant = must.partition(MEANT)
            given = spelled(value) if kind == "value_error" else shown(value)
            but = "" if ", not" in must else f", not {given}"
            yield self.problem(path, f"{name} {must}{but}{mark}{meant}{near}")


_MUST = {
    "bool_type": "must be true or false",
    "string_type": "must be text, in quotes if need be",
    "float_type": "must be a number",
    "int_type": "must be a whole number",
    "tuple_type": "must be a list",
    "dict_type": "must be a block of keys",
    "model_type": "must be a block of keys",
    "timezone_aware": "must state its time zone (end it with Z for UTC)",
}


def shown(value: Any) -> str:
    """A value as a sentence about a YAML file names it."""
    if value is None or isinstance(value, bool):
        return {None: "nothing", True: "true", False: "false"}[value]
    if isinstance(value, str):
        return f"the text {value if len(value) <= 40 else value[:37] + '...'!r}"
    if isinstance(value, list | tuple | dict):
        return "a block of keys" if isinstance(value, dict) else "a list"
    if not isinstance(value, int | float):  # of a program, which sets keys
        return f"the class {value.__name__}" if isinstance(value, type) else f"a Python {type(value).__name__}"
    if isinstance(value, int) and abs(value) > sys.float_info.max:
        return "a whole number of more than 300 digits"
    if not math.isfinite(value):
        return ".nan" if math.isnan(value) else ".inf" if value > 0 else "-.inf"
    return str(value) if abs(value) < 1e15 else f"{value:g}"


def spelled(value: Any) -> str:
    """The same, a few numbers in a list one by one: what is wrong lies in them."""
    numbers = isinstance(value, list) and 0 < len(value) <= MOST_SPELLED and {*map(type, value)} <= {int, float}
    return f"[{', '.join(map(shown, value))}]" if numbers else shown(value)


def dotted(path: KeyPath) -> str:
    """('vehicles', 'pursuers', 0, 'sysid') as vehicles.pursuers[0].sysid"""
    return "".join(f"[{p}]" if isinstance(p, int) else f".{_printable(p)}" for p in path).removeprefix(".")


def _printable(text: str) -> str:
    return text if text.isprintable() else ascii(text)


def nearest(word: str, known: Iterable[str]) -> str | None:
    """The known word that `word` may have been meant to be."""
    return next(iter(difflib.get_close_matches(word, list(known), n=1)), None)


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """ "; did you mean 'x'?" for the known word nearest to `word`, or nothing."""
    near = nearest(word, known)
    return "" if near is None else f"{MEANT}{near!r}?"


def options(schema: dict[str, Any], node: Any) -> Iterator[dict[str, Any]]:
    """A node of a JSON Schema and its alternatives, references followed."""
    if not isinstance(node, dict):
        return
    if "$ref" in node:
        yield from options(schema, schema["$defs"][node["$ref"].rsplit("/", 1)[-1]])
    yield node
    for alternative in (*node.get("anyOf", ()), *node.get("oneOf", ())):
        yield from options(schema, alternative)


def properties(schema: dict[str, Any], path: KeyPath) -> dict[str, Any]:
    """The keys that a JSON Schema knows at `path`, each with its own schema; alternatives are taken together."""
    nodes = list(options(schema, schema))
    for part in path:
        inner = (n.get("items") if isinstance(part, int) else n.get("properties", {}).get(part) for n in nodes)
        nodes = [option for node in inner if node for option in options(schema, node)]
    return {key: value for node in nodes for key, value in node.get("properties", {}).items()}


def path_of(given: Any, what: str, wanted: str = "a path") -> str:
    """A path that a program has given for `what`. Raises TypeError, one sentence, for something else."""
    if isinstance(given, str | os.PathLike) and isinstance(path := os.fspath(given), str):
        return path
    raise TypeError(f"{what} is {shown(given)}: give {wanted}")


def read(path: str | os.PathLike[str]) -> Document:
    """The document in the file at `path`. Raises ScenarioError for whatever keeps it from being read."""
    file = path_of(path, "the file")

    def fail(message: str) -> ScenarioError:
        return ScenarioError([Problem(file, None, None, message)])

    try:
        mode = os.stat(file).st_mode
        if stat.S_ISDIR(mode):
            raise fail("is a directory; give the path of a scenario file in it")
        if not stat.S_ISREG(mode):
            raise fail("is no regular file; give the path of a scenario file")
        with open(file, "rb") as stream:
            content = stream.read(MAX_BYTES + 1)
    except FileNotFoundError:
        raise fail("no such file") from None
    except (OSError, ValueError) as error:
        raise fail(f"cannot be read: {getattr(error, 'strerror', None) or error}") from None
    if len(content) > MAX_BYTES:
        raise fail(f"is larger than {MAX_BYTES >> 20} MiB, which no scenario is")
    if b"\0" in content:
        raise fail("is a binary file, not YAML text")
    try:
        return parse(content.decode("utf-8-sig"), file)
    except UnicodeDecodeError as error:
        line, column = _place(content[: error.start].decode("utf-8"), error.start)
        raise ScenarioError([Problem(file, line, column, "is not UTF-8 text; save the file as UTF-8")]) from None


def _place(text: str, position: int) -> tuple[int, int]:
    before = text[:position]
    return before.count("\n") + 1, len(before) - before.rfind("\n")


def parse(text: str, file: str) -> Document:
    """The document in `text`; `file` is the name by which problems call it. Raises ScenarioError."""
    document = Document(file)
    problems: list[Problem] = []
    try:
        root = node_of(text)
        if root is None:
            raise ScenarioError([Problem(file, None, None, "is empty; a scenario starts with 'schema: 1'")])
        data = _convert(document, root, problems)
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        line, column = (mark.line + 1, mark.column + 1) if mark else (None, None)
        raise ScenarioError([Problem(file, line, column, syntax(error, text))]) from None
    except yaml.reader.ReaderError as error:
        line, column = _place(text, error.position)
        message = f"the character U+{error.character:04X} does not belong in YAML text"
        raise ScenarioError([Problem(file, line, column, message)]) from None
    except (ValueError, OverflowError):  # PyYAML lets them through for an escape that is no character, and the like
        raise ScenarioError([Problem(file, None, None, "YAML syntax: a number or an escape is out of range")]) from None
    if not problems and not isinstance(data, dict):
        problems.append(document.problem((), f"a scenario is a block of keys, not {shown(data)}"))
    if problems:
        raise ScenarioError(problems)
    document.data = data
    return document


def emit(data: dict[str, Any]) -> str:
    """`data` as YAML that `parse` reads back equal: keys in their order, innermost lists on one line, ASCII."""
    return str(yaml.dump(data, Dumper=Dumper, sort_keys=False, default_flow_style=None, width=1e9))


_HALF_PAIR = re.compile("[\ud800-\udfff]")


def _convert(document: Document, root: yaml.Node, problems: list[Problem]) -> Any:
    """`root` as plain data; fills `document.marks` and `problems`. Raises YamlRefused where going on makes no sense."""
    total = characters = 0
    open_nodes: list[yaml.Node] = []
    scalars: dict[int, Any] = {}

    def place(node: yaml.Node) -> tuple[int, int]:
        return node.start_mark.line + 1, node.start_mark.column + 1

    def convert(node: yaml.Node, path: KeyPath, key_place: tuple[int, int]) -> Any:
        nonlocal total, characters
        total += 1
        if total > MAX_NODES:
            raise YamlRefused(f"more than {MAX_NODES} values, aliases written out", node.start_mark)
        if any(node is other for other in open_nodes):
            raise YamlRefused("an alias stands inside what it stands for", node.start_mark)
        document.marks[path] = _Marks(place(node), key_place)
        if isinstance(node, yaml.ScalarNode):
            characters += len(node.value)
            if characters > MAX_CHARACTERS:
                raise YamlRefused(
                    f"more than {MAX_CHARACTERS >> 20} Mi characters, aliases written out", node.start_mark
                )
            if id(node) not in scalars:
                scalars[id(node)] = scalar(node)
            return scalars[id(node)]
        open_nodes.append(node)
        data: Any = block(node, path) if isinstance(node, yaml.MappingNode) else sequence(node, path)
        open_nodes.pop()
        return data

    def scalar(node: yaml.ScalarNode) -> Any:
        if _HALF_PAIR.search(node.value):
            raise YamlRefused("half of a surrogate pair is no character", node.start_mark)
        return SCALARS[node.tag.rsplit(":", 1)[-1]](node.value)

    def sequence(node: yaml.Node, path: KeyPath) -> list[Any]:
        return [convert(item, (*path, i), place(item)) for i, item in enumerate(node.value)]

    def block(node: yaml.Node, path: KeyPath) -> dict[str, Any]:
        data: dict[str, Any] = {}
        for key_node, value_node in node.value:
            line, column = place(key_node)
            key = key_node.value
            if not isinstance(key_node, yaml.ScalarNode):
                problems.append(Problem(document.file, line, column, "a key must be a word, not a list or a block"))
            elif key == "<<" and not key_node.style:
                problems.append(
                    Problem(document.file, line, column, "merge keys (<<) are not allowed; repeat the keys")
                )
            elif key in data:
                first = document.marks[(*path, key)].key[0]
                message = f"duplicate key {key!r}; it is given already on line {first}"
                problems.append(Problem(document.file, line, column, message))
            else:
                data[key] = convert(value_node, (*path, key), (line, column))
        return data

    return convert(root, (), place(root))
