"""Bode data of a linear system as a labelled dataset."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from varistiff.core.errors import InputError

if TYPE_CHECKING:
    import control
    import xarray as xr


def frequency_response(
    system: control.StateSpace, input_name: str, output_name: str, frequencies: ArrayLike, *, units: str = ""
) -> xr.Dataset:
    """Magnitude and phase of one transfer over frequency.

    Parameters
    ----------
    system : in continuous or discrete time, with named signals
    input_name, output_name : of the transfer
    frequencies : (n,) [Hz], above 0 and rising
    units : of the magnitude, "rad/(N*m)" from a torque to an angle; kept with it

    Returns
    -------
    Dataset over ``frequency`` [Hz]: ``magnitude`` in output unit per input unit, ``phase`` [rad] without jumps

    Raises
    ------
    InputError : a name that the system does not have, or frequencies out of order
    """
    import xarray as xr

    for name, labels, what in (
        (input_name, system.input_labels, "input"),
        (output_name, system.output_labels, "output"),
    ):
        if name not in labels:
            raise InputError(f"must be one of {', '.join(labels)}, not {name!r}", field=what)
    f = np.atleast_1d(np.asarray(frequencies, dtype=float))
    if not (np.isfinite(f).all() and (f > 0.0).all() and (np.diff(f) > 0.0).all()):
        raise InputError("must be finite, above 0 and rising", field="frequencies")
    row, column = system.output_labels.index(output_name), system.input_labels.index(input_name)
    response = np.asarray(system.frequency_response(2.0 * np.pi * f, squeeze=False).complex)[row, column]
    about = {"long_name": f"{output_name} over {input_name}", "units": units}
    return xr.Dataset(
        {
            "magnitude": ("frequency", np.abs(response), about),
            "phase": ("frequency", np.unwrap(np.angle(response)), {"long_name": "phase", "units": "rad"}),
        },
        {"frequency": ("frequency", f, {"long_name": "frequency", "units": "Hz"})},
        {"input": input_name, "output": output_name},
    )
