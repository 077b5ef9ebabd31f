"""gcs.scenario.document: what a file says, where, and that a bad one ends in a ScenarioError and nothing else."""

import contextlib
import math
from pathlib import Path
from typing import Any

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from gcs.scenario import document, yaml_dialect
from gcs.scenario.document import MAX_EXPLAINED, Problem, ScenarioError, emit, parse, read
from gcs.scenario.file import load

ROOT = Path(__file__).resolve().parents[3]


def only_problem(text: str) -> Problem:
    with pytest.raises(ScenarioError) as caught:
        parse(text, "f.yaml")
    (problem,) = caught.value.problems
    return problem


@pytest.mark.parametrize(
    ("written", "value"),
    [
        ("1e5", 100000.0),
        ("1E-3", 0.001),
        (".5", 0.5),
        ("1.", 1.0),
        ("-7", -7),
        ("010", 10),
        ("0x1f", 31),
        ("0o17", 15),
        ("-.inf", -math.inf),
        ("on", "on"),
        ("no", "no"),
        ("1:30", "1:30"),
        ("1_000", "1_000"),
        ("2026-01-01", "2026-01-01"),
        ("'5'", "5"),
        ("true", True),
        ("~", None),
        ("", None),
    ],
)
def test_scalars_follow_the_core_schema_of_yaml_1_2(written: str, value: object) -> None:
    read_back = parse(f"k: {written}", "f.yaml").data["k"]
    assert read_back == value
    assert type(read_back) is type(value)


def test_nan_is_read_as_nan() -> None:
    assert math.isnan(parse("k: .nan", "f.yaml").data["k"])


def test_a_problem_stands_at_the_value_or_the_key_and_counts_from_one() -> None:
    document = parse("a: 1\nb:\n  - c:  2\n", "f.yaml")
    assert str(document.problem(("b", 0, "c"), "oh")) == "f.yaml:3:9: oh"
    assert str(document.problem(("b", 0, "c"), "oh", at_key=True)) == "f.yaml:3:5: oh"
    assert str(document.problem(("b", 0, "d", 3), "oh")) == "f.yaml:3:5: oh", "the nearest thing that the file says"


def test_inherited_values_fill_gaps_and_keep_their_place() -> None:
    document = parse("d: {x: {u: 1, w: 2}, y: 3}\nh: {x: {w: 4}}", "f.yaml")
    document.inherit(("d",), ("h",))
    assert document.data["h"] == {"x": {"u": 1, "w": 4}, "y": 3}
    assert document.data["d"] == {"x": {"u": 1, "w": 2}, "y": 3}
    assert str(document.problem(("h", "x", "u"), "oh")) == "f.yaml:1:12: oh"
    assert str(document.problem(("h", "x", "w"), "oh")) == "f.yaml:2:12: oh"


@pytest.mark.parametrize(
    ("text", "place", "words"),
    [
        ("a: 1\nb: 2\na: 3", (3, 1), "duplicate key 'a'; it is given already on line 1"),
        ("a: [1, 2", (1, 9), "YAML syntax"),
        ("a:\n\t- b", (2, 1), "not tabs"),
        ("a: {b: 1\nc: 2", (2, 2), "which begins on line 1: expected ',' or '}', but got"),
        ('a:\n  b: "1\nc: "2"', (3, 5), "expected the block's end, but found a value; is a quote,"),
        ("a: it's: b", (1, 8), "needs quotes"),
        ("schema: 1\nname: b\ndescription: Five: a demo", (3, 18), "a text with a colon in it needs quotes"),
        ("a:\n  b: 2\nclock: mode: real", (3, 12), "a text with a colon in it needs quotes"),
        ("a: 1\n---\nb: 2", (2, 1), "second document"),
        ("a: !!python/object:os.system x", (1, 4), "not allowed"),
        ("a: !mine x", (1, 4), "'!mine' is not allowed"),
        ("a: &a [*a]", (1, 4), "inside what it stands for"),
        ("a: *b", (1, 4), "undefined alias"),
        ("a: &a {x: 1}\nb:\n  <<: *a", (3, 3), "merge keys"),
        ("[" * 100_000, (1, 34), "nested more than 32 deep"),
        ("? [a]\n: 1", (1, 3), "a key must be a word"),
        ("- 1", (1, 1), "not a list"),
        ("word", (1, 1), "not the text 'word'"),
        ("a: \x01", (1, 4), "U+0001"),
        ('a: "\\ud800"', (1, 4), "surrogate"),
        ('a: "\\UFFFFFFFF"', (None, None), "out of range"),
        ("", (None, None), "is empty"),
        ("# nothing\n", (None, None), "is empty"),
    ],
)
def test_what_is_not_a_plain_block_of_keys_is_refused_in_place(
    text: str, place: tuple[int | None, int | None], words: str
) -> None:
    problem = only_problem(text)
    assert (problem.line, problem.column) == place
    assert words in problem.message


def test_every_duplicate_is_reported() -> None:
    with pytest.raises(ScenarioError) as caught:
        parse("a: 1\na: 2\nb: {c: 1, c: 2}", "f.yaml")
    assert [problem.line for problem in caught.value.problems] == [2, 3]


def test_aliases_are_understood() -> None:
    assert parse("a: &a [1, 2]\nb: *a", "f.yaml").data == {"a": [1, 2], "b": [1, 2]}


