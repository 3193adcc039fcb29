"""What every room needs: status codes, errors, quantities at the edge, citations, files."""
