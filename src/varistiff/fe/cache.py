"""Results of three-dimensional checks kept between runs, found again by a hash of the question."""

from __future__ import annotations

import base64
import binascii
import hashlib
import json
import os
import zlib
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from varistiff.core.errors import InputError
from varistiff.core.writing import staged_file

Array = NDArray[Any]
_BROKEN = (OSError, ValueError, KeyError, TypeError, zlib.error, binascii.Error, RecursionError)


def cache_key(*parts: object) -> str:
    """Name of an entry: a hash of numbers, texts, None and arrays in order, and of the code that computed it."""
    from importlib.metadata import PackageNotFoundError, version

    found = hashlib.sha256()
    for name in ("varistiff", "ngsolve"):
        with suppress(PackageNotFoundError):
            found.update(f"{name} {version(name)}\n".encode())
    found.update(_sources())
    for part in parts:
        if isinstance(part, np.ndarray):
            found.update(f"{part.dtype} {part.shape} ".encode() + part.tobytes() + b"\n")
        else:
            found.update(f"{part!r}\n".encode())
    return found.hexdigest()


@cache
def _sources() -> bytes:
    """Hash of this room's modules: an entry of other code is another entry."""
    found = hashlib.sha256()
    for module in sorted(resources.files("varistiff.fe").iterdir(), key=lambda entry: entry.name):
        if module.name.endswith(".py"):
            found.update(module.read_bytes())
    return found.digest()


def cache_directory() -> Path | None:
    """Where entries lie: below ``VARISTIFF_CACHE`` or the user's cache directory; None for ``VARISTIFF_CACHE=off``."""
    wanted = os.environ.get("VARISTIFF_CACHE", "")
    if wanted == "off":
        return None
    try:
        return Path(wanted or os.environ.get("XDG_CACHE_HOME", "") or Path.home() / ".cache") / "varistiff" / "verify"
    except RuntimeError:  # the user has no home directory
        return None


def read_entry(key: str) -> tuple[dict[str, Any], dict[str, Array]] | None:
    """Facts and arrays of an entry; None where there is none, or one that is not whole."""
    directory = cache_directory()
    if directory is None:
        return None
    try:
        digest, _, body = (directory / f"{key}.json").read_text(encoding="utf-8").partition("\n")
        if digest != hashlib.sha256(body.encode()).hexdigest():
            return None
        entry = json.loads(body)
        return dict(entry["facts"]), {name: _decoded(array) for name, array in entry["arrays"].items()}
    except _BROKEN:
        return None


def write_entry(key: str, facts: Mapping[str, Any], arrays: Mapping[str, Array]) -> None:
    """Keep an entry, whole or not at all. Where it cannot be written nothing is said: it only saves time."""
    directory = cache_directory()
    if directory is None:
        return
    body = json.dumps({"facts": dict(facts), "arrays": {name: _encoded(array) for name, array in arrays.items()}})
    with suppress(OSError, InputError), staged_file(directory / f"{key}.json") as stream:
        stream.write(hashlib.sha256(body.encode()).hexdigest() + "\n" + body)


def _encoded(array: Array) -> dict[str, Any]:
    packed = base64.b64encode(zlib.compress(np.ascontiguousarray(array).tobytes(), 1)).decode("ascii")
    return {"dtype": array.dtype.str, "shape": list(array.shape), "bytes": packed}


def _decoded(entry: Mapping[str, Any]) -> Array:
    raw = zlib.decompress(base64.b64decode(entry["bytes"], validate=True))
    return np.frombuffer(raw, dtype=np.dtype(entry["dtype"])).reshape(entry["shape"]).copy()
