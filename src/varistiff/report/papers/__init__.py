"""Our figures of what the papers computed, one module a paper."""
