"""The simulations of Section 4: stored sets, what a linear loop cannot do, and an independent closed loop."""

from __future__ import annotations

import math

import equinox as eqx
import jax.numpy as jnp
import numpy as np
import pytest
from scipy.linalg import expm

from varistiff.dynamics.program import run_one
from varistiff.papers.wang_2024 import paper_values as paper
from varistiff.papers.wang_2024 import section_4_facts as facts
from varistiff.papers.wang_2024.section_4 import POSITION_SETS, position_set, setting_set, stored
from varistiff.papers.wang_2024.section_4_cases import (
    AMPLITUDE,
    DISC,
    DISC_FRICTION,
    FILTER_TIME,
    LENGTH_MIN,
    PERIOD,
    SLIDERS,
    STEP_TIME,
    STIFFNESS,
    PositionSet,
    groove,
    length_of,
    position_case,
    stiffness_at,
)
from varistiff.papers.wang_2024.section_4_measures import sine_numbers, step_numbers
from varistiff.papers.wang_2024.section_4_motors import HEAVIEST, drives
from varistiff.papers.wang_2024.section_4_runs import RUNS, position_courses, position_facts
from varistiff.papers.wang_2024.section_4_search import QUESTS, SETTING, cost_of, misses, unrest
from varistiff.papers.wang_2024.section_4_stability import fast_radius, sampled_loop

KNIFE_EDGE = 0.1  # s: a band of 1.9 instead of 2.1 % moves a settling time by this much

UNLIMITED = PositionSet(
    load_inertia=0.03,
    drive_inertia=0.05,
    drive_friction=0.5,
    proportional=28.0,
    integral=4.0,
    derivative=0.3,
    limit=1e6,
    small=0.0125,  # small enough for sin(phi) = phi to 1e-5
    large=0.0375,
    load_torque=0.02,
)


@pytest.fixture(scope="module")
def runs() -> dict[str, facts.PositionRun]:
    return facts.position_runs()


@pytest.fixture(scope="module")
def linear() -> dict[str, np.ndarray]:
    """Links of a loop that never saturates: with inertia and torque, and with the inertia alone, beside no load."""
    sets = np.array([UNLIMITED, UNLIMITED._replace(load_torque=0.0)])
    both, inertia = position_courses(sets)[:, :, 0]
    return {**dict(zip(RUNS, both, strict=True)), **{f"{k}_inertia": v for k, v in zip(RUNS, inertia, strict=True)}}


@pytest.mark.parametrize("name", POSITION_SETS)
def test_position_sets_meet_what_the_file_says(runs, name):
    aims, found = QUESTS[name].aims, runs[name].facts
    for aim in aims:
        off = abs(getattr(found, aim.fact) - aim.printed)
        edge = KNIFE_EDGE if "settling" in aim.fact else 0.02 * aim.scale  # of another machine's rounding
        if aim.fact in stored(name).meets:
            assert off <= aim.scale + edge, aim.fact
        else:
            assert aim.fact in stored(name).misses
            assert not off < aim.scale - edge, aim.fact
    assert {*stored(name).meets, *stored(name).misses} == {aim.fact for aim in aims}


def test_setting_set_meets_what_the_file_says():
    off = misses(facts.setting_run().facts, SETTING)
    for fact in stored("stiffness").meets:
        assert abs(off[fact]) <= 1.0 + (KNIFE_EDGE / 0.01 if "time" in fact else 0.02), fact
    assert set(off) == {*stored("stiffness").meets, *stored("stiffness").misses}


def test_stored_cost_is_that_of_the_stored_numbers(runs):
    for name in ("sine", "sine_as_printed"):  # no settling time in their aims: nothing there is on a knife's edge
        ceilings = tuple(top for top in QUESTS[name].ceilings if "overshoot" in top.fact)
        cost = cost_of(runs[name].facts, QUESTS[name].aims, ceilings) + unrest(position_set(name))
        assert cost == pytest.approx(
            stored(name).cost, rel=0.05, abs=0.01
        )  # stored with three digits, and slow steps count too


def test_sets_are_those_a_joint_of_4_kg_could_have():
    assert HEAVIEST < 4.0 / 4.0
    for name in POSITION_SETS:
        assert drives(name), name
        assert position_set(name).limit < 3.0 * 14.6  # N m; what the leaf bears, three times
    assert setting_set().load_torque < STIFFNESS * paper.DEFLECTION_LIMIT


def test_inertia_changes_overshoot_alike_at_every_stroke(linear):
    """Proof that an inertia alone cannot add 5 % at a small and 15 % at a large stroke in a linear loop."""
    ratio = UNLIMITED.large / UNLIMITED.small
    for small, large in (("small", "large"), ("small_loaded_inertia", "large_loaded_inertia")):
        # the spring's sin(phi) is the only part that is not linear: 1e-5 at these deflections
        assert linear[large] == pytest.approx(ratio * linear[small], abs=2e-5 * UNLIMITED.large)
    added = [
        step_numbers(linear[f"{name}_loaded_inertia"], 0.0, stroke).overshoot
        - step_numbers(linear[name], 0.0, stroke).overshoot
        for name, stroke in (("small", UNLIMITED.small), ("large", UNLIMITED.large))
    ]
    assert added[0] > 0.02  # it does change
    assert added[1] == pytest.approx(added[0], abs=1e-4)


def test_torque_changes_the_course_by_the_same_angle_at_every_stroke(linear):
    """Proof that a constant torque changes the share of the step in proportion to 1/stroke: less at the large one."""
    small = linear["small_loaded"] - linear["small_loaded_inertia"]
    large = linear["large_loaded"] - linear["large_loaded_inertia"]
    assert np.abs(small).max() > 1e-4  # rad
    assert large == pytest.approx(small, abs=1e-3 * np.abs(small).max())


