"""The equations of motion against Lagrange's, derived by differentiating L = T - V written down here once more.

Energies and forces that do work are stated from the geometry: velocities of masses, heights, depths. Nothing of them
is shared with the plant but the elastic energy of the actuator, which tests/battery holds against its load.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from dataclasses import dataclass

import jax
import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.actuators import Groove, Maccepa, RollerBeam, SliderLeafJoint, SwivellingPair
from varistiff.dynamics.carried_mass import CarriedMass
from varistiff.dynamics.drives import Temperatures
from varistiff.dynamics.equations import Outside, flows
from varistiff.dynamics.friction import DryFriction, Friction
from varistiff.dynamics.ledger import Ledger
from varistiff.dynamics.path import Affine, GroovePath
from varistiff.dynamics.plant import Gravity, Member, Plant
from varistiff.dynamics.signals import Sample
from varistiff.dynamics.state import Command, Motion, State
from varistiff.dynamics.stop import Stop
from varistiff.elastic.leaf import Leaf

G = 9.80665
LINK, DRIVE, SETTING = 0.31, 0.047, 0.0021  # kg m^2
MASS = 0.73  # kg, of what the setting moves
Array = jax.Array


@dataclass(frozen=True)
class Joint:
    """A plant, and its Lagrangian and dissipative forces as functions of (q, q') = (link, drive, motion)."""

    plant: Plant
    lagrangian: Callable[[Array, Array], Array]
    dissipation: Callable[[Array, Array], Array]
    low: tuple[float, float, float]
    high: tuple[float, float, float]


def point_mass_energy(angle: Callable[[Array], Array], radius: Callable[[Array], Array]) -> Callable[..., Array]:
    """Kinetic energy of a mass at polar coordinates, by differentiating its place x = rho (cos a, sin a)."""

    def energy(q: Array, rates: Array) -> Array:
        def place(at: Array) -> Array:
            return radius(at) * jnp.array([jnp.cos(angle(at)), jnp.sin(angle(at))])

        velocity = jax.jvp(place, (q,), (rates,))[1]
        return 0.5 * MASS * velocity @ velocity

    return energy


def body_energy(rates: Array) -> Array:
    return 0.5 * (LINK * rates[0] ** 2 + DRIVE * rates[1] ** 2 + SETTING * rates[2] ** 2)


GROOVE = Groove(inner_radius=0.025, outer_radius=0.054, outer_angle=math.radians(47), arc_radius=0.0368, centre="near")


def wang() -> Joint:
    """Sliders on the drive disc, in the groove of a disc that the setting drive turns; viscous friction everywhere."""
    leaf = Leaf(youngs_modulus=206e9, width=0.025, thickness=0.001, length=0.04)
    device = SliderLeafJoint(leaf=leaf, count=3, clamp_radius=0.025, groove=GROOVE)
    damping = jnp.array([0.21, 0.13, 0.017])
    link, drive, setting = (Friction(float(value)) for value in damping)
    plant = Plant(
        device,
        link=Member(LINK, link),
        drive=Member(DRIVE, drive),
        setting=Member(SETTING, setting),
        setting_path=GroovePath(GROOVE),
        carried=CarriedMass(MASS, GroovePath(GROOVE, start=0.025), "drive"),
    )
    slider = point_mass_energy(lambda q: q[1], lambda q: 0.025 + GROOVE.active_length(q[2]))

    def lagrangian(q: Array, rates: Array) -> Array:
        return body_energy(rates) + slider(q, rates) - device.energy(q[1] - q[0], GROOVE.active_length(q[2]))

    return Joint(plant, lagrangian, lambda q, rates: -damping * rates, (-0.5, -0.45, 0.35), (0.5, 0.45, 0.7))


def knee() -> Joint:
    """A roller beam without a drive: the shuttle rides on the hanging shank, whose zero is not straight down."""
    beam = Leaf(youngs_modulus=194e9, width=0.02545, thickness=0.00316, length=0.9)
    device = RollerBeam(beam, SwivellingPair(offset=0.003, clearance=0.0004), mounting_angle=0.04)
    moment, down, start, lead = 17.0, 0.3, 0.12, 0.008
    dry = DryFriction(coulomb=1.3, breakaway=1.9, stribeck_rate=0.4, smoothing_rate=0.05)
    plant = Plant(
        device,
        link=Member(LINK, Friction(0.4, dry)),
        setting=Member(SETTING, Friction(0.003)),
        setting_path=Affine(start, lead),
        carried=CarriedMass(MASS, Affine(start, lead), "link"),
        gravity=Gravity(moment, down, G),
        driven=False,
    )
    shuttle = point_mass_energy(lambda q: q[0], lambda q: start + lead * q[2])

    def lagrangian(q: Array, rates: Array) -> Array:
        radius = start + lead * q[2]
        # heights above the joint; the link hangs at `down`
        height = -(moment + MASS * G * radius) * jnp.cos(q[0] - down)
        return body_energy(rates) + shuttle(q, rates) - height - device.energy(q[0], radius)

    def dissipation(q: Array, rates: Array) -> Array:
        w = rates[0]
        rub = (1.3 + 0.6 * jnp.exp(-((w / 0.4) ** 2))) * jnp.tanh(w / 0.05)
        return jnp.array([-0.4 * w - rub, 0.0, -0.003 * rates[2]])

    return Joint(plant, lagrangian, dissipation, (0.25, 0.0, 12.0), (0.9, 0.0, 35.0))


def stops() -> Joint:
    """A preloaded joint with play, every stop in contact with damping."""
    device = Maccepa(spring_rate=394.0, lever_length=0.036, anchor_distance=0.135)
    play, stiffness, damping = 0.1, jnp.array([900.0, 1100.0, 70.0, 1300.0]), jnp.array([0.05, 0.08, 0.03, 0.06])
    plant = Plant(
        device,
        link=Member(LINK, stop=Stop(lower=1.3, stiffness=900.0, damping=0.05)),
        drive=Member(DRIVE, stop=Stop(upper=0.7, stiffness=1100.0, damping=0.08)),
        setting=Member(SETTING, stop=Stop(upper=3.0, stiffness=70.0, damping=0.03)),
        setting_path=Affine(0.002, 0.003),
        backlash=play,
        deflection_stop=Stop(lower=-0.2, stiffness=1300.0, damping=0.06),
        gravity=Gravity(11.0),
    )

    def depths(q: Array) -> Array:
        return jnp.array([1.3 - q[0], q[1] - 0.7, q[2] - 3.0, -0.2 - (q[1] - q[0])])

    def lagrangian(q: Array, rates: Array) -> Array:
        pressed = 0.5 * jnp.sum(stiffness * depths(q) ** 2)
        spring = device.energy(q[1] - q[0] + 0.5 * play, 0.002 + 0.003 * q[2])  # below the play
        return body_energy(rates) - pressed - spring - 11.0 * (1.0 - jnp.cos(q[0]))

    def dissipation(q: Array, rates: Array) -> Array:
        depth, closing = jax.jvp(depths, (q,), (rates,))
        return -jax.jacfwd(depths)(q).T @ (stiffness * depth * damping * closing)

    return Joint(plant, lagrangian, dissipation, (1.1, 0.75, 3.1), (1.2, 0.8, 4.0))


JOINTS = {"wang": wang, "knee": knee, "stops": stops}


def lagrange(joint: Joint) -> Callable[[Array, Array, Array], tuple[Array, Array]]:
    """M and r of M q'' = r: M = d2L/dq'2, r = dL/dq + Q - (d2L/dq' dq) q'."""

    @jax.jit
    def equations(q: Array, rates: Array, forces: Array) -> tuple[Array, Array]:
        momenta = jax.grad(joint.lagrangian, argnums=1)
        mixed = jax.jvp(lambda at: momenta(at, rates), (q,), (rates,))[1]
        gradient = jax.grad(joint.lagrangian, argnums=0)(q, rates)
        inertia = jax.hessian(joint.lagrangian, argnums=1)(q, rates)
        return inertia, gradient + forces + joint.dissipation(q, rates) - mixed

    return equations


def answers(plant: Plant) -> Callable[..., Array]:
    """Accelerations of link, drive and setting, and the torque against the link, by the plant's own equations."""

    @jax.jit
    def equations(q: Array, rates: Array, forces: Array, link_acceleration: Array) -> Array:
        link = Sample(q[0], rates[0], link_acceleration)
        now = flows(plant, state_of(plant, q, rates), Command(forces[1], forces[2]), Outside(-forces[0], link))
        return jnp.stack([now.link_acceleration, now.drive_acceleration, now.motion_acceleration, now.external_torque])

    return equations


def state_of(plant: Plant, q: Array, rates: Array) -> State:
    motion = Motion(q[0], rates[0], q[1], rates[1], q[2], rates[2])
    zero = jnp.asarray(0.0)
    cold = Temperatures(zero, zero)
    return State(motion, jnp.asarray(plant.storage.charge0), cold, cold, Ledger({}, {}, zero))


def points(joint: Joint, count: int) -> list[tuple[np.ndarray, np.ndarray, np.ndarray]]:
    """Positions, rates and generalized forces of link, drive and setting; nothing of a drive that is not there."""
    random = np.random.default_rng(5)
    there = np.array([1.0, float(joint.plant.driven), 1.0])
    return [
        (random.uniform(joint.low, joint.high), random.uniform(-4, 4, 3) * there, random.uniform(-9, 9, 3) * there)
        for _ in range(count)
    ]


@pytest.mark.parametrize("name", JOINTS)
def test_accelerations_are_lagranges(name: str) -> None:
    joint = JOINTS[name]()
    theirs, ours = lagrange(joint), answers(joint.plant)
    free = [0, 1, 2] if joint.plant.driven else [0, 2]
    for q, rates, forces in points(joint, 12):
        inertia, right = (np.asarray(part) for part in theirs(q, rates, forces))
        expected = np.zeros(3)
        expected[free] = np.linalg.solve(inertia[np.ix_(free, free)], right[free])
        # closed forms of load and stiffness against derivatives of the energy: both to about 1e-11
        np.testing.assert_allclose(ours(q, rates, forces, 0.0)[:3], expected, rtol=1e-8, atol=1e-8)


@pytest.mark.parametrize("name", JOINTS)
def test_torque_that_moves_a_prescribed_link_is_lagranges(name: str) -> None:
    joint = JOINTS[name]()
    plant = dataclasses.replace(joint.plant, link=dataclasses.replace(joint.plant.link, mode="prescribed"))
    theirs, ours = lagrange(joint), answers(plant)
    free = [1, 2] if plant.driven else [2]
    for (q, rates, forces), moved in zip(points(joint, 6), np.linspace(-30.0, 30.0, 6), strict=True):
        inertia, right = (np.asarray(part) for part in theirs(q, rates, forces * [0.0, 1.0, 1.0]))
        expected = np.array([moved, 0.0, 0.0])
        expected[free] = np.linalg.solve(inertia[np.ix_(free, free)], right[free] - inertia[free, 0] * moved)
        found = np.asarray(ours(q, rates, forces, moved))
        np.testing.assert_allclose(found[:3], expected, rtol=1e-8, atol=1e-8)
        assert found[3] == pytest.approx(right[0] - inertia[0] @ expected, rel=1e-8, abs=1e-8)


@pytest.mark.parametrize("name", JOINTS)
def test_stores_are_the_energy_of_the_lagrangian(name: str) -> None:
    joint = JOINTS[name]()

    @jax.jit
    def both(q: Array, rates: Array) -> Array:
        momenta = jax.grad(joint.lagrangian, argnums=1)(q, rates)
        stores = joint.plant.stores(state_of(joint.plant, q, rates).motion, jnp.asarray(0.0))
        mechanical = stores.kinetic + stores.elastic + stores.gravity + stores.stop_elastic
        return jnp.stack([momenta @ rates - joint.lagrangian(q, rates), mechanical])

    energies = np.array([both(q, rates) for q, rates, _ in points(joint, 8)])
    differences = energies - energies[0]  # a constant is free
    np.testing.assert_allclose(differences[:, 1], differences[:, 0], rtol=1e-11, atol=1e-10)
