"""The report of a simulation: figures, the mechanism in motion, one HTML page, and the data."""
