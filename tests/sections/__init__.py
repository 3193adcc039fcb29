"""Cross-sections against published numbers, exact solutions, other methods and laws."""