def test_an_alias_bomb_is_refused() -> None:
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]" for i in range(1, 10)]
    assert "aliases written out" in only_problem("\n".join(lines)).message


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is empty"),
        (b"\x7fELF\0\0\1", "binary"),
        ("a: é".encode("utf-16"), "binary"),
        (b"a: 1\nbc: \xff", "2:5: is not UTF-8"),
        (b"a: 1\n" + b"#" * (1 << 20), "larger than 1 MiB"),
    ],
)
def test_files_that_are_no_text_are_refused(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "f.yaml"
    path.write_bytes(content)
    with pytest.raises(ScenarioError, match=words):
        read(path)


def test_paths_that_are_no_file_are_refused(tmp_path: Path) -> None:
    for path, words in ((tmp_path, "directory"), (tmp_path / "x", "no such file"), ("/dev/zero", "no regular file")):
        with pytest.raises(ScenarioError, match=words):
            read(path)
    for name in ("\0", "x" * 5000):
        with pytest.raises(ScenarioError, match="cannot be read"):
            read(name)


def test_a_byte_order_mark_is_no_part_of_the_first_key(tmp_path: Path) -> None:
    path = tmp_path / "f.yaml"
    path.write_bytes(b"\xef\xbb\xbfa: 1\n")
    assert read(path).data == {"a": 1}


def test_a_sentence_carries_no_control_characters() -> None:
    document = parse('"a\\e[31m": 1', "f\n.yaml")
    message = str(document.problem(("a\x1b[31m",), "oh"))
    assert message.isprintable()


def test_many_problems_are_cut_short_in_the_text_only() -> None:
    with pytest.raises(ScenarioError) as caught:
        parse("a: 1\n" * 31, "f.yaml")
    assert len(caught.value.problems) == 30
    assert str(caught.value).splitlines()[-1] == "... and 10 more"


texts = st.text(st.characters(exclude_categories=["Cs"]), max_size=20)
plain = st.recursive(
    st.none() | st.booleans() | st.integers(-(10**20), 10**20) | st.floats(allow_nan=False) | texts,
    lambda inner: (
        st.lists(inner, max_size=4) | st.dictionaries(texts.filter(lambda key: key != "<<"), inner, max_size=4)
    ),
    max_leaves=12,
)


@settings(max_examples=60)
@given(st.dictionaries(texts.filter(lambda key: key != "<<"), plain, max_size=4))
def test_what_is_emitted_is_read_back_equal(data: dict[str, object]) -> None:
    assert parse(emit(data), "f.yaml").data == data


@settings(max_examples=150)
@given(st.text(st.sampled_from(list("ab01:-,.[]{}&*!|>'\"%@#?~<\\ \n\tuUx\x85\0")), max_size=60))
def test_no_text_ends_in_anything_but_a_scenario_error(text: str) -> None:
    with contextlib.suppress(ScenarioError):
        parse(text, "f.yaml")


def test_a_long_text_that_is_repeated_by_aliases_is_refused_before_it_costs_anything() -> None:
    text = "a: &a " + "y" * 100_000 + "\nb:\n" + "- *a\n" * 60
    assert only_problem(text).message == "more than 4 Mi characters, aliases written out"


def test_a_text_is_composed_up_to_a_number_of_values_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(yaml_dialect, "MAX_NODES", 100)
    problem = only_problem("- 1\n" * 10_000)
    assert (problem.line, problem.message) == (100, "more than 100 values")


def test_of_many_unknown_keys_few_are_looked_into(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    nearest = document.nearest
    monkeypatch.setattr(document, "nearest", lambda word, known: asked.append(word) or nearest(word, known))
    path = tmp_path / "many.yaml"
    path.write_text("schema: 1\n" + "".join(f"key{i}: 1\n" for i in range(1500)))
    with pytest.raises(ScenarioError) as refused:
        load(path)
    assert len(asked) <= 2 * MAX_EXPLAINED
    assert "further mistakes are not looked into" in str(refused.value.problems[-1])


# libyaml's parser, where it may be used, reads what the one in Python reads


def spelled_out(node: yaml.Node | None) -> Any:
    """A node's tags, values and places."""
    if node is None:
        return None
    place = (node.tag, node.start_mark.line, node.start_mark.column)
    if isinstance(node, yaml.MappingNode):
        return place, [(spelled_out(key), spelled_out(value)) for key, value in node.value]
    if isinstance(node, yaml.SequenceNode):
        return place, list(map(spelled_out, node.value))
    return place, node.value, bool(node.style)


def slowly(text: str) -> Any:
    try:
        return spelled_out(yaml_dialect.Loader(text).get_single_node())
    except (yaml.YAMLError, ValueError, OverflowError):
        return "refused"


def quickly(text: str) -> Any:
    try:
        return spelled_out(yaml_dialect.node_of(text))
    except (yaml.YAMLError, ValueError, OverflowError):
        return "refused"


@pytest.mark.parametrize("path", sorted(ROOT.glob("configs/**/*.yaml")), ids=lambda path: path.stem)
def test_shipped_scenarios_are_read_the_same_either_way(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert quickly(text) == slowly(text) != "refused"


PIECES = ["a", "1", "1e5", "-", "- ", ": ", ":", "\n", "\n  ", " ", "[", "]", "{", "}", ", ", ",", "#", " # ", "'", '"']
PIECES += ["\\", "&x ", "*x", ">\n", "|\n", "%", "@", "`", "~", "é", "<<", "---\n", "..."]
PIECES += ["\t", "?", "!", "\r", "\ufeff", "\x85", "\u2028"]


@settings(max_examples=300)
@given(st.lists(st.sampled_from(PIECES), max_size=25).map("".join))
def test_any_text_is_read_the_same_either_way(text: str) -> None:
    assert quickly(text) == slowly(text)
