"""Tests of the report and the datasheet."""
