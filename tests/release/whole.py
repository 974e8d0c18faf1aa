#  SPDX-License-Identifier: GPL-3.0-or-later
"""A whole release, with a stand-in for script/test alone: minutes, so that
script/test --all names this file."""

from pathlib import Path

import pytest
from release_copy import fresh


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


def test_an_older_index_is_no_fault() -> None:
    """As script/alire-index is for alr 2."""
    copy = fresh()
    index = "script/alire-index/index.toml"
    copy.change(f"""sed -i 's/^version = .*/version = "1.1.0"/' {index}; commit""")
    copy.passes("script/release", "crate")


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
