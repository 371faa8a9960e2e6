# Everything a visitor needs: `make demo` shows a plan, `make test` proves the whole. Both work in a fresh clone.

CARGO ?= cargo
DEMO ?= examples/twist-free-crowning.toml

# The time at which a stage of `make test` begins.
begins = @date '+at %T: $(1)'

.PHONY: demo release test drawings fuzz setup web types python notebooks docs browser api-fuzz load format check instructions milling-speed dependencies clean

setup:
	@scripts/setup

# The pages of the web application, which become part of the program.
web: setup
	@scripts/web

# The description of the server's interface and of the results, and the types of the pages made from it; after a change of either.
types: setup
	UPDATE_OPENAPI=1 $(CARGO) test --package flankwright-server --test server the_pages_have_this_description
	@scripts/web types

# Plans the first example; the summary names the report. For a program that is used every day: `make release`.
demo: web
	@echo 'Building the profile demo, which skips link-time optimisation and debug information; same numbers as a release.'
	$(CARGO) build --profile demo --package flankwright-cli
	target/demo/flankwright plan $(DEMO)
	@echo 'The same in a browser: target/demo/flankwright serve, then open http://127.0.0.1:8470/'

# The whole program, fully optimised: target/release/flankwright.
release: web
	$(CARGO) build --release --package flankwright-cli

# The command and the wheel are built with `verify`, which recomputes the reference files and stands in no default build.
# Properties are tried on the same inputs each time, so that one text gives one verdict; `cargo test` alone draws new ones.
test: export PROPTEST_RNG_SEED ?= 1
test: setup
	@scripts/postgresql install
	$(call begins,dependencies)
	@scripts/dependencies
	$(call begins,format and clippy)
	$(CARGO) fmt --all -- --check
	$(CARGO) clippy --workspace --all-targets --features verify -- -D warnings
	$(call begins,web pages)
	@scripts/web test
	$(call begins,Rust)
	$(CARGO) test --workspace --features verify --no-run
	$(call begins,tests of Rust)
	$(CARGO) test --workspace --features verify --no-fail-fast
	$(call begins,Python)
	@scripts/python test
	$(call begins,notebooks and documentation)
	@scripts/notebooks
	@scripts/docs
	$(call begins,browser and interface of the server)
	@PROGRAM=target/debug/flankwright scripts/browser
	@PROGRAM=target/debug/flankwright scripts/api-fuzz
	$(call begins,end)

# The Python package in an environment of its own.
python: setup
	@scripts/python

# Its notebooks carried out.
notebooks: python
	@scripts/notebooks

# Pages, package and notebooks as a site in target/docs, which loads nothing from elsewhere.
docs: notebooks
	@scripts/docs

# Ten minutes for each reader of files, as many at once as there are processors.
fuzz: setup
	@scripts/fuzz 600

# The pages in a real browser, and the interface of the server under requests made from its description.
browser api-fuzz: web
	$(CARGO) build --profile demo --package flankwright-cli
	@scripts/$@

# How quickly the server answers under load.
load: release
	@scripts/load

# Licences, versions and origins of all dependencies.
dependencies: setup
	@scripts/dependencies

format:
	$(CARGO) fmt --all

# Quick look while writing.
check:
	$(CARGO) clippy --workspace --all-targets --features verify

# Instructions of one update of the electronic gearbox, each with its limit.
instructions: setup
	@scripts/instruction-counts

# Cutter locations per second beside those of OpenCAMLib's drop cutter, and how long plans of milling take.
milling-speed: setup
	@scripts/opencamlib-peer
	$(CARGO) bench --package flankwright --bench mill_planning

# Plans of the 120 ordinary drawings in crates/generating-grinding/tests/drawings.json: how many are met, missed, refused, and how long they take.
drawings: setup
	$(CARGO) bench --profile demo --package flankwright-generating-grinding --bench drawings

clean:
	$(CARGO) clean
