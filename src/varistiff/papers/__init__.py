"""What four papers print, as data, and what varistiff computes for it.

Each paper has a package named by its citation key: ``claims.yaml`` (every printed statement), ``equations.yaml`` (every
numbered equation), ``figures.yaml`` (every figure), modules with the computations that these files name, and
``corrected_reading.yaml``, a design file with which the paper's numbers are consistent.
"""
