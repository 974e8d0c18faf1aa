#  SPDX-License-Identifier: GPL-3.0-or-later
"""script/release refuses what it must, one thing after the other, in a copy of this
tree that is committed; and makes a whole release, with a stand-in for script/test."""

import os
import re
import shutil
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from parties import ROOT, ran


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
        return ran(*command, cwd=self.root, env=self.environment)

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
    listed = "git ls-files -z --cached --others --exclude-standard"
    status, known = ran(*listed.split(), cwd=ROOT)
    if status != 0:
        pytest.skip("this is no git repository")
    for name in known.split("\0")[:-1]:
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


def test_as_it_is() -> None:
    """If the record of the proof is stale, that alone is wrong."""
    copy = fresh()
    if copy.run("script/prove", "record")[0] == 0:
        copy.passes("script/release", "check")
    else:
        said = copy.refuses("^release: refused: proof: ", "check")
        assert said.count("refused:") == 1


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("echo >>README.md", "^ M README.md$"),
        ("touch new", r"^\?\? new$"),
        (
            "git tag -f v$N; echo >>README.md; commit",
            "is the tag of another commit",
        ),
        (
            'sed -i "s/$N/99.0.0/" src/common/project_version.ads; commit',
            "^release: refused: alire.toml has version",
        ),
        (
            'sed -i "s/$N/99.0.0/" src/common/project_version.ads; commit',
            'entry of CHANGELOG.md is not "## 99.0.0 - DATE"',
        ),
        ('sed -i "s/^## $N - .*/## $N - unreleased/" CHANGELOG.md', 'is not "## '),
        (
            'sed -i "s/^## $N - .*/## $N - 2026-13-01/" CHANGELOG.md',
            "2026-13-01 is no date",
        ),
        ("sed -i '/^- /d' CHANGELOG.md", "says nothing of "),
        ("sed -i '0,/^## /s//## 99.0.0 - 2026-01-01\\n&/' CHANGELOG.md", 'is not "## '),
        ("rm CHANGELOG.md", 'is not "## '),
        (
            "echo 'pragma Page;' >>src/monitor/base64.adb; commit",
            "refused: proof: .*base64.adb",
        ),
        ("rm proofs/results/sources.txt; commit", "refused: proof: .* is missing"),
    ],
)
def test_an_unfit_tree_is_refused(change: str, words: str) -> None:
    copy = fresh()
    copy.change(change)
    copy.refuses(words, "check")


@pytest.mark.parametrize(
    "file",
    ["alire.toml", "tests/alire.toml", "proofs/alire.toml", "debian/changelog"],
)
def test_another_version_is_refused(file: str) -> None:
    copy = fresh()
    copy.passes("script/release", "versions")
    copy.change(f"""sed -i 's/^version = ".*"/version = "0.9.9"/
                            1s/ (.*)/ (0.9.9-1)/' {file}""")
    copy.refuses(f"^release: refused: {file} has version 0.9.9", "versions")
    copy.change(f"sed -i '/^version = /d; 1d' {file}")
    copy.refuses(f"{file} has version none", "versions")


def test_tests() -> None:
    copy = fresh()
    copy.stand_in('test "$*" = --all')
    copy.passes("script/release", "tests")
    copy.stand_in("exit 1")
    copy.refuses("refused: script/test --all fails", "tests")
    copy.stand_in("echo >>README.md")
    copy.refuses("^ M README.md$", "tests")
    copy.refuses("^ M README.md$")
    copy.stand_in("git commit -q --allow-empty -m changed")
    copy.refuses("is not here any more", "tests")


@pytest.mark.whole
def test_a_whole_release(tmp_path: Path) -> None:
    copy = fresh()
    copy.stand_in("exit 0")
    copy.passes("script/release")
    copy.passes("sh", "-c", "cd obj/release && sha256sum -c SHA256SUMS")
    #  the same tarball somewhere else, of somebody else
    copy.change(f"""
        tarball=obj/release/destijl-$N.tar.gz
        git clone -q . {tmp_path}/elsewhere
        cp $tarball {tmp_path}/kept
        cd {tmp_path}/elsewhere
        umask 077
        git config tar.umask 077
        TZ=Asia/Tokyo script/release tarball
        cmp $tarball {tmp_path}/kept""")


@pytest.mark.whole
def test_an_older_index_is_no_fault() -> None:
    """As script/alire-index is for alr 2."""
    copy = fresh()
    index = "script/alire-index/index.toml"
    copy.change(f"""sed -i 's/^version = .*/version = "1.1.0"/' {index}; commit""")
    copy.passes("script/release", "crate")


@pytest.mark.whole
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ("sed -i '/^website = /d' alire.toml", "alr publish: .*website"),
        ("sed -i '1s/^/website = [\\n/' alire.toml", "alr publish does not take"),
        (
            "sed -i 's/^begin$/begin;;/' src/main/destijl.adb",
            "alr publish does not take",
        ),
    ],
)
def test_what_alire_does_not_take_is_refused(change: str, words: str) -> None:
    copy = fresh()
    copy.change(f"{change}; commit")
    copy.refuses(words, "crate")
    assert not (copy.root / "obj/release/SHA256SUMS").exists()
