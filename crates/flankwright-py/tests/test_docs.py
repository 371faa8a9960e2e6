"""The pages of the package: every public name has its place, and the examples come out as they stand there."""

import doctest
import re
from pathlib import Path

import flankwright
import pytest
from flankwright import plots

PAGES = sorted((Path(__file__).parents[3] / "docs" / "python").glob("*.md"))


def test_every_public_name_has_its_place() -> None:
    text = "\n".join(page.read_text(encoding="utf-8") for page in PAGES)
    entries = re.findall(r"^\.\. [a-z:]+:: flankwright\.(\S+)", text, re.MULTILINE)
    public = {name for name in flankwright.__all__ if name != "sweep"}
    public |= {f"sweep.{name}" for name in flankwright.sweep.__all__}
    public |= {f"plots.{name}" for name in plots.__all__}
    assert sorted(entries) == sorted(public)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_examples(page: Path) -> None:
    # Empty lines for the fences: an example ends there, and lines keep their numbers.
    text = re.sub(r"^```.*$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE)
    examples = doctest.DocTestParser().get_doctest(text, {}, page.stem, str(page), 0)
    assert examples.examples
    assert doctest.DocTestRunner().run(examples).failed == 0
