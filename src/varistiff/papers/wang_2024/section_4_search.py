"""Search for what the joint of Wang et al. (2024) needs to show what the paper prints in its Section 4.

``python -m varistiff.papers.wang_2024.section_4_search`` searches, in two to three minutes of one core, and writes the
sets to section_4.yaml, which ``section_4`` reads.
"""

from __future__ import annotations

import math
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from varistiff.papers.wang_2024.section_4_cases import PositionSet, SettingSet
from varistiff.papers.wang_2024.section_4_runs import (
    RUNS,
    PositionFacts,
    SettingFacts,
    position_courses,
    position_facts,
    setting_facts,
    setting_runs,
)
from varistiff.papers.wang_2024.section_4_stability import fast_radius

FILE = Path(__file__).with_name("section_4.yaml")
SEED = 1
COARSE, BEST, GENERATIONS, POLISH, CHUNK = 512, 48, 46, 150, 128
CALM = 0.997  # decay of the fast poles a sample
DIGITS = 3  # of the stored numbers
WORST = 400.0  # of one fact, so that a hopeless one does not hide the others; also of a run that does not settle


class Aim(NamedTuple):
    """A printed fact as the search sees it, SI: its value, and what counts as one step away from it.

    A step is half of the last printed digit; of a time, which is knife-edge, 0.01 to 0.05 s.
    """

    fact: str
    printed: float
    scale: float


BY_LOAD = (
    Aim("small_overshoot_by_load", 0.05, 0.005),
    Aim("small_settling_by_load", 0.25, 0.05),
    Aim("large_overshoot_by_load", 0.15, 0.005),
    Aim("large_settling_by_load", 0.16, 0.05),
)
BY_STROKE = (*BY_LOAD[:2], Aim("overshoot_by_stroke", 0.15, 0.005), Aim("settling_by_stroke", 0.16, 0.05))
FIRST = (
    Aim("first_error", math.radians(11.0), math.radians(0.5)),
    Aim("first_error_loaded", math.radians(13.0), math.radians(0.5)),
)
SINE = (
    *FIRST,
    Aim("later_error", math.radians(4.0), math.radians(0.5)),
    Aim("later_error_loaded", math.radians(6.0), math.radians(0.5)),
)
SINE_AS_PRINTED = (*FIRST, SINE[2]._replace(printed=math.radians(6.0)), SINE[3]._replace(printed=math.radians(4.0)))
SETTING = (
    Aim("regulation_time", 0.34, 0.01),
    Aim("regulation_time_loaded", 0.34, 0.034),
    Aim("stiffness_error", 10.0, 0.5),
    Aim("stiffness_error_loaded", 16.0, 0.5),
)
# not printed, but a loop beyond them would not be called good
CEILINGS = (
    Aim("small_overshoot", 0.35, 0.03),
    Aim("large_overshoot", 0.35, 0.03),
    Aim("small_settling", 1.2, 0.1),
    Aim("large_settling", 1.2, 0.1),
)
# below the band of 2 % the settling time of the lever is no knife-edge
SETTING_CEILINGS = (Aim("lever_overshoot", 0.015, 0.002), Aim("lever_overshoot_loaded", 0.015, 0.002))

# what a joint of 4 kg and 140 mm could have, SI units: a motor of 50 to 200 W behind belt and gear
_BOUNDS = {
    "load_inertia": (0.005, 0.3),
    "drive_inertia": (0.008, 0.1),
    "drive_friction": (0.05, 1.0),
    "proportional": (5.0, 200.0),
    "integral": (0.1, 200.0),
    "derivative": (0.1, 5.0),
    "limit": (1.0, 8.0),
    "small": (math.radians(5.0), math.radians(30.0)),
    "large": (math.radians(30.0), math.radians(90.0)),
    "load_torque": (0.02, 6.0),
}
# a derivative above 0.5 N m s/rad makes the sampled loop of the disc chatter
_SETTING_BOUNDS = np.array([(0.5, 20.0), (0.1, 100.0), (0.005, 0.5), (0.005, 0.03), (0.02, 4.0)])


