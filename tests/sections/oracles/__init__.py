"""Values that the project's own solver had no part in."""
