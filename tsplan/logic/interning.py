"""Hash-consing: equal values are one object, so equality is identity and costs nothing.

Source: J.-C. Filliâtre and S. Conchon, "Type-safe modular hash-consing", ML Workshop 2006.
"""

from __future__ import annotations

from dataclasses import fields
from threading import RLock
from typing import Any, TypeVar, cast
from weakref import WeakValueDictionary

T = TypeVar("T")

_known: WeakValueDictionary[tuple[Any, ...], Any] = WeakValueDictionary()
_lock = RLock()


class Interned(type):
    """Metaclass of frozen dataclasses whose equal instances are the same object.

    A new instance is made and checked first, then exchanged for the equal one that is known, if
    any. Fields are compared by value; those that are interned themselves, by identity. Nothing is
    kept alive: an instance that nobody holds is forgotten.
    """

    def __call__(cls: type[T], *args: Any, **kwargs: Any) -> T:
        """The one instance with these fields."""
        made = cast("T", type.__call__(cls, *args, **kwargs))
        key = (cls, *(getattr(made, field.name) for field in fields(cast("Any", cls))))
        with _lock:
            return cast("T", _known.setdefault(key, made))
