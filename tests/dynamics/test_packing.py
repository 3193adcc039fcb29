"""A tree taken apart and put together is the same tree."""

from __future__ import annotations

import jax.numpy as jnp
import numpy as np
import pytest

from varistiff.dynamics.packing import pack

TREE = {"gain": 2.5, "table": np.array([1.0, 2.0]), "count": 3, "flag": True, "at": jnp.asarray(0.5), "name": "x"}


def test_numbers_go_back_to_their_places() -> None:
    numbers, layout = pack(TREE)
    np.testing.assert_array_equal(np.sort(numbers.scalars), [0.5, 2.5])
    again = layout.tree(numbers)
    assert {key: again[key] for key in ("gain", "count", "flag", "name")} == {
        "gain": 2.5,
        "count": 3,
        "flag": True,
        "name": "x",
    }
    assert float(again["at"]) == 0.5
    np.testing.assert_array_equal(again["table"], [1.0, 2.0])


def test_alike_trees_share_a_layout_and_others_do_not() -> None:
    _, layout = pack(TREE)
    other = {**TREE, "gain": 7.0}
    assert pack(other)[1] == layout
    assert hash(pack(other)[1]) == hash(layout)
    assert sorted(layout.numbers(other).scalars) == [0.5, 7.0]
    for changed in ({"count": 4}, {"name": "y"}, {"flag": False}):
        with pytest.raises(ValueError, match="differ"):
            layout.numbers({**TREE, **changed})
    with pytest.raises(ValueError, match="differ"):
        layout.numbers({"gain": 1.0})
