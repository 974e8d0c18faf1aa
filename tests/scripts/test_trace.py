#  SPDX-License-Identifier: GPL-3.0-or-later
"""script/trace: what a viewer gets of a file of --trace."""

import json
import subprocess
from pathlib import Path

import pytest
from parties import ROOT, ran

PROGRAM = ROOT / "script/trace"
HEAD = """# destijl trace, begun at 5.000000000 of CLOCK_MONOTONIC
# task th_stop 36
# task th_move 20
"""


def convert(path: Path, text: str) -> subprocess.CompletedProcess[str]:
    path.write_text(text)
    return subprocess.run([PROGRAM, path], capture_output=True, text=True, check=False)


def test_slices_are_nested_and_closed(tmp_path: Path) -> None:
    done = convert(
        tmp_path / "trace",
        HEAD + "0.000001000 th_move done\n"  # begun before what is kept
        "0.000002000 th_move wait line\n"
        "0.000003500 th_move release #7\n"
        "1.000004000 th_move start\n"
        "1.000004500 th_move take #7\n"
        "1.000005000 th_stop robot M\n"
        "1.000006000 th_move wait line\n"
        "1.000007000 th_move resume\n"
        "1.000008000 th_move wait line\n"
        "1.000009000 th_move start\n",
    )
    assert done.returncode == 0, done.stderr
    events = json.loads(done.stdout)["traceEvents"]
    names = {
        e["tid"]: e["args"]["name"] for e in events if e.get("name") == "thread_name"
    }
    orders = [
        e["args"]["sort_index"] for e in events if e.get("name") == "thread_sort_index"
    ]
    assert names == {1: "th_stop", 2: "th_move"} and orders == sorted(orders)
    assert [
        (e["tid"], e["ph"], e.get("name"), e["ts"], e.get("args", {}).get("command"))
        for e in events
        if "ts" in e
    ] == [
        (2, "i", "release", 3.5, 7),
        (2, "B", "job", 1000004.0, 7),
        (1, "i", "robot M", 1000005.0, None),
        (2, "B", "wait for line", 1000006.0, None),
        (2, "E", None, 1000007.0, None),
        (2, "B", "wait for line", 1000008.0, None),
        (2, "E", None, 1000009.0, None),
        (2, "E", None, 1000009.0, None),
        (2, "B", "job", 1000009.0, None),
        (2, "E", None, 1000009.0, None),
    ]


@pytest.mark.parametrize(
    "line",
    ["{}", "0.5 th_none start", "soon th_move start", "0.5 th_move", "\n", "\xff"],
)
def test_bad_lines(tmp_path: Path, line: str) -> None:
    done = convert(tmp_path / "trace", f"{HEAD}{line}\n")
    assert done.returncode == 1 and "trace: /" in done.stderr, done.stderr
    assert "Traceback" not in done.stderr and done.stdout == ""


def test_file_of_a_full_disk(tmp_path: Path) -> None:
    """Its last line is cut, also within a time."""
    whole = f"{HEAD}0.5 th_move start\n"
    (same,) = {
        convert(tmp_path / "trace", whole + cut).stdout for cut in ("", "0.7", "0")
    }
    assert json.loads(same)["traceEvents"]


def test_nobody_reads(tmp_path: Path) -> None:
    path = tmp_path / "trace"
    path.write_text(HEAD + "0.5 th_move start\n" * 10_000, encoding="ascii")
    _, said = ran("sh", "-c", f"'{PROGRAM}' {path} | head -c 10 >/dev/null")
    assert said == f"trace: {path}: [Errno 32] Broken pipe\n"
