#  SPDX-License-Identifier: GPL-3.0-or-later
"""The folders of src see only what docs/architecture.md says, and in the rooms only
the units that it names have tasks, locks or devices, or import one that has."""

import fnmatch
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from parties import ROOT, ran

ROOMS = ("common", "robot", "monitor", "vision", "missions")
PLAIN = r"Ada\.(?:Real_Time|Characters|Strings)"
DOES = rf"(?m)^ *(?:protected|task)\b|\bImport\b|\bwith (?!{PLAIN})(?:GNAT|Ada)"


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    copy = tmp_path_factory.mktemp("folders")
    shutil.copytree(ROOT / "src", copy / "src")
    for name in ("destijl.adc", "destijl_switches.gpr"):
        shutil.copy(ROOT / name, copy)
    return copy


def compiled(tree: Path, file: str) -> str:
    """What the compiler says; always, as a change within a second is not seen."""
    folder, name = file.split("/")
    project = f"src/{folder}/{folder}.gpr"
    toolchain = subprocess.check_output([ROOT / "script/toolchain"], text=True).strip()
    own = {"GPR_CONFIG": toolchain, "DESTIJL_PURPOSE": "supervisor"}
    build = ("gprbuild", "-q", "-p", "-f", "-c", "-u", "-P", project, name)
    return ran(*build, cwd=tree, env=os.environ | own)[1]


@pytest.mark.parametrize(
    ("file", "foreign"),
    [
        ("common/texts.adb", "Console"),
        ("process/console.adb", "Robot"),
        ("robot/robot-session.adb", "Monitor Vision Missions.Runs Robot.Tasks"),
        ("monitor/monitor-link.adb", "Robot Vision Missions.Runs Monitor.Tasks"),
        ("vision/vision-following.adb", "Robot Monitor Missions.Runs Vision.Tasks"),
        ("missions/missions-driving.adb", "Monitor Mission_Tasks"),
        ("tasks/failures.adb", "Checks"),
    ],
)
def test_imports(tree: Path, file: str, foreign: str) -> None:
    path = tree / "src" / file
    text = path.read_text()
    assert "error" not in compiled(tree, file)
    for unit in foreign.split():
        name = unit.lower().replace(".", "-") + ".ads"
        assert len([*(tree / "src").glob(f"*/{name}")]) == 1
        path.write_text(re.sub("(?m)^package", rf"with {unit};\n\g<0>", text, count=1))
        assert f'file "{name}" not found' in compiled(tree, file)


def test_projects() -> None:
    """Each project file that a script or a document names is there."""
    places = ["script", "debian", ".ci", "docs", "*.md"]
    found = subprocess.check_output(
        ["git", "grep", "-hoE", r"[*a-z0-9_/]+\.gpr\b", "--", *places],
        cwd=ROOT,
        text=True,
    )
    known = [f"/{file.relative_to(ROOT)}" for file in ROOT.rglob("*.gpr")]
    names = {name.lstrip("/") for name in found.split()}
    assert "destijl.gpr" in names
    assert not {name for name in names if not fnmatch.filter(known, f"*/{name}")}


def test_decisions() -> None:
    texts: dict[str, str] = {}
    for file in sorted((ROOT / "src").glob("*/*.ad[bs]")):
        unit = file.stem.replace("-", ".")
        text = re.sub(r'--.*|"[^"\n]*"', "", file.read_text("utf-8"))
        texts[unit] = texts.get(unit, "") + text
    found = {
        unit
        for unit, text in texts.items()
        if re.search(DOES, text) and not re.search(r"\bPure\b", text)
    }
    more = found
    while more:
        has = re.compile(rf"^(?:private )?with (?:{'|'.join(more)});", re.M | re.I)
        more = {
            unit
            for unit, text in texts.items()
            if unit not in found
            and (has.search(text) or unit.rpartition(".")[0] in more)
        }
        found |= more
    table = (ROOT / "docs/architecture.md").read_text("utf-8")
    for room in ROOMS:
        row = re.search(rf"^\| `src/{room}` \|.*\|(.*)\|$", table, re.M)
        assert row, room
        named = {name.lower() for name in re.findall("`([^`]+)`", row[1])}
        here = {f.stem.replace("-", ".") for f in (ROOT / "src" / room).glob("*.ads")}
        assert named == here & found, room
