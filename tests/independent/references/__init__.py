"""Reference solvers for elastic leaves: nothing here imports the package or uses elliptic integrals."""
