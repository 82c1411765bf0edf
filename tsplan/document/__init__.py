"""YAML documents with positions: read safely, and every complaint knows its line and column.

- `scalars`: what a plain scalar means (YAML 1.2 core rules, booleans kept narrow).
- `compose`: events of the YAML parser to nodes, with bounds on nesting and on aliases.
- `document`: the document, places of its parts, and reading files.
- `fields`: types for the fields of file schemas.
- `schema`: checking a part of a document against a pydantic model.
"""

from typing import TYPE_CHECKING

from tsplan.document.document import Document, Path, parse_document, read_document

if TYPE_CHECKING:
    from tsplan.document.validation import validated

__all__ = ["Document", "Path", "parse_document", "read_document", "validated"]


def __getattr__(name: str) -> object:
    """Load `validated` on first use: pydantic is slow to import and not always needed."""
    if name == "validated":
        from tsplan.document.validation import validated  # noqa: PLC0415

        return validated
    raise AttributeError(f"module 'tsplan.document' has no attribute '{name}'")