class Quest(NamedTuple):
    """One search.

    Parameters
    ----------
    aims : the facts to meet together
    generations : how long to search
    tests : the runs that it takes
    ceilings : what must not be exceeded
    calm : whether the spring's motion has to die out
    """

    aims: tuple[Aim, ...]
    generations: int = GENERATIONS
    tests: tuple[str, ...] = RUNS
    ceilings: tuple[Aim, ...] = CEILINGS
    calm: bool = False


_SINES = ("small", "small_loaded", "sine", "sine_loaded")
# a loop that follows a sine for three seconds may still be unstable with load: its small step has to settle
_STABLE = (CEILINGS[0], CEILINGS[2], Aim("small_settling_by_load", 0.3, 0.1))
QUESTS = {
    "steps": Quest(BY_LOAD, 2 * GENERATIONS, RUNS[:4]),
    "steps_by_stroke": Quest(BY_STROKE, GENERATIONS, RUNS[:3]),
    "sine": Quest(SINE, GENERATIONS, _SINES, _STABLE, True),
    "sine_as_printed": Quest(SINE_AS_PRINTED, GENERATIONS, _SINES, _STABLE, True),
    "steps_and_sine": Quest((*BY_LOAD, *SINE)),
}


class Found(NamedTuple):
    """The best set of a search, what it misses (sum of squares, in steps of the aims), and how many runs it took."""

    values: tuple[float, ...]
    cost: float
    simulations: int


def misses(facts: PositionFacts | SettingFacts, aims: tuple[Aim, ...]) -> dict[str, float]:
    """How far each fact lies from what is printed, in steps of its aim."""
    return {aim.fact: (getattr(facts, aim.fact) - aim.printed) / aim.scale for aim in aims}


def cost_of(
    facts: PositionFacts | SettingFacts, aims: tuple[Aim, ...], ceilings: tuple[Aim, ...], worst: float = WORST
) -> float:
    """Sum of squares over the aims, and over what lies above the ceilings, each at most ``worst``."""
    over = (max((getattr(facts, top.fact) - top.printed) / top.scale, 0.0) for top in ceilings)
    squares = np.square([*misses(facts, aims).values(), *over])
    return float(np.minimum(np.nan_to_num(squares, nan=worst), worst).sum())


def unrest(own: PositionSet) -> float:
    """What a set costs whose spring does not come to rest in a third of a second."""
    return float(max((fast_radius(own) - CALM) / 0.001, 0.0) ** 2)


def search_position(name: str, start: Sequence[PositionSet] = ()) -> Found:
    """Best ``PositionSet`` for one of ``QUESTS``; ``start`` are sets to start from beside the random ones."""
    quest = QUESTS[name]
    bounds = np.log(np.array(list(_BOUNDS.values())))

    def costs(places: np.ndarray) -> np.ndarray:
        sets = _stored(places)
        courses = position_courses(sets, quest.tests)
        own = zip(sets, courses, strict=True)
        found = ((PositionSet(*one), run) for one, run in own)
        return np.array(
            [
                cost_of(position_facts(one, run), quest.aims, quest.ceilings) + (unrest(one) if quest.calm else 0.0)
                for one, run in found
            ]
        )

    known = np.log(np.array(start).reshape(-1, len(bounds)))
    place, cost, evaluations = _search(costs, bounds, start=np.clip(known, *bounds.T), generations=quest.generations)
    return Found(tuple(_stored(place).tolist()), cost, evaluations * len(quest.tests))


