"""Models whose attributes' docstrings describe their keys in the JSON Schema, and are read when one is asked for.

pydantic's own `use_attribute_docstrings` reads and parses the source of every model whenever it is imported.
"""

from __future__ import annotations

import ast
import inspect
import textwrap
from itertools import pairwise
from typing import Any

from pydantic import GetJsonSchemaHandler


class Described:
    """Beside BaseModel among the bases of a model, describes it so, and each that derives from it."""

    @classmethod
    def __get_pydantic_json_schema__(cls, core_schema: Any, handler: GetJsonSchemaHandler, /) -> Any:
        schema = handler(core_schema)
        keys = handler.resolve_ref_schema(schema).get("properties", {})
        fields = vars(cls)["__pydantic_fields__"]
        models = [parent for parent in reversed(cls.__mro__) if "__pydantic_fields__" in vars(parent)]
        for parent in models[1:]:  # the first is BaseModel
            for name, text in attribute_docstrings(parent).items():
                field = fields[name]
                key = keys.get(field.alias or name, keys.get(name))
                if key is not None and field.description is None:
                    key["description"] = text
        return schema


def attribute_docstrings(owner: type) -> dict[str, str]:
    """The string below each annotated attribute of a class's own that has one."""
    definition = ast.parse(textwrap.dedent(inspect.getsource(owner))).body[0]
    assert isinstance(definition, ast.ClassDef)
    found = {}
    for node, below in pairwise(definition.body):
        match node, below:
            case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=str(text))):
                found[name] = inspect.cleandoc(text)
    return found
