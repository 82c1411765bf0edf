"""`tsplan export`: a plan in the format of another program."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, cast

from tsplan.cli.arguments import Exit
from tsplan.cli.inputs import files_of, fitted, mission_beside, refuse_place
from tsplan.errors import MapError, PlanError
from tsplan.plans.plan_file import load_plan
from tsplan.ts.io.map_files import load_map
from tsplan.writers.exporter import export
from tsplan.writers.handover import with_paths
from tsplan.writers.plan_formats import writer

if TYPE_CHECKING:
    import argparse
    from pathlib import Path

    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan
    from tsplan.ts import TransitionSystem


def run(options: argparse.Namespace) -> Exit:
    """Write the file."""
    writer(options.to)  # an unknown format is told before anything is read
    read = [options.plan, options.map, options.mission]
    refuse_place(options.output, "the export", read)
    plan, system, files = _plan_and_map(options)
    refuse_place(options.output, "the export", files)
    try:
        export(plan, options.output, to=options.to, map=system, agents=options.agents)
    except PlanError as error:
        raise PlanError(
            replace(item, source=str(options.plan)) for item in error.findings
        ) from None
    except MapError as error:
        source = str(options.map or (files or [options.plan])[-1])
        raise MapError(replace(item, source=source) for item in error.findings) from None
    return Exit.DONE


def _plan_and_map(options: argparse.Namespace) -> tuple[Plan, TransitionSystem, list[Path]]:
    """The plan with a path for every agent, the map, and the files that the mission came from.

    A plan whose mission is away can do with a map, if it has the paths of all its agents.
    """
    plan = load_plan(options.plan)
    given = None if options.map is None else load_map(options.map)
    if given is not None and options.mission is None and mission_beside(options.plan, plan) is None:
        return plan, given, []
    made, mission = cast("tuple[Plan, Mission]", fitted(options.plan, plan, options.mission))
    return with_paths(made, mission), given or mission.system, files_of(mission)
