# Two commands on a fresh machine: `make report` and `make test`.
# Another interpreter: make report PYTHON=python3.12

PYTHON ?= python3
VENV ?= .venv
BUILD ?= build

PIP := $(VENV)/bin/python -m pip --disable-pip-version-check
VERDICTS := $(BUILD)/report/verdicts.json
# The stamps live in the environment, so that removing it removes them.
READY := $(VENV)/.installed
READY_TO_LINT := $(VENV)/.installed-lint

.PHONY: report test lint format mutation benchmark clean

# Exit code 2 of the command means that it could not run: then the verdicts of the last run stay.
report: $(READY)
	@mkdir -p $(dir $(VERDICTS))
	@$(VENV)/bin/armproof verify course --format json > $(VERDICTS).part; code=$$?; \
	if [ $$code -gt 1 ]; then rm -f $(VERDICTS).part; exit $$code; fi; \
	mv $(VERDICTS).part $(VERDICTS)
	@$(VENV)/bin/armproof verify course

test: $(READY)
	$(VENV)/bin/python -m pytest

lint: $(READY_TO_LINT)
	$(VENV)/bin/ruff check
	$(VENV)/bin/ruff format --check
	$(VENV)/bin/mypy
	$(VENV)/bin/lint-imports

format: $(READY_TO_LINT)
	$(VENV)/bin/ruff check --fix
	$(VENV)/bin/ruff format

mutation: $(READY)
	$(VENV)/bin/python -m tests.mutation

benchmark: $(READY)
	$(VENV)/bin/python -m tests.benchmarks

# Leaves the environment, which takes minutes to build; `rm -rf .venv` removes it.
clean:
	rm -rf $(BUILD) .hypothesis .import_linter_cache .mypy_cache .pytest_cache .ruff_cache
	find models verification course tests -name __pycache__ -type d -prune -exec rm -rf {} +

# pip is the last thing that venv writes: without it, an interrupted set-up starts again.
$(VENV)/bin/pip:
	@command -v $(PYTHON) > /dev/null || { \
	echo "Armproof needs Python 3.11, 3.12 or 3.13, and there is no '$(PYTHON)'. Choose one: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -c 'import sys; sys.exit(not (3, 11) <= sys.version_info[:2] <= (3, 13))' || { \
	echo "Armproof needs Python 3.11, 3.12 or 3.13, and '$(PYTHON)' is $$($(PYTHON) --version 2>&1 | head -n 1). Choose another: make PYTHON=python3.12" >&2; exit 1; }
	$(PYTHON) -m venv $(VENV)

$(READY): pyproject.toml $(VENV)/bin/pip
	@echo "Installing Armproof and Drake into $(VENV): some minutes the first time."
	@$(PIP) install --quiet --editable '.[test]'
	@touch $@

$(READY_TO_LINT): $(READY)
	@$(PIP) install --quiet --editable '.[lint]'
	@touch $@
