"""A tree of numbers as one vector: a compiled function takes one argument faster than a hundred."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Generic, NamedTuple, TypeVar

import jax
import numpy as np
from jaxtyping import Array, Float

Tree = TypeVar("Tree")


class Numbers(NamedTuple):
    """Every number of a tree.

    Parameters
    ----------
    scalars : the plain ones, shape (number,)
    arrays : tables and the like, each of its own shape
    """

    scalars: Float[Array | np.ndarray, " number"]
    arrays: tuple[Any, ...]


@dataclass(frozen=True)
class Layout(Generic[Tree]):
    """Everything of a tree but its numbers: what a compilation depends on.

    Parameters
    ----------
    structure : of the tree, as JAX tells it
    scalars, arrays : which of its leaves are plain numbers, and which are tables
    rest : the other leaves, each with its place
    """

    structure: Any
    scalars: tuple[int, ...]
    arrays: tuple[int, ...]
    rest: tuple[tuple[int, Any], ...]

    def tree(self, numbers: Numbers) -> Tree:
        """Put the numbers back into their places."""
        leaves = dict(self.rest) | dict(zip(self.arrays, numbers.arrays, strict=True))
        leaves |= {place: numbers.scalars[index] for index, place in enumerate(self.scalars)}
        return jax.tree.unflatten(self.structure, [leaves[place] for place in range(len(leaves))])

    def numbers(self, tree: Tree) -> Numbers:
        """Numbers of another tree that is laid out alike.

        Raises
        ------
        ValueError : it is not
        """
        leaves, structure = jax.tree.flatten(tree)
        if structure != self.structure or any(leaves[place] != leaf for place, leaf in self.rest):
            raise ValueError("the trees differ in more than numbers")
        scalars = np.array([leaves[place] for place in self.scalars], dtype=float)
        return Numbers(scalars, tuple(np.asarray(leaves[place]) for place in self.arrays))


def pack(tree: Tree) -> tuple[Numbers, Layout[Tree]]:
    """Take a tree apart: its floating-point numbers and arrays, and the rest, whole numbers and flags among it."""
    leaves, structure = jax.tree.flatten(tree)
    places: dict[str, list[int]] = {"scalar": [], "array": [], "rest": []}
    for place, leaf in enumerate(leaves):
        places[_kind(leaf)].append(place)
    rest = tuple((place, leaves[place]) for place in places["rest"])
    layout: Layout[Tree] = Layout(structure, tuple(places["scalar"]), tuple(places["array"]), rest)
    return layout.numbers(tree), layout


def _kind(leaf: Any) -> str:
    if isinstance(leaf, float):
        return "scalar"
    if not isinstance(leaf, jax.Array | np.ndarray):
        return "rest"
    return "scalar" if leaf.ndim == 0 and leaf.dtype == np.float64 else "array"
