#  SPDX-License-Identifier: GPL-3.0-or-later
"""When script/unchanged runs a command again."""

import os
import shutil
import subprocess
from pathlib import Path

UNCHANGED = Path(__file__).parents[2] / "script/unchanged"
AGAIN = "unchanged since it passed: sh -c cat folder/*\n"


def run(root: Path, command: str = "cat folder/*", **more: str) -> tuple[int, str]:
    environment = {name: os.environ[name] for name in ("PATH", "HOME")}
    done = subprocess.run(
        ["script/unchanged", "name", "folder", "--", "sh", "-c", command],
        cwd=root,
        env=environment | more,
        capture_output=True,
        text=True,
        check=False,
    )
    return done.returncode, done.stdout


def test_unchanged(tmp_path: Path) -> None:
    (tmp_path / "script").mkdir()
    (tmp_path / "folder").mkdir()
    shutil.copy(UNCHANGED, tmp_path / "script")
    file = tmp_path / "folder/file"
    file.write_text("1\n")
    #  not without git, whose changes nobody knows
    assert run(tmp_path) == run(tmp_path) == (0, "1\n")
    git = ["git", "-C", str(tmp_path), "-c", "user.name=a", "-c", "user.email=b"]
    subprocess.run([*git, "init", "-q"], check=True)
    subprocess.run([*git, "add", "script", "folder"], check=True)
    subprocess.run([*git, "commit", "-qm", "all"], check=True)
    assert run(tmp_path) == (0, "1\n")
    assert run(tmp_path) == (0, AGAIN + "1\n")
    assert run(tmp_path, CI="true") == (0, "1\n")
    (tmp_path / "other").touch()
    assert run(tmp_path) == (0, AGAIN + "1\n")
    file.write_text("2\n")
    assert run(tmp_path) == (0, "2\n")
    (tmp_path / "folder/new").write_text("3\n")
    assert run(tmp_path) == (0, "2\n3\n")
    assert run(tmp_path, "cat folder/*; false") == (1, "2\n3\n")
    assert run(tmp_path) == (0, "2\n3\n")
    file.unlink()
    assert run(tmp_path) == (0, "3\n")
    assert run(tmp_path) == (0, AGAIN + "3\n")
