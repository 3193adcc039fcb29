"""Checks against methods that share no formula with the package."""
