"""Double precision for JAX, switched on once before anything is traced."""

from __future__ import annotations


def enable() -> None:
    """Switch JAX to float64: single precision cannot hold the tolerances of the models."""
    import jax

    jax.config.update("jax_enable_x64", True)
