# Everything a visitor needs: `make demo` shows a plan, `make test` proves the whole. Both work in a fresh clone.

CARGO ?= cargo
DEMO ?= examples/twist-free-crowning.toml

.PHONY: demo test setup format check instructions milling-speed clean

setup:
	@scripts/setup

# Plans the first example; the summary names the report.
demo: setup
	$(CARGO) build --release --package flankwright-cli
	target/release/flankwright plan $(DEMO)

test: setup
	@scripts/postgresql install
	$(CARGO) fmt --all -- --check
	$(CARGO) clippy --workspace --all-targets -- -D warnings
	$(CARGO) test --workspace --no-fail-fast

format:
	$(CARGO) fmt --all

# Quick look while writing.
check:
	$(CARGO) clippy --workspace --all-targets

# Instructions of one update of the electronic gearbox, each with its limit.
instructions: setup
	@scripts/instruction-counts

# Cutter locations per second beside those of OpenCAMLib's drop cutter, and how long plans of milling take.
milling-speed: setup
	@scripts/opencamlib-peer
	$(CARGO) bench --package flankwright --bench mill_planning

clean:
	$(CARGO) clean
