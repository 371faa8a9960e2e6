"""What tests share."""

from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="session")
def command() -> Path:
    """The command, as `make test` has built it."""
    for profile in ("debug", "release"):
        path = ROOT / "target" / profile / "flankwright"
        if path.exists():
            return path
    pytest.fail("the command is not built: `cargo build --package flankwright-cli --features verify`")
