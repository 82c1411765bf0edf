"""What `tsplan` offers, in groups, and the modules that have it.

`docs/library.md` shows every name at work, in the same groups.
"""

from __future__ import annotations

from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

GROUPS: Mapping[str, Mapping[str, tuple[str, ...]]] = MappingProxyType(
    {
        "Maps": {
            "ts": ("Action", "Edge", "State", "TransitionSystem"),
            "ts.builders": ("cell_name", "from_networkx", "grid"),
            "ts.io.lomap": ("lomap_to_yaml",),
            "ts.io.map_files": ("load_map", "map_text", "save_map"),
            "ts.product": ("product", "unit_steps"),
        },
        "Formulas": {
            "logic": ("Formula", "horizon", "parse", "simplify"),
            "logic.evaluation": ("CountTrace", "SignalTrace", "holds", "robustness"),
        },
        "Missions": {
            "mission": (
                "Configuration",
                "Group",
                "Mission",
                "Preference",
                "Reconfiguration",
                "Resource",
                "SolverChoice",
                "UnderWay",
                "load_mission",
                "mission_from_text",
            ),
            "signals": (
                "Region",
                "System",
                "double_integrator",
                "free_signals",
                "single_integrator",
            ),
            "signals.signal_files": ("load_any_mission", "load_signal_mission"),
            "signals.signal_mission": ("SignalMission",),
        },
        "Planning": {
            "checking.assignment": ("assign",),
            "explanation.whynot.diagnosis": ("explain",),
            "monitoring.monitor": ("Monitor",),
            "protocol.disturbances": ("simulate_controlled", "simulate_disturbed"),
            "protocol.margin_size": ("margin_for",),
            "protocol.simulation": ("simulate",),
            "replanning.execution_trial": ("execute",),
            "replanning.receding_horizon": ("plan_in_pieces",),
            "replanning.replanner": ("replan", "rest_mission"),
            "run.events": ("Event",),
            "run.problem": ("Problem",),
            "signals.controller": ("Controller",),
            "signals.planning": ("plan",),
            "signals.result_check": ("check",),
            "signals.synthesis": ("Synthesis",),
            "signals.synthesiser": ("synthesise",),
            "sweeps.sweeper": ("sweep",),
        },
        "Results": {
            "checking.check_report": ("Report",),
            "explanation": ("Explanation",),
            "monitoring.verdict": ("Verdict",),
            "plans.agent_plans": ("AgentPlan",),
            "plans.moves": ("Move",),
            "plans.outcomes": ("Status",),
            "plans.plan": ("Plan",),
            "plans.plan_file": ("load_plan", "save_plan"),
            "plans.subswarms": ("SubSwarm",),
            "protocol.disturbances": ("DisturbedRuns",),
            "protocol.simulation": ("Simulation",),
            "signals.trajectory": ("Trajectory",),
            "signals.trajectory_file": ("load_trajectory", "save_trajectory"),
            "stopping": ("StoppedBy",),
            "replanning.execution_trial": ("Trial",),
            "sweeps.sweep_rows": ("SweepResults", "SweepRow"),
            "writers.exporter": ("export",),
        },
        "Pictures": {
            "draw.picture_files": ("save_picture",),
            "viewer.animation": ("animate",),
            "viewer.movie": ("Movie",),
        },
        "Errors": {
            "errors": (
                "Finding",
                "FormulaError",
                "InputError",
                "MapError",
                "MissionError",
                "PlanError",
                "SolverError",
                "SolverUnavailableError",
                "TsplanError",
            ),
            "plans.plan_frame": ("FrameUnavailableError",),
        },
    }
)
"""For each group the names by the module, from `tsplan` on, that has them."""


def public_names() -> dict[str, list[str]]:
    """The names by their modules, whatever group they are in."""
    homes: dict[str, list[str]] = {}
    for group in GROUPS.values():
        for home, names in group.items():
            homes.setdefault(home, []).extend(names)
    return homes
