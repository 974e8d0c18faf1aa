#  SPDX-License-Identifier: GPL-3.0-or-later
"""What the program is called with."""

import re
from pathlib import Path

import pytest
from destijl_web import options
from destijl_web.options import HELP, Options, Usage, Wish, read
from helpers import token_file


def test_defaults() -> None:
    assert read([]) == Options()


def test_values(tmp_path: Path) -> None:
    given = "--supervisor=robot.local:5545 --bind ::1 --port 0"
    given += " --origin http://localhost:9000/ --origin=http://127.0.0.1:9000"
    chosen = read([*given.split(), "--record", str(tmp_path), "--record-limit", "5"])
    assert chosen == Options(
        supervisor_host="robot.local",
        supervisor_port=5545,
        bind="::1",
        port=0,
        record=tmp_path,
        record_limit=5_000_000,
        origins=("http://localhost:9000", "http://127.0.0.1:9000"),
    )
    chosen = read(["--supervisor", "[fe80::1]:7"])
    assert isinstance(chosen, Options)
    assert (chosen.supervisor_host, chosen.supervisor_port) == ("fe80::1", 7)


def test_wishes() -> None:
    assert read(["--help"]) is Wish.HELP
    assert read(["--version"]) is Wish.VERSION


@pytest.mark.parametrize(
    "given",
    [
        *("web", "--verbose", "--help=yes", "--port", "--port=", "--port 65536"),
        *("--port -1", "--port 8080x", "--supervisor robot", "--supervisor robot:0"),
        *("--supervisor a\tb:1", "--bind robot", "--record /nonexistent"),
        *("--record-limit 0", "--record-limit 5GB", "--record-limit -1"),
        *("--token /nonexistent", "--origin robot.example"),
        *("--origin https://robot.example/path", "--origin http://localhost " * 9),
    ],
)
def test_refused(given: str) -> None:
    with pytest.raises(Usage):
        read([word.replace("\t", " ") for word in given.strip().split(" ")])


def test_other_machines_need_a_token(tmp_path: Path) -> None:
    token = token_file(tmp_path, "secret-of-teacher")
    for given in (
        ["--bind", "0.0.0.0"],
        ["--bind", "::"],
        ["--bind", "192.0.2.1"],
        ["--origin", "https://robot.example"],
    ):
        with pytest.raises(Usage, match="--token"):
            read(given)
        chosen = read([*given, "--token", token])
        assert isinstance(chosen, Options) and chosen.token == "secret-of-teacher"
    assert isinstance(read(["--bind", "127.0.0.2"]), Options)


def test_viewers_need_a_teacher(tmp_path: Path) -> None:
    teacher = token_file(tmp_path, "secret-of-teacher")
    viewer = token_file(tmp_path, "secret-of-viewers")
    with pytest.raises(Usage):
        read(["--viewers-token", viewer])
    with pytest.raises(Usage):
        read(["--token", teacher, "--viewers-token", teacher])
    chosen = read(["--token", teacher, "--viewers-token", viewer])
    assert isinstance(chosen, Options) and chosen.viewers_token == "secret-of-viewers"


@pytest.mark.parametrize("token", ["short", "with a blank in it", "x" * 129, "é" * 10])
def test_bad_tokens(tmp_path: Path, token: str) -> None:
    with pytest.raises(Usage) as refused:
        read(["--token", token_file(tmp_path, token)])
    assert token not in str(refused.value).replace(str(tmp_path), "").replace(
        f"token_{token}", ""
    )


@pytest.mark.parametrize("mode", [0o620, 0o604, 0o602])
def test_tokens_that_others_may_read(tmp_path: Path, mode: int) -> None:
    path = token_file(tmp_path, "secret-of-teacher")
    Path(path).chmod(mode)
    with pytest.raises(Usage, match="others"):
        read(["--token", path])


def test_help_names_every_option() -> None:
    source = Path(options.__file__).read_text()
    known = set(re.findall(r'"(--[a-z-]+)"', source))
    said = re.findall(r"^  (--[a-z-]+)(?:, (--[a-z-]+))?", HELP, re.MULTILINE)
    assert known == {name for names in said for name in names if name}
    assert max(map(len, HELP.splitlines())) <= 72
