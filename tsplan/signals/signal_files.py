"""Reading missions over signals from files and texts, and files of either kind of mission."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from tsplan.document import Document, parse_document, read_document
from tsplan.document.kinds import SIGNALS, kind_of_data
from tsplan.errors import InputError, MissionError
from tsplan.mission import Mission
from tsplan.mission.read import mission_from_document
from tsplan.signals.signal_draft import parts_of_document
from tsplan.signals.signal_mission import SignalMission


def load_signal_mission(path: str | Path) -> SignalMission:
    """Read a file `tsplan-signals/1`.

    Raises MissionError with everything that is wrong with the file and its formula.
    """
    return _made(lambda: read_document(path))


def signal_mission_from_text(text: str, source: str = "mission") -> SignalMission:
    r"""Read a mission over signals from its text. Raises MissionError.

    >>> mission = signal_mission_from_text("signals: {x: [0, 9]}\nspec: F[0,3] x >= 5\n"
    ...                                    "format: tsplan-signals/1")
    >>> mission.horizon, [aim.name for aim in mission.objective]
    (3, ['robustness'])
    """
    return _made(lambda: parse_document(text, source))


def load_any_mission(path: str | Path) -> Mission | SignalMission:
    """Read a mission of either kind: its `format` decides, or else what is in it.

    Raises MissionError with everything that is wrong.
    """
    try:
        document = read_document(path)
    except InputError as error:
        raise MissionError(error.findings) from None
    return any_mission_from_document(document, Path(path).parent)


def mission_given(given: Mission | SignalMission | str | Path) -> Mission | SignalMission:
    """The mission of a file, for a path; or the one that is given.

    Raises MissionError with everything that is wrong with the file.
    """
    return load_any_mission(given) if isinstance(given, str | Path) else given


def any_mission_from_document(document: Document, folder: Path) -> Mission | SignalMission:
    """The mission of either kind of a document; maps are looked for in `folder`.

    Raises MissionError with everything that is wrong.
    """
    if kind_of_data(document.data) == SIGNALS:
        return _made(lambda: document)
    return mission_from_document(lambda: document, folder)


def _made(document: Callable[[], Document]) -> SignalMission:
    try:
        return SignalMission(**vars(parts_of_document(document())))
    except InputError as error:
        raise MissionError(error.findings) from None
