"""The stock of measured blanks, and the language of what an inspection writes."""

import json
import shutil
import subprocess
from pathlib import Path

import flankwright as fw
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples"
BLANK = EXAMPLES / "inspection/blank.csv"
JOB = EXAMPLES / "cycles/measured-blank.toml"
PART = ROOT / "fuzz/seeds/klingelnberg/curves.mka"


def test_a_blank_has_the_stock_that_the_command_finds(command: Path, tmp_path: Path) -> None:
    found = fw.blank_stock(BLANK, JOB)
    told = subprocess.run(
        [command, "inspect", BLANK, "--job", JOB, "--blank", "--json", "-o", tmp_path / "command"],
        check=True,
        stdout=subprocess.PIPE,
    )
    assert found.document == json.loads(told.stdout)
    written = found.write(tmp_path / "own")
    assert [path.name for path in written] == ["stock.csv", "blank.json"]
    assert written[0].read_bytes() == (tmp_path / "command/stock.csv").read_bytes()
    left = found.flanks["left"]
    # Without pitches only the teeth with traces are listed.
    assert left.spaces == list(range(0, 35, 5)) and left.stock.shape == (7, left.w.size, left.z.size)
    allowance = fw.Job.load(JOB)["stock.allowance_um"]
    least, mean, most = found.document["stock_um"]["left"]
    found_um = np.array([left.stock.min(), left.stock.mean(), left.stock.max()]) + allowance
    np.testing.assert_allclose(found_um, [least, mean, most], atol=1e-9)
    assert "BlankStock" in repr(found) and "7 spaces" in repr(left)


def test_a_blank_that_is_none_is_refused() -> None:
    with pytest.raises(fw.BadInput) as caught:
        fw.blank_stock("none.mka", JOB)
    assert caught.value.code == "unreadable-file"
    with pytest.raises(fw.BadInput) as caught:
        fw.blank_stock(BLANK, EXAMPLES / "milling/spur-module-8.toml")
    assert (caught.value.code, caught.value.field) == ("process-not-available", "job.process")
    with pytest.raises(fw.BadInput) as caught:
        fw.blank_stock(BLANK, fw.Job.load(JOB).replace({"stock": None, "technology": None}))
    assert caught.value.field == "stock.allowance_um" and caught.value.way_out


def test_an_inspection_is_written_in_its_language(tmp_path: Path) -> None:
    def words(result: fw.Result) -> str:
        return next(path for path in result.write(tmp_path / "out") if path.suffix == ".html").read_text()[:300]

    assert 'lang="de"' in words(fw.inspect(PART, language="de"))
    assert 'lang="en"' in words(fw.inspect(PART))
    (tmp_path / "parts").mkdir()
    shutil.copy(PART, tmp_path / "parts/one.mka")
    assert 'lang="de"' in words(fw.inspect(tmp_path / "parts", language="de"))
    against = {"job": EXAMPLES / "inspection/measured.toml", "language": "de"}
    assert 'lang="de"' in words(fw.inspect(EXAMPLES / "inspection/measured.csv", **against))  # type: ignore[arg-type]
    with pytest.raises(fw.BadInput) as caught:
        fw.inspect(PART, language="fr")  # type: ignore[arg-type]
    assert (caught.value.field, caught.value.value) == ("language", "fr")
