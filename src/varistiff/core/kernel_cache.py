"""Compiled kernels kept between runs of the command line, which halves its cold start."""

from __future__ import annotations

import os
import platform
from contextlib import suppress
from pathlib import Path


def keep_compiled_kernels() -> None:
    """Point JAX to a cache in the user's cache directory; only before JAX is imported.

    A cache that the user set up in JAX's own variables stays as it is; ``VARISTIFF_CACHE=off`` leaves none. Where the
    directory cannot be made there is no cache and nothing is said: it only saves time.
    """
    wanted = os.environ.get("VARISTIFF_CACHE", "")
    if wanted == "off" or "JAX_COMPILATION_CACHE_DIR" in os.environ:
        return
    base = Path(wanted or os.environ.get("XDG_CACHE_HOME", "") or Path.home() / ".cache")
    # compiled for one processor: a home directory that several machines share keeps them apart
    place = base / "varistiff" / f"{platform.node() or 'host'}-{platform.machine()}"
    with suppress(OSError):
        place.mkdir(parents=True, exist_ok=True)
        if os.access(place, os.W_OK):
            os.environ["JAX_COMPILATION_CACHE_DIR"] = str(place)
            os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_COMPILE_TIME_SECS", "0")
            os.environ.setdefault("JAX_PERSISTENT_CACHE_MIN_ENTRY_SIZE_BYTES", "0")
