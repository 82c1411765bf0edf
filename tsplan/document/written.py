"""What a value looks like in a file, where the type that it becomes does not say so."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pydantic import GetJsonSchemaHandler, TypeAdapter
from pydantic_core import CoreSchema


@dataclass(frozen=True)
class Written:
    """Marks a field for JSON Schema: it may be written as any value of a type is.

    For fields with short forms and for those that are read apart; how a file is read does not
    change by it. A type has one mark; of several in one another the innermost counts.

    >>> from typing import Annotated
    >>> TypeAdapter(Annotated[Any, Written(int | list[int])]).json_schema()
    {'anyOf': [{'type': 'integer'}, {'items': {'type': 'integer'}, 'type': 'array'}]}
    """

    kind: Any

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        """The schema of what may be written, in place of that of what it becomes."""
        return handler(TypeAdapter(self.kind).core_schema)
