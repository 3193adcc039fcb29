"""Parameters as arrays, so that another value does not compile anything again."""

from __future__ import annotations

from typing import TypeVar

import jax
import numpy as np

Tree = TypeVar("Tree")


def numbers_as_arrays(tree: Tree) -> Tree:
    """The same tree with every plain float as an array of no dimension; other leaves stay."""
    converted: Tree = jax.tree.map(lambda leaf: np.asarray(leaf) if isinstance(leaf, float) else leaf, tree)
    return converted
