"""Words in pictures: as they were written, all of them to be seen, whatever matplotlib thinks."""

from __future__ import annotations

import re
import warnings
import xml.etree.ElementTree as ET
from itertools import pairwise

import pytest

from tests.command_line import printed
from tests.seeds import sampled
from tsplan.cli import main
from tsplan.draw.badges import three_digits
from tsplan.draw.matplotlib_loading import MissingLettersWarning
from tsplan.draw.picture_files import content, save_picture
from tsplan.mission import Group, Mission
from tsplan.plans.agent_plans import AgentPlan
from tsplan.plans.outcomes import MissionRef
from tsplan.plans.plan import Plan
from tsplan.ts import Edge, State, TransitionSystem
from tsplan.viewer import page
from tsplan.viewer.animation import Pace, animate
from tsplan.viewer.scene import Scene

ODD = {
    "two\nlines": "two\\nlines",
    "\x1b[31mred": "\\x1b[31mred",
    "\u202elive": "\\u202elive",
    "$x^2$ \\$1": "$x^2$ \\$1",
    ":car: <b>&": ":car: <b>&",
    "_under $": "_under $",
}
"""Names, and how they are seen."""


def mission(names: list[str], *, labels: list[str] | None = None) -> Mission:
    """A row of states with odd names, labels, a class and a name of its own."""
    states = [
        State(name, at=(3 * place, 0), labels=frozenset([(labels or names)[place]]))
        for place, name in enumerate(names)
    ]
    edges = [Edge(a, b) for a, b in pairwise(names)]
    edges += [Edge(name, name) for name in names]
    return Mission.of(
        name=names[0],
        map=TransitionSystem.build(states, edges, names[0]),
        team=[Group.of(names[0], {names[0]: 1}, [names[1]])],
        formula="true",
        language="mtl",
        horizon=4,
    )


def plan(chosen: Mission) -> Plan:
    names = list(chosen.system.states)
    agent = chosen.agents[0]
    stays = ((0, 1, names[0]), (2, 4, names[1]))
    made = AgentPlan(agent.id, agent.class_name, agent.capabilities, stays)
    ref = MissionRef(chosen.name, chosen.digest)
    return Plan("feasible", ref, 4, "gap", agents=(made,))


def pictures(chosen: Mission) -> dict[str, object]:
    """Every kind of picture, as figures."""
    made = plan(chosen)
    found = {view: made.plot(chosen, view=view)[0] for view in ("paths", "timeline", "flow", "map")}
    found["requirements"] = made.plot(chosen, view="requirements")[0]
    found["alone"] = made.plot()[0]
    return found | {"system": chosen.system.plot()[0]}


def texts(svg: bytes) -> str:
    """All texts of an SVG picture, which is XML however odd its names are."""
    root = ET.fromstring(svg)
    return "\n".join("".join(item.itertext()) for item in root.iter() if item.tag.endswith("}text"))


def test_names_are_seen_as_they_were_written_in_every_picture() -> None:
    chosen = mission(list(ODD))
    for view, figure in pictures(chosen).items():
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            svg = content(figure, "svg")
            content(figure, "png")
        shown = texts(svg)
        assert "two\\nlines" in shown, view
        assert not re.search("[\x00-\x09\x0b-\x1f\u202e]", svg.decode()), view
        if view in ("map", "system", "paths"):
            for seen in ODD.values():
                assert seen in shown, (view, seen)


def test_the_text_of_svg_files_stays_text_and_equal_pictures_are_equal_files() -> None:
    chosen = mission(["仓库", "مخزن", "store"])
    figure = chosen.system.plot()[0]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = content(figure, "svg")
    assert {"仓库", "مخزن", "store"} <= set(texts(made).split("\n"))
    assert b"sans-serif" in made
    assert made == content(chosen.system.plot()[0], "svg")


def test_letters_that_no_font_has_are_named_once(tmp_path) -> None:
    chosen = mission(["仓库", "库房", "store"])
    said: list[str] = []
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        save_picture(plan(chosen).plot(chosen)[0], tmp_path / "p.png", tell=said.append)
        save_picture(plan(chosen).plot(chosen)[0], tmp_path / "p.svg", tell=said.append)
        pace = Pace(fps=1, seconds_per_step=1, size=(300, 200))
        animate(chosen, plan(chosen), tmp_path / "p.gif", pace, said.append)
    assert len(said) == 2
    assert said[0].startswith(f"{tmp_path / 'p.png'}: no font here has the letters ")
    assert {"'仓'", "'库'", "'房'"} == set(re.findall("'.'", said[0]))
    assert said[0].endswith("they are boxes; an .svg file keeps its text as text")
    assert "p.gif" in said[1]
    with pytest.warns(MissingLettersWarning, match="no font here has"):
        save_picture(chosen.system.plot()[0], tmp_path / "q.png")


