#  SPDX-License-Identifier: GPL-3.0-or-later
"""Alire's index that script/bootstrap registers: for alr 1.2 and for alr 2."""

import os
import shutil
from pathlib import Path

import pytest
from parties import ROOT, ran

ALR_2 = """#!/bin/sh
#  What differs in alr 2
indexes=$ALIRE_SETTINGS_DIR/indexes
echo "$*" >>"$HOME/calls"
case $* in
   *version) echo "indexes folder:        $indexes   " ;;
   *' config '*) exit 1 ;;
   *--add*)
      mkdir -p "$indexes/destijl"
      echo "url = \\"file:$5\\"" >"$indexes/destijl/index.toml" ;;
esac
"""


class User:
    def __init__(self, home: Path, **environment: str) -> None:
        names = ("ALIRE_SETTINGS_DIR", "ALR_CONFIG", "XDG_CONFIG_HOME", "XDG_DATA_HOME")
        self.home = home
        self.environment = {k: v for k, v in os.environ.items() if k not in names}
        self.environment |= {"HOME": str(home)} | environment

    def run(self, *command: str | Path) -> str:
        return ran(*command, env=self.environment, cwd=self.home)[1]

    def register(self) -> str:
        return self.run(ROOT / "script/register_index")


needs_alr = pytest.mark.skipif(shutil.which("alr") is None, reason="no alr")


@needs_alr
@pytest.mark.parametrize("settings", [".config", "elsewhere"])
def test_the_index_is_registered_once(tmp_path: Path, settings: str) -> None:
    user = User(tmp_path, XDG_CONFIG_HOME=str(tmp_path / settings))
    assert "registered" in user.register()
    assert "destijl" in user.run("alr", "-n", "index", "--list")
    assert (
        "old_index = false" in (tmp_path / settings / "alire/config.toml").read_text()
    )
    assert "kept" in user.register()


@needs_alr
@pytest.mark.parametrize("settings", [".config", "elsewhere"])
def test_an_index_that_alr_2_registered_is_read(tmp_path: Path, settings: str) -> None:
    user = User(tmp_path, XDG_CONFIG_HOME=str(tmp_path / settings))
    user.register()
    entry = tmp_path / settings / "alire/indexes/destijl/index.toml"
    entry.write_text(entry.read_text().replace("file:///", "file:/"))
    assert "Cannot load" in user.run("alr", "-n", "index", "--list")
    assert "kept" in user.register()
    assert "destijl" in user.run("alr", "-n", "index", "--list")


def test_what_alr_2_registers_alr_1_reads(tmp_path: Path) -> None:
    alr = tmp_path / "alr"
    alr.write_text(ALR_2)
    alr.chmod(0o755)
    settings = tmp_path / "settings"
    path = f"{tmp_path}:{os.environ['PATH']}"
    user = User(tmp_path, ALIRE_SETTINGS_DIR=str(settings), PATH=path)
    assert "registered" in user.register()
    entry = (settings / "indexes/destijl/index.toml").read_text()
    assert entry == f'url = "file://{tmp_path}/.local/share/destijl/alire-index"\n'
    calls = (tmp_path / "calls").read_text()
    for key in ("toolchain.assistant", "warning.old_index"):
        assert f"settings --set --global {key} false" in calls


def test_git_ignores_what_alire_makes() -> None:
    for folder in ("", "tests/", "proofs/"):
        for name in ("alire", "config"):
            ignored = ran("git", "check-ignore", f"{folder}{name}/", cwd=ROOT)
            assert ignored[0] == 0
