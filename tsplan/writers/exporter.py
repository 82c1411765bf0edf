"""Writing a plan to a file in the format of another program."""

from __future__ import annotations

from collections.abc import Collection
from pathlib import Path
from typing import TYPE_CHECKING

from tsplan.checking.fitting import refuse_impossible
from tsplan.document.files import write_whole
from tsplan.ts import TransitionSystem
from tsplan.ts.edges import words
from tsplan.ts.io.map_files import load_map
from tsplan.writers.handover import handover, with_paths
from tsplan.writers.plan_formats import writer

if TYPE_CHECKING:
    from tsplan.mission import Mission
    from tsplan.plans.plan import Plan


def export(
    plan: Plan,
    path: str | Path,
    *,
    to: str,
    map: TransitionSystem | Mission | str | Path,  # noqa: A002  (the word of the mission file)
    agents: Collection[str] = (),
) -> None:
    """Write a plan, or the paths of some of its agents, in the format of another program.

    The file is written whole or not at all.

    Parameters
    ----------
    plan
        A plan with paths. Where it has the moves of a swarm alone, its agents' paths are made as
        `tsplan.assign` does; that needs the mission.
    path
        The file to write.
    to
        `nav2`, `rmf`, `planviz`, `movingai` (the grid for PlanViz), `csv`, `geojson`, `graphml`, or
        a format that another package adds as an entry point of the group `tsplan.plan_writers`.
    map
        The map that the plan was made on, the path of its file, or the mission. Coordinates,
        original ids of states and the length of a step come from there.
    agents
        Ids of the agents to write, by default all.

    Raises
    ------
    PlanError
        The plan has no paths, does not fit the map, or has what the format cannot say.
    MapError
        The map lacks what the format needs, such as coordinates or ids.
    InputError
        There is no such format or agent, or the file cannot be written.

    >>> import tsplan
    >>> mission = tsplan.load_mission("mission.yaml")
    >>> export(tsplan.plan(mission), "plan.csv", to="csv", map=mission)
    >>> Path("plan.csv").read_text().splitlines()[:2]
    ['agent,step,state,x,y', 'crew-1,0,yard,,']

    """
    written = writer(to)
    if isinstance(map, str | Path):
        system = load_map(map)
    elif isinstance(map, TransitionSystem):
        system = map
    else:
        refuse_impossible(plan, map)
        plan, system = with_paths(plan, map), map.system
    parts = written(handover(plan, system, words(agents)))
    write_whole(Path(path), (part.encode("utf-8", "backslashreplace") for part in parts))