def test_agents_of_a_moving_picture_stand_clear_of_the_names() -> None:
    chosen = mission(["first", "second"])
    scene = Scene(chosen, plan(chosen), (600, 300))
    dot, line = 300 * 0.5, 1.25 * 8.0 * 100 / 72  # dots; the middle of the picture, a line of text
    for _, y in scene.ground.places.values():
        assert y < dot - line


def test_other_warnings_are_passed_on(tmp_path, monkeypatch) -> None:
    figure = mission(["a", "b"]).system.plot()[0]
    written = figure.savefig

    def warning(*given: object, **more: object) -> object:
        warnings.warn("something else", RuntimeWarning, stacklevel=1)
        return written(*given, **more)

    monkeypatch.setattr(figure, "savefig", warning)
    with pytest.warns(RuntimeWarning, match="something else"):
        save_picture(figure, tmp_path / "p.png")


def test_the_command_names_lost_letters_in_one_sentence(tmp_path, capsys) -> None:
    (tmp_path / "m.yaml").write_text(
        "states: {仓库: {at: [0, 0]}, store: {at: [1, 0]}}\nedges: [[仓库, store, 1]]\n", "utf-8"
    )
    assert main(["show", str(tmp_path / "m.yaml"), "-o", str(tmp_path / "m.png")]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert len(err.splitlines()) == 1
    assert "'仓'" in err
    assert main(["show", str(tmp_path / "m.yaml"), "-o", str(tmp_path / "m.svg")]) == 0
    assert capsys.readouterr() == ("", "")


def test_the_page_shows_what_cannot_be_seen() -> None:
    chosen = mission(["</script>", "\x1b]0;pwn\x07", "\u202elive"])
    text = page(chosen, plan(chosen))
    assert not re.search("[\x00-\x08\x0b-\x1f\u202e]", text)
    assert text.count("</script>") == 2  # the page's own
    assert "\\\\x1b]0;pwn\\\\x07" in text


@pytest.mark.parametrize("backend", sampled(["module://no.such.backend", "tkagg"], ["tkagg"]))
def test_the_backend_of_the_environment_is_none_of_ours(backend: str, tmp_path) -> None:
    code = (
        "import sys\n"
        "from tsplan.ts.builders import grid\n"
        "from tsplan.draw.picture_files import save_picture\n"
        f"save_picture(grid(2, 2).plot()[0], {str(tmp_path / 'p.png')!r})\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
        "import os, matplotlib\n"
        f"assert os.environ['MPLBACKEND'] == {backend!r}\n"
    )
    if backend == "tkagg":  # the user's own pyplot has it still
        code += "assert matplotlib.rcParams['backend'].lower() == 'tkagg'\n"
    assert printed(code, MPLBACKEND=backend) == ""
    assert (tmp_path / "p.png").stat().st_size


WITHOUT = """
import sys
sys.modules["matplotlib"] = None
from tests.test_draw_words import mission, plan
from pathlib import Path
from tsplan.cli import main
from tsplan.draw.matplotlib_loading import PlotUnavailableError
from tsplan.draw.starts import draw_starts, class_entries
from tsplan.draw.palette import Palette
from tsplan.viewer.animation import animate
from tsplan.draw.views import draw_page
from tsplan.plans.plan_file import save_plan
chosen = mission(["a", "b"])
made = plan(chosen)
def tried(said, make):
    try:
        make()
    except PlotUnavailableError as error:
        assert str(error) == "drawing needs matplotlib, which is not installed; " \\
            "pip install 'tsplan[plot]'", error
    else:
        raise AssertionError(said)
for view in ("paths", "timeline", "flow", "map", "requirements"):
    tried(view, lambda: made.plot(chosen, view=view))
tried("alone", made.plot)
tried("page", lambda: draw_page(made, chosen))
tried("mission", chosen.plot)
tried("system", chosen.system.plot)
tried("gif", lambda: animate(chosen, made, Path("p.gif")))
"""


@pytest.mark.long
def test_without_matplotlib_every_picture_says_what_to_install() -> None:
    assert printed(WITHOUT) == ""


def test_short_numbers_are_right_where_they_are_rounded() -> None:
    cases = {999: "999", 1000: "1k", 1234: "1.23k", 99_950: "100k", 999_499: "999k"}
    cases |= {999_500: "1M", 1_234_567: "1.23M", 2_000_000_000: "2G"}
    assert {count: three_digits(count) for count in cases} == cases
