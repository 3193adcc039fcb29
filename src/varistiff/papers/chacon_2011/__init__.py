"""Chacón et al. (2011): an adjustable-stiffness spring of four antagonistic leaves."""
