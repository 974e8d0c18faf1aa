#  SPDX-License-Identifier: GPL-3.0-or-later
"""The token that the package makes when it is installed."""

import os
from pathlib import Path

import pytest
from parties import ROOT, ran

POSTINST = ROOT / "debian/destijl.postinst"


def configure(tmp_path: Path) -> list[str]:
    """Which of sync and mv it has called, in order."""
    calls = tmp_path / "calls"
    tools = tmp_path / "tools"
    tools.mkdir(exist_ok=True)
    for name in ("sync", "mv"):
        tool = tools / name
        tool.write_text(f'#!/bin/sh\necho {name} "$@" >>{calls}\nexec /bin/{name} "$@"')
        tool.chmod(0o755)
    script = POSTINST.read_text().replace("/etc/destijl", str(tmp_path / "etc"))
    calls.write_text("")
    environment = {"PATH": f"{tools}:{os.environ['PATH']}"}
    assert ran("sh", "-c", script, "postinst", "configure", env=environment)[0] == 0
    return calls.read_text().replace(str(tmp_path / "etc"), "").splitlines()


def test_token_is_on_the_disk_before_it_has_its_name(tmp_path: Path) -> None:
    calls = configure(tmp_path)
    token = tmp_path / "etc/token"
    assert calls == ["sync /token.new", "mv /token.new /token", "sync "]
    assert len(token.read_text()) == 33
    assert token.stat().st_mode & 0o777 == 0o600
    assert token.parent.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("left", ["", "the user's own\n"])
def test_only_an_empty_token_is_made_again(tmp_path: Path, left: str) -> None:
    token = tmp_path / "etc/token"
    token.parent.mkdir()
    token.write_text(left)
    configure(tmp_path)
    assert (token.read_text() == left) == bool(left)
    assert token.stat().st_size > 8
