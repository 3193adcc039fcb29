"""Joints in motion: plant, drives, storage, control, integration and the energy audit."""

from varistiff.core import precision
from varistiff.dynamics.small_loops import compile_small_loops_whole

compile_small_loops_whole()
precision.enable()
