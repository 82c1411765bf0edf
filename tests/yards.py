"""A yard with three agents, and how to find things in its pictures."""

from __future__ import annotations

from tsplan import Mission
from tsplan.mission import Group
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem

YARD = TransitionSystem.build(
    [
        State("gate", frozenset({"way", "in"}), at=(0, 0)),
        State("shed", frozenset({"store"}), at=(4, 0)),
        State("field", frozenset({"crop"}), shape=((6, -1), (8, -1), (8, 1), (6, 1)), color="tan"),
        State("hill", at=(4, 3)),
    ],
    [
        Edge("gate", "shed", 2),
        Edge("shed", "gate", 2),
        Edge("shed", "field", 2),
        Edge("field", "shed", 2),
        Edge("field", "hill", {"cart": 1, "default": 3}),
        *(Edge(name, name) for name in ("gate", "shed", "field", "hill")),
    ],
    name="yard",
)


def yard():
    """Three agents: one goes to the field by the shed and on to the hill, two to the shed."""
    mission = Mission.of(
        map=YARD,
        team=[Group.of("cart", {"gate": 1}, ["haul"]), Group.of("man", {"gate": 2}, ["look"])],
        formula=[
            "F[0,4] sum(crop,haul) >= 1",
            "F[2,6] G[0,1] sum(store) >= 2",
            "G[0,8] sum(in) <= 3",
        ],
        language="mtl",
        horizon=8,
        name="yard work",
    )
    cart = ((0, 0, "gate"), (2, 2, "shed"), (4, 6, "field"), (7, 8, "hill"))
    men = ((0, 1, "gate"), (3, 8, "shed"))
    haul, look = frozenset({"haul"}), frozenset({"look"})
    agents = (
        AgentPlan("cart-1", "cart", haul, cart),
        AgentPlan("man-1", "man", look, men),
        AgentPlan("man-2", "man", look, men),
    )
    plan = Plan("feasible", MissionRef("yard work", ""), 8, "gap", agents=agents)
    return mission, plan


def texts(ax, *, legend=False):
    """Everything written in axes, or in their legend."""
    found = ax.get_legend().get_texts() if legend else ax.texts
    return [text.get_text() for text in found if text.get_text()]


def named(ax, name):
    """The artists of a kind."""
    return [artist for artist in ax.get_children() if artist.get_gid() == name]


def bars(ax):
    """What each bar of a timeline means, from when to when it reaches, and its row."""
    return [
        (b.get_gid(), b.get_x(), round(b.get_x() + b.get_width(), 9), round(b.get_y() + 0.41))
        for b in ax.patches
    ]
