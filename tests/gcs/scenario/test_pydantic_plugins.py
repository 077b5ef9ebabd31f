"""Models built without pydantic's plugins, in a context only."""

import os

import pytest
from pydantic import BaseModel
from pydantic.plugin import _loader

from gcs.scenario.pydantic_plugins import VARIABLE, without_plugins


def test_no_plugin_is_loaded_in_the_context(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = []
    monkeypatch.setattr(_loader, "_plugins", None)
    monkeypatch.setattr(_loader, "entry_points", lambda **group: asked.append(group) or ())
    monkeypatch.delenv(VARIABLE, raising=False)
    with without_plugins():
        type("Inside", (BaseModel,), {})
    assert not asked
    assert VARIABLE not in os.environ
    type("Outside", (BaseModel,), {})
    assert asked == [{"group": "pydantic"}]


def test_what_the_user_has_said_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv(VARIABLE, "one")
    with without_plugins():
        assert os.environ[VARIABLE] == "one"
    assert os.environ[VARIABLE] == "one"
