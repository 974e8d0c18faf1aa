#  SPDX-License-Identifier: GPL-3.0-or-later
"""Every link of the documentation leads somewhere, with its anchor; every operation of
a unit and every test of docs/security.md that it names is there."""

import re
from collections import defaultdict
from pathlib import Path

import pytest
from parties import ROOT

FILES = [
    path
    for path in sorted(ROOT.rglob("*.md"))
    if not {"obj", "alire"}.intersection(path.relative_to(ROOT).parts)
]


def prose(path: Path) -> str:
    """Without blocks of code."""
    text = re.sub(r"^```.*?^```", "", path.read_text("utf-8"), flags=re.M | re.S)
    return re.sub(r"`[^`\n]*`", lambda code: code[0].replace("](", ""), text)


def anchors(path: Path) -> set[str]:
    heads = re.findall(r"^#+ +(.*?) *$", prose(path), re.M)
    words = [re.sub(r"[^\w\- ]", "", head.lower()) for head in heads]
    return {word.replace(" ", "-") for word in words}


@pytest.mark.parametrize("file", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_links(file: Path) -> None:
    dead = []
    links = re.findall(r"\]\(\s*([^)\s]+)\s*\)", prose(file))
    for link in links + re.findall(r'src="([^"]+)"', prose(file)):
        if re.match("[a-z]+:", link):
            continue
        path, _, anchor = link.partition("#")
        target = (file.parent / path).resolve() if path else file
        if not target.exists() or (
            anchor and target.suffix == ".md" and anchor not in anchors(target)
        ):
            dead.append(link)
    assert not dead


def test_names() -> None:
    units: dict[str, set[str]] = defaultdict(set)
    for path in [*ROOT.glob("src/*/*.ad[sb]"), *ROOT.glob("proofs/*.ad[sb]")]:
        code = re.sub("--.*", "", path.read_text("utf-8")).lower()
        units[path.stem.replace("-", ".")].update(re.findall(r"\w+", code))
    unknown = []
    for file in FILES:
        for name in re.findall(r"\b[A-Z]\w*(?:\.[A-Z]\w*)+", file.read_text("utf-8")):
            unit, inside = name.lower(), set[str]()
            while unit and unit not in units:
                unit, _, last = unit.rpartition(".")
                inside.add(last)
            if unit and not inside <= units[unit]:
                unknown.append(f"{file.name}: {name}")
    assert not unknown


def test_tests_of_security() -> None:
    text = (ROOT / "docs/security.md").read_text("utf-8")
    table = text.partition("\n| attacker ")[2].splitlines()[2:]
    sources = [*ROOT.glob("tests/**/*.py"), *ROOT.glob("tests/**/*.adb")]
    there = {path.name for path in sources} | {"debian/tests/drive"}
    for path in sources:
        there.update(re.findall(r"\w+", path.read_text("utf-8")))
    for row in table:
        named = re.findall("`([^`]+)`", row.split(" | ")[3])
        assert named and not set(named) - there
