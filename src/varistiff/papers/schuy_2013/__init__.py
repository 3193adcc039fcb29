"""Schuy et al. (2013): an elastic element of variable torsion stiffness."""
