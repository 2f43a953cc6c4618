# make demo and make test do all the set-up on a fresh machine with Python 3.11+.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
KERNELS := $(wildcard src/swarmgrasp/kernels/*.[ch] src/swarmgrasp/kernels/python/*.[ch])

# Warnings are errors here, but where the package is installed for use: make WARNINGS= builds anyway.
WARNINGS := -Wall -Wextra -Werror

.PHONY: demo test test-c test-long test-oldest test-newest lint docs packages dist bench paper page page-tools lock clean

demo: $(VENV)/installed
	mkdir -p demo
	$(BIN)/swarmgrasp place deck-barge --plot demo/deck-barge.png --json demo/deck-barge.json
	$(BIN)/swarmgrasp verify demo/deck-barge.json

test: $(VENV)/developing
	$(BIN)/python -m pytest -n 2 --dist worksteal

# The kernels without Python, under sanitizers, each allocation and each look at the keyboard failing
# once; what is never freed is counted there, which works under a debugger too.
test-c: build/test-c
	ASAN_OPTIONS=detect_leaks=0 build/test-c

build/test-c: $(wildcard tests/c/*.[ch]) $(KERNELS)
	mkdir -p build
	$(CC) -std=c11 -pedantic $(WARNINGS) -Wshadow -Wconversion -Wvla -O1 -g -ffp-contract=off \
		-fsanitize=address,undefined -fno-sanitize-recover=all \
		-Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc,--wrap=free \
		-o $@ $(filter tests/%.c,$^) $(wildcard src/swarmgrasp/kernels/*.c) -lm

test-long: $(VENV)/developing
	$(BIN)/python -m pytest -n 2 --dist worksteal -m long -o timeout=3600

# The quick tests with the oldest and the newest versions that pyproject.toml allows. That packages
# have deprecated what other packages of another age use is no fault of ours.
test-oldest: .venv-oldest/installed
	.venv-oldest/bin/python -m pytest -q -n 2 --dist worksteal -W ignore::DeprecationWarning

test-newest: .venv-newest/installed
	.venv-newest/bin/python -m pytest -q -n 2 --dist worksteal -W ignore::DeprecationWarning

lint: $(VENV)/developing
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports

docs: $(VENV)/documenting
	$(BIN)/sphinx-build -q -W --keep-going docs docs/_build/html
	$(BIN)/python tools/check_site.py docs/_build/html
	$(BIN)/python tools/browse_site.py docs/_build/html

bench: $(VENV)/benchmarking
	$(BIN)/python benchmarks/run.py

# The source paper made again, a few minutes: demo/paper/paper.html
paper: $(VENV)/developing
	mkdir -p demo
	$(BIN)/swarmgrasp paper demo/paper

# The page of the studio from its sources: with Node, which users of the package need not have.
CLIENT := src/swarmgrasp/gui/client
page: page-tools
	cd $(CLIENT) && npm run --silent check && npm run --silent build

page-tools: $(CLIENT)/node_modules/.package-lock.json

$(CLIENT)/node_modules/.package-lock.json: $(CLIENT)/package-lock.json
	cd $(CLIENT) && npm ci --silent --ignore-scripts --no-audit --no-fund

$(VENV)/locked: requirements.lock
	$(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements.lock
	touch $@

# The package itself goes in last, from this folder, without fetching anything.
define INSTALL
PYTHONWARNINGS=ignore CPPFLAGS='$(CPPFLAGS) $(WARNINGS)' $(1)/bin/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation -e .
touch $(1)/installed
endef

$(VENV)/installed: $(VENV)/locked pyproject.toml $(KERNELS)
	@command -v cc >/dev/null || { echo "a C compiler is needed, such as Debian's gcc and libc6-dev" >&2; exit 1; }
	$(call INSTALL,$(VENV))

$(VENV)/developing: $(VENV)/locked requirements-dev.lock | $(VENV)/installed
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-dev.lock
	touch $@

$(VENV)/packing: $(VENV)/locked requirements-packing.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-packing.lock
	touch $@

$(VENV)/benchmarking: $(VENV)/developing requirements-bench.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-bench.lock
	touch $@

$(VENV)/documenting: $(VENV)/developing requirements-docs.lock
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r requirements-docs.lock
	touch $@

.venv-oldest/installed: requirements-oldest.lock pyproject.toml $(KERNELS)
	$(PYTHON) -m venv .venv-oldest
	.venv-oldest/bin/python -m pip install --quiet --disable-pip-version-check --require-hashes -r $<
	$(call INSTALL,.venv-oldest)

.venv-newest/installed: pyproject.toml $(KERNELS)
	$(PYTHON) -m venv .venv-newest
	.venv-newest/bin/python -m pip install --quiet --disable-pip-version-check --upgrade '.[build,test]'
	$(call INSTALL,.venv-newest)

LOCK := uv pip compile --quiet --universal --python-version 3.11 --generate-hashes --no-emit-index-url \
	--no-emit-find-links --no-header --no-annotate pyproject.toml

# The packages, as an index takes them: dist/. The wheel is tried where there is no compiler.
packages: $(VENV)/packing
	rm -rf dist build/wheel && mkdir -p dist
	$(BIN)/python -m build --no-isolation --sdist --outdir dist .
	$(BIN)/python -m build --no-isolation --wheel --outdir build/wheel .
	PATH="$(CURDIR)/$(BIN):$$PATH" $(BIN)/auditwheel repair --wheel-dir dist build/wheel/*.whl
	$(BIN)/abi3audit --strict --summary dist/*.whl
	$(BIN)/twine check --strict dist/*
	$(BIN)/python tools/try_packages.py --wheel dist

# Both of them, with every Python that can be had and all quick tests: TRY="--python 3.12" for one.
dist: packages
	$(BIN)/python tools/try_packages.py $(TRY) dist

lock:
	$(LOCK) --upgrade --extra build -o requirements.lock
	$(LOCK) --upgrade --extra build --extra dev -o requirements-dev.lock
	$(LOCK) --upgrade --extra build --extra dev --extra docs -o requirements-docs.lock
	$(LOCK) --upgrade --extra build --extra dev --extra bench -o requirements-bench.lock
	$(LOCK) --upgrade --extra build --extra packing -o requirements-packing.lock
	$(LOCK) --resolution lowest-direct --extra build --extra test -o requirements-oldest.lock

clean:
	rm -rf $(VENV) .venv-oldest .venv-newest build demo dist docs/_build docs/generated .pytest_cache .hypothesis .mypy_cache .ruff_cache .import_linter_cache
	rm -f src/swarmgrasp/kernels/*.so
	find . -name __pycache__ -type d -prune -exec rm -rf {} +
