#  SPDX-License-Identifier: GPL-3.0-or-later
"""script/release refuses what it must, one thing after the other."""

import pytest
from release_copy import fresh


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
    "file", ["alire.toml", "tests/alire.toml", "proofs/alire.toml"]
)
def test_another_version_is_refused(file: str) -> None:
    copy = fresh()
    copy.passes("script/release", "versions")
    copy.change(f'sed -i \'s/^version = ".*"/version = "0.9.9"/\' {file}')
    copy.refuses(f"^release: refused: {file} has version 0.9.9", "versions")
    copy.change(f"sed -i '/^version = /d' {file}")
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
