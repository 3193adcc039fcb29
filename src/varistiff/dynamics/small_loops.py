"""Let XLA compile a time loop of scalars into one function."""

from __future__ import annotations

import os

_OPTION = "xla_cpu_small_while_loop_byte_threshold"
_BYTES = 1 << 30


def compile_small_loops_whole() -> None:
    """Raise the size up to which XLA on CPUs compiles a loop with its whole body as one function.

    Without it each elementary operation of a time step is dispatched by itself: 3000 steps take 30 ms in place of 1.
    XLA reads the option once, before its first computation in the process; set later it has no effect, and
    simulations are slower but the same. An option that the user has set stays.
    """
    flags = os.environ.get("XLA_FLAGS", "")
    if _OPTION in flags or "xla_backend_extra_options" in flags:
        return
    os.environ["XLA_FLAGS"] = f"{flags} --xla_backend_extra_options={_OPTION}={_BYTES}".strip()
