# The two commands of the README. Each makes the environment first, once.
PYTHON ?= python3
VENV := .venv
READY := $(VENV)/.ready
DEV_READY := $(VENV)/.ready-dev
CONSTRAINTS := tests/constraints.txt

PEERS := .venv-peers
SIMULATORS := .venv-simulators
PEERS_READY := $(PEERS)/.ready

DOCS := .venv-docs
DOCS_READY := $(DOCS)/.ready

# What is imported is compiled then, a tenth of what is installed, and kept: images for containers often forbid that
# by this variable, and each start would take twice its time.
export PYTHONDONTWRITEBYTECODE :=
INSTALL = $(VENV)/bin/python -m pip install --quiet --disable-pip-version-check --progress-bar on --no-compile -c $(CONSTRAINTS)

# Each Python file with a .pxd beside it is compiled, and again once it changes.
DECLARED := $(shell find gcs simvehicle skytender -name '*.pxd')
BUILT := $(VENV)/.built

.PHONY: run build environments check test test-all release-check bench simulators fuzz faults docs picture gallery clean

run: $(BUILT)
	@$(VENV)/bin/gcs run demo

build: $(READY)
	@$(VENV)/bin/python setup.py --quiet build_ext --inplace
	@touch $(BUILT)

# Of all tests, at once with `make -j2 environments`.
environments: $(DEV_READY) $(PEERS_READY) $(DOCS_READY)

