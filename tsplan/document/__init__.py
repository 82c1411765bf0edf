"""YAML documents with positions: read safely, and every complaint knows its line and column.

- `scalars`: what a plain scalar means (YAML 1.2 core rules, booleans kept narrow).
- `yaml_nodes`, `compose`: from the YAML parser to a tree, with bounds on nesting and on aliases.
- `json_text`: the same for texts in JSON.
- `mishaps`: what YAML makes of a text that was meant otherwise, said in a sentence.
- `document`: the document, and places of its parts.
- `files`, `kinds`: reading and writing files of any kind, and telling which kind they are of.
- `fields`, `validation`: types for the fields of file schemas, and checking a part by a schema.
- `flow_style`: values as YAML on one line.

Names are loaded when they are first used: YAML and pydantic are slow to import, and what only
reads or writes a file needs neither.
"""

from typing import TYPE_CHECKING

from tsplan.lazy_names import lazily

if TYPE_CHECKING:
    from tsplan.document.document import Document, Path, parse_document, read_document
    from tsplan.document.validation import validated

__all__ = ["Document", "Path", "parse_document", "read_document", "validated"]

__getattr__, __dir__ = lazily(
    __name__,
    {
        "document.document": ("Document", "Path", "parse_document", "read_document"),
        "document.validation": ("validated",),
    },
)
