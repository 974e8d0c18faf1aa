#  SPDX-License-Identifier: GPL-3.0-or-later
"""Each option in the source of a program is in its --help, of which the packages' man
pages and completions are made, and those of the supervisor in the manual's table."""

import re

import pytest
from parties import PROGRAMS, ROOT, ran


def options(pattern: str, text: str) -> set[str]:
    """Of the lines that begin so."""
    lines = re.findall(f"^{pattern}.*", text, re.M)
    return set(re.findall("--[a-z][a-z-]*", "\n".join(lines)))


def helped(program: str) -> set[str]:
    status, said = ran(PROGRAMS / program, "--help")
    assert status == 0
    return options("  --", said)


@pytest.mark.parametrize(
    ("program", "source"),
    [
        ("destijl", "src/process/command_lines.adb"),
        ("destijl_monitor", "monitor/console/invocation.adb"),
        ("destijl_emulator", "tests/emulator/destijl_emulator.adb"),
        ("destijl_web", "monitor/web/destijl_web/options.py"),
    ],
)
def test_help(program: str, source: str) -> None:
    code = re.sub("(?m)^ *(--|#) .*", "", (ROOT / source).read_text("utf-8"))
    known = set(re.findall('"(--[a-z-]+)"', code))
    if program == "destijl_emulator":
        #  its settings, by their names in a table
        settings = (ROOT / "tests/emulator/settings.adb").read_text("utf-8")
        names = re.findall(r'(?:\(\+|Add \()"([a-z-]*)"', settings)
        known.update(f"--{name}" for name in names)
    assert known and known == helped(program)


def test_table() -> None:
    manual = (ROOT / "docs/manual.md").read_text("utf-8")
    section = manual.partition("\n## Options")[2].partition("\n## ")[0]
    assert options(r"\| `--", section) == helped("destijl")
