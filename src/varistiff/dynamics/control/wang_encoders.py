"""The three encoders of the joint of Wang et al. (2024)."""

from __future__ import annotations

import math

from varistiff.dynamics.control.encoder import Encoder, rotary_encoder


def wang_encoders(
    *,
    link_counts: float = math.inf,
    drive_counts: float = math.inf,
    setting_counts: float = math.inf,
    belt_ratio: float = 1.0,
    reducer_ratio: float = 1.0,
) -> tuple[Encoder, Encoder, Encoder]:
    """Encoders of output disc, drive disc and stiffness disc, in this order.

    Reader 2 sees a ring on the output disc, reader 1 one on the drive disc; the third encoder sits at the tail of the
    stiffness motor, before its reducer, and sees the angle of the stiffness disc ``reducer_ratio`` times as large. An
    encoder on the drive motor, in place of reader 1, sees the drive disc through the timing belt: give the
    ``belt_ratio``. Counts, belt and reducer are not published.

    Parameters
    ----------
    link_counts, drive_counts, setting_counts : counts in a turn of each encoder's own shaft, after quadrature;
        infinite for an ideal one
    belt_ratio : turns of the drive encoder per turn of the drive disc: 1 for the ring on the disc, teeth of the large
        pulley over those of the small one for an encoder on the motor
    reducer_ratio : turns of the stiffness motor per turn of the stiffness disc

    Raises
    ------
    InputError : a number is not positive

    Notes
    -----
    Wang et al. (2024), section 3, doi 10.3390/app14072685. The belt is rigid and has no play here: an encoder on the
    motor could not see either.

    >>> link, drive, _ = wang_encoders(link_counts=8192, drive_counts=8192, belt_ratio=4.0)
    >>> round(link.step / drive.step, 12)
    4.0
    """
    return (
        rotary_encoder(link_counts),
        rotary_encoder(drive_counts, belt_ratio),
        rotary_encoder(setting_counts, reducer_ratio),
    )
