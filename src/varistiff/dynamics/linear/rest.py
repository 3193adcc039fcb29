"""Where a case rests at the start: the equilibrium about which it is linearised."""

from __future__ import annotations

from varistiff.dynamics.linear.equilibrium import Equilibrium, equilibrium
from varistiff.dynamics.linear.state_at import first_load, start_of
from varistiff.dynamics.linear.statics import real_coordinates
from varistiff.dynamics.program import Case


def rest(case: Case, *, motion: float | None = None) -> Equilibrium:
    """Equilibrium under the external torque of the start, with the link where it starts if a drive can hold it there.

    The link stands at its start and the drive, if it is free, where the spring carries the load; a drive that is
    locked, and a joint without one, stay where they start and the link gives way. The setting is held at its start.

    Parameters
    ----------
    motion : coordinate of the setting drive in place of its start [rad or m]

    Raises
    ------
    InputError : there is no such equilibrium
    """
    plant, start, load = case.plant, start_of(case), first_load(case)
    setting = None
    if "motion" in real_coordinates(plant):
        setting = float(start.motion) if motion is None else motion
    link = float(start.link)
    drive = float(start.drive) if plant.driven else None
    if plant.link.mode != "free":
        return equilibrium(plant, guess=start, link=link, drive=drive, motion=setting)
    if plant.driven and plant.drive.mode == "free":
        return equilibrium(plant, guess=start, link=link, motion=setting, external_torque=load)
    return equilibrium(plant, guess=start, drive=drive, motion=setting, external_torque=load)
