"""Solve the solid leaf to a stated error."""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property

import jax
import jax.numpy as jnp
import numpy as np

from varistiff.core.errors import InputError
from varistiff.elastic.guided_leaf import GuidedLeaf
from varistiff.elastic.leaf import Leaf
from varistiff.elastic.roller_contact import centreline, roller_contact
from varistiff.elastic.wrapped_leaf import WrappedLeaf
from varistiff.fe import import_ngsolve
from varistiff.fe.leaf_guard import add_guard
from varistiff.fe.leaf_holds import LeafHold, SlidingHold, TurnedHold, UprightHold
from varistiff.fe.leaf_mesh import Floats, LeafGrid, leaf_grid
from varistiff.fe.leaf_newton import Linearised, NotConvergedError, find_equilibrium
from varistiff.fe.leaf_problem import LeafProblem, LeafResult, SlidingContact, TurnedEnd, UprightContact
from varistiff.fe.leaf_solid import LeafSolid, unit

ORDERS = (3, 4, 5)  # of the displacement, from level to level; 2 locks in thin leaves
_POISSON_STEPS = 4  # where the beam's shape is too far from the solid's
_NUDGE = 1e-3  # of the contact's distance, for differences over the deflection

Progress = Callable[[str], None]

# compiled once: unjitted, each call would compile its conditionals again
_roller_contact = jax.jit(roller_contact)
_respond = jax.jit(lambda law, leaf, span, rise: law.respond(leaf, span, rise))


class _Start:
    """The beam theory's answer: where Newton's method begins, half-width forces."""

    def __init__(self, problem: LeafProblem) -> None:
        self.problem = problem
        if isinstance(problem.hold, SlidingContact):
            (self._sliding if math.isinf(problem.hold.guard_radius) else self._wrapped)(problem.hold)
        elif isinstance(problem.hold, UprightContact):
            self._upright(problem.hold)
        else:
            self._turned(problem.hold)

    def _sliding(self, hold: SlidingContact) -> None:
        x, y, radius = (jnp.asarray(value) for value in (*hold.centre, hold.radius))
        state = _roller_contact(x, y, radius, jnp.asarray(self.problem.flexural_rigidity))
        if not bool(state.touching):
            raise InputError(
                "the roller does not touch the leaf; allowed is a point in contact", field=self.problem.name
            )
        if not bool(state.exists):
            raise InputError("the leaf slips off; allowed is a point short of that", field=self.problem.name)
        slope, self.span = float(state.slope), float(state.arc_length)
        self.turn = slope
        self.energy = float(state.energy)
        self.unknowns = np.array([0.5 * float(state.force), slope, 1.0, 1.0])
        self.line = centreline(slope, self.span, 401)

    def _wrapped(self, hold: SlidingContact) -> None:
        problem, span, rise = self.problem, 2.0 * hold.centre[0], 2.0 * hold.centre[1]
        leaf = Leaf(youngs_modulus=problem.youngs_modulus, width=problem.width, thickness=problem.thickness)
        law = WrappedLeaf(hold.guard_radius)
        state = _respond(law, leaf, jnp.asarray(span), jnp.asarray(rise))
        if not bool(state.exists):
            raise InputError("the leaf is beyond its hard stop; allowed is a point short of that", field=problem.name)
        line = law.centreline(leaf, span, rise, 801)[:401]
        self.turn = math.atan2(*(line[-1] - line[-2])[::-1])
        self.span, self.energy = 0.5 * float(state.arc_length), 0.5 * float(state.energy)
        self.unknowns = np.array([-0.5 * float(state.force) / math.sin(self.turn), self.turn, 1.0, 1.0])
        self.line = line

    def _upright(self, hold: UprightContact) -> None:
        span, rise = 2.0 * hold.centre[0], 2.0 * hold.centre[1]
        if not span > 0.0:
            raise InputError("the leaf has no span; allowed is a centre with x > 0", field=self.problem.name)
        problem = self.problem
        leaf = Leaf(youngs_modulus=problem.youngs_modulus, width=problem.width, thickness=problem.thickness)
        state = _respond(GuidedLeaf(), leaf, jnp.asarray(span), jnp.asarray(rise))
        self.span, self.energy = 0.5 * float(state.arc_length), 0.5 * float(state.energy)
        force = leaf.flexural_rigidity * float(state.curvature_max) / hold.centre[0]
        line = GuidedLeaf().centreline(leaf, span, rise, 801)[:401]
        slope = math.atan2(*(line[-1] - line[-2])[::-1])
        self.unknowns = np.array([0.5 * force, 1.0, math.cos(slope)])
        self.line, self.turn = line, slope

    def _turned(self, hold: TurnedEnd) -> None:
        self.span, angle = self.problem.length, hold.angle
        self.turn = angle
        rigidity = self.problem.flexural_rigidity
        self.energy = 0.5 * rigidity * angle**2 / self.span
        self.unknowns = np.array([0.5 * rigidity * angle / self.span])
        turn = np.linspace(0.0, angle, 401)
        scale = self.span * np.sinc(0.5 * turn / math.pi) * np.linspace(0.0, 1.0, 401)
        self.line = np.stack([scale * np.cos(0.5 * turn), scale * np.sin(0.5 * turn)], axis=1)

    def curve(self) -> tuple[Floats, Floats, Floats]:
        """Arc, slope and points of the whole leaf, finely and evenly spaced."""
        from scipy.interpolate import CubicSpline

        arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(self.line, axis=0).T))])
        arc *= self.span / arc[-1]
        spline = CubicSpline(arc, self.line)
        even = np.linspace(0.0, self.span + self.problem.tail, 401)
        inside = np.minimum(even, self.span)
        rate = spline(inside, 1)
        turn = np.unwrap(np.arctan2(rate[:, 1], rate[:, 0]))
        beyond = (even - inside)[:, None] * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        return even, turn, spline(inside) + beyond


