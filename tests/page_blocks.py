"""The fenced blocks of a page, and a run of them from the first to the last, as a reader does it.

| block | what is done |
|---|---|
| `yaml NAME`, `json NAME`, `text NAME`, ... | the file is written |
| `sh` | each line is a command that has to end well; those that install something are left out |
| `console`, or none that begins with `$` | each command prints what is shown below it |
| `python` | it is run, with the names of the blocks above |
| `text` after `python` | what that has printed |

What is shown may leave parts out as `...`, and white space does not count.
"""

from __future__ import annotations

import contextlib
import doctest
import io
import re
import shlex
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tests.command_line import Done, here

ROOT = Path(__file__).parents[1]
PROMPT = "$ "
INSTALLS = ("pip install", "python3 -m venv")
_BLOCK = re.compile(r"^```([^\n`]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_SHOWN = doctest.ELLIPSIS | doctest.NORMALIZE_WHITESPACE


@dataclass(frozen=True)
class Block:
    """A fenced block: its language, the file that it is, its text, and the line where it begins."""

    language: str
    file: str
    text: str
    line: int


def blocks(page: str, language: str | None = None) -> list[Block]:
    """The blocks of a page, all of them or those of one language, in their order."""
    found = [
        Block(*[*match[1].split(), "", ""][:2], match[2], page[: match.start()].count("\n") + 1)
        for match in _BLOCK.finditer(page)
    ]
    return [block for block in found if language in (None, block.language)]


def commands(text: str) -> Iterator[tuple[str, str]]:
    """The commands of a console, each with what is shown below it."""
    for part in re.split(rf"^{re.escape(PROMPT)}", text, flags=re.MULTILINE)[1:]:
        command, _, shown = part.partition("\n")
        yield command, shown


def is_shown(shown: str, printed: str) -> bool:
    """Whether what was printed is what a page shows, but for what that leaves out."""
    return doctest.OutputChecker().check_output(shown, printed, _SHOWN)


def run_command(command: str, folder: Path) -> Done:
    """Run a command of a page in this process."""
    name, *arguments = shlex.split(command, comments=True)
    assert name == "tsplan", f"no test knows how to run '{command}'"
    return here(*arguments, folder=folder)


@dataclass
class Reader:
    """Somebody who follows a page, in a folder of their own."""

    folder: Path
    names: dict[str, Any] = field(default_factory=lambda: {"__name__": "page"})
    printed: str | None = None  # by the block before

    def follow(self, block: Block) -> None:
        """Do what a block says."""
        before, self.printed = self.printed, None
        if block.file:
            place = self.folder / block.file
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(block.text, encoding="utf-8")
        elif block.language == "sh":
            self._obey(block.text)
        elif block.language in ("console", "") and block.text.startswith(PROMPT):
            self._compare(block.text)
        elif block.language == "python":
            self.printed = self._run(block)
        elif block.language == "text" and before is not None:
            assert is_shown(block.text, before), before

    def _obey(self, text: str) -> None:
        if any(word in text for word in INSTALLS):
            return
        for line in text.replace("\\\n", "").splitlines():
            if line.partition("#")[0].strip():
                done = run_command(line, self.folder)
                assert done.code == 0, f"{line}: {done.err}"

    def _compare(self, text: str) -> None:
        for command, shown in commands(text):
            done = run_command(command, self.folder)
            assert is_shown(shown, done.out), f"{command}\n{done.out}{done.err}"

    def _run(self, block: Block) -> str:
        with contextlib.redirect_stdout(io.StringIO()) as told, contextlib.chdir(self.folder):
            code = compile("\n" * block.line + block.text, "page", "exec")
            exec(code, self.names)
        return told.getvalue()
