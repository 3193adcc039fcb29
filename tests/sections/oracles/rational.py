"""Torsion of polygons by rational functions: poles outside that cluster at the corners, fitted by least squares.

A. Gopal and L. N. Trefethen, "Solving Laplace problems with corner singularities via rational functions", SIAM J.
Numer. Anal. 57 (2019) 2074-2094. The stress function's harmonic part is fitted to |z|^2/2 on the boundary: a Dirichlet
problem, no integral equation, and its convergence is root-exponential at any corner.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np


class Fitted(NamedTuple):
    """J, and the largest misfit of the boundary values over the size squared."""

    torsion_constant: float
    misfit: float


def polygon(corners: list[complex], poles: int) -> Fitted:
    """J of a polygon without holes, corners counter-clockwise."""
    z, step = _samples(np.array(corners))
    centre, size = np.mean(corners), np.abs(np.subtract.outer(corners, corners)).max()
    away = np.concatenate([_poles(corners, n, poles, size) for n in range(len(corners))])
    nearest = np.abs(away[:, None] - np.array(corners)).min(axis=1)
    basis = np.concatenate([_powers((z - centre) / size, poles), nearest / (z[:, None] - away)], axis=1)
    real = np.concatenate([basis.real, -basis.imag[:, 1:]], axis=1)
    conjugate = np.concatenate([basis.imag, basis.real[:, 1:]], axis=1)
    return _solved(z, step, real, conjugate, size)


def regular_polygon(sides: int, poles: int) -> Fitted:
    """J of the regular polygon whose inscribed circle has the diameter 1; everything has its symmetry."""
    corner = 0.5 / np.cos(np.pi / sides)
    side = corner * np.exp(2j * np.pi * np.arange(2) / sides)
    z, step = (part[: part.size // 2] for part in _samples(side))
    away = corner + corner * _distances(poles)
    ratio = (z[:, None] / away) ** sides
    rational = (away / corner - 1.0) / (ratio - 1.0)
    basis = np.concatenate([((z / corner) ** sides)[:, None] ** np.arange(poles // 2), rational], axis=1)
    return _solved(z, step * sides, basis.real, basis.imag, corner)


def _solved(z: np.ndarray, step: np.ndarray, real: np.ndarray, conjugate: np.ndarray, size: float) -> Fitted:
    weight, wanted = np.sqrt(np.abs(step)), 0.5 * np.abs(z) ** 2
    norm = np.linalg.norm(real * weight[:, None], axis=0)
    found = np.linalg.lstsq(real * weight[:, None] / norm, wanted * weight, rcond=1e-15)[0] / norm
    other = conjugate @ found
    # twice the integral of Re f - |z|^2/2; by Green's identity with |z|^2/4, whose Laplacian is 1, and by parts
    flux = (z.conj() * step).imag
    rise = (z.conj() * step).real
    potential = 0.5 * (wanted * flux).sum() + 0.5 * (other * rise).sum()
    polar = 0.25 * (np.abs(z) ** 2 * flux).sum()
    return Fitted(float(2.0 * potential - polar), float(np.abs(real @ found - wanted).max() / size**2))


def _samples(corners: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Gauss points on panels that halve and halve towards both ends of every side, and dz."""
    marks = np.concatenate([[0.0], 2.0 ** -np.arange(36.0, 0.0, -1.0)])
    marks = np.concatenate([marks, 1.0 - marks[-2::-1]])
    t, w = np.polynomial.legendre.leggauss(7)
    width = np.diff(marks)[:, None]
    at, share = (marks[:-1, None] + 0.5 * width * (t + 1.0)).ravel(), (0.5 * width * w).ravel()
    z, step = [], []
    for start, end in zip(corners, np.roll(corners, -1), strict=True):
        z.append(start + at * (end - start))
        step.append(share * (end - start))
    return np.concatenate(z), np.concatenate(step)


def _poles(corners: list[complex], number: int, poles: int, size: float) -> np.ndarray:
    before, here, after = (corners[(number + shift) % len(corners)] for shift in (-1, 0, 1))
    inside = np.angle((before - here) / (after - here)) % (2.0 * np.pi)
    outward = -(after - here) / abs(after - here) * np.exp(0.5j * inside)
    return here + 0.5 * size * outward * _distances(poles)


def _distances(poles: int) -> np.ndarray:
    return np.exp(-4.0 * (np.sqrt(poles) - np.sqrt(np.arange(1, poles + 1))))


def _powers(z: np.ndarray, degree: int) -> np.ndarray:
    """Polynomials made orthogonal on the samples (Arnoldi): powers themselves would be ill-conditioned."""
    columns = [np.ones_like(z)]
    for _ in range(degree):
        new = z * columns[-1]
        for _ in range(2):
            for old in columns:
                new = new - np.vdot(old, new) / z.size * old
        columns.append(new / np.sqrt(np.vdot(new, new).real / z.size))
    return np.stack(columns, axis=1)


def symmetric_curve(z: np.ndarray, step: np.ndarray, rotations: int, degree: int) -> Fitted:
    """J of a smooth star-shaped curve with rotations and a mirror, by powers of z^rotations alone.

    ``z`` and ``step`` are points and dz of a rule along half a sector.
    """
    size = float(np.abs(z).max())
    basis = ((z / size) ** rotations)[:, None] ** np.arange(degree)
    return _solved(z, step * 2.0 * rotations, basis.real, basis.imag, size)
