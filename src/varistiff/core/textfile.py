"""Text files from users, read safely: regular, small enough, UTF-8; and YAML without its surprises.

YAML is read from its event stream into plain mappings, lists and scalars. Tags, anchors and aliases are
refused, so nothing is constructed and nothing expands; depth is bounded; a repeated key is an error. Plain
scalars follow the core schema of YAML 1.2: only ``true``/``false`` are booleans, and ``on``, ``no``, ``1:30``
and dates are text.
"""

from __future__ import annotations

import os
import re
import stat
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from varistiff.core.errors import InputError
from varistiff.core.suggest import printable, quoted

YAML_LIMIT = 1_000_000  # bytes; a design has about one thousand
_DEEPEST = 16
_LONGEST_NUMBER = 60
_MOST_DOCUMENTS = 8

_INTEGER = re.compile(r"[-+]?[0-9]+", re.ASCII)
_FLOAT = re.compile(r"[-+]?(?:\.[0-9]+|[0-9]+(?:\.[0-9]*)?)(?:[eE][-+]?[0-9]+)?", re.ASCII)
_CONSTANTS: dict[str, Any] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
    **dict.fromkeys((".inf", ".Inf", ".INF", "+.inf", "+.Inf", "+.INF"), float("inf")),
    **dict.fromkeys(("-.inf", "-.Inf", "-.INF"), float("-inf")),
}


def read_text(path: str | os.PathLike[str], *, limit: int) -> str:
    """Return the text of a regular UTF-8 file of at most ``limit`` bytes, without its byte order mark.

    The size is checked before the first byte is read.

    Raises
    ------
    InputError : missing, not a regular file, unreadable, too large, empty, binary or not UTF-8
    """
    data = read_bytes(path, limit=limit)
    try:
        return _text(data)
    except InputError as error:
        raise error.located(file=printable_path(os.fspath(path))) from None


def read_bytes(path: str | os.PathLike[str], *, limit: int) -> bytes:
    """Return the bytes of a regular file of at most ``limit`` bytes.

    Raises
    ------
    InputError : missing, not a regular file, unreadable or too large
    """
    file = os.fspath(path)
    try:
        return _bytes(file, limit)
    except OSError as error:
        raise InputError(f"cannot be read: {reason(error)}", file=printable_path(file)) from None
    except InputError:  # a ValueError too, and already in words
        raise
    except ValueError:  # a path with a null character
        raise InputError("is no path that a file can have", file=printable_path(file)) from None


def reason(error: OSError) -> str:
    """Return what the operating system says, as a clause."""
    text = error.strerror or type(error).__name__
    return text[:1].lower() + text[1:]


def printable_path(path: str) -> str:
    """Return a path on one line."""
    return "".join(character if character.isprintable() else "?" for character in path)


def _bytes(file: str, limit: int) -> bytes:
    shown = printable_path(file)
    status = Path(file).stat()
    if stat.S_ISDIR(status.st_mode):
        raise InputError("is a directory; allowed is a file", file=shown)
    if not stat.S_ISREG(status.st_mode):
        raise InputError("is not a regular file", file=shown)
    if status.st_size > limit:
        raise InputError(_too_large(status.st_size, limit), file=shown)
    with Path(file).open("rb") as stream:
        data = stream.read(limit + 1)
    if len(data) > limit:  # it grew in between
        raise InputError(_too_large(len(data), limit), file=shown)
    return data


def _too_large(size: int, limit: int) -> str:
    return f"is too large ({size / 1e6:.1f} MB); allowed are {limit / 1e6:g} MB"


def _text(data: bytes) -> str:
    if not data.strip():
        raise InputError("is empty")
    if b"\0" in data and not data.startswith((b"\xff\xfe", b"\xfe\xff")):
        raise InputError("is a binary file; allowed is UTF-8 text")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise InputError(f"is not UTF-8 text (line {line}); save it as UTF-8") from None


def read_yaml_documents(path: str | os.PathLike[str], *, limit: int = YAML_LIMIT) -> tuple[str, list[Any]]:
    """Return the text of a YAML file and its documents as plain data; empty documents are left out.

    Raises
    ------
    InputError : as ``read_text``; not YAML; or tags, anchors, aliases, repeated keys or deep nesting
    """
    text = read_text(path, limit=limit)
    try:
        documents = [document for document in parse_yaml(text) if document is not None]
    except InputError as error:
        raise error.located(file=printable_path(os.fspath(path))) from None
    if not documents:
        raise InputError("is empty (nothing but comments)", file=printable_path(os.fspath(path)))
    return text, documents


