"""The joint as a mechanical and electrical system: parameters, and what the state alone determines."""

from __future__ import annotations

from typing import Literal, NamedTuple

import equinox as eqx
import jax.numpy as jnp
from jaxtyping import Array, Float

from varistiff.actuators.actuator import Actuator
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.drives import Drive, TorqueSource
from varistiff.dynamics.friction import Friction
from varistiff.dynamics.ledger import Stores
from varistiff.dynamics.path import Affine, Path
from varistiff.dynamics.state import Motion
from varistiff.dynamics.stop import Stop, push
from varistiff.dynamics.storage import IdealSupply, Storage

Scalar = Float[Array, ""]
Mode = Literal["free", "locked", "prescribed"]


class Member(eqx.Module):
    """A moving part: its inertia, friction and stops.

    Parameters
    ----------
    inertia : about the joint [kg m^2], or mass [kg] of a linear device; without rotor and carried mass
    friction : against its rate
    stop : ends of its travel
    mode : "free", "locked" where it starts, or (the link only) "prescribed" by a signal
    """

    inertia: float = 0.0
    friction: Friction = Friction()
    stop: Stop | None = None
    mode: Mode = eqx.field(static=True, default="free")


class Gravity(eqx.Module):
    """Weight of the link as a pendulum: V_g = m g l (1 - cos(q - q_0)).

    Parameters
    ----------
    moment : m g l [N m]
    rest : q_0 [rad], link position in which it hangs down
    acceleration : g [m/s^2], for the mass that the setting carries on the link
    """

    moment: float
    rest: float = 0.0
    acceleration: float = 9.80665


class Plant(eqx.Module):
    """A link, a drive and a setting drive around an actuator's energy.

    With the deflection d = q_1 - q of a driven joint and s = s(z), load = dV/dd:

        d/dt(M_l q') + F_l(q') + dV_g/dq + tau_ext = load
        d/dt(M_d q_1') + F_d(q_1') + load = u_1
        M_z z'' + M_z'(z) z'^2/2 - M_b'(z) w_b^2/2 + F_z(z') + dV/ds s'(z) = u_2

    M_l, M_d include the reflected rotor and the mass that the setting carries on them (body b). A semi-active joint
    has no drive: d = q and the load acts on the link with the opposite sign.

    Parameters
    ----------
    actuator : whose energy couples them
    link, drive, setting : the moving parts; their own coordinates
    setting_path : s(z)
    carried : mass moved by the setting; None for one that is part of the setting's inertia
    drive_motor, setting_motor : what turns a command into torque
    storage : what both motors draw from
    gravity : weight of the link and of the mass carried on it; None for none
    backlash : play between drive and link, as a whole width [rad] or [m]; None for none
    deflection_stop : limits of the deflection, between drive and link; None for none
    driven : False for a semi-active joint
    motion_unit : SI unit of the setting drive's coordinate, for labels

    Notes
    -----
    Wang et al. (2024), Eq. (17), doi 10.3390/app14072685, with the load from the energy instead of K_s (q_1 - q).
    """

    actuator: Actuator
    link: Member
    drive: Member = Member(mode="locked")
    setting: Member = Member(mode="locked")
    setting_path: Path = Affine()
    carried: CarriedMass | None = None
    drive_motor: Drive = TorqueSource()
    setting_motor: Drive = TorqueSource()
    storage: Storage = IdealSupply()
    gravity: Gravity | None = None
    backlash: float | None = None
    deflection_stop: Stop | None = None
    driven: bool = eqx.field(static=True, default=True)
    motion_unit: Literal["rad", "m"] = eqx.field(static=True, default="rad")

    def deflection(self, motion: Motion) -> Scalar:
        """Drive minus link; of a semi-active joint the link's position itself."""
        return motion.drive - motion.link if self.driven else motion.link

    def deflection_rate(self, motion: Motion) -> Scalar:
        """Rate of the deflection."""
        return motion.drive_rate - motion.link_rate if self.driven else motion.link_rate

    def stretch(self, motion: Motion) -> Scalar:
        """Deflection of the elastic element: what the backlash leaves of the deflection."""
        deflection = self.deflection(motion)
        if self.backlash is None:
            return deflection
        half = 0.5 * self.backlash
        return deflection - jnp.clip(deflection, -half, half)

    def inertias(self, motion: Motion) -> Inertias:
        """Inertias of the three coordinates at this setting, and their rates with z."""
        still = 0.0 * motion.motion
        link = self.link.inertia + still
        drive = self.drive.inertia + self.drive_motor.reflected_inertia + still
        setting = self.setting.inertia + self.setting_motor.reflected_inertia + still
        if self.carried is None:
            return Inertias(link, drive, setting, still, still, still)
        mass, body = self.carried.at(motion.motion), self.carried.body
        return Inertias(
            link=link + mass.body_inertia if body == "link" else link,
            drive=drive + mass.body_inertia if body == "drive" else drive,
            setting=setting + mass.own_inertia,
            link_rate=mass.body_rate if body == "link" else still,
            drive_rate=mass.body_rate if body == "drive" else still,
            setting_rate=mass.own_rate,
        )

    def stores(self, motion: Motion, charge: Scalar) -> Stores:
        """Energies that the state determines; differences only are of use."""
        inertia = self.inertias(motion)
        kinetic = (
            inertia.link * motion.link_rate**2
            + inertia.drive * motion.drive_rate**2
            + inertia.setting * motion.motion_rate**2
        )
        setting = self.setting_path.at(motion.motion).value
        stops = (
            push(self.link.stop, motion.link, motion.link_rate).energy
            + push(self.drive.stop, motion.drive, motion.drive_rate).energy
            + push(self.setting.stop, motion.motion, motion.motion_rate).energy
            + push(self.deflection_stop, self.deflection(motion), self.deflection_rate(motion)).energy
        )
        return Stores(
            kinetic=0.5 * kinetic,
            elastic=self.actuator.energy(self.stretch(motion), setting),
            gravity=self._height_energy(motion),
            stop_elastic=stops,
            stored=self.storage.energy(charge),
        )

    def _height_energy(self, motion: Motion) -> Scalar:
        if self.gravity is None:
            return 0.0 * motion.link
        angle = motion.link - self.gravity.rest
        energy = self.gravity.moment * 2.0 * jnp.sin(0.5 * angle) ** 2
        if self.carried is None or self.carried.body != "link":
            return energy
        weight = self.carried.mass * self.gravity.acceleration
        return energy - weight * self.carried.radius.at(motion.motion).value * jnp.cos(angle)

    def weight(self, motion: Motion) -> tuple[Scalar, Scalar]:
        """Generalized forces of gravity on link and setting: -dV_g/dq, -dV_g/dz."""
        still = 0.0 * motion.link
        if self.gravity is None:
            return still, still
        angle = motion.link - self.gravity.rest
        if self.carried is None or self.carried.body != "link":
            return -self.gravity.moment * jnp.sin(angle), still
        weight = self.carried.mass * self.gravity.acceleration
        radius = self.carried.radius.at(motion.motion)
        torque = -(self.gravity.moment + weight * radius.value) * jnp.sin(angle)
        return torque, weight * radius.slope * jnp.cos(angle)


class Inertias(NamedTuple):
    """Inertias of link, drive and setting, and their rates with the setting's coordinate."""

    link: Scalar
    drive: Scalar
    setting: Scalar
    link_rate: Scalar
    drive_rate: Scalar
    setting_rate: Scalar
