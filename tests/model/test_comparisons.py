#  SPDX-License-Identifier: GPL-3.0-or-later
"""What proofs/model/steps says of the order of operations, and
proofs/schedulability/calls of their number: in a copy, each fault of faults.txt
is planted, and the place is named. Needs no SPIN, but bin/schedulability."""

import re
import shutil
from pathlib import Path

import pytest
from parties import ROOT, ran

TOOLS = {
    "steps": ["proofs/model/steps"],
    "calls": ["proofs/schedulability/calls", "--counts"],
}
_, *FAULTS = Path(__file__).with_name("faults.txt").read_text().split("\n\n")
NAMES = [fault.strip().split("\n")[0] for fault in FAULTS]


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    tree = tmp_path_factory.mktemp("tree")
    for folder in ("src", "proofs/model", "proofs/schedulability"):
        shutil.copytree(ROOT / folder, tree / folder)
    (tree / "bin").mkdir()
    shutil.copy(ROOT / "bin/schedulability", tree / "bin")
    return tree


def says(tree: Path, tool: str, file: str, script: str) -> tuple[int, str]:
    """Its status and output, with this file changed by sed."""
    kept = (tree / file).read_bytes()
    try:
        assert ran("sed", "-i", "-E", script, file, cwd=tree) == (0, "")
        assert (tree / file).read_bytes() != kept
        return ran(*TOOLS[tool], cwd=tree)
    finally:
        (tree / file).write_bytes(kept)


@pytest.mark.parametrize("tool", TOOLS)
def test_as_it_is(tree: Path, tool: str) -> None:
    assert ran(*TOOLS[tool], cwd=tree)[0] == 0


@pytest.mark.parametrize("fault", FAULTS, ids=NAMES)
def test_a_fault_is_noticed(tree: Path, fault: str) -> None:
    _, planted, words = fault.strip().split("\n")
    tool, file, script = planted.split(" ", 2)
    status, said = says(tree, tool, file, script)
    assert status != 0
    assert re.search(rf"^[a-z]*: .*({words})", said, re.M), said


@pytest.mark.parametrize(
    ("file", "script"),
    [
        #  a condition, which is for the mutants
        (
            "robot/robot-line.adb",
            "/^   procedure Look/,/end Look/s/if Next <= Now/if Next > Now/",
        ),
        (
            "vision/vision-turns.adb",
            "s/Arena_Turn.Set;/ARENA_TURN.SET;/; s/ine.Put/INE . put/",
        ),
    ],
)
def test_the_same_operations_pass(tree: Path, file: str, script: str) -> None:
    status, said = says(tree, "steps", f"src/{file}", script)
    assert status == 0, said