def search_setting(own: PositionSet) -> Found:
    """Best ``SettingSet`` beside a position set."""

    def costs(places: np.ndarray) -> np.ndarray:
        runs = zip(*setting_runs(own, _stored(places)), strict=True)
        return np.array([cost_of(setting_facts(*pair), SETTING, SETTING_CEILINGS, 100.0) for pair in runs])

    place, cost, evaluations = _search(costs, np.log(_SETTING_BOUNDS), coarse=COARSE // 2, generations=28, best=28)
    return Found(tuple(_stored(place).tolist()), cost, evaluations * 4)


def _search(
    costs: Callable[[np.ndarray], np.ndarray],
    bounds: np.ndarray,
    start: np.ndarray | None = None,
    coarse: int = COARSE,
    generations: int = GENERATIONS,
    best: int = BEST,
) -> tuple[np.ndarray, float, int]:
    """Sobol points, then differential evolution from the best of them, then a simplex; place, cost and evaluations."""
    from scipy.optimize import differential_evolution, minimize
    from scipy.stats import qmc

    points = qmc.scale(qmc.Sobol(len(bounds), seed=SEED).random(coarse), *bounds.T)
    if start is not None:
        points = np.concatenate([start, points])
    first = np.concatenate([costs(points[at : at + CHUNK]) for at in range(0, len(points), CHUNK)])
    bred = differential_evolution(
        lambda places: costs(places.T),
        bounds,
        vectorized=True,
        updating="deferred",
        init=points[np.argsort(first)[:best]],
        mutation=(0.3, 0.9),
        maxiter=generations,
        polish=False,
        tol=0.0,
        seed=SEED,
    )
    simplex = minimize(
        lambda place: float(costs(place[None])[0]),
        bred.x,
        method="Nelder-Mead",
        bounds=bounds,
        options={"maxfev": POLISH, "initial_simplex": bred.x + 0.03 * np.eye(len(bounds) + 1, len(bounds), -1)},
    )
    return simplex.x, float(simplex.fun), len(points) + best * (bred.nit + 1) + int(simplex.nfev)


def _stored(places: np.ndarray) -> np.ndarray:
    """Numbers of logarithms, rounded as they are stored: a knife-edge settling time must survive that."""
    return np.array([rounded(value) for value in np.exp(places).ravel()]).reshape(places.shape)


def rounded(value: float) -> float:
    """As many digits as are stored."""
    return float(f"{value:.{DIGITS}g}")


def search(tell: Callable[[str], None] = lambda text: None) -> dict[str, Any]:
    """Every search, as section_4.yaml holds it."""
    sets: dict[str, Any] = {}
    for name, quest in QUESTS.items():
        before = [PositionSet(**entry["values"]) for entry in sets.values()] if name == "steps_and_sine" else []
        found = search_position(name, before)
        own = PositionSet(*found.values)
        facts = position_facts(own, position_courses(np.array([own]))[0])
        sets[name] = _entry(own, found, facts, quest.aims)
        tell(f"{name}: cost {found.cost:.3g}")
    beside = PositionSet(**sets["steps"]["values"])
    found = search_setting(beside)
    setting = SettingSet(*found.values)
    steps, sines = setting_runs(beside, np.array([setting]))
    sets["stiffness"] = _entry(setting, found, setting_facts(steps[0], sines[0]), SETTING)
    tell(f"stiffness: cost {found.cost:.3g}")
    return {"seed": SEED, "digits": DIGITS, "sets": sets}


def _entry(
    own: PositionSet | SettingSet, found: Found, facts: PositionFacts | SettingFacts, aims: tuple[Aim, ...]
) -> dict[str, Any]:
    off = misses(facts, aims)
    return {
        "values": own._asdict(),
        "cost": rounded(found.cost),
        "simulations": found.simulations,
        "meets": [fact for fact, steps in off.items() if abs(steps) <= 1.0],
        "misses": [fact for fact, steps in off.items() if not abs(steps) <= 1.0],
    }


def text_of(result: dict[str, Any]) -> str:
    """The file that ``search`` stands for."""
    return "\n".join(_lines(result)) + "\n"


def _lines(result: dict[str, Any]) -> Iterator[str]:
    yield "# Numbers that the paper does not print, in SI units, found by"
    yield "# python -m varistiff.papers.wang_2024.section_4_search"
    yield "# cost: sum of squared distances from the printed facts, each in steps of its aim there"
    yield f"seed: {result['seed']}"
    yield f"digits: {result['digits']}"
    yield "sets:"
    for name, entry in result["sets"].items():
        yield f"  {name}:"
        yield "    values:"
        yield from (f"      {field}: {value!r}" for field, value in entry["values"].items())
        yield f"    cost: {entry['cost']!r}"
        yield f"    simulations: {entry['simulations']}"
        for key in ("meets", "misses"):
            yield f"    {key}: [{', '.join(entry[key])}]"


def main() -> None:
    """Search and write the file."""
    start = time.process_time()
    result = search(lambda text: print_line(f"{time.process_time() - start:6.1f} s  {text}"))
    FILE.write_text(text_of(result), encoding="utf-8", newline="\n")


def print_line(text: str) -> None:
    """Write one line to the terminal."""
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()
