"""The missions of a folder as runs."""

from __future__ import annotations

from pathlib import Path

from tsplan.document.kinds import MISSION, SIGNALS, kind_of_data
from tsplan.errors import Finding, InputError
from tsplan.sweeps.mission_variant import FileText, Variant
from tsplan.sweeps.sweep_runs import SweepRun


def runs_of_folder(folder: Path) -> tuple[SweepRun, ...]:
    """A run for each mission of a folder, by the names of their files.

    Files of other kinds, such as maps, are left out; what is no YAML is a run that fails. Raises
    InputError for a folder without a mission, and for files that cannot be read at all.
    """
    runs: list[SweepRun] = []
    findings: list[Finding] = []
    for path in sorted([*folder.glob("*.yaml"), *folder.glob("*.yml")]):
        try:
            variant = _variant(FileText.read(path))
        except InputError as error:
            findings += error.findings
            continue
        if variant is not None:
            runs.append(SweepRun({"mission": path.name}, variant))
    if not runs and not findings:
        what = "there is no mission in this folder"
        findings = [Finding(what, "give a folder of mission files (*.yaml)", str(folder))]
    if findings:
        raise InputError(findings)
    return tuple(runs)


def _variant(file: FileText) -> Variant | None:
    """The mission of a file as it stands, None for a file of another kind."""
    variant = Variant(file)
    try:
        data = file.document.data
    except InputError:
        return variant
    if kind_of_data(data) not in (MISSION, SIGNALS):
        return None
    return Variant(file, map_file=variant.named_map(data.get("map")))
