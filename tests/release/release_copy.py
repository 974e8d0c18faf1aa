#  SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of this tree, committed, in which script/release is tried."""

import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

ROOT = Path(__file__).parents[2]


class Copy:
    """A change of it is a shell script, in which commit commits all."""

    def __init__(self) -> None:
        self.folder = TemporaryDirectory()  # removed with this object
        self.root = Path(self.folder.name)
        version = (ROOT / "src/common/project_version.ads").read_text()
        self.number = re.findall(r'"(.*)";', version)[0]
        git = {"GIT_CONFIG_GLOBAL": "/dev/null", "GIT_CONFIG_SYSTEM": "/dev/null"}
        for who in ("AUTHOR", "COMMITTER"):
            git |= {f"GIT_{who}_NAME": "test", f"GIT_{who}_EMAIL": "t@example.org"}
        self.environment = os.environ | git | {"N": self.number}

    def run(self, *command: str) -> tuple[int, str]:
        done = subprocess.run(
            command,
            cwd=self.root,
            env=self.environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            check=False,
        )
        return done.returncode, done.stdout

    def passes(self, *command: str) -> str:
        status, said = self.run(*command)
        assert status == 0, said
        return said

    def change(self, script: str) -> None:
        commit = "commit () { git add -A; git commit -qm changed; }"
        self.passes("sh", "-ec", f"{commit}; {script}")

    def stand_in(self, script: str) -> None:
        """Instead of script/test."""
        (self.root / "script/test").write_text(f"#!/bin/sh\n{script}\n")
        self.change("commit")

    def refuses(self, words: str, *parts: str) -> str:
        """WORDS is a regular expression."""
        status, said = self.run("script/release", *parts)
        assert status != 0
        assert re.search(words, said, re.M), said
        return said


@cache
def original() -> Copy:
    copy = Copy()
    known = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    if known.returncode != 0:
        pytest.skip("this is no git repository")
    for name in known.stdout.split("\0")[:-1]:
        if (ROOT / name).exists():
            (copy.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, copy.root / name)
    copy.change("git -c init.defaultBranch=main init -q; commit; git tag original")
    return copy


def fresh() -> Copy:
    """The copy, as it was committed."""
    copy = original()
    copy.change("""
        git reset -q --hard original
        git clean -qfdx
        git tag -l v$N | xargs -r git tag -d""")
    return copy
