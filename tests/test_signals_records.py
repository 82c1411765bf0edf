"""Systems, regions and missions over signals as data."""

from __future__ import annotations

import pickle

from tsplan.logic import linear
from tsplan.signals.aims import Aim
from tsplan.signals.linear_system import Dynamics, Limit, System
from tsplan.signals.region import Region
from tsplan.signals.signal_mission import SignalMission

CART = System(
    {"p": (0, 9), "v": (-1, 1)},
    {"u": (-0.5, 0.5)},
    Dynamics(((1, 1), (0, 1)), ((0,), (1,)), (0, 0)),
    {"p": (2, 2)},
    (Limit((), ((1.0, (("u", 1.0),)),), 1.0),),
    {"gap": ((("p", 1.0), ("v", -1.0)), 0.5)},
)


def test_missions_travel_between_processes():
    aim = Aim((("state_effort", 1.0),), {"state_effort": {"p": 2.0}})
    box = Region(p=(7, 8))
    mission = SignalMission(CART, box.inside().eventually(0, 4), 4, (aim,), regions={"box": box})
    copy = pickle.loads(pickle.dumps(mission))
    assert copy == mission
    assert dict(copy.system.signals) == dict(CART.signals)
    assert dict(copy.system.outputs) == dict(CART.outputs)
    assert copy.regions["box"].inside() == box.inside()
    assert copy.objective[0].efforts == aim.efforts
    assert copy.formula != linear({"p": 1}, ">=", 7)
