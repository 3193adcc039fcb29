"""Elastic laws: energy, load and stress of single elastic elements, one law per file."""

from varistiff.core import precision

precision.enable()
