# Two commands on a fresh machine: `make report` and `make test`.
# Another interpreter: make report PYTHON=python3.12

PYTHON ?= python3
VENV ?= .venv
BUILD ?= build

PIP := $(VENV)/bin/python -m pip --disable-pip-version-check
REPORT := $(BUILD)/report
TREE := $(BUILD)/typecheck
BIN := $(abspath $(VENV))/bin
# The stamps live in the environment, so that removing it removes them.
READY := $(VENV)/.installed
READY_TO_LINT := $(VENV)/.installed-lint
READY_TO_LAB := $(VENV)/.installed-lab

.PHONY: report lab lessons site figures translations test test-rest lint format mutation benchmark sweep clean

# Exit code 2 of the command means that it could not run: then the report of the last run stays.
report: $(READY)
	@$(VENV)/bin/armproof verify course/handouts course/lessons --report $(REPORT); code=$$?; \
	if [ $$code -le 1 ]; then echo "The pages: $(REPORT)/index.html"; fi; exit $$code

# Students work in copies of their own, which are written once: nobody's answers are overwritten.
lab: $(READY_TO_LAB)
	$(VENV)/bin/armproof lesson begin --into my-lessons
	$(VENV)/bin/jupyter lab my-lessons/01_frames.ipynb

lessons: $(READY)
	$(VENV)/bin/armproof lesson build
	$(VENV)/bin/armproof lesson check

site: $(READY)
	$(VENV)/bin/armproof lesson site --out $(BUILD)/site

# One worker more than cores: some tests wait for a browser, a kernel or a clock. The tests of one file share what they load,
# and all their processes what is compiled. Matrices are small: threads of the linear algebra would wait for each other.
WORKERS := $(shell expr $$(nproc) + 1)

test test-rest sweep: export OPENBLAS_NUM_THREADS = 1
test: $(READY)
	ARMPROOF_PART=some $(VENV)/bin/python -m pytest -n $(WORKERS) --dist loadfile

# The cases that `make test` leaves out.
test-rest: $(READY)
	ARMPROOF_PART=rest $(VENV)/bin/python -m pytest -n $(WORKERS) --dist loadfile

# mypy and import-linter follow folders, not the mapping of pyproject.toml: a tree of links shows them the package `armproof`.
lint: $(READY_TO_LINT)
	$(VENV)/bin/ruff check
	$(VENV)/bin/ruff format --check
	@mkdir -p $(TREE)/armproof
	@ln -sfn $(addprefix "$(CURDIR)"/,models verification course armproof/__init__.py armproof/py.typed) $(TREE)/armproof
	@seen=$$(find -L $(TREE) -name '*.py' | wc -l); kept=$$(git ls-files armproof models verification course | grep -c '\.py$$'); \
	test "$$seen" -ge "$$kept" || { echo "$(TREE) shows $$seen of the $$kept files that git keeps" >&2; exit 1; }
	cd $(TREE) && MYPYPATH=. $(BIN)/mypy --config-file "$(CURDIR)/pyproject.toml" --cache-dir "$(CURDIR)/.mypy_cache"
	cd $(TREE) && PYTHONPATH=. $(BIN)/lint-imports --config "$(CURDIR)/pyproject.toml"

format: $(READY_TO_LINT)
	$(VENV)/bin/ruff check --fix
	$(VENV)/bin/ruff format

mutation: $(READY)
	$(VENV)/bin/python -m tests.mutation

benchmark: $(READY)
	$(VENV)/bin/python -m tests.benchmarks

sweep: $(READY)
	ARMPROOF_SWEEP=1 $(VENV)/bin/python -m pytest -n $(WORKERS) --dist loadfile
	$(VENV)/bin/python -m tests.sweeps.claims
	$(VENV)/bin/python -m tests.sweeps.mutants_of_displays
	$(VENV)/bin/python -m tests.sweeps.sentences
	$(VENV)/bin/python -m tests.sweeps.singularities
	$(VENV)/bin/python -m tests.sweeps.inverse
	$(VENV)/bin/python -m tests.sweeps.tracking
	$(VENV)/bin/python -m tests.sweeps.correct
	$(VENV)/bin/python -m tests.sweeps.watch
	$(VENV)/bin/python -m tests.sweeps.interrupted
	$(VENV)/bin/python -m tests.sweeps.grading
	$(VENV)/bin/python -m tests.sweeps.site

figures: $(READY)
	$(VENV)/bin/armproof figures --out $(BUILD)/figures

# Writes what is new into the catalogues, and lists what is to translate.
translations: $(READY)
	$(VENV)/bin/python -m tests.translations

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

$(READY_TO_LAB): $(READY)
	@$(PIP) install --quiet --editable '.[lab]'
	@touch $@

$(READY_TO_LINT): $(READY)
	@$(PIP) install --quiet --editable '.[lint]'
	@touch $@
