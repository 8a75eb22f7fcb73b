# make demo        build FMUs of a four-bar and of a worn slider-crank, run them in fmpy, show what they conserve
# make test        everything CI runs: format, lint, types, import contracts, C warnings, tests
# make long        what takes longer: long tests, sanitize, hostile, coverage
# make hostile     random bad input at length: make hostile SEED=7 N=5000 ATTACKS="scenes states"
# make coverage    which functions, lines and branches of the kernel run in the tests of make test (needs gcc)
# make sanitize    the kernel under ASan and UBSan: all scenes and orders (needs gcc)
# make docs        the documentation site, in build/docs; its examples are run, and a warning is an error
# make linkcheck   whether the site's links to other sites lead somewhere
# make benchmark   time and accuracy, on this machine
# make importers   run our FMUs in the tools of docs/importers.md (ecospy needs Debian's libtbb12)
# make platforms   native FMUs of other platforms, in wine and qemu-user where these are installed
# make release     an archive of the sources and wheels of all platforms in dist/, and tests of these
# make viewer      bundle the scripts of reports again (needs node and npm)
# make browser     look at reports and live pages in a browser of this machine: chromium
# make cofmupy     the same in cofmupy, which is large
# make kernel      compile the C kernel and nothing else
# make clean       back to a fresh clone
#
# Each makes or reuses .venv and needs only Python (PYTHON=... chooses which), pip and make.

PYTHON ?= python3
JOBS ?= 2
SEED ?= 1
N ?= 5000
ATTACKS ?=