def parse_yaml(text: str) -> Iterator[Any]:
    """Yield the documents of a YAML text."""
    import yaml

    loader = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
    try:
        yield from _documents(yaml.parse(text, Loader=loader))
    except yaml.reader.ReaderError as error:
        raise InputError(f"has a character that no text file has (position {error.position})") from None
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        where = f"line {mark.line + 1}, column {mark.column + 1}" if mark else None
        problem = printable_problem(error.problem or error.context or "unreadable")
        raise InputError(f"is not YAML: {problem}", field=where) from None
    except (yaml.YAMLError, RecursionError, UnicodeError):
        raise InputError("is not YAML") from None


def printable_problem(text: str) -> str:
    """Return a parser's complaint as one line of moderate length."""
    line = " ".join(text.split())
    return "".join(character if character.isprintable() else "?" for character in line[:160])


def _documents(events: Iterator[Any]) -> Iterator[Any]:
    import yaml

    open_nodes: list[_Node] = []
    root: Any = None
    for event in events:
        if isinstance(event, yaml.DocumentStartEvent):
            root, open_nodes = None, []
        elif isinstance(event, yaml.DocumentEndEvent):
            yield root
        elif isinstance(event, yaml.NodeEvent):
            _refuse(event)
            value = _value(event)
            if open_nodes:
                open_nodes[-1].add(value, event)
            else:
                root = value
            if isinstance(value, dict | list):
                open_nodes.append(_Node(value))
                if len(open_nodes) > _DEEPEST:
                    raise InputError(f"is nested deeper than {_DEEPEST} levels", field=_line(event))
        elif isinstance(event, yaml.CollectionEndEvent):
            open_nodes.pop()


class _Node:
    """A mapping or list that is being filled."""

    def __init__(self, value: dict[str, Any] | list[Any]) -> None:
        self.value = value
        self.key: str | None = None

    def add(self, item: Any, event: Any) -> None:
        if isinstance(self.value, list):
            self.value.append(item)
        elif self.key is None:
            self.key = _key(event)
            if self.key in self.value:
                raise InputError(f"the field {quoted(self.key)} is given twice", field=_line(event))
        else:
            self.value[self.key] = item
            self.key = None


def _key(event: Any) -> str:
    if not hasattr(event, "value"):
        raise InputError("a field name must be text", field=_line(event))
    return str(event.value)


def _refuse(event: Any) -> None:
    import yaml

    if isinstance(event, yaml.AliasEvent):
        raise InputError(f"YAML aliases (*{printable(event.anchor or '')}) are not allowed", field=_line(event))
    if event.anchor is not None:
        raise InputError(f"YAML anchors (&{printable(event.anchor)}) are not allowed", field=_line(event))
    if event.tag is not None:
        raise InputError(f"YAML tags ({printable(event.tag)}) are not allowed", field=_line(event))


def _line(event: Any) -> str:
    return f"line {event.start_mark.line + 1}"


def _value(event: Any) -> Any:
    import yaml

    if isinstance(event, yaml.MappingStartEvent):
        return {}
    if isinstance(event, yaml.SequenceStartEvent):
        return []
    text: str = event.value
    if not event.implicit[0]:  # quoted or block text
        return text
    if text in _CONSTANTS:
        return _CONSTANTS[text]
    if len(text) <= _LONGEST_NUMBER:
        if _INTEGER.fullmatch(text):
            return int(text)
        if _FLOAT.fullmatch(text):
            return float(text)
    return text


def one_document(documents: list[Any], file: str, *, what: str = "design") -> Any:
    """Return the only document of a file; ``what`` says in a message what one document is.

    Raises
    ------
    InputError : more than one; says their names
    """
    if len(documents) == 1:
        return documents[0]
    names = [document.get("name") if isinstance(document, dict) else None for document in documents]
    shown = [printable(str(name)) if name is not None else "without a name" for name in names[:_MOST_DOCUMENTS]]
    more = ", ..." if len(names) > _MOST_DOCUMENTS else ""
    raise InputError(
        f"holds {len(documents)} {what}s ({', '.join(shown)}{more}); allowed is one {what} per file",
        file=printable_path(file),
    )
