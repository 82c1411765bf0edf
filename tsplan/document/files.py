"""Files: read by kind and by bytes, so that no path hangs or fills the memory; written whole.

A path may name anything, also a device that never ends or a pipe that nobody writes to. So a file
is opened without waiting, its kind is asked of what was opened, and reading stops at a limit
whatever size the file claims to have.
"""

from __future__ import annotations

import os
import pathlib
import shutil
import stat
from collections.abc import Iterable
from difflib import get_close_matches

from tsplan.document.kinds import kind_of_bytes
from tsplan.errors import Finding, InputError
from tsplan.words import nfc

_AT_ONCE = 1024**2  # bytes
_BOMS = {b"\xff\xfe": "UTF-16", b"\xfe\xff": "UTF-16"}
# flags that not every system has
_WITHOUT_WAITING, _BINARY = getattr(os, "O_NONBLOCK", 0), getattr(os, "O_BINARY", 0)
_KINDS = (
    (stat.S_ISDIR, "a directory"),
    (stat.S_ISFIFO, "a pipe"),
    (stat.S_ISSOCK, "a socket"),
    (stat.S_ISCHR, "a device"),
    (stat.S_ISBLK, "a device"),
)


def read_text(path: str | pathlib.Path, *, most: int) -> str:
    """The text of an input file of at most `most` bytes, without a byte order mark.

    Raises
    ------
    InputError
        The file is missing, is no ordinary file, cannot be opened, is too large or not UTF-8.

    """
    raw = read_bytes(path, most=most)
    try:
        return raw.decode("utf-8").removeprefix("\ufeff")
    except UnicodeDecodeError as error:
        raise InputError([_undecodable(raw, error.start, str(path))]) from None


def read_bytes(path: str | pathlib.Path, *, most: int) -> bytes:
    """The bytes of an input file, whatever it holds; InputError as `read_text` says."""
    raw = _read(path, most, whole=True)
    if len(raw) > most:
        raise InputError([_too_large(most, str(path))])
    return raw


def beginning(path: str | pathlib.Path, most: int) -> str:
    """The first bytes of an input file as text, whatever it holds; InputError as `read_text`."""
    return _read(path, most, whole=False).decode("utf-8", "replace").removeprefix("\ufeff")


def write_whole(
    path: pathlib.Path,
    content: bytes | Iterable[bytes],
    error: type[InputError] = InputError,
) -> None:
    """Write a file beside its place and move it there at once; devices are written directly.

    So a reader sees the old file or the whole new one, never a part. What is large may come in
    parts, which are written one after the other; if making one fails, there is no new file. Raises
    `error` if the place cannot be written.
    """
    parts = (content,) if isinstance(content, bytes) else content
    place = path.resolve()
    part = place.with_name(f".{place.name}.{os.getpid()}.part")
    try:
        if place.exists() and not place.is_file():
            with place.open("wb") as stream:
                stream.writelines(parts)
            return
        try:
            with part.open("xb") as stream:
                stream.writelines(parts)
                stream.flush()
                os.fsync(stream.fileno())
            if place.exists():
                shutil.copymode(place, part)
            part.replace(place)
        finally:
            part.unlink(missing_ok=True)
    except OSError as failed:
        why = f"cannot write: {failed.strerror or 'it cannot be written'}"
        raise error([Finding(why, "choose another file", str(path))]) from None


def beside(folder: pathlib.Path, name: str) -> pathlib.Path:
    """The file of a name in a folder, also where its name is spelled in another Unicode form."""
    path = folder / name
    try:
        if name.isascii() or path.exists():
            return path
        for file in path.parent.iterdir():
            if nfc(file.name) == nfc(path.name):
                return file
    except (OSError, ValueError):
        pass  # whoever reads the file says what is wrong
    return path


def _read(path: str | pathlib.Path, most: int, *, whole: bool) -> bytes:
    """At most so many bytes of an ordinary file; with `whole`, one more where there are more.

    A file that says itself that it is larger is not read at all then.
    """
    file, source = pathlib.Path(path), str(path)
    try:
        # without O_NONBLOCK, a pipe that nobody writes to would be waited for
        descriptor = os.open(file, os.O_RDONLY | _WITHOUT_WAITING | _BINARY)
        try:
            told = os.fstat(descriptor)
            _refuse_kind(told.st_mode, source)
            if whole and told.st_size > most:
                raise InputError([_too_large(most, source)])
            return _bytes(descriptor, most + 1 if whole else most)
        finally:
            os.close(descriptor)
    except FileNotFoundError:
        raise InputError([_missing(file, source)]) from None
    except InputError:
        raise
    except (OSError, ValueError) as error:
        raise InputError([_unreadable(error, file, source)]) from None


def _bytes(descriptor: int, most: int) -> bytes:
    """Bytes up to the end of a file, whatever size it says it has, or up to so many."""
    parts, left = [], most
    while left > 0:
        part = os.read(descriptor, min(left, _AT_ONCE))
        if not part:
            break
        parts.append(part)
        left -= len(part)
    return b"".join(parts)


def _too_large(most: int, source: str) -> Finding:
    return Finding(f"larger than {most // 1024**2} MiB", "use a smaller file", source)


def _refuse_kind(mode: int, source: str) -> None:
    """Raise InputError for anything but an ordinary file."""
    for is_kind, name in _KINDS:
        if is_kind(mode):
            raise InputError([Finding(f"this is {name}", "name a file", source)])


def _unreadable(error: OSError | ValueError, file: pathlib.Path, source: str) -> Finding:
    """Why a file could not be opened; some systems open no directory at all."""
    try:
        _refuse_kind(file.stat().st_mode, source)
    except InputError as refused:
        return refused.findings[0]
    except (OSError, ValueError):
        pass
    reason = (error.strerror if isinstance(error, OSError) else None) or str(error)
    return Finding(f"cannot be read: {reason}", "check the path", source)


def _missing(file: pathlib.Path, source: str) -> Finding:
    """There is no such file; name the closest one beside it, if one may look there."""
    folder = file.parent
    try:
        names = [file.name for file in folder.iterdir()]
    except OSError:
        names = []
    close = get_close_matches(file.name, names, n=1)
    remedy = f"did you mean '{folder / close[0]}'?" if close else "check the path"
    return Finding("there is no such file", remedy, source)


def _undecodable(raw: bytes, at: int, source: str) -> Finding:
    """What a file is that is no UTF-8 text, or where it stops being one."""
    kind = kind_of_bytes(raw)
    if kind is not None:
        return Finding(f"this is {kind}", "name a text file", source)
    encoding = _BOMS.get(raw[:2])
    if encoding is not None:
        return Finding(f"not UTF-8 text but {encoding}", "save the file as UTF-8", source)
    before = raw[:at]
    line = before.count(b"\n") + 1
    column = len(before[before.rfind(b"\n") + 1 :].decode("utf-8", "replace")) + 1
    return Finding("not UTF-8 text", "save the file as UTF-8", source, line, column)
