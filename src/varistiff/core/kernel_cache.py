"""Compiled kernels kept between runs of the command line, which saves compiling them again."""

from __future__ import annotations

import hashlib
import os
import platform
from contextlib import suppress
from pathlib import Path

_PROCESSORS = Path("/proc/cpuinfo")


def keep_compiled_kernels() -> None:
    """Point JAX to a cache in the user's cache directory; only before JAX is imported.

    A cache that the user set up in JAX's own variables stays as it is; ``VARISTIFF_CACHE=off`` leaves none. Where the
    directory cannot be made, or there is no home directory, there is no cache and nothing is said: it only saves time.
    """
    wanted = os.environ.get("VARISTIFF_CACHE", "")
    if wanted == "off" or "JAX_COMPILATION_CACHE_DIR" in os.environ:
        return
    with suppress(OSError, RuntimeError):  # RuntimeError: the user has no home directory
        base = Path(wanted or os.environ.get("XDG_CACHE_HOME", "") or Path.home() / ".cache")
        place = base / "varistiff" / _processor()
        place.mkdir(parents=True, exist_ok=True)
        if os.access(place, os.W_OK):
            os.environ["JAX_COMPILATION_CACHE_DIR"] = str(place)
            os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "0")
            os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES", "0")


def _processor() -> str:
    """Return a short name of the processor's model and instructions, which compiled code depends on."""
    said: dict[str, str] = {}
    with suppress(OSError), _PROCESSORS.open(encoding="utf-8", errors="replace") as lines:
        for line in lines:
            key, _, value = line.partition(":")
            if key.strip() in ("model name", "flags"):
                said.setdefault(key.strip(), value.strip())
            if len(said) == 2:  # the first processor speaks for all
                break
    parts = [said["model name"], said["flags"]] if len(said) == 2 else [platform.machine(), platform.processor()]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:12]
