"""The physics battery: laws that every actuator obeys, run on every kind by parametrisation."""