# Tests of single packages: no whole session, no peer, no browser, and none that takes long by itself. CONTRIBUTING.md
# names the folders that are left out.
FAST := tests/test_architecture.py tests/test_walks.py $(filter-out %/test_elementary.py,$(wildcard tests/skytender/*.py)) \
  $(addprefix tests/simvehicle/,autopilot law mavlink world) \
  $(addprefix tests/gcs/,console mavlink missions planner refuelling scenario supervisor telemetry)

check: $(DEV_READY)
	@$(VENV)/bin/ruff check .
	@$(VENV)/bin/ruff format --check .
	@$(VENV)/bin/mypy >$(VENV)/mypy.log & typed=$$!; \
	  $(VENV)/bin/python -m pytest -n auto --dist loadfile --no-loadscope-reorder $(FAST); tested=$$?; \
	  wait $$typed || tested=1; cat $(VENV)/mypy.log; exit $$tested

# The tests are imported once, and workers are forked from there. Many tests wait for real time: four workers for each of
# two processors keep those busy. mypy runs beside them.
test: CHOSEN := -m "not slow"
test test-all: environments
	@$(VENV)/bin/ruff check .
	@$(VENV)/bin/ruff format --check .
	@$(VENV)/bin/mypy >$(VENV)/mypy.log & typed=$$!; \
	  $(VENV)/bin/python tests/support/forked.py 8 --dist loadfile --no-loadscope-reorder $(CHOSEN); tested=$$?; \
	  wait $$typed || tested=1; cat $(VENV)/mypy.log; exit $$tested

# What a release needs, as far as it needs no network: lint, types and the fast tests; the source archive, and of it a
# wheel that flies the demo; the recipes for other repositories, for containers and for conda; action, workflows and
# container as their linters want them; what the release's last job does; one version everywhere.
release-check: check
	@$(VENV)/bin/python -m pytest tests/test_compiled.py $(addprefix tests/system/test_,wheel.py container.py release.py)

bench: $(DEV_READY)
	@$(VENV)/bin/python tests/benchmarks

# The simulators that `make bench` flies the law beside, where they are there: 1.5 GB. gym-pybullet-drones is not on PyPI.
simulators:
	@rm -rf $(SIMULATORS)
	@$(PYTHON) -m venv $(SIMULATORS)
	@$(SIMULATORS)/bin/python -m pip install --quiet --disable-pip-version-check --no-compile --no-deps \
	  -r tests/benchmarks/constraints.txt

# FUZZ="--frames 10000 --files 100 --seed 7" attacks for shorter, and elsewhere.
fuzz: $(DEV_READY)
	@$(VENV)/bin/python tests/fuzz $(FUZZ)

# FAULTS="--moments 3 --only SIGKILL,blackout --hours 0" flies less of it; what has been flown is kept, and --write puts
# the table into docs/faults.md.
faults: $(DEV_READY)
	@$(VENV)/bin/python tests/faults $(FAULTS)

docs: $(DEV_READY) $(DOCS_READY)
	@$(VENV)/bin/python docs/.site/build.py --builder $(DOCS)/bin/python

# The README's pictures: the flight, which needs Chromium, and the console.
picture: $(DEV_READY)
	@$(VENV)/bin/python docs/.site/picture.py
	@$(VENV)/bin/python docs/.site/console_picture.py

# The pictures of docs/gallery.md and of how-to pages, by flights; needs Chromium. GALLERY="demo act" makes only these.
gallery: $(DEV_READY)
	@$(VENV)/bin/python docs/.site/gallery.py $(GALLERY)

clean:
	rm -rf $(VENV) $(PEERS) $(SIMULATORS) $(DOCS) .docs-site .mypy_cache .ruff_cache build
	find gcs simvehicle skytender -name '*.so' -delete

$(READY): pyproject.toml $(CONSTRAINTS)
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo "Skytender needs Python 3.11 or newer; set one with: make PYTHON=python3.12 $(MAKECMDGOALS)"; exit 2; }
	@$(PYTHON) -c 'import ensurepip, venv' 2>/dev/null || \
	  { echo "Python's venv module is missing: install it (Debian, Ubuntu: apt install python3-venv) and call make again."; exit 2; }
	@.ci/compiler $(PYTHON)
	@echo "[1/3] making the environment in $(VENV)"
	@$(PYTHON) -m venv $(VENV)
	@echo "[2/3] installing what compiles Skytender"
	@$(INSTALL) setuptools cython
	@echo "[3/3] compiling Skytender, and installing what it needs beside that (half a minute)"
	@$(VENV)/bin/python setup.py --quiet build_ext --inplace >$(VENV)/compile.log & compiling=$$!; \
	  $(VENV)/bin/python .ci/needs $(EXTRAS) | $(INSTALL) -r /dev/stdin; installed=$$?; \
	  wait $$compiling && exit $$installed
	@$(INSTALL) --no-build-isolation --no-deps -e .
	@touch $@

$(BUILT): $(READY) setup.py $(DECLARED) $(wildcard $(DECLARED:.pxd=.py))
	@$(VENV)/bin/python setup.py --quiet build_ext --inplace
	@touch $@

# Of an environment that is made for these, all is installed at once: prerequisites know the extras too.
$(DEV_READY): EXTRAS := dev
$(DEV_READY): $(READY) $(BUILT)
	@echo "[tests] installing what only tests, benchmarks and documentation need"
	@$(VENV)/bin/python .ci/needs $(EXTRAS) | $(INSTALL) -r /dev/stdin
	@touch $@

# MAVSDK and MAVProxy, which only tests/peers run; without MAVProxy's graphical part, whole it is 1.2 GB. Where they cannot
# be had, those tests are skipped with the reason, and the next call tries again.
$(PEERS_READY): tests/peers/constraints.txt
	@echo "[peers] installing MAVSDK and MAVProxy for the tests in $(PEERS)"
	@rm -rf $(PEERS)
	@$(PYTHON) -m venv $(PEERS)
	@if $(PEERS)/bin/python -m pip install --quiet --disable-pip-version-check --no-compile --no-deps -r $< 2>$(PEERS)/pip.log; \
	  then touch $@; \
	  else { echo "MAVSDK and MAVProxy could not be installed:"; tail -n 1 $(PEERS)/pip.log; } | tee $(PEERS)/missing; fi

# What builds the documentation's site, for `make docs` and the test that builds it.
$(DOCS_READY): docs/.site/requirements.txt
	@echo "[docs] installing the documentation's builder in $(DOCS)"
	@rm -rf $(DOCS)
	@$(PYTHON) -m venv $(DOCS)
	@$(DOCS)/bin/python -m pip install --quiet --disable-pip-version-check -r $< 2>$(DOCS)/pip.log || \
	  { echo "The documentation's builder (docs/.site/requirements.txt) could not be installed:"; tail -n 1 $(DOCS)/pip.log; \
	    echo "The pages can be read as they are, in docs/."; exit 2; }
	@touch $@
