"""What docs/performance.md states, measured: ``python -m benchmarks`` writes its tables."""
