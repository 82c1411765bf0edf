"""The switches of the tight encoding and the search, each for one of the methods behind them.

Turning one off never changes an answer, only the time it takes: that is what the ablation in
`scripts/benchmark.py` measures and what the tests check.
"""

from __future__ import annotations

from enum import StrEnum


class Switch(StrEnum):
    """One method of the tight encoding or of the search on it."""

    REDUCTION = "reduction"  # plan between the states that matter (encode.map_reduction)
    OUTLOOK = "outlook"  # leave out witnesses that travel times rule out (encode.robustness_bound)
    SHARING = "sharing"  # F under G: windows share their witnesses (encode.witness)
    CHAINS = "chains"  # F under G: a first plan with the fewest witnesses (encode.witness)
    TEAMS = "teams"  # many parts: a first plan by teams that see to some of them (search.sub_teams)
    ROUTES = "routes"  # many parts: a bound and plans by routes of single agents (search.routes)
    STRAIGHT = "straight"  # resources: a first plan by straight ways (encode.straight_ways)
    FAMILIES = "families"  # one row for demands that exclude each other (encode.demand_rows)
    BLOCKS = "blocks"  # signals: first trajectories with choices for blocks of steps
    VISITS = "visits"  # arrival cuts over windows (encode.demand_rows)
    HULLS = "hulls"  # arrival cuts of limited places with all around them (encode.hulls)
    TOGETHER = "together"  # needs of one witness at several places at once (encode.joint_demands)
    RIVALS = "rivals"  # witnesses that the same agents cannot both serve (encode.rivals)
    LAZY = "lazy"  # more arrival cuts where the LP violates them (encode.arrival_cuts)
    VISITORS = "visitors"  # cuts of different agents, where the LP violates them
    CAPACITIES = "capacities"  # capacities where they matter only (search.capacity_relaxation)
    CONTINUOUS = "continuous"  # flows continuous at first, repaired to whole agents (search.search)
    DIVE = "dive"  # LP-guided dive for the first plan (search.dive)
    TOKENS = "tokens"  # swarms: fewest splits by tokens, a first plan along their ways
    TOURS = "tours"  # swarms: least travel by the ways of weighted tokens
    LONE = "lone"  # swarms that need not split: each as one agent
    PLACES = "places"  # swarms: where groups are before how many agents they have
    TREE = "tree"  # a short search of our own before the solver's (search.branch_and_bound)


ALL_SWITCHES = frozenset(Switch)