VENV := .venv
BIN := $(VENV)/bin
COFMUPY := .venv-cofmupy
PIP := $(BIN)/python -m pip --disable-pip-version-check
INSTALL := $(PIP) install --quiet --no-compile --editable
# Of the kernel of who changes it: a newer compiler than ours may warn, and stops no user.
WARNINGS := -Werror -Wshadow -Wcast-qual -Wconversion -Wno-sign-conversion
BUILD := pyproject.toml $(wildcard build_kernel/*.py solver/kernel/*.[ch] solver/kernel/*/*.[ch] solver/kernel/*.py) \
    $(wildcard fmu_src/native/*.c fmu_src/native/*.h fmu_src/native/*.def) build_fmu/platforms.py \
    solver/runtime/layout.py solver/runtime/errors.py

.PHONY: demo test tests long lint style types sanitize hostile coverage docs linkcheck benchmark importers platforms viewer browser browser-tools release cofmupy kernel clean

demo: $(VENV)/installed
	@$(BIN)/python -m examples.demo
	@$(BIN)/python -m examples.clearance

test: style
	@$(MAKE) -j 2 types tests

tests: $(VENV)/installed-tools
	$(BIN)/python -m pytest -n $(JOBS) -m "not long"

long: $(VENV)/installed-truth
	$(BIN)/python -m pytest -n $(JOBS) -m long
	$(MAKE) sanitize hostile coverage

lint: style types

style: $(VENV)/installed-tools
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/lint-imports

types: $(VENV)/installed-tools
	$(BIN)/pyright --pythonpath $(BIN)/python

sanitize: $(VENV)/installed-tools
	$(BIN)/python -m tests.sanitize

hostile: $(VENV)/installed-tools
	$(BIN)/python -m tests.hostile --seed $(SEED) --count $(N) $(ATTACKS)

coverage: $(VENV)/installed-tools
	$(BIN)/python -m tests.coverage -n $(JOBS)

docs: $(VENV)/installed-docs
	$(BIN)/python -m sphinx -W --keep-going -q -E -d build/doctrees docs build/docs
	@echo build/docs/index.html

linkcheck: $(VENV)/installed-docs
	@if $(BIN)/python -c 'import socket; socket.create_connection(("github.com", 443), 10)' 2>/dev/null; \
	then $(BIN)/python -m sphinx -b linkcheck -q -D nb_execution_mode=off -D suppress_warnings=myst-nb.lexer -d build/doctrees docs build/links; \
	else echo "no network: links to other sites are not looked at"; fi

benchmark: $(VENV)/installed-benchmarks
	$(BIN)/python -m benchmarks

importers: export IMPORTERS = fmpy libcosimpy ecospy pathsim-fmi fmu-manipulation-toolbox
importers: $(VENV)/installed-importers
	$(BIN)/python -m pytest -n $(JOBS) -rs tests/importers
	@$(BIN)/python -m tests.importers.page

platforms: $(VENV)/installed-platforms
	$(BIN)/python -m build_kernel --all
	$(BIN)/python -m pytest -rs tests/platforms

release: $(VENV)/installed-release
	$(BIN)/python -m build_kernel.release
	$(BIN)/python -m pytest -rs tests/release

viewer:
	cd viewer && npm ci --silent && npm run --silent build

browser-tools: $(VENV)/installed-browser
	@cd viewer && npm ci --silent || echo "no npm, or no network: axe-core does not look at the pages"

browser: browser-tools
	$(BIN)/python -m pytest -n $(JOBS) --dist loadfile -rs -m "not long" tests/viewer/test_browser.py tests/viewer/test_live_browser.py

cofmupy: export IMPORTERS = cofmupy
cofmupy: export COFMUPY_PYTHON = $(CURDIR)/$(COFMUPY)/bin/python
cofmupy: $(VENV)/installed-importers $(COFMUPY)/installed
	$(BIN)/python -m pytest -rs tests/importers/test_coupled.py -k cofmupy
	@$(BIN)/python -m tests.importers.page

kernel:
	$(PYTHON) -m build_kernel

clean:
	rm -rf $(VENV) $(COFMUPY) viewer/node_modules build dist docs/generated *.egg-info solver/runtime/_kernel fmu_src/native/_libraries
	rm -rf .pytest_cache .ruff_cache .hypothesis .import_linter_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

# The environment. A newer source of the kernel or pyproject.toml installs again, which compiles the kernel.

$(VENV)/created:
	@$(PYTHON) -c 'import sys; sys.version_info >= (3, 10) or sys.exit("holonom needs Python 3.10 or newer, and $(PYTHON) is %d.%d; remedy: make PYTHON=python3.12" % sys.version_info[:2])'
	@echo "creating $(VENV)"
	@# Debian's Python comes without ensurepip: its pip then installs another one into the environment.
	@$(PYTHON) -m venv $(VENV) >/dev/null 2>&1 || { \
	    rm -rf $(VENV); \
	    $(PYTHON) -m venv --without-pip $(VENV) && $(PYTHON) -m pip --python $(BIN)/python install --quiet pip; }
	@touch $@

$(VENV)/installed: $(VENV)/created $(BUILD)
	@echo "installing holonom and what it needs (some minutes, the first time)"
	@$(INSTALL) .
	@touch $@

$(VENV)/installed-tools: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and the tools that check it (some minutes, the first time)"
	@$(INSTALL) '.[test,lint]' -C cflags="$(WARNINGS)"
	@touch $@ $(VENV)/installed

$(VENV)/installed-truth: $(VENV)/installed-tools
	@echo "installing what random mechanisms are compared with: MuJoCo and Pinocchio"
	@$(PIP) install --quiet --no-compile $$($(BIN)/python -c 'from importlib.metadata import requires; \
	    print(*(x.partition(";")[0] for x in requires("holonom") if x.endswith("extra == \"truth\"")))')
	@touch $@

$(VENV)/installed-docs: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and what its documentation needs"
	@$(INSTALL) '.[docs]'
	@touch $@ $(VENV)/installed

$(VENV)/installed-benchmarks: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and what benchmarks need"
	@$(INSTALL) '.[test,benchmarks]'
	@touch $@ $(VENV)/installed

$(VENV)/installed-importers: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and importers of FMUs"
	@$(INSTALL) '.[test,importers]'
	@touch $@

$(VENV)/installed-platforms: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and compilers for all platforms (400 MB)"
	@$(INSTALL) '.[test,platforms]'
	@touch $@

$(VENV)/installed-release: $(VENV)/created $(BUILD)
	@echo "installing holonom, what it needs, and compilers for all platforms (400 MB)"
	@$(INSTALL) '.[test,release]'
	@touch $@

# Its packages alone: to install holonom again would compile the kernel again.
$(VENV)/installed-browser: $(VENV)/installed-tools
	@echo "installing what drives a browser"
	@$(PIP) install --quiet --no-compile $$($(BIN)/python -c 'from importlib.metadata import requires; \
	    print(*(x.partition(";")[0] for x in requires("holonom") if x.endswith("extra == \"browser\"")))')
	@touch $@

$(COFMUPY)/installed: $(VENV)/created
	@echo "installing cofmupy (1 GB, some minutes)"
	@$(PYTHON) -m venv --without-pip $(COFMUPY)
	@$(PIP) --python $(COFMUPY)/bin/python install --quiet cofmupy
	@touch $@
