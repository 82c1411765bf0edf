"""Numbers of agents in words."""

from __future__ import annotations


def many(count: int, what: str) -> str:
    """A number of agents of a class."""
    return f"{count} agent{'' if count == 1 else 's'} of class {what}"


def agents(count: int, capability: str | None) -> str:
    """A number of agents, with the capability they are counted for."""
    noun = "agent" if count == 1 else "agents"
    return f"{count} {noun}" + (f" with {capability}" if capability else "")
