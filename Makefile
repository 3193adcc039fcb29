# make analyse   the main job on every design in examples/, reports in results/
# make test      every check that a change has to pass
# Both make their own virtual environment in .venv; the second run installs nothing again.

.DEFAULT_GOAL := help
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c

VENV := .venv
BIN := $(VENV)/bin
CORE := $(VENV)/.core
TOOLS := $(VENV)/.tools
BENCHMARK := $(VENV)/.benchmark
PIP := $(BIN)/python -m pip --disable-pip-version-check
# the first interpreter that runs and is new enough; say PYTHON=... to choose another
PYTHON ?= $(shell for python in python3.11 python3.12 python3.13 python3; do \
    "$$python" -c 'import sys; sys.exit(sys.version_info < (3, 11))' 2>/dev/null && echo "$$python" && break; done)

EXAMPLES := $(wildcard examples/*.yaml)
REPORTS := $(EXAMPLES:examples/%.yaml=results/%/report.html)
SOURCES := $(shell find src -type f -not -name '*.pyc' 2>/dev/null)

.PHONY: help analyse test docs benchmark clean

help:
	@sed -n '/^#/!q;s/^# //p' Makefile
	@echo "make docs      the documentation as pages, in docs/_build/html"
	@echo "make benchmark the tables of docs/performance.md"
	@echo "make clean     remove everything that make made"

$(CORE): pyproject.toml constraints.txt
	@test -n "$(PYTHON)" || { echo "varistiff needs Python 3.11 or newer with venv; set PYTHON=..." >&2; exit 1; }
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(PIP) install --quiet --constraint constraints.txt --editable .
	touch $@

$(TOOLS): $(CORE)
	$(PIP) install --quiet --constraint constraints.txt --editable '.[test,docs,dev,fe,dxf]'
	touch $@

$(BENCHMARK): $(TOOLS)
	$(PIP) install --quiet --constraint constraints.txt --editable '.[benchmark]'
	touch $@

results/%/report.html: examples/%.yaml $(CORE) $(SOURCES)
	$(BIN)/varistiff analyse $< --output $(@D)

analyse: $(REPORTS)
	@printf '\nReports:\n'; printf '  %s\n' $(REPORTS)

# pytest comes last, so that its closing line closes the run
test: $(TOOLS)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/sphinx-build -W --keep-going -q -b html docs docs/_build/html
	$(BIN)/pytest -n auto --maxprocesses 4 --dist loadfile

docs: $(TOOLS)
	$(BIN)/sphinx-build -W --keep-going -q -b html docs docs/_build/html
	@echo "docs/_build/html/index.html"

benchmark: $(BENCHMARK)
	$(BIN)/python -m benchmarks

clean:
	rm -rf $(VENV) results docs/_build .mypy_cache .ruff_cache .pytest_cache .import_linter_cache .hypothesis