def _hold(problem: LeafProblem, solid: LeafSolid, unknowns: Floats) -> LeafHold:
    hold = problem.hold
    if isinstance(hold, TurnedEnd):
        return TurnedHold(solid, unknowns, angle=hold.angle, width=problem.width)
    if isinstance(hold, SlidingContact):
        if math.isfinite(hold.guard_radius):
            add_guard(solid, hold.guard_radius, problem.youngs_modulus)
        return SlidingHold(
            solid, unknowns, centre=hold.centre, radius=hold.radius, youngs_modulus=problem.youngs_modulus
        )
    return UprightHold(solid, unknowns, centre=hold.centre, radius=0.0, youngs_modulus=problem.youngs_modulus)


def _grid(problem: LeafProblem, start: _Start) -> LeafGrid:
    return leaf_grid(
        length=start.span,
        tail=problem.tail,
        width=problem.width,
        thickness=problem.thickness,
        turn=start.turn,
        uniform_across=problem.poissons_ratio == 0.0,
    )


def elements_of(problem: LeafProblem) -> tuple[int, int]:
    """Elements along the leaf and over half its width."""
    grid = _grid(problem, _Start(problem))
    return grid.along.size - 1, grid.across.size - 1


def _solid(problem: LeafProblem, start: _Start, order: int) -> LeafSolid:
    return LeafSolid(
        _grid(problem, start),
        problem.thickness,
        order=order,
        youngs_modulus=problem.youngs_modulus,
        poissons_ratio=problem.poissons_ratio,
    )


class _Level:
    """One polynomial order, solved."""

    def __init__(self, problem: LeafProblem, start: _Start, order: int, coarse: _Level | None) -> None:
        self.problem = problem
        self.hold: LeafHold
        self.solid = _solid(problem, start, order)
        unknowns = start.unknowns if coarse is None else coarse.hold.unknowns
        self.hold = _hold(problem, self.solid, unknowns)
        if coarse is None:
            self.solid.shape(*start.curve())
        else:
            # the same mesh: the coarser field is a polynomial of the finer space
            self.solid.displacement.Set(coarse.solid.displacement)
        self.iterations = find_equilibrium(self.hold, start.energy)

    @cached_property
    def system(self) -> Linearised:
        """Linearisation at the equilibrium, for its derivatives."""
        return Linearised(self.hold)

    @classmethod
    def first(cls, problem: LeafProblem, start: _Start, order: int) -> _Level:
        """From the beam's shape, with Poisson's ratio raised in steps where that is too far away."""
        try:
            return cls(problem, start, order, None)
        except NotConvergedError:
            level: _Level | None = None
            for part in np.linspace(0.0, 1.0, _POISSON_STEPS + 1):
                # a ratio of exactly 0 would get another mesh
                ratio = max(float(part), 1e-9) * problem.poissons_ratio
                level = cls(replace(problem, poissons_ratio=ratio), start, order, level)
            assert level is not None
            level.problem = problem
            return level

    def gradient(self) -> Floats:
        """dV/dC of the whole width [N], or the moment of a turned end."""
        if isinstance(self.hold, TurnedHold):
            return 2.0 * self.hold.unknowns
        force = 2.0 * float(self.hold.unknowns[0])
        if isinstance(self.hold, SlidingHold):
            return force * np.array(unit(float(self.hold.unknowns[1]))[1])
        assert isinstance(self.hold, UprightHold)
        rates = self._sensitivities(self.hold)
        release = 2.0 * self.solid.stretch_force()
        return np.array([0.0, force]) + release * np.array([rate[1] for rate in rates])

    def slope(self) -> float:
        """Direction of the force's normal, or of the turned end."""
        if isinstance(self.hold, TurnedHold):
            return self.hold.angle
        return float(self.hold.unknowns[1]) if isinstance(self.hold, SlidingHold) else 0.0

    def _sensitivities(self, hold: SlidingHold | UprightHold) -> list[Floats]:
        """dq/dC for both coordinates."""
        rates = []
        for axis in range(2):
            column, equations = hold.moved(axis)
            column.data *= -1.0
            rates.append(self.system.solve(column, -equations)[1])
        return rates

    def hessian(self) -> Floats:
        """d2V/dC2 of a sliding contact [N/m]."""
        assert isinstance(self.hold, SlidingHold)
        force, slope = map(float, self.hold.unknowns[:2])
        tangent, normal = map(np.array, unit(slope))
        rows = [2.0 * (rate[0] * normal - force * rate[1] * tangent) for rate in self._sensitivities(self.hold)]
        return np.array(rows)

    def load(self) -> float:
        """Part of the device's load."""
        motion, gradient = self.problem.motion, self.gradient()
        rate = np.array([1.0]) if isinstance(self.hold, TurnedHold) else np.array(motion.rate)
        return float(motion.copies * (gradient @ rate))

    def stiffness(self) -> float:
        """Part of the device's tangent stiffness; NaN for an upright contact, which needs neighbours."""
        motion = self.problem.motion
        if isinstance(self.hold, TurnedHold):
            column, equations = self.hold.moved()
            column.data *= -1.0
            return float(motion.copies * 2.0 * self.system.solve(column, -equations)[1][0])
        if isinstance(self.hold, UprightHold):
            return math.nan
        rate = np.array(motion.rate)
        curved = self.gradient() @ np.array(motion.acceleration)
        return float(motion.copies * (rate @ self.hessian() @ rate + curved))


