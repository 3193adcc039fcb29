"""dos Santos and Richter (2019): a cantilever under a moving roller."""
