"""What a transmission keeps for itself, driving or driven back."""

from __future__ import annotations

from jaxtyping import Array, Float

Scalar = Float[Array, ""]


def loss_share(sense: Scalar, *, forward: float, backward: float) -> Scalar:
    """Share of a power that is lost: (f + b)/2 + (f - b)/2 * sense.

    Parameters
    ----------
    sense : +1 where the power flows forward, -1 where it flows back, between them a smooth passage
    forward, backward : shares f, b that are lost in either direction, not below zero

    Notes
    -----
    Never below zero for ``sense`` from -1 to 1.

    >>> loss_share(1.0, forward=0.25, backward=0.5), loss_share(-1.0, forward=0.25, backward=0.5)
    (0.25, 0.5)
    """
    return 0.5 * (forward + backward) + 0.5 * (forward - backward) * sense