def test_steps_need_inertia_and_torque():
    """The set that meets the steps: either alone misses both strokes."""
    own = position_set("steps")
    inertia, torque = (
        position_facts(changed, position_courses(np.array([changed]))[0])
        for changed in (own._replace(load_torque=0.0), own._replace(load_inertia=0.0))
    )
    assert inertia.small_overshoot_by_load > 0.10
    assert torque.large_overshoot_by_load < 0.05


def test_time_loop_equals_an_exact_discretisation(linear):
    """Two inertias and a spring by the matrix exponential, under the PID as a matrix: no code in common."""
    own = UNLIMITED
    across, wanted = sampled_loop(own, loaded=1.0)
    state, course = np.zeros(7), []
    for sample in range(1500):
        course.append(state[0])
        state = across @ state + wanted * (own.small if sample * PERIOD >= STEP_TIME else 0.0)
    # the Runge-Kutta step errs by (230 rad/s * 1 ms)^5/120 a step, sin(phi) by 1e-5
    assert linear["small_loaded_inertia"][:1500] == pytest.approx(np.array(course), abs=1e-3 * own.small)


@pytest.mark.parametrize("name", POSITION_SETS)
def test_position_loops_are_stable(name):
    """A loop can follow a sine for three seconds and be unstable: the sets must not be of that kind."""
    own = position_set(name)
    for loaded in (0.0, 1.0):
        assert np.abs(np.linalg.eigvals(sampled_loop(own, loaded=loaded)[0])).max() < 1.0
    assert fast_radius(own) < 1.0


def test_stiffness_loop_is_stable():
    own, inertia = setting_set(), DISC + SLIDERS * groove_slope() ** 2
    double = expm(PERIOD * np.array([[0.0, 1.0, 0.0], [0.0, -DISC_FRICTION / inertia, 1.0 / inertia], [0.0] * 3]))
    held = 1.0 / (FILTER_TIME + PERIOD)
    rate = np.array([-held, 0.0, 0.0, -held, FILTER_TIME * held])  # over angle, its rate, integral, error before, rate
    torque = np.array([-own.proportional, 0.0, 1.0, 0.0, 0.0]) + own.derivative * rate
    across = np.zeros((5, 5))
    across[:2, :2] = double[:2, :2]
    across[:2] += np.outer(double[:2, 2], torque)
    across[2] = -own.integral * PERIOD, 0.0, 1.0, 0.0, 0.0
    across[3, 0], across[4] = -1.0, rate
    assert np.abs(np.linalg.eigvals(across)).max() < 1.0


def groove_slope() -> float:
    return float(groove().active_length_rate(jnp.asarray(0.4)))


def test_the_deflection_is_a_small_part_of_the_first_error(runs):
    """3.03 degrees, all that the spring may deflect, are under half of 11, and the stored sets use far less."""
    assert paper.DEFLECTION_LIMIT < 0.5 * facts.FIRST_PRINTED
    for name in POSITION_SETS:
        deflection = np.abs(runs[name].courses[:, 1] - runs[name].courses[:, 0]).max()
        assert deflection < paper.DEFLECTION_LIMIT, name
        assert facts.deflection_largest(name=name) < math.radians(1.0)  # in the sine with load
    assert facts.spring_share_margin() < 0.0


def test_without_the_spring_the_first_error_stays(runs):
    own = position_set("sine")
    stiff = position_case(own, loaded=0.0, sine=AMPLITUDE)
    motion = stiff.motion._replace(motion=groove().angle(jnp.asarray(LENGTH_MIN)))
    course = run_one(eqx.tree_at(lambda case: case.motion, stiff, motion), duration=3.0, substeps=4)
    first = sine_numbers(np.asarray(course.state.motion.link)).first
    assert stiffness_at(LENGTH_MIN) > 25.0 * STIFFNESS
    # all but the spring is the same; its share of the error is the deflection, under a tenth
    assert first == pytest.approx(runs["sine"].facts.first_error, rel=0.1)


def test_load_deteriorates_the_first_errors_and_not_the_later_ones():
    """13 and 11 degrees with and without load; later 4 and 6."""
    assert np.degrees(facts.printed_order_margin()) == pytest.approx([4.0 - 6.0, 13.0 - 11.0], rel=1e-12)


def test_numbers_read_off_known_courses():
    time = np.arange(2101) * PERIOD
    since = np.maximum(time - STEP_TIME, 0.0)
    decay, pulsation = 5.0, 20.0
    course = 0.3 * (1.0 - np.exp(-decay * since) * (np.cos(pulsation * since)))
    found = step_numbers(course, 0.0, 0.3)
    peak = since[np.argmax(course)]
    assert found.overshoot == pytest.approx(-math.exp(-decay * peak) * math.cos(pulsation * peak), rel=1e-6)
    assert found.settling <= math.log(50.0) / decay  # where the envelope enters 2 %


def test_length_and_stiffness_are_inverse():
    assert stiffness_at(length_of(437.0)) == pytest.approx(437.0, rel=1e-12)
    assert length_of(STIFFNESS) == pytest.approx(paper.LENGTH_MAX, abs=0.0005)  # rounds to 25 mm


def test_the_stiffness_has_not_arrived_with_the_lever():
    """0.34 s are the lever's: the stiffness is outside 2 % of its step for more than a second."""
    assert facts.setting_fact(fact="regulation_time") < 0.4
    assert not facts.stiffness_settling() < 1.0  # NaN where it never arrives
    assert not math.isnan(facts.setting_fact(fact="regulation_time"))
