"""The two theories of the slider leaf joint: small deflection as published, large deflection exact."""

from __future__ import annotations

import math
from abc import abstractmethod
from typing import NamedTuple

import equinox as eqx
import jax.numpy as jnp

from varistiff.actuators.actuator import Field, Mask
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.lemniscate import circular
from varistiff.elastic.linear_cantilever import linear_cantilever
from varistiff.elastic.link_contact import link_contact, mirrored

ROTATION_LIMIT = math.radians(10.0)


class LeafJointState(NamedTuple):
    """All leaves together unless said otherwise; SI units, one shape."""

    exists: Mask
    valid: Mask
    energy: Field
    load: Field
    stiffness: Field
    thrust: Field  # dV/d(active length) [N]
    rotation: Field  # of one leaf at the slider [rad]
    force: Field  # on one leaf, normal to it [N]
    curvature: Field  # the largest [1/m]
    arc_length: Field  # of one leaf up to the slider [m]


class LeafJointTheory(eqx.Module):
    """How a leaf answers a slider that turns about the output axis."""

    @abstractmethod
    def solve(self, leaf: Leaf, count: int, clamp_radius: float, deflection: Field, length: Field) -> LeafJointState:
        """State at deflection angles [rad] and active lengths l_1 > 0 [m] of one shape."""


class SmallDeflection(LeafJointTheory):
    """Wang et al. (2024), Eqs. (1)-(12), with the number of leaves N that (10) and (12) drop.

        V = N E b h^3 l_2^2 (1 - cos phi)/(4 l_1^3),   l_2 = r_2 + l_1

    Valid while the leaf turns by at most 10 degrees at the slider; the formulas have no fold and go on beyond.
    """

    def solve(self, leaf: Leaf, count: int, clamp_radius: float, deflection: Field, length: Field) -> LeafJointState:
        """Closed forms; dV/dl_1 = -N E b h^3 (1 - cos phi)(l_1^2 + 4 r_2 l_1 + 3 r_2^2)/(4 l_1^4)."""
        phi = deflection
        radius = clamp_radius + length
        inverse = 1.0 / length
        scale = 3.0 * count * leaf.flexural_rigidity * inverse * inverse * inverse
        # one sine and cosine, of the half angle, carry everything: a time loop spends most of its time here
        half_sine, half_cosine = circular(0.5 * phi)
        versine = 2.0 * half_sine * half_sine
        sine, cosine = 2.0 * half_sine * half_cosine, 1.0 - versine
        single = linear_cantilever(radius * sine / cosine, length, jnp.asarray(leaf.flexural_rigidity))
        return LeafJointState(
            exists=jnp.ones_like(phi, dtype=bool),
            # tan(phi) is small again near half a turn
            valid=(jnp.abs(single.rotation) <= ROTATION_LIMIT) & (jnp.abs(phi) < 0.5 * math.pi),
            energy=scale * radius**2 * versine,
            load=scale * radius**2 * sine,
            stiffness=scale * radius**2 * cosine,
            thrust=-scale * versine * radius * (length + 3.0 * clamp_radius) * inverse,
            rotation=single.rotation,
            force=jnp.abs(single.force),
            curvature=jnp.abs(single.root_curvature),
            arc_length=length + 0.0 * phi,
        )


class LargeDeflection(LeafJointTheory):
    """Exact: the leaf is an elastica that slides over a frictionless point of the slider, free beyond it.

    The same law as the roller beam's with alpha_w = d_0 = d_r = 0, d_1 = r_2, x_r = l_2 and zero roller radius.
    """

    def solve(self, leaf: Leaf, count: int, clamp_radius: float, deflection: Field, length: Field) -> LeafJointState:
        """Contact on whichever side the slider pushes; at phi = 0 the linear limit, which is exact there."""
        radius = clamp_radius + length
        zero = jnp.zeros_like(deflection)
        solved = link_contact(
            jnp.abs(deflection),
            radius,
            offset=zero,
            joint=(zero - clamp_radius, zero),
            radius=zero,
            flexural_rigidity=jnp.asarray(leaf.flexural_rigidity),
        )
        state = solved.contact
        # the fork has no play: where the overlap is too small to solve, the leaf is still held, and linear
        still = ~state.touching & (jnp.abs(deflection) < 0.5 * math.pi)
        linear = linear_cantilever(radius * jnp.abs(deflection), length, jnp.asarray(leaf.flexural_rigidity))
        load = jnp.where(still, linear.force * radius, solved.moment)
        stiffness = jnp.where(still, 3.0 * leaf.flexural_rigidity * radius**2 / length**3, solved.stiffness)
        return LeafJointState(
            exists=still | (state.touching & state.exists & (jnp.abs(deflection) <= math.pi)),
            valid=jnp.ones_like(still),
            energy=count * jnp.where(still, 0.5 * linear.force * radius * jnp.abs(deflection), state.energy),
            load=count * mirrored(deflection, load),
            stiffness=count * stiffness,
            thrust=count * jnp.where(still, 0.0, solved.thrust),
            rotation=mirrored(deflection, jnp.where(still, linear.rotation, state.slope)),
            force=jnp.where(still, linear.force, state.force),
            curvature=jnp.where(still, linear.root_curvature, state.curvature_max),
            arc_length=jnp.where(still, length, state.arc_length),
        )