def _levels(problem: LeafProblem, tolerance: float, progress: Progress | None) -> list[_Level]:
    """Orders 3, 4, ... until the load settles."""
    start = _Start(problem)
    levels: list[_Level] = []
    for order in ORDERS:
        level = _Level(problem, start, order, levels[-1]) if levels else _Level.first(problem, start, order)
        levels.append(level)
        load = level.load()
        if progress is not None:
            progress(f"{problem.name}: order {order}, {level.solid.space.ndof} unknowns, load {load:.6g}")
        if len(levels) > 1 and abs(load - levels[-2].load()) <= tolerance * abs(load):
            break
    return levels


def solve(problem: LeafProblem, *, tolerance: float = 0.005, progress: Progress | None = None) -> LeafResult:
    """Equilibrium of the solid leaf.

    The polynomial order rises until the load changes by less than ``tolerance``; that change is the stated error.

    Parameters
    ----------
    problem : the leaf and what holds it
    tolerance : relative, of the load
    progress : told one line after every level

    Raises
    ------
    InputError : no contact, no equilibrium, the tolerance not reached, or NGSolve missing
    """
    import_ngsolve()
    if not 1e-9 <= tolerance < 1.0:
        raise InputError(f"is {tolerance:g}; allowed is 1e-9 to 1", field="tolerance")
    begun = time.perf_counter()
    levels = _levels(problem, tolerance, progress)
    loads = tuple(level.load() for level in levels)
    error = abs(loads[-1] - loads[-2]) / abs(loads[-1])
    if error > tolerance:
        raise InputError(f"the 3-D load settled to {error:.1e} only; allowed is a larger tolerance", field=problem.name)
    stiffness = levels[-1].stiffness()
    if math.isnan(stiffness):
        stiffness = _neighbours(problem, levels[-1].solid.order)
    return _result(problem, levels, loads, error, stiffness, begun)


def _neighbours(problem: LeafProblem, order: int) -> float:
    """Stiffness by the loads at two neighbouring deflections."""
    assert isinstance(problem.hold, UprightContact)
    centre, rate = np.array(problem.hold.centre), np.array(problem.motion.rate)
    change = _NUDGE * float(np.hypot(*centre) / np.hypot(*rate))
    loads = []
    for sign in (-1.0, 1.0):
        x, y = centre + sign * change * rate
        moved = replace(problem, hold=UprightContact((float(x), float(y))))
        loads.append(_Level.first(moved, _Start(moved), order).load())
    return (loads[1] - loads[0]) / (2.0 * change)


def _result(
    problem: LeafProblem, levels: list[_Level], loads: tuple[float, ...], error: float, stiffness: float, begun: float
) -> LeafResult:
    finest = levels[-1]
    solid, unknowns = finest.solid, finest.hold.unknowns
    arc, half_width, points, upper, lower = solid.sample()
    across = np.concatenate([-half_width[:0:-1], half_width])
    points = np.concatenate([points[:, :0:-1] * np.array([1.0, 1.0, -1.0]), points], axis=1)
    points = points * np.array([1.0, problem.side, 1.0])
    faces = [np.concatenate([values[:, :0:-1], values], axis=1) for values in (upper, lower)]
    span = float(solid.grid.along[solid.grid.span])
    distance = min(problem.thickness, 0.5 * span)
    return LeafResult(
        problem=problem,
        load=loads[-1],
        stiffness=stiffness,
        energy=2.0 * solid.energy(),
        contact_force=2.0 * float(unknowns[0]),
        contact_slope=finest.slope(),
        arc_length=span * float(solid.stretch.Get()),
        stress=solid.middle_stress(distance),
        stress_distance=distance,
        error=error,
        unknowns=int(solid.space.ndof),
        seconds=time.perf_counter() - begun,
        level_loads=loads,
        iterations=sum(level.iterations for level in levels),
        arc=arc,
        across=across,
        points=points,
        stress_upper=faces[0] if problem.side > 0.0 else faces[1],
        stress_lower=faces[1] if problem.side > 0.0 else faces[0],
    )
